//! The reasons for which a controller refuses a command or stops.

use dobot_arm::Unreachable;
use dobot_motion::TrajectoryError;
use dobot_wire::ParseError;

/// The reason for which the controller refused a packet or stopped.
///
/// The protocol cannot report it to the client; the host of a virtual arm shows it.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Refused {
    /// The packet is not part of the protocol, or a value is outside the range of its table.
    #[error("a packet was refused: {0}")]
    Unreadable(ParseError),
    /// The queue was full.
    #[error(
        "a packet was refused: all {QUEUE_LEN} places of the queue are taken; one packet per status is allowed"
    )]
    QueueFull,
    /// The target is unreachable or the path leaves the limits (note N30); the command was not started.
    #[error("a command was refused before it moved: {0}")]
    Trajectory(TrajectoryError),
    /// A voice command has no known word.
    #[error(
        "a voice command was refused: it is none of ahead, back, left, right, up and down with a number word, catch and release"
    )]
    NotUnderstood,
    /// A jog stopped at a limit.
    #[error("a jog stopped at a limit: one tick later {0}")]
    AtLimit(Unreachable),
    /// A gripper jog stopped at the end of its range.
    #[error(
        "a jog stopped at a limit: one tick later the gripper angle would be {found}°; Table 3.7 allows -90 to 90°"
    )]
    GripperAtLimit {
        /// The angle in degrees.
        found: f64,
    },
    /// The last byte of a packet was wrong (note N39).
    #[error(
        "a packet was lost: its last byte is not a packet tail; check that all 42 bytes are sent"
    )]
    BadTail,
    /// The receive buffer held more than one packet (note N39).
    #[error(
        "a packet was lost: the next one followed without a gap while the controller calculated; one packet per status is allowed"
    )]
    TooLong,
    /// The target of a command is out of reach; the stock controller skips it (note N45).
    #[error("a target was skipped: it is out of reach or beyond the joint limits")]
    OutOfReach,
    /// A motion was cut short at a limit; the stock controller continues with the next (note N42).
    #[error("a motion was cut short at a limit; the next command continues from there")]
    CutShort,
    /// The stock controller hangs (note N51).
    #[error("the controller hangs until it is reset: {0}")]
    Hangs(Hang),
    /// The stock controller has lost the pose of the arm (note N51).
    #[error(
        "the controller has lost the arm's pose, which is now NaN; reset it, and send no line without length, no acceleration of 0 and no straight line out of reach"
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

/// The cause of a hang of the stock controller (note N51).
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
    /// State 5 without a preceding text.
    #[error("state 5 was sent as floats; voice is text between B5 and 5B, over Bluetooth")]
    NothingSaid,
    /// The target to follow is the current position.
    #[error("a mouse or gesture packet has no motion; send only packets with motion")]
    NothingToFollow,
    /// A motion that never ends.
    #[error("a motion never ends; speeds, accelerations and percentages of 0 are not allowed")]
    NeverArrives,
}

/// Capacity for commands waiting behind the current one (note N20).
pub(crate) const QUEUE_LEN: usize = 6;
