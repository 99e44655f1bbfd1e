//! What happened.

use dobot_wire::Dialect;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{ClientId, JobPhase};

/// Something that happened, for all who watch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Notice {
    /// Its number, from 1.
    pub number: u64,
    /// When, in seconds since the station started.
    pub at_s: f64,
    /// What.
    #[serde(flatten)]
    pub news: News,
    /// The same for a person, in one line.
    pub text: String,
}

/// What can happen.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum News {
    /// The link to the arm came up.
    LinkUp,
    /// The link to the arm was lost.
    LinkLost,
    /// The arm was reset: its pose cannot be trusted.
    Reset,
    /// A person confirmed the pose, or the arm was referenced.
    PoseTrusted,
    /// The dialect is known now.
    DialectKnown {
        /// The dialect.
        dialect: Dialect,
    },
    /// A command is over: the arm is where it leads.
    CommandDone {
        /// Its number.
        command: u64,
    },
    /// A command is over, but the arm is not where it leads, or it was never sent.
    CommandFailed {
        /// Its number.
        command: u64,
    },
    /// The arm stands where a command leads, and pauses there for five seconds or longer.
    Pausing {
        /// The number of the command.
        command: u64,
        /// How long, in seconds.
        lasts_s: f64,
    },
    /// The safety policy is another one from now on.
    PolicyChanged,
    /// Another calibration of the arm holds.
    Calibrated,
    /// Something that a client asked for was refused.
    Refused {
        /// Who asked.
        client: ClientId,
        /// The kind of refusal, as in the problem documents.
        kind: String,
    },
    /// A packet of a raw program was sent otherwise than it said: a stock arm would have taken it
    /// harmlessly, or the policy has a ceiling for it.
    Amended {
        /// Who.
        client: ClientId,
    },
    /// Somebody took control.
    LeaseTaken {
        /// Who.
        client: ClientId,
    },
    /// Somebody asks for control.
    LeaseAsked {
        /// Who.
        client: ClientId,
    },
    /// Control is free.
    LeaseFree,
    /// The arm was stopped.
    Stopped,
    /// The arm came to rest after a stop.
    AtRest,
    /// A person let the arm move again.
    StopReset,
    /// An administrator keeps the arm.
    Locked,
    /// Everyone may take control of the arm again.
    Unlocked,
    /// Other time slots hold from now on, or none.
    SlotsChanged,
    /// The time of a student at the arm begins.
    SlotBegan {
        /// Who.
        student: String,
    },
    /// The time of a student at the arm is over in a minute, or sooner.
    SlotEnding {
        /// Who.
        student: String,
    },
    /// The time of a student at the arm is over.
    SlotEnded {
        /// Who.
        student: String,
    },
    /// A person tells something to all who watch.
    Message {
        /// Who.
        client: ClientId,
    },
    /// The laser may be switched on.
    LaserArmed,
    /// The laser was switched off and stays so.
    LaserDisarmed,
    /// The laser was switched off, because it would have burned on the spot, or did; it stays armed.
    LaserOff,
    /// A held button was let go because its client fell silent.
    DeadMan,
    /// A job changed.
    Job {
        /// Its number.
        job: u64,
        /// How far it is now.
        phase: JobPhase,
    },
    /// Something of the station itself goes wrong: recording, journal, a flooding client.
    Trouble,
}
