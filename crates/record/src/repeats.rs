//! Repeated statuses, as those of a resting arm.

use dobot_wire::Status;

/// A status and the times of its repetitions, held back to be written together.
///
/// Bytes may be split anywhere. A packet counts as received at its last byte; the pieces of an
/// unfinished packet are kept as they arrived.
#[derive(Debug)]
pub(crate) struct Repeats {
    packet: [u8; LEN],
    status: Status,
    /// The times at which each repetition was complete, in nanoseconds since 1970, ascending.
    ends_ns: Vec<u64>,
    /// The pieces of the next packet.
    pieces: Vec<Piece>,
    /// The length of these pieces; below `LEN`.
    place: usize,
}

/// Some bytes of a packet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Piece {
    pub(crate) at_ns: u64,
    pub(crate) bytes: Vec<u8>,
}

/// A repeated packet, and the start of another one.
#[derive(Debug)]
pub(crate) struct HeldBack {
    pub(crate) packet: [u8; LEN],
    pub(crate) status: Status,
    /// The times of the repetitions, in nanoseconds since 1970.
    pub(crate) ends_ns: Vec<u64>,
    /// The pieces after them.
    pub(crate) pieces: Vec<Piece>,
}

impl Repeats {
    /// Starts with a status that was just written.
    pub(crate) const fn new(packet: [u8; LEN], status: Status) -> Self {
        Self {
            packet,
            status,
            ends_ns: Vec::new(),
            pieces: Vec::new(),
            place: 0,
        }
    }

    /// Accepts the next piece if it continues the repetition; `is_end` if it completes a packet.
    pub(crate) fn take(&mut self, at_ns: u64, bytes: &[u8], is_end: bool) -> bool {
        let last_ns = self.pieces.last().map(|piece| piece.at_ns);
        let last_ns = last_ns.or_else(|| self.ends_ns.last().copied());
        let end = self.place + bytes.len();
        let is_same = self.packet[self.place..].starts_with(bytes) && is_end == (end == LEN);
        if last_ns.is_some_and(|last_ns| at_ns < last_ns) || !is_same {
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

    /// Whether the held-back data must be written now.
    pub(crate) fn is_due(&self) -> bool {
        match &self.ends_ns[..] {
            [first, .., last] => self.place == 0 && last - first >= MAX_HELD_NS,
            _ => false,
        }
    }

    /// Whether anything is held back.
    pub(crate) const fn is_holding(&self) -> bool {
        !self.ends_ns.is_empty() || !self.pieces.is_empty()
    }

    /// Whether the next piece starts a packet.
    pub(crate) const fn is_between_packets(&self) -> bool {
        self.place == 0
    }

    /// Returns everything that is held back.
    pub(crate) fn take_held(&mut self) -> HeldBack {
        HeldBack {
            packet: self.packet,
            status: self.status,
            ends_ns: std::mem::take(&mut self.ends_ns),
            pieces: std::mem::take(&mut self.pieces),
        }
    }
}

/// The length of a packet, in bytes.
pub(crate) const LEN: usize = 42;

/// The longest time that repetitions are held back.
const MAX_HELD_NS: u64 = 10_000_000_000;
