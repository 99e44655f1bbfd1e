//! Where on the paper: from the sheet into the base frame, and whether the arm gets there.

use std::fmt;

use dobot_arm::Position;
use thiserror::Error;

use crate::pen::Pen;
use crate::plan::Plan;
use crate::point::{Bounds, Point, Stroke};

/// Where drawings go unless told otherwise: 120 mm deep and 200 mm wide, all of it inside reach.
pub const AREA: Bounds = Bounds {
    min: Point::new(150.0, -100.0),
    max: Point::new(270.0, 100.0),
};

/// Where on the paper a drawing goes, and how large.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// The part of the base frame that is for drawing, in mm.
    pub area: Bounds,
    /// How large the drawing becomes.
    pub size: Size,
    /// Where its middle goes, in the base frame; the middle of the area if not given.
    pub center: Option<Point>,
}

impl Placement {
    /// Places strokes of a sheet in the base frame.
    ///
    /// To a person behind the arm, looking forward, the drawing lies upright: its right is -Y and
    /// its down is -X. What counts is the ink, not the page around it.
    ///
    /// # Errors
    ///
    /// [`PlaceError`] where the scale is no number above 0, or the drawing is larger than the area
    /// and neither fitted into it nor sent to a place of its own.
    pub fn place(&self, strokes: &[Stroke]) -> Result<Placed, PlaceError> {
        let ink = Bounds::of_strokes(strokes);
        let scale = self.scale(ink)?;
        let (from, to) = (ink.center(), self.center.unwrap_or(self.area.center()));
        let place = |p: &Point| {
            let way = (*p - from) * scale;
            Point::new(to.x - way.y, to.y - way.x)
        };
        let strokes = strokes.iter().map(|stroke| Stroke {
            points: stroke.points.iter().map(place).collect(),
            closed: stroke.closed,
        });
        Ok(Placed {
            strokes: strokes.collect(),
            scale,
        })
    }

    fn scale(&self, ink: Bounds) -> Result<f64, PlaceError> {
        let (wide, deep) = (self.area.height(), self.area.width());
        let fitting = (wide / ink.width()).min(deep / ink.height());
        let scale = match self.size {
            Size::Scaled(factor) if factor > 0.0 && factor.is_finite() => factor,
            Size::Scaled(factor) => return Err(PlaceError::Scale { factor }),
            Size::Fit if fitting.is_finite() => fitting,
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
}

impl Default for Placement {
    /// True size in the middle of [`AREA`].
    fn default() -> Self {
        Self {
            area: AREA,
            size: Size::True,
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
    /// As large as the area allows, aspect kept.
    Fit,
}

/// Strokes in the base frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    /// What to draw, in mm.
    pub strokes: Vec<Stroke>,
    /// How much larger than the sheet they are.
    pub scale: f64,
}

/// Why a drawing cannot be placed.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PlaceError {
    /// The scale is no number above 0.
    #[error("the scale is {factor}; it must be a number above 0")]
    Scale {
        /// What it is.
        factor: f64,
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
    pen: &Pen,
    reachable: impl Fn(Position) -> Result<(), E>,
) -> Result<(), PlaceError> {
    let mut here = Point::new(plan.start[0], plan.start[1]);
    for [x, y, _] in plan.positions() {
        let there = Point::new(x, y);
        for p in here.steps_to(there, STEP_MM) {
            for z_mm in [pen.down_z_mm, pen.up_z_mm] {
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
    use crate::pen::LinkRate;

    fn line(points: &[(f64, f64)]) -> Stroke {
        Stroke::open(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
    }

    #[test]
    fn right_on_the_sheet_is_to_the_right_of_the_arm_and_down_is_towards_it() {
        let sheet = [line(&[(0.0, 0.0), (20.0, 0.0), (20.0, 10.0)])];
        let placed = Placement::default().place(&sheet).unwrap();
        // The middle of the area is x 210, y 0.
        let expected = line(&[(215.0, 10.0), (215.0, -10.0), (205.0, -10.0)]);
        assert_eq!((placed.strokes, placed.scale), (vec![expected], 1.0));
    }

    #[test]
    fn fitting_scales_up_and_down_and_keeps_the_aspect() {
        let fit = Placement {
            size: Size::Fit,
            ..Placement::default()
        };
        let wide = fit.place(&[line(&[(0.0, 0.0), (400.0, 10.0)])]).unwrap();
        assert_eq!(wide.scale, 0.5);
        let small = fit.place(&[line(&[(0.0, 0.0), (10.0, 10.0)])]).unwrap();
        assert_eq!(small.scale, 12.0);
        assert_eq!(
            Bounds::of_strokes(&small.strokes).min,
            Point::new(150.0, -60.0)
        );
        let dot = fit.place(&[line(&[(7.0, 7.0)])]).unwrap();
        assert_eq!(dot.strokes, [line(&[(210.0, 0.0)])]);
    }

    #[test]
    fn a_drawing_larger_than_the_area_is_refused_with_both_sizes() {
        let error = Placement::default()
            .place(&[line(&[(0.0, 0.0), (400.0, 10.0)])])
            .unwrap_err();
        assert_eq!(
            error.to_string(),
            "the drawing is 400.0 x 10.0 mm and the drawing area 200.0 x 120.0 mm; \
             shrink it into the area with --fit"
        );
    }

    #[test]
    fn a_scale_must_be_a_number_above_0() {
        for factor in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let placement = Placement {
                size: Size::Scaled(factor),
                ..Placement::default()
            };
            let error = placement
                .place(&[line(&[(0.0, 0.0), (4.0, 1.0)])])
                .unwrap_err();
            assert!(error.to_string().starts_with("the scale is "));
        }
    }

    #[test]
    fn a_straight_line_through_the_hole_around_the_base_is_found_out() {
        let pen = Pen::default();
        let ends_fine = [line(&[(0.0, 150.0), (0.0, -150.0)])];
        let plan = Plan::new(&ends_fine, &pen, LinkRate::default()).unwrap();
        let reachable = |p: Position| {
            if p.reach().0 < 129.0 {
                Err("too near")
            } else {
                Ok(())
            }
        };
        let error = check_reach(&plan, &pen, reachable).unwrap_err();
        assert!(
            error
                .to_string()
                .starts_with("the pen would have to go to x 0.0, y 1"),
            "{error}"
        );
        assert!(error.to_string().contains("mm: too near; fit the drawing"));
        check_reach(&plan, &pen, |_| Ok::<(), String>(())).unwrap();
    }
}
