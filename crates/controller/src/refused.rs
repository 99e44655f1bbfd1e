//! What a controller does not do.

use dobot_arm::Unreachable;
use dobot_motion::PlanError;
use dobot_wire::ParseError;

use crate::plan::LONGEST_S;

/// Why the controller did not do what a packet says, or stopped.
///
/// Nothing of it travels to the client: the protocol has no word for it. The host of a virtual arm
/// shows it.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Refused {
    /// The packet is none of the protocol's, or breaks a range of its table.
    #[error("a packet was refused: {0}")]
    Unreadable(ParseError),
    /// The queue was full.
    #[error(
        "a packet was refused: all {QUEUE_LEN} places of the queue are taken; one packet per status is allowed"
    )]
    QueueFull,
    /// The way of a command leaves the limits (note N30); it was not begun.
    #[error("a command was refused before it moved: on its way {0}")]
    Unreachable(Unreachable),
    /// A command cannot be planned.
    #[error("a command was refused before it moved: {0}")]
    Unplannable(PlanError),
    /// A command asks for speeds so low that it would take hours.
    #[error(
        "a command was refused before it moved: it takes {found} s; a motion is allowed {LONGEST_S} s"
    )]
    TooSlow {
        /// How long it would take, in seconds.
        found: f64,
    },
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
}

/// Commands that wait behind the one that is executed (note N20).
pub(crate) const QUEUE_LEN: usize = 6;
