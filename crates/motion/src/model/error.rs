//! Why a command leads nowhere.

use crate::PlanError;
use dobot_arm::Unreachable;
use dobot_wire::ParseError;

/// Why a command leads nowhere, or to a place that is unknown.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TrajectoryError {
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
    /// Voice, which this arm does not hear.
    #[error(
        "a stock arm hears voice on its Bluetooth port alone (note N50); send the motion or the button that the words mean"
    )]
    NotHeard,
    /// A straight line to where the arm stands, which makes it lose its pose.
    #[error(
        "the arm is there already, and a straight line of no length would make it lose its pose (note N34); leave it out"
    )]
    OnTheSpot,
    /// A mouse or gesture packet that may move nothing, which makes the arm hang.
    #[error(
        "the packet may move nothing, and that would make the arm hang until it is reset (note N51); leave it out, or go further"
    )]
    NothingToFollow,
    /// A motion or a pause of which a stock arm cannot count the ticks.
    #[error(
        "it takes {found} s; a stock arm counts to {MOST_COUNTED_S} s, and goes astray or never ends behind that (note N51); make it shorter"
    )]
    Uncounted {
        /// How long it would take, in seconds.
        found: f64,
    },
    /// A straight line behind one that may have been cut short: it would begin with a jump.
    #[error(
        "a straight line was perhaps tick_stroke short, and the next one would begin with a jump as long as that (note N46); send a MOVJ before it"
    )]
    BehindCutLine,
    /// A vector that a stock arm would never end.
    #[error(
        "the arm might never end this vector, but creep on (note N48): behind the end speed that the vector before left, or that others may have left, its ticks add up to less than none; send a longer vector, or use writing mode"
    )]
    NeverEnds,
    /// A vector behind which the next one would begin backwards.
    #[error(
        "behind this vector the next one would first go back {back_mm:.1} mm (note N48): its ticks end at {left_mm_s:.0} mm/s; use writing mode, or another length"
    )]
    LeavesBackwards {
        /// The speed that it leaves for the next vector, in mm/s: less than nothing.
        left_mm_s: f32,
        /// How far back that one would go at least, in mm.
        back_mm: f32,
    },
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

/// The longest that a motion may take, in seconds: across the whole workspace at 0.2 mm/s, which
/// nobody is slower than on purpose.
pub const LONGEST_S: f64 = 3600.0;
/// How far a stock arm counts in seconds: 32767 ticks of 20 ms, less what rounding and ramps may add.
pub(crate) const MOST_COUNTED_S: f64 = 640.0;
