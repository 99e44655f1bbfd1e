//! Why there is no link to an arm.

use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Why there is no link to an arm, and what to do about it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LinkProblem {
    /// The kind, for programs.
    pub cause: LinkCause,
    /// One line for a person.
    pub text: String,
    /// What to do, if known.
    pub remedy: Option<String>,
}

/// The kinds of reasons why there is no link to an arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum LinkCause {
    /// No port has been found to search for an arm.
    NoneFound,
    /// The serial port does not exist.
    NoSuchPort,
    /// This user may not open the port.
    NotAllowed,
    /// Another program uses the port.
    InUse,
    /// The file is no serial port.
    NotASerialPort,
    /// No TCP connection can be made to the address.
    Unreachable,
    /// The port cannot be opened for another reason.
    CannotOpen,
    /// The port is open, but nothing is received.
    Silent,
    /// Another device or program is there: what it sends are no statuses.
    NotAnArm,
    /// The arm sends the high byte of each float first.
    BigEndian,
    /// The other end closed the link, or it was unplugged.
    Closed,
    /// The link failed.
    Broken,
}

/// Writes the text and the remedy.
impl fmt::Display for LinkProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)?;
        match &self.remedy {
            Some(remedy) => write!(f, "; {remedy}"),
            None => Ok(()),
        }
    }
}
