//! Who has control.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Names a client of the station while it is connected.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema,
)]
#[serde(transparent)]
pub struct ClientId(pub u64);

/// Who has control of the arm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LeaseView {
    /// The holder.
    pub client: ClientId,
    /// What the holder calls itself.
    pub name: String,
    /// By which name time slots know the holder: that of its token where this is one person's.
    #[serde(default)]
    pub person: String,
    /// Whether the holder is a program on the raw port, which cannot be asked: an administrator takes
    /// control from it.
    #[serde(default)]
    pub is_program: bool,
    /// Since when, in seconds since the station started.
    pub since_s: f64,
    /// Who asks for control.
    pub asked_by: Vec<Asking>,
}

/// Somebody who asks for control.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Asking {
    /// Who.
    pub client: ClientId,
    /// What it calls itself.
    pub name: String,
}
