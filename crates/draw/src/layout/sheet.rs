//! The sheet of paper to draw on: its size and position.

use std::fmt;
use std::str::FromStr;

use dobot_geometry::{Point, Rect, Vec2};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The size of a sheet: a name such as `a5`, or width and height in mm or inches, as in `210x148` or
/// `5x7in`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "String", into = "String")]
#[schemars(with = "String")]
pub struct PaperSize {
    /// The width, in mm.
    pub width_mm: f64,
    /// The height, in mm.
    pub height_mm: f64,
}

impl PaperSize {
    /// Returns the sheet with its longer side from left to right.
    #[must_use]
    pub fn landscape(self) -> Self {
        Self {
            width_mm: self.width_mm.max(self.height_mm),
            height_mm: self.width_mm.min(self.height_mm),
        }
    }
}

impl FromStr for PaperSize {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let size = |width_mm, height_mm| Self {
            width_mm,
            height_mm,
        };
        let name = text.to_ascii_lowercase();
        if let Some(known) = NAMED.iter().find(|named| named.0 == name) {
            return Ok(size(known.1, known.2));
        }
        let (sides, unit_mm) = match name.strip_suffix("in") {
            Some(inches) => (inches, INCH_MM),
            None => (name.strip_suffix("mm").unwrap_or(&name), 1.0),
        };
        let side_mm = |text: &str| {
            let side: f64 = text.trim().parse().ok()?;
            // Inches have at most three decimal places in mm.
            let side_mm = (side * unit_mm * 1000.0).round() / 1000.0;
            SIDE_MM.contains(&side_mm).then_some(side_mm)
        };
        sides
            .split_once('x')
            .and_then(|(width, height)| Some(size(side_mm(width)?, side_mm(height)?)))
            .ok_or(ALLOWED)
    }
}

impl fmt::Display for PaperSize {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width_mm, self.height_mm)
    }
}

impl From<PaperSize> for String {
    fn from(size: PaperSize) -> Self {
        size.to_string()
    }
}

impl TryFrom<String> for PaperSize {
    type Error = &'static str;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        text.parse()
    }
}

/// A sheet in the base frame.
///
/// ```text
///   corner *-------> right         x forward (up here), y to the left: the sheet as a person behind
///          |                       the arm sees it
///     down v
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SheetPlace {
    /// The size.
    pub size: PaperSize,
    /// The upper left corner, in mm.
    pub corner: Point,
    /// The unit vector to the right.
    right: Vec2,
}

impl SheetPlace {
    /// Places a sheet straight in front of the arm, centred at a point.
    #[must_use]
    pub fn centered(size: PaperSize, middle: Point) -> Self {
        let half = Vec2::new(size.height_mm, size.width_mm) / 2.0;
        Self {
            size,
            corner: middle + half,
            right: Vec2::new(0.0, -1.0),
        }
    }

    /// Places a sheet straight in front of the arm with its lower left corner at a point: the left
    /// one of the corners closest to a person behind the arm.
    #[must_use]
    pub fn from_lower_left(size: PaperSize, lower_left: Point) -> Self {
        Self::along(size, lower_left, Vec2::new(0.0, -1.0))
    }

    /// Places a sheet by touched points: its lower left corner and another point on its lower edge.
    /// `None` if both are equal.
    #[must_use]
    pub fn through(size: PaperSize, lower_left: Point, on_lower_edge: Point) -> Option<Self> {
        let way = on_lower_edge - lower_left;
        let length_mm = way.length();
        (length_mm > 0.0).then(|| Self::along(size, lower_left, way / length_mm))
    }

    fn along(size: PaperSize, lower_left: Point, right: Vec2) -> Self {
        let corner = lower_left - down(right) * size.height_mm;
        Self {
            size,
            corner,
            right,
        }
    }

    /// Converts a point on the sheet, right and down from its upper left corner, to the base frame.
    #[must_use]
    pub fn place(&self, on_sheet: Point) -> Point {
        self.corner + self.right * on_sheet.x + down(self.right) * on_sheet.y
    }

    /// Converts a point in the base frame to the sheet.
    #[must_use]
    pub fn on_sheet(&self, place: Point) -> Point {
        let way = place - self.corner;
        Point::new(way.dot(self.right), way.dot(down(self.right)))
    }

    /// Returns the distance of a point in the base frame beyond the edge, in mm; below 0 on the
    /// sheet.
    #[must_use]
    pub fn beyond_mm(&self, place: Point) -> f64 {
        let Point { x, y } = self.on_sheet(place);
        let PaperSize {
            width_mm,
            height_mm,
        } = self.size;
        [-x, x - width_mm, -y, y - height_mm]
            .into_iter()
            .fold(f64::NEG_INFINITY, f64::max)
    }

    /// Returns the corners in the base frame, in order from the upper left one.
    #[must_use]
    pub fn corners(&self) -> [Point; 4] {
        let PaperSize {
            width_mm: w,
            height_mm: h,
        } = self.size;
        [(0.0, 0.0), (w, 0.0), (w, h), (0.0, h)].map(|corner| self.place(corner.into()))
    }

    /// Returns the sheet reduced by a margin.
    pub(crate) fn without_margin(&self, margin_mm: f64) -> Self {
        let room = self.room(margin_mm);
        Self {
            size: PaperSize {
                width_mm: room.width(),
                height_mm: room.height(),
            },
            corner: self.place(room.origin()),
            ..*self
        }
    }

    /// Returns its sides reduced by a margin, on the sheet.
    pub(crate) fn room(&self, margin_mm: f64) -> Rect {
        let PaperSize {
            width_mm,
            height_mm,
        } = self.size;
        Rect::new(0.0, 0.0, width_mm, height_mm).inflate(-margin_mm, -margin_mm)
    }
}

/// Turns a direction by a quarter clockwise, seen from above.
const fn down(right: Vec2) -> Vec2 {
    Vec2::new(right.y, -right.x)
}

/// Named sizes with width and height.
const NAMED: [(&str, f64, f64); 11] = [
    ("a3", 297.0, 420.0),
    ("a4", 210.0, 297.0),
    ("a5", 148.0, 210.0),
    ("a6", 105.0, 148.0),
    ("a7", 74.0, 105.0),
    ("b5", 176.0, 250.0),
    ("b6", 125.0, 176.0),
    ("letter", 215.9, 279.4),
    ("legal", 215.9, 355.6),
    ("tabloid", 279.4, 431.8),
    // As printers name it; that of Europe is an A6 sheet.
    ("postcard", 100.0, 148.0),
];
const ALLOWED: &str = "allowed are a3, a4, a5, a6, a7, b5, b6, letter, legal, tabloid, postcard, and WIDTHxHEIGHT from 10 to 2000 mm, as in 210x148 or 5x7in";
const INCH_MM: f64 = 25.4;
const SIDE_MM: std::ops::RangeInclusive<f64> = 10.0..=2000.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    fn near(a: Point, b: (f64, f64)) -> bool {
        a.distance(b.into()) < 1e-9
    }

    #[test]
    fn sizes_are_names_or_two_numbers() {
        let a5: PaperSize = "A5".parse().unwrap();
        assert_eq!((a5.width_mm, a5.height_mm), (148.0, 210.0));
        assert_eq!(a5.landscape().to_string(), "210x148");
        assert_eq!(
            "85.5x54".parse::<PaperSize>().unwrap().to_string(),
            "85.5x54"
        );
        for wrong in [
            "", "a9", "10", "5x5", "nanx100", "100x1e9", "0.3x7in", "5x7ft", "in",
        ] {
            assert!(wrong.parse::<PaperSize>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn sizes_in_inches_are_exact_in_millimetres() {
        for (inches, mm) in [
            ("5x7in", "127x177.8"),
            ("8.5 x 11 in", "215.9x279.4"),
            ("4X6IN", "101.6x152.4"),
        ] {
            assert_eq!(inches.parse::<PaperSize>().unwrap().to_string(), mm);
        }
        assert_eq!(
            "210x148mm".parse::<PaperSize>().unwrap().to_string(),
            "210x148"
        );
        assert_eq!("tabloid".parse::<PaperSize>(), "11x17in".parse());
        assert_eq!("letter".parse::<PaperSize>(), "8.5x11in".parse());
    }

    #[test]
    fn every_named_size_is_in_the_error_and_fits_twice_into_the_next_one_of_its_series() {
        let size = |name: &str| name.parse::<PaperSize>().unwrap();
        for (name, ..) in NAMED {
            assert!(ALLOWED.contains(name), "{name}");
        }
        for (larger, smaller) in [
            ("a3", "a4"),
            ("a4", "a5"),
            ("a5", "a6"),
            ("a6", "a7"),
            ("b5", "b6"),
        ] {
            let (larger, smaller) = (size(larger), size(smaller));
            assert_eq!(larger.width_mm, smaller.height_mm);
            assert_eq!((larger.height_mm / 2.0).floor(), smaller.width_mm);
        }
    }

    #[test]
    fn a_sheet_is_upright_for_a_person_behind_the_arm() {
        let size: PaperSize = "200x100".parse().unwrap();
        let sheet = SheetPlace::centered(size, Point::new(210.0, 0.0));
        assert!(near(sheet.place(Point::ORIGIN), (260.0, 100.0)));
        assert!(near(sheet.place(Point::new(200.0, 100.0)), (160.0, -100.0)));
        assert_eq!(
            SheetPlace::from_lower_left(size, Point::new(160.0, 100.0)),
            sheet
        );
        assert_eq!(sheet.beyond_mm(Point::new(265.0, 0.0)), 5.0);
        assert_eq!(sheet.beyond_mm(Point::new(165.0, 0.0)), -5.0);
    }

    #[test]
    fn a_touched_sheet_is_placed_as_it_was_touched() {
        let size: PaperSize = "200x100".parse().unwrap();
        // Its lower edge points away from the arm: up is to the left.
        let [a, b] = [Point::new(100.0, 50.0), Point::new(150.0, 50.0)];
        let sheet = SheetPlace::through(size, a, b).unwrap();
        assert!(near(sheet.place(Point::ORIGIN), (100.0, 150.0)));
        assert!(near(sheet.place(Point::new(200.0, 100.0)), (300.0, 50.0)));
        assert!(SheetPlace::through(size, a, a).is_none());
    }
}
