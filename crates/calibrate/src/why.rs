//! Why touches give no calibration, and what to do about it.

use thiserror::Error;

/// Why touches give no calibration.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum FitError {
    /// There are too few.
    #[error(
        "{found} points are touched; a calibration needs 4 at least, and 9 for its full accuracy: touch more points of the sheet"
    )]
    TooFew {
        /// How many there are.
        found: usize,
    },
    /// They lie in a line, seen from above, or nearly so.
    #[error(
        "the touched points lie within {width_mm:.0} mm of one line; allowed are 60 mm and more: touch points in all corners of the sheet"
    )]
    InLine {
        /// How far the points are from the line, both sides together.
        width_mm: f64,
    },
    /// A number of a touch is no number, or no place on paper in front of the arm.
    #[error(
        "touch {number} is not a place that an arm can touch: its point is at {x_mm} and {y_mm} mm, and allowed are -400 to 400 mm: touch it again"
    )]
    NoPlace {
        /// The number of the touch, counted from 1.
        number: usize,
        /// Forward, in mm.
        x_mm: f64,
        /// To the left, in mm.
        y_mm: f64,
    },
    /// The print is too large or too small.
    #[error(
        "the points fit only if the print is {percent:.1} % of its true size: print the sheet at 100 % (\"actual size\") and measure its bar, then touch the points again"
    )]
    ScaledPrint {
        /// How large the print is.
        percent: f64,
    },
    /// The base was turned, or counted anew, between two touches.
    #[error("up to touch {last} and from touch {next} on the base's zero differs by {deg:.1} degrees: the arm was reset or turned by hand there; begin anew from touch 1", next = last + 1)]
    Reset {
        /// The last touch before it, counted from 1.
        last: usize,
        /// By how much the base's zero differs.
        deg: f64,
    },
    /// Nothing that an arm can have explains the touches.
    #[error(
        "the touches contradict each other by {typical_mm:.1} mm, and allowed are {allowed_mm:.1} mm: is it the right sheet, did it move, were all points touched in their order? Touch them again"
    )]
    Contradiction {
        /// The typical residual, in mm.
        typical_mm: f64,
        /// The largest typical residual that is believed.
        allowed_mm: f64,
    },
    /// The result is nothing that an arm can have.
    #[error(
        "the result has {what} of {found:.1} {unit}; an arm can have at most {allowed} {unit}: is it the right sheet, and does it lie in front of the arm as drawn?"
    )]
    Beyond {
        /// What of the arm.
        what: &'static str,
        /// What the touches say.
        found: f64,
        /// The most that an arm can have.
        allowed: f64,
        /// The unit of both.
        unit: &'static str,
    },
}
