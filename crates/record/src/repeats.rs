//! A status that comes again and again, as it does at rest.

use dobot_wire::Status;

/// A status, and the times at which it came again: they are held back, to be written together.
///
/// Bytes may come in pieces of any length. A whole packet counts as received at its last byte; the
/// pieces of an unfinished packet are kept as they came.
#[derive(Debug)]
pub(crate) struct Repeats {
    packet: [u8; LEN],
    status: Status,
    /// When each repeat was whole, in nanoseconds since 1970, none later than the one behind it.
    ends_ns: Vec<u64>,
    /// What came since of the next one.
    pieces: Vec<Piece>,
    /// How much that is; below `LEN`.
    place: usize,
}

/// Some bytes of a packet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Piece {
    pub(crate) at_ns: u64,
    pub(crate) bytes: Vec<u8>,
}

/// A packet that came again and again, and the begin of one more.
#[derive(Debug)]
pub(crate) struct HeldBack {
    pub(crate) packet: [u8; LEN],
    pub(crate) status: Status,
    /// When each of them came, in nanoseconds since 1970.
    pub(crate) ends_ns: Vec<u64>,
    /// What came behind them.
    pub(crate) pieces: Vec<Piece>,
}

impl Repeats {
    /// A status that was just told.
    pub(crate) const fn new(packet: [u8; LEN], status: Status) -> Self {
        Self {
            packet,
            status,
            ends_ns: Vec::new(),
            pieces: Vec::new(),
            place: 0,
        }
    }

    /// Takes the next piece if it says the same again; `is_end` if it ends a packet.
    pub(crate) fn take(&mut self, at_ns: u64, bytes: &[u8], is_end: bool) -> bool {
        let last_ns = self.pieces.last().map(|it| it.at_ns);
        let last_ns = last_ns.or_else(|| self.ends_ns.last().copied());
        let end = self.place + bytes.len();
        let is_same = self.packet[self.place..].starts_with(bytes) && is_end == (end == LEN);
        if last_ns.is_some_and(|it| at_ns < it) || !is_same {
            return false;
        }
        if is_end {
            self.ends_ns.push(at_ns);
            self.pieces.clear();
        } else {
            let bytes = bytes.to_vec();
            self.pieces.push(Piece { at_ns, bytes });
        }
        self.place = end % LEN;
        true
    }

    /// Whether what is held back has to be told.
    pub(crate) fn is_due(&self) -> bool {
        match &self.ends_ns[..] {
            [first, .., last] => self.place == 0 && last - first >= LONGEST_NS,
            _ => false,
        }
    }

    /// Whether it holds anything back.
    pub(crate) const fn is_holding(&self) -> bool {
        !self.ends_ns.is_empty() || !self.pieces.is_empty()
    }

    /// Whether what comes next is the begin of a packet.
    pub(crate) const fn is_between_packets(&self) -> bool {
        self.place == 0
    }

    /// All that is held back.
    pub(crate) fn take_held(&mut self) -> HeldBack {
        HeldBack {
            packet: self.packet,
            status: self.status,
            ends_ns: std::mem::take(&mut self.ends_ns),
            pieces: std::mem::take(&mut self.pieces),
        }
    }
}

/// A packet, in bytes.
pub(crate) const LEN: usize = 42;

/// What is held back is told after so much time at the latest, if more comes.
const LONGEST_NS: u64 = 10_000_000_000;
