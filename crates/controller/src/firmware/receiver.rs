//! The stock controller's search for packets (notes N39 and N40).

use core::time::Duration;

use dobot_wire::{Frame, HEADER, PACKET_LEN, TAIL};
use heapless::Vec;

use crate::Port;

/// The receive buffer of the serial port, and the search for packets in it.
///
/// The buffer is searched continuously, except while a tick is calculating.
#[derive(Debug)]
pub(crate) struct Receiver {
    port: Port,
    /// The oldest byte first.
    ring: Vec<u8, RING_LEN>,
    /// The header found, while the rest of the packet is awaited.
    header: Option<u8>,
    /// The end of the tick calculation.
    busy_until: Duration,
    /// Bytes that belong to no packet or did not fit.
    pub(crate) skipped: u64,
}

/// A result of a search of the receive buffer.
#[derive(Debug)]
pub(crate) enum Received {
    /// A packet with a correct tail.
    Frame(Frame),
    /// Forty bytes of text with a correct tail, over Bluetooth.
    Voice([u8; BODY_LEN - 1]),
    /// A packet whose last byte is wrong.
    BadTail {
        /// Its first byte.
        header: u8,
    },
    /// More bytes than a packet before the buffer was searched.
    TooLong,
}

impl Receiver {
    pub(crate) const fn new(port: Port) -> Self {
        Self {
            port,
            ring: Vec::new(),
            header: None,
            busy_until: Duration::ZERO,
            skipped: 0,
        }
    }

    /// Disables the search until `time`.
    pub(crate) const fn set_busy_until(&mut self, time: Duration) {
        self.busy_until = time;
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.ring.is_empty()
    }

    pub(crate) fn is_busy(&self, now: Duration) -> bool {
        now < self.busy_until
    }

    /// Stores arriving bytes up to the first one after which a search could find anything; returns the
    /// rest.
    pub(crate) fn push<'a>(&mut self, bytes: &'a [u8]) -> &'a [u8] {
        let count = match self.header {
            Some(_) => BODY_LEN.saturating_sub(self.ring.len()).max(1),
            None => 1,
        };
        let (taken, rest) = bytes.split_at(count.min(bytes.len()));
        if self.ring.extend_from_slice(taken).is_err() {
            // Only if the buffer is full.
            self.skipped += 1;
        }
        rest
    }

    /// Whether a search could find anything.
    pub(crate) fn may_find(&self) -> bool {
        self.header.is_none() || self.ring.len() >= BODY_LEN
    }

    /// Searches the buffer; `None` if it contains no complete packet.
    pub(crate) fn look(&mut self) -> Option<Received> {
        let header = match self.header {
            Some(header) => header,
            None => self.hunt()?,
        };
        self.header = Some(header);
        if self.ring.len() < BODY_LEN {
            return None;
        }
        self.header = None;
        if self.ring.len() > BODY_LEN && self.port == Port::Usb {
            // The bytes stay, and the search continues within them.
            self.skipped += 1;
            return Some(Received::TooLong);
        }
        Some(self.take_packet(header))
    }

    /// The header of a packet of which at least one more byte, but not all, has arrived.
    pub(crate) fn begun(&self) -> Option<u8> {
        self.header.filter(|_| !self.ring.is_empty())
    }

    /// Discards bytes up to a header.
    fn hunt(&mut self) -> Option<u8> {
        let is_header =
            |&byte: &u8| byte == HEADER || (byte == VOICE_HEADER && self.port == Port::Bluetooth);
        let found = self.ring.iter().position(is_header);
        self.skipped += found.unwrap_or(self.ring.len()) as u64;
        let header = found.map(|at| self.ring[at]);
        self.discard(found.map_or(self.ring.len(), |at| at + 1));
        header
    }

    fn take_packet(&mut self, header: u8) -> Received {
        let (text, tail) = (&self.ring[..BODY_LEN - 1], self.ring[BODY_LEN - 1]);
        let found = match (header, tail) {
            (HEADER, TAIL) => {
                let mut packet = [HEADER; PACKET_LEN];
                packet[1..].copy_from_slice(&self.ring[..BODY_LEN]);
                Received::Frame(Frame::from_bytes(&packet).expect("the delimiters were checked"))
            }
            (VOICE_HEADER, VOICE_TAIL) => {
                Received::Voice(text.try_into().expect("the length is fixed"))
            }
            _ => {
                self.skipped += PACKET_LEN as u64;
                Received::BadTail { header }
            }
        };
        self.discard(BODY_LEN);
        found
    }

    /// Removes the oldest bytes.
    fn discard(&mut self, count: usize) {
        let left = self.ring.len() - count;
        if left > 0 {
            self.ring.copy_within(count.., 0);
        }
        self.ring.truncate(left);
    }
}

/// The length after the header: ten floats or a text, and the tail.
const BODY_LEN: usize = PACKET_LEN - 1;
/// Of 64 bytes the ring can use all but one.
const RING_LEN: usize = 63;
pub(crate) const VOICE_HEADER: u8 = 0xB5;
const VOICE_TAIL: u8 = 0x5B;
