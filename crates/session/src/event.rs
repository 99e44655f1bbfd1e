//! What happens in a session.

use std::fmt;
use std::time::Duration;

use dobot_arm::Position;
use dobot_wire::Status;

use crate::{CommandId, LinkError, ResetEvidence, SendError};

/// What happened in a session.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Event {
    /// The arm told its state.
    Status(Status),
    /// A command left for the arm.
    Sent(CommandId),
    /// A command is over: the arm was seen where it leads.
    Completed(CommandId),
    /// The arm is where a command leads, and now pauses there for five seconds or longer.
    Pausing {
        /// The command; it is over when its pause is.
        command: CommandId,
        /// How long the pause lasts.
        lasts: Duration,
        /// Whether it is the default pause (state 9, mode 1; note N10), and not the command's own.
        by_default: bool,
    },
    /// A command is over, or given up, elsewhere than it leads.
    NotReached {
        /// The command.
        command: CommandId,
        /// Why, as far as it shows.
        reason: NotReached,
        /// Where it leads.
        expected: Position,
        /// Where the arm is.
        found: Position,
    },
    /// The arm was reset: its pose is not to be trusted, what it was told is forgotten, and so are
    /// the commands that were under way or waited. See [`Session::is_trusted`](crate::Session::is_trusted).
    Reset {
        /// What shows it.
        evidence: ResetEvidence,
        /// How many commands are forgotten.
        forgotten: usize,
    },
    /// A command that was taken is forgotten before it could be sent: it burns and the laser's time is
    /// over, or what was before it ended elsewhere and it would be a trap by now; or it waited behind
    /// such a one.
    NotSent {
        /// The command.
        command: CommandId,
        /// Why it, or the one that it waited behind, would be refused now.
        reason: SendError,
    },
    /// The laser's time is over, or its arm was reset or lost: what burns is refused until it is armed
    /// anew.
    LaserDisarmed(Disarmed),
    /// The laser was switched off, because it would have burned on the spot, or did.
    LaserOff,
    /// Bytes that belong to no status were skipped, and the stream of statuses was found again.
    Resynced {
        /// How many bytes since the last such event.
        skipped: u64,
    },
    /// No status came for longer than any command under way explains.
    LinkLost {
        /// How long.
        silent_for: Duration,
        /// Bytes that came all the same, but in no status.
        noise: u64,
    },
}

/// Why the laser is not armed any more.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Disarmed {
    /// The time for which it was armed is over.
    TimeOver,
    /// The arm fell silent, or its port was opened again.
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

/// Why a command did not end where it leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum NotReached {
    /// Its way leaves the limits of the arm, or the arm rests at one: it was refused, skipped or
    /// stopped there.
    AtLimit,
    /// The arm rests although nothing is in its way that the client knows of.
    Stalled,
    /// The arm still moves, long after the slowest motion would have been over.
    TimedOut,
}

impl fmt::Display for NotReached {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::AtLimit => "it was refused or stopped at a limit",
            Self::Stalled => "it was lost on its way, or the arm stalled",
            Self::TimedOut => "it is not over long after it should be",
        })
    }
}

impl Event {
    /// The event, or the failure that it is.
    ///
    /// # Errors
    ///
    /// [`LinkError::Silent`] for a lost link, [`LinkError::NotReached`] for a move that fell short,
    /// [`LinkError::Reset`] for an arm that was reset, [`LinkError::Send`] for a command that was not
    /// sent.
    pub fn or_failed(self) -> Result<Self, LinkError> {
        match self {
            Self::LinkLost { silent_for, noise } => Err(LinkError::Silent { silent_for, noise }),
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
