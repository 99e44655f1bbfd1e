//! Where on the paper: from the sheet into the base frame, and whether the arm gets there.

use std::fmt;

use dobot_arm::Position;
use dobot_geometry::{Point, Rect, Vec2, bounds, direction, steps};
use dobot_plan::{Paper, Plan};
use dobot_source::{Artwork, Layer};
use thiserror::Error;

/// Where drawings go unless told otherwise: 120 mm deep and 200 mm wide, all of it inside reach.
pub const AREA: Rect = Rect::new(150.0, -100.0, 270.0, 100.0);

/// Where on the paper a drawing goes, and how large.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// The part of the base frame that is for drawing, in mm.
    pub area: Rect,
    /// How much of the area stays empty along its edges, in mm, from 0 up.
    pub margin_mm: f64,
    /// How large the drawing becomes.
    pub size: Size,
    /// Turns the drawing on the paper, counterclockwise, in degrees.
    pub rotate_deg: f64,
    /// Where its middle goes, in the base frame; the middle of the area if not given.
    pub center: Option<Point>,
}

impl Placement {
    /// Places what is on a page in the base frame.
    ///
    /// To a person behind the arm, looking forward, the drawing lies upright: its right is -Y and
    /// its down is -X. What counts is the ink, not the page around it.
    ///
    /// # Errors
    ///
    /// [`PlaceError`] where a setting is not a number or out of range, or the drawing is larger than
    /// the area and neither fitted into it nor sent to a place of its own.
    pub fn place(&self, artwork: Artwork) -> Result<Placed, PlaceError> {
        let turn = self.turn()?;
        let turned = |p: Point| p.to_vec2().rotate_scale(turn).to_point();
        let ink = bounds(artwork.points().map(turned));
        let scale = self.scale(ink)?;
        let (from, to) = (ink.center(), self.center.unwrap_or(self.area.center()));
        let place = |p: &mut Point| {
            let way = (turned(*p) - from) * scale;
            *p = Point::new(to.x - way.y, to.y - way.x);
        };
        let mut layers = artwork.layers;
        layers
            .iter_mut()
            .flat_map(Layer::points_mut)
            .for_each(place);
        Ok(Placed { layers, scale })
    }

    /// Where the drawing's right points on the page, where y points down.
    fn turn(&self) -> Result<Vec2, PlaceError> {
        if !self.rotate_deg.is_finite() {
            return Err(PlaceError::Rotate(self.rotate_deg));
        }
        Ok(direction(-self.rotate_deg))
    }

    fn scale(&self, ink: Rect) -> Result<f64, PlaceError> {
        let [wide, deep] = self.room()?;
        let fitting = (wide / ink.width()).min(deep / ink.height());
        let scale = match self.size {
            Size::Scaled(factor) if factor > 0.0 && factor.is_finite() => factor,
            Size::Scaled(factor) => return Err(PlaceError::Scale(factor)),
            Size::Fit if fitting.is_finite() => fitting,
            Size::Within => fitting.min(1.0),
            // A dot fits as it is.
            Size::Fit | Size::True => 1.0,
        };
        if scale > fitting * (1.0 + 1e-9) && self.center.is_none() {
            return Err(PlaceError::TooLarge {
                width_mm: ink.width() * scale,
                height_mm: ink.height() * scale,
                area_width_mm: wide,
                area_height_mm: deep,
            });
        }
        Ok(scale)
    }

    /// Width and depth of the area without its margins.
    fn room(&self) -> Result<[f64; 2], PlaceError> {
        let margin_mm = self.margin_mm;
        let [wide, deep] = [self.area.height(), self.area.width()].map(|it| it - 2.0 * margin_mm);
        if margin_mm >= 0.0 && wide > 0.0 && deep > 0.0 {
            return Ok([wide, deep]);
        }
        let most_mm = self.area.height().min(self.area.width()) / 2.0;
        Err(PlaceError::Margin { margin_mm, most_mm })
    }
}

impl Default for Placement {
    /// True size, upright in the middle of [`AREA`], without margins.
    fn default() -> Self {
        Self {
            area: AREA,
            margin_mm: 0.0,
            size: Size::True,
            rotate_deg: 0.0,
            center: None,
        }
    }
}

/// How large a drawing becomes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Size {
    /// As the file says: a millimetre is a millimetre.
    True,
    /// The true size times a factor above 0.
    Scaled(f64),
    /// As the file says, or as large as the area allows where that is less.
    Within,
    /// As large as the area allows, aspect kept.
    Fit,
}

/// Layers in the base frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    /// What to draw, in mm.
    pub layers: Vec<Layer>,
    /// How much larger than on the page they are.
    pub scale: f64,
}

/// Why a drawing cannot be placed.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PlaceError {
    /// The scale is not a number above 0.
    #[error("the scale is {0}; it must be a number above 0")]
    Scale(f64),
    /// The turn, in degrees, is not a number.
    #[error("the drawing is turned by {0} degrees; it must be a number")]
    Rotate(f64),
    /// The margin leaves no room.
    #[error("the margin is {margin_mm} mm; it must be from 0 to below {most_mm} mm")]
    Margin {
        /// What it is.
        margin_mm: f64,
        /// What leaves no room at all.
        most_mm: f64,
    },
    /// The drawing is larger than the area.
    #[error(
        "the drawing is {width_mm:.1} x {height_mm:.1} mm and the drawing area {area_width_mm:.1} x {area_height_mm:.1} mm; shrink it into the area with --fit"
    )]
    TooLarge {
        /// The drawing, left to right.
        width_mm: f64,
        /// The drawing, top to bottom.
        height_mm: f64,
        /// The area, left to right (along Y).
        area_width_mm: f64,
        /// The area, top to bottom (along X).
        area_height_mm: f64,
    },
    /// A point where the arm does not get.
    #[error(
        "the pen would have to go to x {x_mm:.1}, y {y_mm:.1}, z {z_mm:.1} mm: {reason}; fit the drawing into the area with --fit, or place it elsewhere"
    )]
    OutOfReach {
        /// Forward, in the base frame.
        x_mm: f64,
        /// To the left.
        y_mm: f64,
        /// Up.
        z_mm: f64,
        /// Which limit of the arm says so.
        reason: String,
    },
}

/// Checks every place of a plan, at most 2 mm apart, with the pen down and with the pen up: a
/// drawing that is broken off anywhere must be able to lift it there.
///
/// # Errors
///
/// [`PlaceError::OutOfReach`] with the first place that `reachable` refuses, and its reason.
pub fn check_reach<E: fmt::Display>(
    plan: &Plan,
    paper: &Paper,
    reachable: impl Fn(Position) -> Result<(), E>,
) -> Result<(), PlaceError> {
    let mut here = Point::new(plan.start[0], plan.start[1]);
    let lift_mm = plan.lift_mm();
    for [x, y, _] in plan.positions() {
        let there = Point::new(x, y);
        for p in steps(here, there, STEP_MM) {
            let down_mm = paper.z_at(p);
            for z_mm in [down_mm, down_mm + lift_mm] {
                let place = Position::new(p.x, p.y, z_mm);
                reachable(place).map_err(|reason| PlaceError::OutOfReach {
                    x_mm: p.x,
                    y_mm: p.y,
                    z_mm,
                    reason: reason.to_string(),
                })?;
            }
        }
        here = there;
    }
    Ok(())
}

const STEP_MM: f64 = 2.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use dobot_geometry::{Stroke, bounds_of_strokes};
    use dobot_plan::{DrawingTool, Machine, Pass};

    fn place(placement: &Placement, stroke: Stroke) -> Result<(Vec<Stroke>, f64), PlaceError> {
        let layer = Layer {
            strokes: vec![stroke],
            ..Layer::default()
        };
        let artwork = Artwork {
            layers: vec![layer],
            ..Artwork::default()
        };
        let placed = placement.place(artwork)?;
        Ok((placed.layers[0].strokes.clone(), placed.scale))
    }

    fn line(points: &[(f64, f64)]) -> Stroke {
        Stroke::open(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
    }

    #[test]
    fn right_on_the_sheet_is_to_the_right_of_the_arm_and_down_is_towards_it() {
        let sheet = line(&[(0.0, 0.0), (20.0, 0.0), (20.0, 10.0)]);
        let placed = place(&Placement::default(), sheet).unwrap();
        // The middle of the area is x 210, y 0.
        let expected = line(&[(215.0, 10.0), (215.0, -10.0), (205.0, -10.0)]);
        assert_eq!(placed, (vec![expected], 1.0));
    }

    #[test]
    fn fitting_scales_up_and_down_and_keeps_the_aspect() {
        let fit = Placement {
            size: Size::Fit,
            ..Placement::default()
        };
        let wide = place(&fit, line(&[(0.0, 0.0), (400.0, 10.0)])).unwrap();
        assert_eq!(wide.1, 0.5);
        let small = place(&fit, line(&[(0.0, 0.0), (10.0, 10.0)])).unwrap();
        assert_eq!(small.1, 12.0);
        assert_eq!(
            bounds_of_strokes(&small.0).origin(),
            Point::new(150.0, -60.0)
        );
        let dot = place(&fit, line(&[(7.0, 7.0)])).unwrap();
        assert_eq!(dot.0, [line(&[(210.0, 0.0)])]);
    }

    #[test]
    fn what_is_to_stay_within_the_area_shrinks_but_never_grows() {
        let within = Placement {
            size: Size::Within,
            ..Placement::default()
        };
        for (width, scale) in [(400.0, 0.5), (100.0, 1.0)] {
            let placed = place(&within, line(&[(0.0, 0.0), (width, 10.0)])).unwrap();
            assert_eq!(placed.1, scale);
        }
    }

    #[test]
    fn a_drawing_larger_than_the_area_is_refused_with_both_sizes() {
        let wide = line(&[(0.0, 0.0), (400.0, 10.0)]);
        let error = place(&Placement::default(), wide).unwrap_err();
        assert_eq!(
            error.to_string(),
            "the drawing is 400.0 x 10.0 mm and the drawing area 200.0 x 120.0 mm; \
             shrink it into the area with --fit"
        );
    }

    #[test]
    fn a_quarter_turn_counterclockwise_makes_right_up() {
        let turned = Placement {
            rotate_deg: 90.0,
            ..Placement::default()
        };
        // Up on the paper is away from the arm: +X.
        let (strokes, _) = place(&turned, line(&[(0.0, 0.0), (20.0, 0.0)])).unwrap();
        assert_eq!(strokes, [line(&[(200.0, 0.0), (220.0, 0.0)])]);
        let endless = Placement {
            rotate_deg: f64::INFINITY,
            ..Placement::default()
        };
        let error = place(&endless, line(&[(0.0, 0.0), (20.0, 0.0)])).unwrap_err();
        assert_eq!(
            error.to_string(),
            "the drawing is turned by inf degrees; it must be a number"
        );
    }

    #[test]
    fn a_margin_stays_empty_and_must_leave_room() {
        let within = |margin_mm| Placement {
            margin_mm,
            size: Size::Fit,
            ..Placement::default()
        };
        let square = || line(&[(0.0, 0.0), (10.0, 10.0)]);
        let (strokes, scale) = place(&within(10.0), square()).unwrap();
        assert_eq!(scale, 10.0);
        assert_eq!(
            bounds_of_strokes(&strokes).origin(),
            Point::new(160.0, -50.0)
        );
        for margin_mm in [-1.0, 60.0, f64::NAN] {
            let error = place(&within(margin_mm), square()).unwrap_err();
            let told = format!("the margin is {margin_mm} mm; it must be from 0 to below 60 mm");
            assert_eq!(error.to_string(), told);
        }
    }

    #[test]
    fn a_scale_must_be_a_number_above_0() {
        for factor in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let placement = Placement {
                size: Size::Scaled(factor),
                ..Placement::default()
            };
            let error = place(&placement, line(&[(0.0, 0.0), (4.0, 1.0)])).unwrap_err();
            assert!(error.to_string().starts_with("the scale is "));
        }
    }

    #[test]
    fn a_straight_line_through_the_hole_around_the_base_is_found_out() {
        let paper = Paper::default();
        let ends_fine = [line(&[(0.0, 150.0), (0.0, -150.0)])];
        let pass = Pass::new(DrawingTool::default(), ends_fine.to_vec());
        let plan = Plan::new(&[pass], &paper, &Machine::default()).unwrap();
        let reachable = |p: Position| {
            if p.reach().0 < 129.0 {
                Err("too near")
            } else {
                Ok(())
            }
        };
        let error = check_reach(&plan, &paper, reachable).unwrap_err();
        assert!(
            error
                .to_string()
                .starts_with("the pen would have to go to x 0.0, y 1"),
            "{error}"
        );
        assert!(error.to_string().contains("mm: too near; fit the drawing"));
        check_reach(&plan, &paper, |_| Ok::<(), String>(())).unwrap();
    }
}
