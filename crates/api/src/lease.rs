//! The lease: control of the arm.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The id of a client while it is connected.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema,
)]
#[serde(transparent)]
pub struct ClientId(pub u64);

/// The kind of device on which a page is open.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Device {
    /// A phone or a tablet.
    Phone,
    /// Any other computer.
    Computer,
}

impl Device {
    /// Returns the name of a client with its device, if it is a page: `Anna (phone)`.
    #[must_use]
    pub fn named(name: &str, device: Option<Self>) -> String {
        match device {
            Some(Self::Phone) => format!("{name} (phone)"),
            Some(Self::Computer) => format!("{name} (computer)"),
            None => name.to_owned(),
        }
    }
}

/// The lease holder.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LeaseView {
    /// The holder.
    pub client: ClientId,
    /// The holder's name.
    pub name: String,
    /// The device of a page; absent for a program.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub device: Option<Device>,
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
    /// The device of a page; absent for a program.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub device: Option<Device>,
}
