//! Search options of the finder.

use dobot_session::{Address, Port, Usb};
use serde::{Deserialize, Serialize};

/// Search options of the finder.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Search {
    /// The named addresses; if any, only these are tried.
    pub named: Vec<Address>,
    /// Line speeds to try besides 9600 baud, in bits per second.
    pub other_bauds: Vec<u32>,
    /// Where an arm was last found.
    pub last: Option<KnownPort>,
}

/// The serial port where an arm was found.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct KnownPort {
    /// The name.
    pub path: String,
    /// The speed, in bits per second.
    pub baud: u32,
    /// The USB chip.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub usb: Option<Usb>,
}

impl KnownPort {
    /// Returns whether this is the same port: the same chip if it has a serial number, otherwise
    /// the same kind of chip under the same name.
    pub(super) fn is(&self, port: &Port) -> bool {
        match &self.usb {
            Some(usb) if usb.serial.is_some() => port.usb.as_ref() == Some(usb),
            _ => port.path == self.path && port.usb == self.usb,
        }
    }

    /// Returns whether this may be the same port under another name: the same kind of chip without
    /// serial numbers.
    pub(super) fn may_be(&self, port: &Port) -> bool {
        self.usb.is_some() && port.usb == self.usb
    }
}
