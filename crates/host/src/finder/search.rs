//! What the finder is told.

use dobot_session::{Address, Port, Usb};
use serde::{Deserialize, Serialize};

/// What the finder is told.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Search {
    /// The addresses that the person names; only these are tried then.
    pub named: Vec<Address>,
    /// Line speeds to be tried besides 9600 baud, in bits per second.
    pub other_bauds: Vec<u32>,
    /// Where an arm was found last.
    pub last: Option<WhereFound>,
}

/// The serial port where an arm was found.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct WhereFound {
    /// Its name.
    pub path: String,
    /// Bits per second.
    pub baud: u32,
    /// Its USB chip.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub usb: Option<Usb>,
}

impl WhereFound {
    /// Whether this is the same port: the same chip where it has a number of its own, or else one of
    /// the same kind under the same name.
    pub(super) fn is(&self, port: &Port) -> bool {
        match &self.usb {
            Some(usb) if usb.serial.is_some() => port.usb.as_ref() == Some(usb),
            _ => port.path == self.path && port.usb == self.usb,
        }
    }

    /// Whether this may be the same port under another name: the chip is of the same kind, and neither
    /// has a number of its own.
    pub(super) fn may_be(&self, port: &Port) -> bool {
        self.usb.is_some() && port.usb == self.usb
    }
}
