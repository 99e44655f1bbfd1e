//! The ports that may have an arm, and the order in which they are tried.

use dobot_session::{Address, DEFAULT_BAUD, Port, Usb};

use super::{KnownPort, Search};

/// A port to try.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Candidate {
    pub(super) address: Address,
    /// The attached device.
    pub(super) device: Option<String>,
    /// The USB chip.
    pub(super) usb: Option<Usb>,
    /// Whether it is known to be the arm's port: it was named, or the arm was found there.
    pub(super) sure: bool,
}

/// The ports to try and those passed over.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Choice {
    /// In the order of trying.
    pub(super) candidates: Vec<Candidate>,
    /// Ports that are tried only when named.
    pub(super) passed_over: Vec<String>,
}

/// The likelihood that a port is the arm's, likeliest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Rank {
    TheSame,
    PerhapsTheSame,
    LikelyChip,
    OtherChip,
    NoUsb,
}

impl Candidate {
    /// Returns where an arm was found, if this is a serial port.
    pub(super) fn place(&self) -> Option<KnownPort> {
        match &self.address {
            Address::Serial { path, baud } => Some(KnownPort {
                path: path.clone(),
                baud: *baud,
                usb: self.usb.clone(),
            }),
            _ => None,
        }
    }
}

/// Chooses the ports to try, in the order documented at [`Finder`](super::Finder).
pub(super) fn choose(search: &Search, ports: &[Port]) -> Choice {
    let (first, passed_over) = if search.named.is_empty() {
        automatic(search, ports)
    } else {
        (named(search, ports), Vec::new())
    };
    let mut candidates = first.clone();
    for &baud in &search.other_bauds {
        let others = first.iter().filter_map(|candidate| candidate.at(baud));
        candidates.extend(others.filter(|other| !first.contains(other)));
    }
    Choice {
        candidates,
        passed_over,
    }
}

fn named(search: &Search, ports: &[Port]) -> Vec<Candidate> {
    let candidate = |address: &Address| {
        let port = match address {
            Address::Serial { path, .. } => ports.iter().find(|port| port.path == *path),
            _ => None,
        };
        Candidate {
            address: address.clone(),
            device: port.and_then(|port| port.device.clone()),
            usb: port.and_then(|port| port.usb.clone()),
            sure: true,
        }
    };
    search.named.iter().map(candidate).collect()
}

fn automatic(search: &Search, ports: &[Port]) -> (Vec<Candidate>, Vec<String>) {
    let last = search.last.as_ref();
    let mut ranked: Vec<_> = ports.iter().map(|port| (rank(port, last), port)).collect();
    // A stable sort keeps the order of names among equals.
    ranked.sort_by_key(|(rank, _)| *rank);
    let (tried, passed_over): (Vec<_>, Vec<_>) = ranked
        .into_iter()
        .partition(|(rank, _)| *rank != Rank::NoUsb);
    let candidate = |(rank, port): (Rank, &Port)| {
        let baud = last.filter(|_| rank <= Rank::PerhapsTheSame);
        Candidate {
            address: Address::Serial {
                path: port.path.clone(),
                baud: baud.map_or(DEFAULT_BAUD, |found| found.baud),
            },
            device: port.device.clone(),
            usb: port.usb.clone(),
            sure: rank == Rank::TheSame,
        }
    };
    let passed_over = passed_over.into_iter().map(|(_, port)| port.path.clone());
    (
        tried.into_iter().map(candidate).collect(),
        passed_over.collect(),
    )
}

fn rank(port: &Port, last: Option<&KnownPort>) -> Rank {
    match &port.usb {
        _ if last.is_some_and(|last| last.is(port)) => Rank::TheSame,
        _ if last.is_some_and(|last| last.may_be(port)) => Rank::PerhapsTheSame,
        Some(usb) if is_chip_of_arms(usb) => Rank::LikelyChip,
        Some(_) => Rank::OtherChip,
        None => Rank::NoUsb,
    }
}

impl Candidate {
    /// Returns the port at another speed.
    fn at(&self, baud: u32) -> Option<Self> {
        let Address::Serial { path, .. } = &self.address else {
            return None;
        };
        let path = path.clone();
        Some(Self {
            address: Address::Serial { path, baud },
            ..self.clone()
        })
    }
}

/// Returns whether arms were built with this USB chip; other devices have it, too.
#[must_use]
pub fn is_chip_of_arms(usb: &Usb) -> bool {
    LIKELY.contains(&(usb.vendor, usb.product))
}

/// Vendor and product ids of the USB chips that arms were built with: two kinds of Arduino Mega,
/// CH340, FTDI FT232R, CP2102.
const LIKELY: [(u16, u16); 5] = [
    (0x2341, 0x0010),
    (0x2341, 0x0042),
    (0x1a86, 0x7523),
    (0x0403, 0x6001),
    (0x10c4, 0xea60),
];

#[cfg(test)]
mod tests;
