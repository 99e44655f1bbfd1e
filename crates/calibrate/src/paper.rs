//! The plane and the bend of the paper, from touched positions.

use dobot_api::PaperPlane;
use dobot_geometry::{HeightMap, Point};
use dobot_plan::{Paper, PaperError};
use thiserror::Error;

/// The paper and how well its touches agree.
#[derive(Clone, Debug, PartialEq)]
pub struct TouchedPaper {
    /// The paper: flat for three touches, otherwise bent through all of them.
    pub paper: PaperPlane,
    /// The height of each touch above the plane, in mm.
    pub away_mm: Vec<f64>,
    /// The slope of the plane, in degrees.
    pub slope_deg: f64,
}

impl TouchedPaper {
    /// Returns the height difference between the lowest and the highest touch, relative to the
    /// plane, in mm.
    #[must_use]
    pub fn bent_mm(&self) -> f64 {
        let least = self.away_mm.iter().copied().fold(0.0, f64::min);
        self.away_mm.iter().copied().fold(0.0, f64::max) - least
    }
}

/// Fits the paper to touched positions in the calibrated frame: X, Y, Z in mm.
///
/// # Errors
///
/// [`PaperTouchError`] if the touches do not determine the paper.
pub fn paper(touched: &[[f64; 3]]) -> Result<TouchedPaper, PaperTouchError> {
    if touched.len() < MIN_TOUCHES {
        return Err(PaperTouchError::TooFew(touched.len()));
    }
    let mut places = (1..).zip(touched);
    if let Some((number, _)) = places.find(|(_, place)| place.iter().any(|v| !v.is_finite())) {
        return Err(PaperTouchError::NoPlace(number));
    }
    if let Some((first, second)) = same_place(touched) {
        return Err(PaperTouchError::SamePlace(first, second));
    }
    let plane = Paper::through(touched)?.plane();
    let higher = |&[x_mm, y_mm, z_mm]: &[f64; 3]| z_mm - plane.z_at([x_mm, y_mm]);
    let away_mm: Vec<f64> = touched.iter().map(higher).collect();
    let farthest = (1..)
        .zip(&away_mm)
        .max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    if let Some((number, &away_mm)) = farthest.filter(|touch| touch.1.abs() > MAX_BENT_MM) {
        return Err(PaperTouchError::NoPaper { number, away_mm });
    }
    let heights: Vec<[f64; 3]> = if touched.len() > MIN_TOUCHES {
        let bent = touched.iter().zip(&away_mm);
        bent.map(|([x_mm, y_mm, _], away_mm)| [*x_mm, *y_mm, *away_mm])
            .collect()
    } else {
        Vec::new()
    };
    if !heights.is_empty() && HeightMap::through(&heights).is_none() {
        return Err(PaperError::Collinear(0.0).into());
    }
    Ok(TouchedPaper {
        slope_deg: plane.slope_x.hypot(plane.slope_y).atan().to_degrees(),
        paper: PaperPlane {
            z_mm: plane.z0_mm,
            slope_x: plane.slope_x,
            slope_y: plane.slope_y,
            heights,
        },
        away_mm,
    })
}

/// Returns two touches at the same position, counted from 1.
fn same_place(touched: &[[f64; 3]]) -> Option<(usize, usize)> {
    let place = |&[x_mm, y_mm, _]: &[f64; 3]| Point::new(x_mm, y_mm);
    (0..touched.len()).find_map(|second| {
        let near = |other: &[f64; 3]| place(other).distance(place(&touched[second])) < MIN_APART_MM;
        let first = touched[..second].iter().position(near)?;
        Some((first + 1, second + 1))
    })
}

/// The error returned when touches do not determine the paper, with what to do.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PaperTouchError {
    /// There are too few touches.
    #[error(
        "the number of touches is {0}; a plane needs 3, bent paper 9 or more; touch more places of the paper"
    )]
    TooFew(usize),
    /// The coordinates of a touch are not finite; its number is counted from 1.
    #[error("touch {0} has a coordinate that is not finite; x, y and z must be finite")]
    NoPlace(usize),
    /// Two touches are at nearly the same position, counted from 1.
    #[error("touches {0} and {1} are less than 5 mm apart; touch places farther apart")]
    SamePlace(usize, usize),
    /// The touches span no plane, or one that is too steep.
    #[error(transparent)]
    Plane(#[from] PaperError),
    /// A touch is too far from the common plane.
    #[error(
        "touch {number} is {away_mm:.1} mm from the plane of all touches; allowed are {MAX_BENT_MM} mm; touch it again"
    )]
    NoPaper {
        /// The number of the touch, counted from 1.
        number: usize,
        /// Its height above the plane, in mm.
        away_mm: f64,
    },
}

const MIN_TOUCHES: usize = 3;
const MIN_APART_MM: f64 = 5.0;
/// Paper on a table does not bend more than this.
const MAX_BENT_MM: f64 = 3.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use crate::SHEET_POINTS;

    #[test]
    fn three_touches_define_a_plane_and_more_its_bend() {
        let board = |[x, y]: [f64; 2]| -42.0 + 0.01 * x - 0.02 * y + (y / 100.0).powi(2);
        let touched = SHEET_POINTS.map(|[x, y]| [x, y, board([x, y])]);
        let flat = paper(&touched[..3]).unwrap();
        assert!(flat.paper.heights.is_empty());
        assert!(flat.away_mm.iter().all(|mm| mm.abs() < 1e-9));
        let bent = paper(&touched).unwrap();
        assert!((bent.bent_mm() - 1.0).abs() < 1e-9, "{}", bent.bent_mm());
        // No touch is below its table.
        for [x, y, z] in touched {
            assert!(bent.paper.table().z_at([x, y]) < z + 1e-9);
        }
    }

    #[test]
    fn touches_that_define_no_paper_are_refused_with_a_remedy() {
        let mut touched = SHEET_POINTS.map(|[x, y]| [x, y, -42.0]);
        touched[4][2] = -30.0;
        let refused = |touched: &[[f64; 3]]| paper(touched).unwrap_err().to_string();
        assert!(
            refused(&touched).starts_with("touch 5 is "),
            "{}",
            refused(&touched)
        );
        assert!(refused(&touched[..2]).starts_with("the number of touches is 2; a plane needs 3"));
        let twice = [touched[0], touched[1], touched[0], touched[2]];
        assert!(refused(&twice).starts_with("touches 1 and 3 are less than 5 mm apart"));
        let line = [touched[0], touched[5], touched[6]];
        assert!(refused(&line).contains("of one line"), "{}", refused(&line));
        assert!(refused(&[[f64::NAN; 3]; 3]).starts_with("touch 1 has a coordinate"));
    }
}
