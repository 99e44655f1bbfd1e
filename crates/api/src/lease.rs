//! The lease: control of the arm.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The id of a client while it is connected.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema,
)]
#[serde(transparent)]
pub struct ClientId(pub u64);

/// The lease holder.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LeaseView {
    /// The holder.
    pub client: ClientId,
    /// The holder's name.
    pub name: String,
    /// The person the holder counts as for time slots: the name of its token if the token belongs
    /// to a person.
    #[serde(default)]
    pub person: String,
    /// Whether the holder is a program on the raw port, which cannot answer requests: an
    /// administrator can take control from it.
    #[serde(default)]
    pub is_program: bool,
    /// When the holder got it, in seconds since the station started.
    pub since_s: f64,
    /// The clients that ask for control.
    pub asked_by: Vec<ControlRequest>,
}

/// A client that asks for control.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ControlRequest {
    /// The client.
    pub client: ClientId,
    /// The client's name.
    pub name: String,
}
