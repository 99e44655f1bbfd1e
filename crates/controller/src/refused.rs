//! The reasons why a controller does not do what it is told.

use dobot_arm::Unreachable;
use dobot_motion::TrajectoryError;
use dobot_wire::ParseError;

/// Why the controller did not do what a packet says, or stopped.
///
/// Nothing of it travels to the client: the protocol has no word for it. The host of a virtual arm
/// shows it.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Refused {
    /// The packet is not one of the protocol, or breaks a range of its table.
    #[error("a packet was refused: {0}")]
    Unreadable(ParseError),
    /// The queue was full.
    #[error(
        "a packet was refused: all {QUEUE_LEN} places of the queue are taken; one packet per status is allowed"
    )]
    QueueFull,
    /// A command leads nowhere, or its way leaves the limits (note N30); it was not begun.
    #[error("a command was refused before it moved: {0}")]
    Trajectory(TrajectoryError),
    /// No word of a voice command is known.
    #[error(
        "a voice command was refused: it is none of ahead, back, left, right, up and down with a number word, catch and release"
    )]
    NotUnderstood,
    /// A jog came to a limit and stopped there.
    #[error("a jog stopped at a limit: one tick later {0}")]
    AtLimit(Unreachable),
    /// A jog of the gripper came to the end of its range and stopped there.
    #[error(
        "a jog stopped at a limit: one tick later the gripper angle would be {found}°; Table 3.7 allows -90 to 90°"
    )]
    GripperAtLimit {
        /// The angle in degrees.
        found: f64,
    },
    /// The last byte of a packet was wrong (note N39).
    #[error(
        "a packet was lost: its last byte is not that of a packet; check that all 42 bytes are sent"
    )]
    BadTail,
    /// More than a packet was in the receive buffer (note N39).
    #[error(
        "a packet was lost: the next one followed without a gap while the controller calculated; one packet per status is allowed"
    )]
    TooLong,
    /// The target of a command is out of reach; the stock controller skips it (note N45).
    #[error("a target was skipped: it is out of reach or beyond the angles that the arms may have")]
    OutOfReach,
    /// A limit cut a motion short; the stock controller goes on with the next (note N42).
    #[error("a motion was cut short at a limit; the next command goes on from there")]
    CutShort,
    /// The stock controller will do nothing any more (note N51).
    #[error("the controller hangs until it is reset: {0}")]
    Hangs(Hang),
    /// The stock controller does not know any more where the arm is (note N51).
    #[error(
        "the controller has lost the arm's pose, which is not a number any more; reset it, and send no line without length, no acceleration of 0 and no straight way out of reach"
    )]
    PoseLost,
}

impl From<TrajectoryError> for Refused {
    fn from(error: TrajectoryError) -> Self {
        match error {
            TrajectoryError::NotUnderstood => Self::NotUnderstood,
            error => Self::Trajectory(error),
        }
    }
}

/// What makes the stock controller hang (note N51).
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Hang {
    /// An unknown state.
    #[error("state {0} is unknown; 1 to 10 and 15 are allowed")]
    State(i16),
    /// An unknown moving mode.
    #[error("moving mode {0} is unknown; 0, 1 and 2 are allowed")]
    MovingMode(i16),
    /// An unknown axis of a jog.
    #[error("axis {0} of a jog is unknown; 0 to 14 are allowed")]
    JogAxis(i16),
    /// State 5 without a word before.
    #[error("state 5 came in floats; voice is text between B5 and 5B, over Bluetooth")]
    NothingSaid,
    /// A target to be followed where the arm is already.
    #[error("a mouse or gesture packet moves nothing; send only such that do")]
    NothingToFollow,
    /// A motion that takes for ever.
    #[error("a motion never arrives; speeds, accelerations and percentages of 0 are not allowed")]
    NeverArrives,
}

/// Commands that wait behind the one that is executed (note N20).
pub(crate) const QUEUE_LEN: usize = 6;
