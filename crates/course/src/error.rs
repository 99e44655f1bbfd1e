//! Why a command leads nowhere.

use dobot_arm::Unreachable;
use dobot_motion::PlanError;
use dobot_wire::ParseError;

/// Why a command leads nowhere, or to where nobody knows.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CourseError {
    /// A value breaks a range of its table.
    #[error("{0}")]
    Invalid(ParseError),
    /// The end of the command, or a corner of a JUMP, is beyond the limits of a stock arm.
    #[error("on its way {0}")]
    Unreachable(Unreachable),
    /// The motion cannot be planned.
    #[error("{0}")]
    Unplannable(PlanError),
    /// The speeds are so low that it would take hours.
    #[error("it takes {found} s; a motion is allowed {LONGEST_S} s")]
    TooSlow {
        /// How long it would take, in seconds.
        found: f64,
    },
    /// No word of a voice command is known.
    #[error(
        "the voice command is none of ahead, back, left, right, up and down with a number word, catch and release"
    )]
    NotUnderstood,
    /// A straight line to where the arm stands, which makes it lose its pose.
    #[error(
        "the arm is there already, and a straight line of no length would make it lose its pose (note N34); leave it out"
    )]
    OnTheSpot,
    /// A mouse or gesture packet that moves nothing, which makes the arm hang.
    #[error(
        "the packet moves nothing, and that would make the arm hang until it is reset (note N51); leave it out"
    )]
    NothingToFollow,
    /// A vector of laser mode without the laser that begins at rest, so slow that a stock arm goes
    /// 4 mm at most and calls it done.
    #[error(
        "the largest speed is {found} mm/s; from rest and without the laser, laser mode needs {least} mm/s at least at this acceleration, or the vector ends early (note N48); use writing mode"
    )]
    SlowRapid {
        /// The largest speed in mm/s.
        found: f64,
        /// What it has to be at least, in mm/s.
        least: f64,
    },
}

impl From<Unreachable> for CourseError {
    fn from(error: Unreachable) -> Self {
        Self::Unreachable(error)
    }
}

impl From<PlanError> for CourseError {
    fn from(error: PlanError) -> Self {
        Self::Unplannable(error)
    }
}

/// The longest that a motion may take, in seconds: across the whole workspace at 0.2 mm/s, which
/// nobody is slower than on purpose.
pub const LONGEST_S: f64 = 3600.0;
