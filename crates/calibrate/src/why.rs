//! Errors of a calibration from touches, with what to do.

use thiserror::Error;

/// The error returned when touches do not determine a calibration.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum FitError {
    /// There are too few touches.
    #[error(
        "the number of touches is {found}; a calibration needs at least 4, and 9 for full accuracy; touch more points of the sheet"
    )]
    TooFew {
        /// The number of touches.
        found: usize,
    },
    /// The points lie nearly on a line, seen from above.
    #[error(
        "the touched points lie within {width_mm:.0} mm of one line; at least 60 mm are needed; touch points in all corners of the sheet"
    )]
    InLine {
        /// The width of the strip that holds all points.
        width_mm: f64,
    },
    /// A value of a touch is not finite, or its point is out of range.
    #[error(
        "touch {number} has a point at {x_mm}, {y_mm} mm; allowed are -400 to 400 mm and finite angles; touch it again"
    )]
    NoPlace {
        /// The number of the touch, counted from 1.
        number: usize,
        /// Forward, in mm.
        x_mm: f64,
        /// To the left, in mm.
        y_mm: f64,
    },
    /// The print is scaled.
    #[error(
        "the points fit only a print at {percent:.1} % of its true size; print the sheet at 100 % (\"actual size\"), measure its bar and touch the points again"
    )]
    ScaledPrint {
        /// The size of the print.
        percent: f64,
    },
    /// The base was turned or referenced again between two touches.
    #[error("between touches {last} and {next} the base's zero changes by {deg:.1} degrees; the arm was reset or turned by hand; start again from touch 1", next = last + 1)]
    Reset {
        /// The last touch before the change, counted from 1.
        last: usize,
        /// The change of the base's zero.
        deg: f64,
    },
    /// No calibration within the limits explains the touches.
    #[error(
        "the touches contradict each other by {typical_mm:.1} mm; allowed are {allowed_mm:.1} mm; check that it is the right sheet, that it did not move and that the order is right, and touch the points again"
    )]
    Contradiction {
        /// The typical residual, in mm.
        typical_mm: f64,
        /// The largest typical residual that is accepted.
        allowed_mm: f64,
    },
    /// The result is outside the limits of an arm.
    #[error(
        "the result has {what} of {found:.1} {unit}; an arm has at most {allowed} {unit}; check that it is the right sheet and that it lies in front of the arm as drawn"
    )]
    Beyond {
        /// The parameter.
        what: &'static str,
        /// The fitted value.
        found: f64,
        /// The largest value that an arm can have.
        allowed: f64,
        /// The unit of both values.
        unit: &'static str,
    },
}
