//! Events of a session.

use std::fmt;
use std::time::Duration;

use dobot_arm::Position;
use dobot_wire::Status;

use crate::{CommandId, LinkError, NoStatus, ResetEvidence, SendError};

/// An event of a session.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Event {
    /// The arm sent its status.
    Status(Status),
    /// A command was sent to the arm.
    Sent(CommandId),
    /// A command has ended: the arm was seen at its target.
    Completed(CommandId),
    /// The arm is at the target of a command and now pauses there for five seconds or longer.
    Pausing {
        /// The command; it ends with its pause.
        command: CommandId,
        /// How long the pause lasts.
        lasts: Duration,
        /// Whether it is the default pause (state 9, mode 1; note N10), and not the command's own.
        by_default: bool,
    },
    /// A command ended, or was abandoned, away from its target.
    NotReached {
        /// The command.
        command: CommandId,
        /// The reason, as far as it is visible.
        reason: NotReached,
        /// Its target.
        expected: Position,
        /// Where the arm is.
        found: Position,
    },
    /// The arm was reset: its pose is not trusted; its settings and all waiting and in-flight commands
    /// are lost. See [`Session::is_trusted`](crate::Session::is_trusted).
    Reset {
        /// The evidence.
        evidence: ResetEvidence,
        /// Number of lost commands.
        forgotten: usize,
    },
    /// An accepted command is discarded before it was sent: it burns and the laser is no longer armed, or an
    /// earlier command missed its target and this one would now trap the arm, or it waited behind such a
    /// command.
    NotSent {
        /// The command.
        command: CommandId,
        /// Why it, or the command before it, is refused now.
        reason: SendError,
    },
    /// The laser was disarmed. Commands that burn are refused until it is armed again.
    LaserDisarmed(Disarmed),
    /// The laser was switched off, because it would have burned without moving, or did.
    LaserOff,
    /// Bytes that belong to no status were skipped, and the decoder found the next status.
    Resynced {
        /// Number of bytes since the last such event.
        skipped: u64,
    },
    /// No status arrived for longer than the in-flight commands explain.
    LinkLost {
        /// The duration of the silence.
        silent_for: Duration,
        /// What arrived instead.
        received: NoStatus,
    },
}

/// Why the laser was disarmed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Disarmed {
    /// The time for which it was armed is over.
    TimeOver,
    /// The arm went silent, or its port was opened again.
    LinkLost,
    /// The arm was reset.
    Reset,
}

impl fmt::Display for Disarmed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::TimeOver => "the time for which it was armed is over",
            Self::LinkLost => "the link to the arm was lost",
            Self::Reset => "the arm was reset",
        })
    }
}

/// Why a command missed its target.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum NotReached {
    /// Its path leaves the limits of the arm, or the arm rests at a limit: it was refused, skipped or stopped
    /// there.
    AtLimit,
    /// The arm rests and no limit explains it.
    Stalled,
    /// The arm still moves, long after the slowest motion would have ended.
    TimedOut,
}

impl fmt::Display for NotReached {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::AtLimit => "it was refused or stopped at a limit",
            Self::Stalled => "it was lost in transmission, or the arm stalled",
            Self::TimedOut => "the arm still moves long after it should have ended",
        })
    }
}

impl Event {
    /// Returns the event, or the error that it stands for.
    ///
    /// # Errors
    ///
    /// [`LinkError::Silent`] for a lost link, [`LinkError::NotReached`] for a missed target,
    /// [`LinkError::Reset`] for a reset, [`LinkError::Send`] for a command that was not sent.
    pub fn or_failed(self) -> Result<Self, LinkError> {
        match self {
            Self::LinkLost {
                silent_for,
                received,
            } => Err(LinkError::Silent {
                silent_for,
                received,
            }),
            Self::NotReached {
                reason,
                expected,
                found,
                ..
            } => Err(LinkError::NotReached {
                reason,
                expected: point(expected),
                found: point(found),
            }),
            Self::Reset { evidence, .. } => Err(LinkError::Reset(evidence)),
            Self::NotSent { reason, .. } => Err(reason.into()),
            event => Ok(event),
        }
    }
}

fn point(position: Position) -> String {
    format!(
        "{:.2}, {:.2}, {:.2} mm",
        position.x.0, position.y.0, position.z.0
    )
}
