//! Old programs, which speak the arm's own protocol: what is known of them.

use std::path::PathBuf;

/// What happens to the programs that speak the arm's own protocol.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ProgramNews {
    /// A program came.
    Came {
        /// The name by which the station knows it.
        name: String,
    },
    /// A program was turned away: one at a time is served.
    TurnedAway {
        /// What would have been its name.
        name: String,
        /// The program that is served.
        by: String,
    },
    /// The program left.
    Left {
        /// Its name.
        name: String,
        /// What it sent and got.
        traffic: Traffic,
    },
    /// The virtual serial port has another name now: a program that was killed left the old one
    /// locked.
    PortMoved(PathBuf),
    /// No program can come for now; it is tried again.
    Trouble(String),
}

/// What a program that speaks the arm's own protocol sent and got.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Traffic {
    /// Packets that it sent.
    pub packets: u64,
    /// How many of them were refused.
    pub refused: u64,
    /// Bytes that it sent and that belong to no packet.
    pub damaged_bytes: u64,
    /// Statuses that it got.
    pub statuses: u64,
    /// Statuses that it did not get, because it did not read those before.
    pub lost_statuses: u64,
    /// It was no program but a web page in a browser, and was cut off: its packets would have come
    /// from anywhere.
    pub web: bool,
}
