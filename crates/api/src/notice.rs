//! Notices of events.

use std::fmt;

use dobot_wire::Dialect;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::request::without_fields;
use crate::{ClientId, EpisodeMark, JobPhase, LinkCause, Sense};

/// An event, for all observers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Notice {
    /// Its number, from 1.
    pub number: u64,
    /// The time, in seconds since the station started.
    pub at_s: f64,
    /// The event.
    #[serde(flatten)]
    pub news: News,
    /// The event as one line of text.
    pub text: String,
}

/// What was understood of something that was said.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "what", rename_all = "snake_case", deny_unknown_fields)]
pub enum Heard {
    /// An order. It waits for "go".
    Order {
        /// Its words, as in a voice command.
        #[schemars(length(max = 40))]
        words: String,
    },
    /// "Go": do what was said last.
    #[serde(deserialize_with = "without_fields")]
    Go,
    /// "No": forget what was said last.
    #[serde(deserialize_with = "without_fields")]
    No,
    /// "Stop".
    #[serde(deserialize_with = "without_fields")]
    Stop,
    /// Nothing that is an order.
    #[serde(deserialize_with = "without_fields")]
    Nothing,
}

impl fmt::Display for Heard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Order { words } => write!(f, "{words}; go?"),
            Self::Go => f.write_str("go"),
            Self::No => f.write_str("no"),
            Self::Stop => f.write_str("stop"),
            Self::Nothing => f.write_str("no order was understood"),
        }
    }
}

/// The kinds of events.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum News {
    /// The link to the arm came up.
    LinkUp,
    /// The link to the arm was lost.
    LinkLost,
    /// There is no link to an arm: at the start, after a loss, and when the cause has changed.
    NoLink {
        /// Why.
        cause: LinkCause,
    },
    /// The arm was reset: its pose cannot be trusted.
    Reset,
    /// The pose was confirmed, or the arm was referenced.
    PoseTrusted,
    /// The dialect is now known.
    DialectKnown {
        /// The dialect.
        dialect: Dialect,
    },
    /// A command is done: the arm is at its end.
    CommandDone {
        /// The command number.
        command: u64,
    },
    /// A microphone heard an order, which waits for a confirmation, or a word about it. Nothing
    /// moves because of this notice.
    Heard {
        /// The client that holds a button to talk; absent for the listener's own microphone.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        client: Option<ClientId>,
        /// What was understood.
        heard: Heard,
    },
    /// A command from a sense was accepted.
    Sensed {
        /// The client.
        client: ClientId,
        /// The sense.
        sense: Sense,
        /// The command number.
        command: u64,
    },
    /// A command failed: the arm is not at its end, or the command was never sent.
    CommandFailed {
        /// The command number.
        command: u64,
    },
    /// The arm pauses after a command for five seconds or longer.
    Pausing {
        /// The command number.
        command: u64,
        /// The length of the pause, in seconds.
        lasts_s: f64,
    },
    /// The safety policy has changed.
    PolicyChanged,
    /// A person added a button to the page, or removed one.
    ButtonsChanged,
    /// The calibration of the arm has changed.
    Calibrated,
    /// A request was refused.
    Refused {
        /// The requester.
        client: ClientId,
        /// The kind of refusal, as in problem documents.
        kind: String,
    },
    /// A packet of a raw program was modified before it was sent: a stock arm would have reacted
    /// badly to it, or the policy limits it.
    Amended {
        /// The client of the program.
        client: ClientId,
    },
    /// A client took control.
    LeaseTaken {
        /// The client.
        client: ClientId,
    },
    /// A client asks for control.
    LeaseAsked {
        /// The client.
        client: ClientId,
    },
    /// Control is free.
    LeaseFree,
    /// The arm was stopped.
    Stopped,
    /// The arm came to rest after a stop.
    AtRest,
    /// The stop was cleared; the arm may move again.
    StopReset,
    /// An administrator locked the arm.
    Locked,
    /// The lock was removed: every client may take control again.
    Unlocked,
    /// The time slots have changed or were removed.
    SlotsChanged,
    /// The time slot of a student begins.
    SlotBegan {
        /// The student.
        student: String,
    },
    /// The time slot of a student ends in a minute or less.
    SlotEnding {
        /// The student.
        student: String,
    },
    /// The time slot of a student is over.
    SlotEnded {
        /// The student.
        student: String,
    },
    /// A message from a person to all observers.
    Message {
        /// The sender.
        client: ClientId,
    },
    /// A client marked an episode in the recording.
    EpisodeMarked {
        /// The mark.
        mark: EpisodeMark,
        /// What the arm does, if the client has said so at the beginning.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        task: Option<String>,
    },
    /// The laser was armed: it may be switched on.
    LaserArmed,
    /// The laser was switched off and disarmed.
    LaserDisarmed,
    /// The laser was switched off because it burned, or would have burned, in one place; it stays
    /// armed.
    LaserOff,
    /// A held button was released because its client fell silent.
    DeadMan,
    /// A job changed.
    Job {
        /// The job number.
        job: u64,
        /// Its phase.
        phase: JobPhase,
    },
    /// The running program asks a question.
    JobAsks {
        /// The job number.
        job: u64,
    },
    /// The question of the running program was answered.
    JobAnswered {
        /// The job number.
        job: u64,
    },
    /// A fault of the station itself: recording, journal, or a client that sends too much.
    Trouble,
}
