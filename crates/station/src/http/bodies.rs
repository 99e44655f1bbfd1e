//! What bodies of requests hold.

use dobot_api::{ClientId, Jog, LeaseView};
use dobot_wire::{Command, Dialect};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Nothing.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Nothing {}

/// A command to be sent.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct NewCommand {
    /// The command.
    pub(super) command: Command,
    /// Answer when the command is over, instead of as soon as it waits for its turn.
    #[serde(default)]
    pub(super) wait: bool,
}

/// A stop.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct NewStop {
    /// Why, for those who find the arm stopped.
    #[serde(default)]
    pub(super) reason: Option<String>,
}

/// Who wants control.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Wish {
    /// What the client calls itself.
    #[serde(default)]
    #[schemars(length(min = 1, max = 60))]
    pub(super) name: Option<String>,
}

/// Control, or the hope for it.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Granted {
    /// What to send as header `Dobot-Lease` with all requests that go with it.
    pub(super) token: String,
    /// How long the token lasts without being used, in seconds.
    pub(super) lasts_s: u64,
    /// Who has control now, if anybody has.
    pub(super) lease: Option<LeaseView>,
}

/// Who is to get control.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Heir {
    /// One of those who ask.
    pub(super) to: ClientId,
}

/// For how long the laser may be switched on.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Arming {
    /// In seconds.
    #[schemars(range(min = 1.0, max = 3600.0))]
    pub(super) for_s: f64,
}

/// How fast a job is drawn.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Speed {
    /// In percent of the planned speed.
    #[schemars(range(min = 10.0, max = 200.0))]
    pub(super) percent: f64,
}

/// How high a job is drawn.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Height {
    /// How far above the plan, in millimetres; below 0 is lower.
    #[schemars(range(min = -5.0, max = 5.0))]
    pub(super) offset_mm: f64,
}

/// Which dialect the arm speaks.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Speech {
    /// The dialect.
    pub(super) dialect: Dialect,
}

/// A button.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Press {
    /// Which one.
    pub(super) jog: Jog,
}
