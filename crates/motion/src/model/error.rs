//! Errors of commands without a trajectory.

use crate::PlanError;
use dobot_arm::Unreachable;
use dobot_wire::ParseError;

/// The error returned when a command has no valid trajectory.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TrajectoryError {
    /// A value violates a range of its table.
    #[error("{0}")]
    Invalid(ParseError),
    /// The end of the command, or a corner of a JUMP, exceeds the limits of a stock arm.
    #[error("on its way {0}")]
    Unreachable(Unreachable),
    /// The motion cannot be planned.
    #[error("{0}")]
    Unplannable(PlanError),
    /// The speeds are so low that the motion would take hours.
    #[error("the motion takes {found} s; allowed are {LONGEST_S} s")]
    TooSlow {
        /// The duration, in seconds.
        found: f64,
    },
    /// A voice command contains no known word.
    #[error(
        "no word of the voice command is known; allowed are ahead, back, left, right, up and down with a number word, catch and release"
    )]
    NotUnderstood,
    /// This arm does not accept voice commands.
    #[error(
        "a stock arm accepts voice commands only on its Bluetooth port (note N50); send a motion or a button instead"
    )]
    NotHeard,
    /// A straight line to the current position, which makes the arm lose its pose.
    #[error(
        "the arm is there already, and a straight line of length 0 would make it lose its pose (note N34); omit it"
    )]
    OnTheSpot,
    /// A mouse or gesture packet that may move nothing, which makes the arm hang.
    #[error(
        "the packet may move nothing, which makes the arm hang until it is reset (note N51); omit it, or move further"
    )]
    NothingToFollow,
    /// A motion or a pause with too many ticks for a stock arm's counter.
    #[error(
        "the motion takes {found} s; a stock arm counts up to {MAX_COUNTED_S} s, then deviates or never ends (note N51); make it shorter"
    )]
    Uncounted {
        /// The duration, in seconds.
        found: f64,
    },
    /// A straight line after one that may have been cut short: it would begin with a jump.
    #[error(
        "a straight line may have been cut short, and the next one would begin with a jump of that length (note N46); send a MOVJ first"
    )]
    BehindCutLine,
    /// A vector that a stock arm would never finish.
    #[error(
        "the arm might creep along this vector forever (note N48): after the end speed left by the vector before, or possibly by others, its ticks add up to less than zero; send a longer vector, or use writing mode"
    )]
    NeverEnds,
    /// A vector after which the next one would begin backwards.
    #[error(
        "after this vector the next one would first move back {back_mm:.1} mm (note N48): its ticks end at {left_mm_s:.0} mm/s; use writing mode, or another length"
    )]
    LeavesBackwards {
        /// The speed left for the next vector, in mm/s: below zero.
        left_mm_s: f32,
        /// The minimum distance that the next vector would move back, in mm.
        back_mm: f32,
    },
    /// A laser mode vector without the laser that begins at rest, so slow that a stock arm stops
    /// after at most 4 mm.
    #[error(
        "the largest speed is {found} mm/s; from rest and without the laser, laser mode needs at least {least} mm/s at this acceleration, or the vector ends early (note N48); use writing mode"
    )]
    SlowRapid {
        /// The largest speed in mm/s.
        found: f64,
        /// The required speed.
        least: f64,
    },
}

impl From<Unreachable> for TrajectoryError {
    fn from(error: Unreachable) -> Self {
        Self::Unreachable(error)
    }
}

impl From<PlanError> for TrajectoryError {
    fn from(error: PlanError) -> Self {
        Self::Unplannable(error)
    }
}

/// The longest allowed motion, in seconds: across the whole workspace at 0.2 mm/s, slower than any
/// intended motion.
pub const LONGEST_S: f64 = 3600.0;
/// The range of a stock arm's counter, in seconds: 32767 ticks of 20 ms, less a margin for rounding
/// and ramps.
pub(crate) const MAX_COUNTED_S: f64 = 640.0;
