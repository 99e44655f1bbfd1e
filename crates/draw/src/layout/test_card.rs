//! The laser test card, which shows the right speed and number of passes for a material.

use std::fmt::Display;
use std::ops::RangeInclusive;

use dobot_geometry::{Point, Stroke, Vec2};
use dobot_lettering::{Anchor, strokes, width};
use dobot_plan::{DrawingTool, Laser, Pass};
use thiserror::Error;

/// A grid of small hatched squares, each burned with a different speed and number of passes. A line
/// below each square shows whether the material is cut through.
///
/// ```text
///            3    5    8   12      mm/s, to the right
///     1×    ▒▒   ▒▒   ░░   ░░
///           --   --   --   --
///     2×    ▓▓   ▒▒   ▒▒   ░░
///           --   --   --   --      passes, downwards, as seen from behind the arm
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Card {
    /// The speed of each column, in mm/s: 0.1 to 100, ascending, at most 20.
    pub speeds_mm_s: Vec<f64>,
    /// The maximum number of passes: there is a row for each number from 1; at most 20.
    pub most_passes: u32,
    /// The width and height of a square, in mm; 3 to 50.
    pub cell_mm: f64,
    /// The gap between squares, in mm; 1 to 50.
    pub gap_mm: f64,
    /// The line spacing in a square, in mm; 0.05 to 5.
    pub spacing_mm: f64,
    /// The travel speed, in mm/s; 0.1 to 500.
    pub travel_speed_mm_s: f64,
    /// The speed for burning the labels, once, in mm/s; 0.1 to 100.
    pub label_speed_mm_s: f64,
    /// The caption below the squares: the material and the day.
    pub caption: String,
    /// The centre, in the base frame.
    pub center: Point,
}

impl Card {
    /// The range of the number of passes.
    pub(crate) const PASSES: [f64; 2] = [1.0, 20.0];
    /// The range of the size of a square, in mm.
    pub(crate) const CELL_MM: [f64; 2] = [3.0, 50.0];
    /// The range of the gap between squares, in mm.
    pub(crate) const GAP_MM: [f64; 2] = [1.0, 50.0];

    /// Returns the labels followed by the squares, starting with the one that burns least, so that
    /// a person can stop in time.
    ///
    /// # Errors
    ///
    /// [`CardError`] if a setting is outside the range of its field.
    pub fn to_passes(&self) -> Result<Vec<Pass>, CardError> {
        self.check()?;
        let mut cells: Vec<(u32, usize)> = (1..=self.most_passes)
            .flat_map(|times| (0..self.speeds_mm_s.len()).map(move |column| (times, column)))
            .collect();
        let dose = |&(times, column): &(u32, usize)| f64::from(times) / self.speeds_mm_s[column];
        cells.sort_by(|a, b| dose(a).total_cmp(&dose(b)));
        let labels = self.pass("labels".to_owned(), self.label_speed_mm_s, 1, self.labels());
        let count = cells.len();
        let cells = (0..).zip(cells).map(|(number, (times, column))| {
            let speed_mm_s = self.speeds_mm_s[column];
            let name = format!("{speed_mm_s} mm/s, {times} times");
            let cell = self.cell(column, times);
            Pass {
                color: Some(shade(number, count)),
                ..self.pass(name, speed_mm_s, times, cell)
            }
        });
        Ok([labels].into_iter().chain(cells).collect())
    }

    fn pass(&self, name: String, speed_mm_s: f64, times: u32, strokes: Vec<Stroke>) -> Pass {
        let laser = Laser {
            burn_speed_mm_s: speed_mm_s,
            travel_speed_mm_s: self.travel_speed_mm_s,
            times,
            ..Laser::default()
        };
        let strokes = strokes
            .into_iter()
            .map(|stroke| self.placed(stroke))
            .collect();
        Pass {
            name,
            ..Pass::new(DrawingTool::Laser(laser), strokes)
        }
    }

    fn check(&self) -> Result<(), CardError> {
        let speeds = &self.speeds_mm_s;
        within("number of speeds", speeds.len(), 1..=20, "")?;
        within(
            "number of passes",
            self.most_passes.into(),
            among(Self::PASSES),
            "",
        )?;
        for &speed in speeds {
            within("speed", speed, BURN_SPEED, " mm/s")?;
        }
        if let Some([a, b]) = speeds.windows(2).find(|pair| pair[0] >= pair[1]) {
            return Err(CardError {
                name: "order of speeds",
                found: format!("{a} mm/s before {b} mm/s"),
                allowed: "rising speeds".to_owned(),
            });
        }
        within("cell", self.cell_mm, among(Self::CELL_MM), " mm")?;
        within("gap", self.gap_mm, among(Self::GAP_MM), " mm")?;
        within("spacing", self.spacing_mm, 0.05..=5.0, " mm")?;
        within("travel speed", self.travel_speed_mm_s, SPEED, " mm/s")?;
        within("label speed", self.label_speed_mm_s, BURN_SPEED, " mm/s")
    }

    /// Returns a square of lines back and forth and the line below it, on the page.
    fn cell(&self, column: usize, times: u32) -> Vec<Stroke> {
        let corner = self.corner(column, times);
        let (right, size) = (corner.x + self.cell_mm, self.cell_mm);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "at most 1000"
        )]
        let lines = (size / self.spacing_mm + 1e-9) as u32;
        let mut rows: Vec<f64> = (0..=lines)
            .map(|line| corner.y + f64::from(line) * self.spacing_mm)
            .collect();
        rows.push(corner.y + size + BELOW_MM);
        let ends = [corner.x, right];
        (0..)
            .zip(rows)
            .map(|(row, y)| {
                let [from, to] = [ends[row % 2], ends[1 - row % 2]];
                Stroke::open(vec![Point::new(from, y), Point::new(to, y)])
            })
            .collect()
    }

    /// Returns the upper left corner of a square on the page.
    fn corner(&self, column: usize, times: u32) -> Point {
        #[expect(clippy::cast_precision_loss, reason = "at most 20")]
        let column = column as f64;
        Point::new(
            LEFT_MM + column * (self.cell_mm + self.gap_mm),
            ABOVE_MM + f64::from(times - 1) * (self.cell_mm + BELOW_MM + self.gap_mm),
        )
    }

    /// Returns speeds above the columns and numbers of passes beside the rows.
    fn labels(&self) -> Vec<Stroke> {
        let speeds: Vec<String> = self.speeds_mm_s.iter().map(f64::to_string).collect();
        let room_mm = self.cell_mm + self.gap_mm - 1.0;
        let widths_mm = speeds.iter().map(|speed| width(speed, LABEL_MM));
        let widest_mm = widths_mm.fold(0.0, f64::max);
        let height_mm = LABEL_MM * (room_mm / widest_mm).min(1.0);
        let half = Vec2::splat(self.cell_mm / 2.0);
        let mut words = strokes(
            "mm/s",
            Anchor::Left,
            Point::new(0.0, LABEL_MM),
            LABEL_MM * 0.8,
        );
        for (column, speed) in speeds.iter().enumerate() {
            let at = Point::new(self.corner(column, 1).x + half.x, LABEL_MM);
            words.extend(strokes(speed, Anchor::Middle, at, height_mm));
        }
        for times in 1..=self.most_passes {
            let y = self.corner(0, times).y + half.y + LABEL_MM / 2.0;
            let (label, at) = (format!("{times}\u{d7}"), Point::new(LEFT_MM - 2.0, y));
            words.extend(strokes(&label, Anchor::Right, at, LABEL_MM));
        }
        let below = Point::new(0.0, self.page().y + 1.5 * LABEL_MM);
        words.extend(strokes(&self.caption, Anchor::Left, below, LABEL_MM));
        words.into_iter().map(Stroke::open).collect()
    }

    /// Returns the lower right corner of the last square on the page.
    fn page(&self) -> Point {
        let last = self.corner(self.speeds_mm_s.len() - 1, self.most_passes);
        last + Vec2::new(self.cell_mm, self.cell_mm + BELOW_MM)
    }

    /// Converts a stroke from the page to the base frame.
    fn placed(&self, mut stroke: Stroke) -> Stroke {
        let middle = Point::ORIGIN.midpoint(self.page());
        for p in &mut stroke.points {
            let way = *p - middle;
            *p = self.center + Vec2::new(-way.y, -way.x);
        }
        stroke
    }
}

impl Default for Card {
    /// Returns six speeds from 3 to 30 mm/s and one to three passes: 57 x 34 mm, about a quarter of
    /// an hour.
    fn default() -> Self {
        Self {
            speeds_mm_s: vec![3.0, 5.0, 8.0, 12.0, 20.0, 30.0],
            most_passes: 3,
            cell_mm: 6.0,
            gap_mm: 2.0,
            spacing_mm: 0.25,
            travel_speed_mm_s: Laser::default().travel_speed_mm_s,
            label_speed_mm_s: 8.0,
            caption: String::new(),
            center: crate::layout::place::AREA.center(),
        }
    }
}

/// Returns the colour of a square in pictures: from blue, burned least, through green to red.
fn shade(number: usize, count: usize) -> [u8; 3] {
    #[expect(clippy::cast_precision_loss, reason = "at most 400")]
    let share = number as f64 / (count - 1).max(1) as f64;
    let hue = 4.0 * (1.0 - share);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "from 0 to 200"
    )]
    let level = |distance: f64| (200.0 * (2.0 - distance.abs()).clamp(0.0, 1.0)) as u8;
    [level(hue), level(hue - 2.0), level(hue - 4.0)]
}

/// The error returned for an invalid setting of a test card.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("the {name} of the test card is {found}; allowed is {allowed}")]
pub struct CardError {
    /// The setting.
    pub name: &'static str,
    /// The value.
    pub found: String,
    /// The allowed values.
    pub allowed: String,
}

const fn among([least, most]: [f64; 2]) -> RangeInclusive<f64> {
    least..=most
}

fn within<T: Copy + PartialOrd + Display>(
    name: &'static str,
    found: T,
    allowed: RangeInclusive<T>,
    unit: &str,
) -> Result<(), CardError> {
    if allowed.contains(&found) {
        return Ok(());
    }
    let (least, most) = allowed.into_inner();
    Err(CardError {
        name,
        found: format!("{found}{unit}"),
        allowed: format!("a number from {least} to {most}{unit}"),
    })
}

/// A faster laser would need a run-up beyond the arm's reach.
const BURN_SPEED: RangeInclusive<f64> = 0.1..=100.0;
const SPEED: RangeInclusive<f64> = 0.1..=500.0;
/// The distance from a square to the line below it.
const BELOW_MM: f64 = 1.5;
/// Space for the labels.
const LEFT_MM: f64 = 11.0;
const ABOVE_MM: f64 = 5.0;
const LABEL_MM: f64 = 2.5;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_geometry::{Rect, bounds_of_strokes};

    use super::*;

    fn laser(pass: &Pass) -> Laser {
        match pass.tool {
            DrawingTool::Laser(laser) => laser,
            DrawingTool::Pen(pen) => panic!("{pen:?}"),
        }
    }

    /// Returns the square of a pass: the bounds of all its lines except the one below.
    fn square(pass: &Pass) -> Rect {
        bounds_of_strokes(&pass.strokes[..pass.strokes.len() - 1])
    }

    #[test]
    fn each_cell_is_burned_at_its_speed_and_repetitions_the_mildest_first() {
        let card = Card {
            speeds_mm_s: vec![4.0, 10.0],
            most_passes: 2,
            ..Card::default()
        };
        let passes = card.to_passes().unwrap();
        let names: Vec<&str> = passes.iter().map(|pass| pass.name.as_str()).collect();
        assert_eq!(
            names,
            [
                "labels",
                "10 mm/s, 1 times",
                "10 mm/s, 2 times",
                "4 mm/s, 1 times",
                "4 mm/s, 2 times",
            ]
        );
        let burned: Vec<(f64, u32)> = passes
            .iter()
            .map(|pass| (laser(pass).burn_speed_mm_s, laser(pass).times))
            .collect();
        assert_eq!(burned[1..], [(10.0, 1), (10.0, 2), (4.0, 1), (4.0, 2)]);
    }

    #[test]
    fn speeds_increase_to_the_right_and_passes_downwards_as_seen_from_behind_the_arm() {
        let passes = Card::default().to_passes().unwrap();
        let square_of = |name: &str| square(passes.iter().find(|pass| pass.name == name).unwrap());
        let [first, right, below] = ["3 mm/s, 1 times", "5 mm/s, 1 times", "3 mm/s, 2 times"]
            .map(|name| square_of(name).center());
        // Right is -Y and down is -X; columns are 6 + 2 mm apart, rows another 1.5 for the line.
        assert!((right - first - Vec2::new(0.0, -8.0)).length() < 1e-9);
        assert!((below - first - Vec2::new(-9.5, 0.0)).length() < 1e-9);
    }

    #[test]
    fn a_square_has_the_requested_size_and_spacing() {
        let card = Card {
            cell_mm: 8.0,
            spacing_mm: 0.5,
            ..Card::default()
        };
        let passes = card.to_passes().unwrap();
        let cell = &passes[1];
        // Lines at 0, 0.5 .. 8 mm, and one below.
        assert_eq!(cell.strokes.len(), 18);
        assert!(
            cell.strokes
                .iter()
                .all(|stroke| (stroke.length_mm() - 8.0).abs() < 1e-9)
        );
        assert!((square(cell).width() - 8.0).abs() < 1e-9);
        assert!((square(cell).height() - 8.0).abs() < 1e-9);
    }

    #[test]
    fn the_card_is_centred_with_its_labels_on_it() {
        let center = Point::new(200.0, 30.0);
        let card = Card {
            center,
            ..Card::default()
        };
        let strokes: Vec<Stroke> = card
            .to_passes()
            .unwrap()
            .into_iter()
            .flat_map(|pass| pass.strokes)
            .collect();
        let bounds = bounds_of_strokes(&strokes);
        assert!((bounds.center() - center).length() < 3.0, "{bounds:?}");
        let [deep, wide] = [bounds.width(), bounds.height()];
        assert!(
            (30.0..35.0).contains(&deep) && (53.0..58.0).contains(&wide),
            "{bounds:?}"
        );
        let labels = &card.to_passes().unwrap()[0].strokes;
        // "mm/s", 3 5 8 12 20 30, 1x 2x 3x.
        assert!(labels.len() >= 18, "{}", labels.len());
    }

    #[test]
    fn invalid_settings_of_a_card_are_refused_with_what_is_allowed() {
        let error = |card: Card| card.to_passes().unwrap_err().to_string();
        let card = Card::default;
        assert_eq!(
            error(Card {
                speeds_mm_s: vec![],
                ..card()
            }),
            "the number of speeds of the test card is 0; allowed is a number from 1 to 20"
        );
        assert_eq!(
            error(Card {
                speeds_mm_s: vec![5.0, 3.0],
                ..card()
            }),
            "the order of speeds of the test card is 5 mm/s before 3 mm/s; allowed is rising speeds"
        );
        assert_eq!(
            error(Card {
                most_passes: 0,
                ..card()
            }),
            "the number of passes of the test card is 0; allowed is a number from 1 to 20"
        );
        assert_eq!(
            error(Card {
                cell_mm: f64::NAN,
                ..card()
            }),
            "the cell of the test card is NaN mm; allowed is a number from 3 to 50 mm"
        );
    }
}
