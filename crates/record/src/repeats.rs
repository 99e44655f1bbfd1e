//! A status that comes again and again, as it does at rest.

use dobot_wire::Status;

/// A status, and the times at which it came again: they are held back, to be told together.
///
/// What comes may be cut anywhere: each piece has a time of its own.
#[derive(Debug)]
pub(crate) struct Repeats {
    packet: [u8; LEN],
    status: Status,
    /// How much of the next repeat came already; below `LEN`.
    place: usize,
    /// The pieces that came since the status was told, none later than the one behind it.
    pieces: Vec<Piece>,
}

/// Some bytes of a packet, at most all of it.
#[derive(Clone, Copy, Debug)]
struct Piece {
    at_ns: u64,
    len: usize,
}

/// Pieces of the same packet, one after the other, from its first byte on.
#[derive(Debug)]
pub(crate) struct Told {
    pub(crate) packet: [u8; LEN],
    pub(crate) status: Status,
    /// When the first of them came, in nanoseconds since 1970.
    pub(crate) first_ns: u64,
    /// When the last of them came.
    pub(crate) last_ns: u64,
    /// From each to the next.
    pub(crate) gaps_ns: Vec<u64>,
    /// How long each is, in bytes.
    pub(crate) lens: Vec<usize>,
}

impl Repeats {
    /// A status that was just told.
    pub(crate) const fn new(packet: [u8; LEN], status: Status) -> Self {
        Self {
            packet,
            status,
            place: 0,
            pieces: Vec::new(),
        }
    }

    /// Takes the next piece if it says the same again; `is_end` if it ends a packet.
    pub(crate) fn take(&mut self, at_ns: u64, piece: &[u8], is_end: bool) -> bool {
        let in_order = self.pieces.last().is_none_or(|last| last.at_ns <= at_ns);
        let end = self.place + piece.len();
        let is_same = self.packet[self.place..].starts_with(piece) && is_end == (end == LEN);
        if !in_order || !is_same {
            return false;
        }
        let len = piece.len();
        self.pieces.push(Piece { at_ns, len });
        self.place = end % LEN;
        true
    }

    /// Whether what is held back has to be told.
    pub(crate) fn is_due(&self) -> bool {
        let time_ns = match &self.pieces[..] {
            [first, .., last] => last.at_ns - first.at_ns,
            _ => 0,
        };
        self.place == 0 && time_ns >= LONGEST_NS || self.pieces.len() >= MOST
    }

    /// Whether it holds anything back.
    pub(crate) const fn is_holding(&self) -> bool {
        !self.pieces.is_empty()
    }

    /// Whether what comes next is the begin of a packet.
    pub(crate) const fn is_between_packets(&self) -> bool {
        self.place == 0
    }

    /// All that is held back.
    pub(crate) fn tell(&mut self) -> Option<Told> {
        let pieces = std::mem::take(&mut self.pieces);
        let gaps = pieces.windows(2).map(|it| it[1].at_ns - it[0].at_ns);
        Some(Told {
            packet: self.packet,
            status: self.status,
            first_ns: pieces.first()?.at_ns,
            last_ns: pieces.last()?.at_ns,
            gaps_ns: gaps.collect(),
            lens: pieces.iter().map(|it| it.len).collect(),
        })
    }
}

impl Told {
    /// Whether each piece is the whole packet.
    pub(crate) fn are_packets(&self) -> bool {
        self.lens.iter().all(|len| *len == LEN)
    }
}

/// A packet, in bytes.
pub(crate) const LEN: usize = 42;

/// What is held back is told after so much time at the latest, if more comes ...
const LONGEST_NS: u64 = 10_000_000_000;

/// ... or when there are so many pieces of it: a serial port gives a few for each packet.
const MOST: usize = 1024;
