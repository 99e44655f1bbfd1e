//! The position of the paper.

use std::sync::Arc;

use dobot_arm::{Calibration, Plane, Position, Tool};
use dobot_geometry::{HeightMap, Point, least_width};
use thiserror::Error;

/// The paper, as Z of the wrist in the base frame at which the tool works: the pen touches, or the
/// laser is in focus. It is a plane, optionally with a bend.
#[derive(Clone, Debug, PartialEq)]
pub struct Paper {
    plane: Plane,
    /// The height above the plane.
    bent: Option<Arc<HeightMap>>,
    /// The calibration that converts to raw positions, if there is one.
    raw: Option<(Calibration, Tool)>,
}

impl Paper {
    /// Creates level paper.
    #[must_use]
    pub const fn level(z_mm: f64) -> Self {
        Self::sloping(Plane {
            z0_mm: z_mm,
            slope_x: 0.0,
            slope_y: 0.0,
        })
    }

    /// Creates the plane through three touched points, or closest to more of them: X, Y, Z in mm.
    ///
    /// # Errors
    ///
    /// [`PaperError`] if the points lie nearly on one line (seen from above), or the plane is
    /// steeper than 10 degrees.
    pub fn through(touched: &[[f64; 3]]) -> Result<Self, PaperError> {
        let places: Vec<Point> = touched.iter().map(|[x, y, _]| Point::new(*x, *y)).collect();
        let width_mm = if places.len() < 3 {
            0.0
        } else {
            least_width(&places)
        };
        if !(MIN_WIDTH_MM..f64::INFINITY).contains(&width_mm) {
            return Err(PaperError::Collinear(width_mm));
        }
        let plane = nearest(touched);
        let slope_deg = plane.slope_x.hypot(plane.slope_y).atan().to_degrees();
        if slope_deg.is_nan() || slope_deg > STEEPEST_DEG {
            return Err(PaperError::TooSteep(slope_deg));
        }
        Ok(Self::sloping(plane))
    }

    /// Creates paper on a plane.
    #[must_use]
    pub const fn sloping(plane: Plane) -> Self {
        Self {
            plane,
            bent: None,
            raw: None,
        }
    }

    /// Returns the plane.
    #[must_use]
    pub const fn plane(&self) -> Plane {
        self.plane
    }

    /// Adds a height map above the plane.
    #[must_use]
    pub fn bent(self, heights: HeightMap) -> Self {
        Self {
            bent: Some(Arc::new(heights)),
            ..self
        }
    }

    /// Converts the paper to the raw positions of a calibrated arm, in which a plane is curved.
    #[must_use]
    pub fn to_raw(self, arm: Calibration, tool: Tool) -> Self {
        Self {
            raw: Some((arm, tool)),
            ..self
        }
    }

    /// Returns Z of the paper at a place, in mm.
    #[must_use]
    pub fn z_at(&self, place: Point) -> f64 {
        let calibrated_mm = self.calibrated_z(place);
        match &self.raw {
            Some((arm, tool)) => self.raw_z(place, calibrated_mm, arm, *tool),
            None => calibrated_mm,
        }
    }

    /// Whether straight lines of the arm leave the paper: if it is bent, or converted to raw
    /// positions.
    #[must_use]
    pub const fn is_curved(&self) -> bool {
        self.raw.is_some() || self.bent.is_some()
    }

    /// Raises the paper; a negative offset lowers it.
    #[must_use]
    pub fn raised(self, offset_mm: f64) -> Self {
        let z0_mm = self.plane.z0_mm + offset_mm;
        Self {
            plane: Plane {
                z0_mm,
                ..self.plane
            },
            ..self
        }
    }

    /// Returns the height of a place above the paper, in mm.
    #[must_use]
    pub fn height_mm(&self, place: Position) -> f64 {
        place.z.0 - self.z_at(Point::new(place.x.0, place.y.0))
    }

    /// Whether the paper has the same height everywhere.
    #[must_use]
    pub const fn is_level(&self) -> bool {
        self.plane.slope_x == 0.0 && self.plane.slope_y == 0.0 && !self.is_curved()
    }

    /// Returns the raw height at which the calibrated tool is on the paper (Newton's method). If
    /// the arm cannot reach the place, returns the paper's height; the reach check reports it.
    fn raw_z(&self, place: Point, calibrated_mm: f64, arm: &Calibration, tool: Tool) -> f64 {
        let over_mm = |z_mm: f64| {
            let raw = Position::new(place.x, place.y, z_mm);
            let there = arm.true_place(raw, tool).ok()?;
            Some(there.z.0 - self.calibrated_z(Point::new(there.x.0, there.y.0)))
        };
        let mut z_mm = calibrated_mm;
        for _ in 0..ROUNDS {
            let Some((here, above)) = over_mm(z_mm).zip(over_mm(z_mm + STEP_MM)) else {
                return calibrated_mm;
            };
            z_mm -= here * STEP_MM / (above - here);
            if here.abs() < EXACT_MM {
                break;
            }
        }
        if z_mm.is_finite() {
            z_mm
        } else {
            calibrated_mm
        }
    }

    /// Returns the calibrated height at a calibrated place.
    fn calibrated_z(&self, place: Point) -> f64 {
        let bent_mm = self
            .bent
            .as_ref()
            .map_or(0.0, |heights| heights.z_at(place));
        self.plane.z_at([place.x, place.y]) + bent_mm
    }

    pub(super) fn check(&self) -> Result<(), PaperError> {
        let z0_mm = self.plane.z0_mm;
        if z0_mm.is_finite() {
            return Ok(());
        }
        Err(PaperError::Height(z0_mm))
    }
}

impl Default for Paper {
    /// Returns level paper at -40 mm.
    fn default() -> Self {
        Self::level(-40.0)
    }
}

/// The error returned for invalid paper.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PaperError {
    /// The points do not span a plane: the width of their strip, in mm.
    #[error(
        "the touched points lie within {0:.1} mm of one line; touch three corners of the paper, at least 10 mm off the line"
    )]
    Collinear(f64),
    /// The plane is too steep: its slope, in degrees.
    #[error(
        "the paper through the touched points slopes by {0:.1} degrees; at most 10 are allowed; touch them again"
    )]
    TooSteep(f64),
    /// The height, in mm, is not finite.
    #[error("the paper is at {0} mm; it must be a finite number")]
    Height(f64),
}

/// Returns the least-squares plane of points that span one.
fn nearest(touched: &[[f64; 3]]) -> Plane {
    let [mut xx, mut xy, mut yy, mut xz, mut yz] = [0.0; 5];
    #[expect(clippy::cast_precision_loss, reason = "few points")]
    let count = touched.len() as f64;
    let middle = [0, 1, 2].map(|axis| touched.iter().map(|place| place[axis]).sum::<f64>() / count);
    for point in touched {
        let [x, y, z] = [0, 1, 2].map(|axis| point[axis] - middle[axis]);
        xx += x * x;
        xy += x * y;
        yy += y * y;
        xz += x * z;
        yz += y * z;
    }
    let area2 = xx * yy - xy * xy;
    let slope_x = (xz * yy - yz * xy) / area2;
    let slope_y = (yz * xx - xz * xy) / area2;
    Plane {
        z0_mm: middle[2] - slope_x * middle[0] - slope_y * middle[1],
        slope_x,
        slope_y,
    }
}

const ROUNDS: usize = 10;
const STEP_MM: f64 = 1e-3;
const EXACT_MM: f64 = 1e-7;
const MIN_WIDTH_MM: f64 = 10.0;
const STEEPEST_DEG: f64 = 10.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn the_plane_passes_through_the_three_touched_points() {
        let touched = [
            [150.0, -80.0, -41.0],
            [150.0, 80.0, -39.5],
            [270.0, 0.0, -42.0],
        ];
        let paper = Paper::through(&touched).unwrap();
        for [x, y, z] in touched {
            let found = paper.z_at(Point::new(x, y));
            assert!((found - z).abs() < 1e-9, "{found} instead of {z}");
            assert!(paper.height_mm(Position::new(x, y, z + 2.0)) - 2.0 < 1e-9);
        }
        let raised = paper.clone().raised(0.25).z_at(Point::new(150.0, 80.0));
        assert!((raised + 39.25).abs() < 1e-9);
        assert!(!paper.is_level());
    }

    #[test]
    fn collinear_steep_and_invalid_points_are_refused() {
        let on_a_line = [
            [150.0, 0.0, -40.0],
            [200.0, 1.0, -40.0],
            [250.0, 0.0, -40.0],
        ];
        assert_eq!(
            Paper::through(&on_a_line).unwrap_err().to_string(),
            "the touched points lie within 1.0 mm of one line; touch three corners of the \
             paper, at least 10 mm off the line"
        );
        let steep = [
            [150.0, 0.0, -40.0],
            [250.0, 0.0, -20.0],
            [150.0, 50.0, -40.0],
        ];
        assert_eq!(
            Paper::through(&steep).unwrap_err().to_string(),
            "the paper through the touched points slopes by 11.3 degrees; at most 10 are allowed; \
             touch them again"
        );
        assert!(Paper::through(&[[f64::NAN; 3]; 3]).is_err());
    }
}
