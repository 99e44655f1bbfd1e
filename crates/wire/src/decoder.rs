//! The decoder: a stream of bytes in, packets out.

use crate::direction::{Commands, Direction, Statuses};
use crate::{Frame, PACKET_LEN};

/// Finds the packets in a stream of bytes, whatever happened to it on the way.
///
/// It keeps its place from packet to packet. Where a window of 42 bytes cannot be trusted it goes on
/// looking at the byte after the false header, so that damage costs no packet but the one it hit;
/// what it trusts is the business of the direction: [`Statuses`] (note N22) or [`Commands`]
/// (note N24).
#[derive(Clone, Debug)]
pub struct Decoder<D> {
    direction: D,
    /// The beginning of a packet whose end has not arrived; `window[0]` is a header whenever
    /// `filled > 0`.
    window: [u8; PACKET_LEN],
    /// Below `PACKET_LEN` whenever `feed` has run to its end.
    filled: usize,
    /// The next window begins where the last packet ended, or where the stream began.
    locked: bool,
    counts: Counts,
}

impl Decoder<Statuses> {
    /// Creates a decoder for packets from the controller.
    ///
    /// `plausible` judges frames whose floats are all in range (note N22). X, Y and Z that equal the
    /// forward kinematics of the angles are the checksum that the protocol does not have.
    #[must_use]
    pub const fn statuses(plausible: fn(&Frame) -> bool) -> Self {
        Self::new(Statuses::new(plausible))
    }
}

impl Decoder<Commands> {
    /// Creates a decoder for packets from clients.
    #[must_use]
    pub const fn commands() -> Self {
        Self::new(Commands)
    }
}

impl<D> Decoder<D> {
    const fn new(direction: D) -> Self {
        Self {
            direction,
            window: [0; PACKET_LEN],
            filled: 0,
            locked: true,
            counts: Counts {
                frames: 0,
                skipped_bytes: 0,
                resyncs: 0,
            },
        }
    }

    /// The counters.
    #[must_use]
    pub const fn counts(&self) -> Counts {
        self.counts
    }

    /// How many bytes wait for the rest of their packet: below 42.
    ///
    /// Every byte taken belongs to a packet, was skipped, or waits.
    #[must_use]
    pub const fn waiting(&self) -> usize {
        self.filled
    }
}

impl<D: Direction> Decoder<D> {
    /// Discards an incomplete packet: its sender has been silent for so long that the
    /// rest will not come. Bytes that come later belong to others; they might complete it to what
    /// looks like a packet.
    pub fn give_up_waiting(&mut self) {
        let len = core::mem::take(&mut self.filled);
        self.count_skipped(len);
    }

    /// Takes bytes, of any number, and gives the packets that they complete.
    ///
    /// All bytes are taken, also where the iterator is dropped before its end: the packets that it has not
    /// given are gone then.
    pub fn feed<'d, 'b>(&'d mut self, bytes: &'b [u8]) -> Packets<'d, 'b, D> {
        Packets {
            decoder: self,
            rest: bytes,
            uncounted: 0,
        }
    }

    /// The window of the next packet; one that is simply the next 42 bytes of `rest` is counted in
    /// `uncounted`.
    #[inline]
    fn next_window<'w, 'b: 'w>(
        &'w mut self,
        rest: &mut &'b [u8],
        uncounted: &mut u64,
    ) -> Option<&'w [u8; PACKET_LEN]> {
        if self.locked
            && self.filled == 0
            && let Some((window, after)) = rest.split_first_chunk()
            && self.direction.trusts(window, true)
        {
            *rest = after;
            *uncounted += 1;
            return Some(window);
        }
        // A copy, so that `rest` itself may stay in registers while packets follow each other.
        let mut later = *rest;
        let found = self.hunt(&mut later);
        *rest = later;
        match found? {
            Found::Outside(window) => Some(window),
            Found::Inside => Some(&self.window),
        }
    }

    /// The next packet that is not simply the next 42 bytes of `rest`.
    #[cold]
    fn hunt<'b>(&mut self, rest: &mut &'b [u8]) -> Option<Found<'b>> {
        loop {
            let step = match rest.split_first_chunk() {
                Some((window, after)) if self.filled == 0 => self.step_outside(rest, window, after),
                _ => self.step_inside(rest),
            };
            match step {
                Step::Found(found) => return Some(found),
                Step::Skipped => {}
                Step::Starved => return None,
            }
        }
    }

    /// Judges the next 42 bytes of `rest` where they lie.
    fn step_outside<'b>(
        &mut self,
        rest: &mut &'b [u8],
        window: &'b [u8; PACKET_LEN],
        after: &'b [u8],
    ) -> Step<'b> {
        if self.direction.trusts(window, self.locked) {
            *rest = after;
            self.count_packet();
            return Step::Found(Found::Outside(window));
        }
        let len = false_start_len::<D>(window);
        *rest = &rest[len..];
        self.count_skipped(len);
        Step::Skipped
    }

    /// Fills the window from `rest` and judges it when it is full.
    fn step_inside<'b>(&mut self, rest: &mut &'b [u8]) -> Step<'b> {
        if self.filled == 0 {
            let len = rest
                .iter()
                .position(|&byte| D::begins(byte))
                .unwrap_or(rest.len());
            *rest = &rest[len..];
            self.count_skipped(len);
        }
        self.fill(rest);
        if self.filled < PACKET_LEN {
            return Step::Starved;
        }
        if self.direction.trusts(&self.window, self.locked) {
            self.filled = 0;
            self.count_packet();
            return Step::Found(Found::Inside);
        }
        let len = false_start_len::<D>(&self.window);
        self.window.copy_within(len.., 0);
        self.filled -= len;
        self.count_skipped(len);
        Step::Skipped
    }

    /// Moves bytes from `rest` to the window, as many as fit.
    fn fill(&mut self, rest: &mut &[u8]) {
        let (now, later) = rest.split_at(rest.len().min(PACKET_LEN - self.filled));
        self.window[self.filled..][..now.len()].copy_from_slice(now);
        self.filled += now.len();
        *rest = later;
    }

    fn count_packet(&mut self) {
        self.counts.frames += 1;
        self.counts.resyncs += u64::from(!self.locked);
        self.locked = true;
    }

    fn count_skipped(&mut self, len: usize) {
        self.counts.skipped_bytes += len as u64;
        self.locked &= len == 0;
    }
}

/// The packets that [`Decoder::feed`] finds.
#[derive(Debug)]
#[must_use = "bytes are taken as the iterator runs"]
pub struct Packets<'d, 'b, D: Direction> {
    decoder: &'d mut Decoder<D>,
    rest: &'b [u8],
    /// Packets that the decoder has not counted yet: a count in memory would cost as much as the
    /// packet.
    uncounted: u64,
}

impl<D: Direction> Iterator for Packets<'_, '_, D> {
    type Item = D::Item;

    #[inline]
    fn next(&mut self) -> Option<D::Item> {
        self.decoder
            .next_window(&mut self.rest, &mut self.uncounted)
            .map(D::read)
    }
}

impl<D: Direction> Drop for Packets<'_, '_, D> {
    fn drop(&mut self) {
        while self
            .decoder
            .next_window(&mut self.rest, &mut self.uncounted)
            .is_some()
        {}
        self.decoder.counts.frames += self.uncounted;
    }
}

/// The counters of a decoder.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Counts {
    /// Packets found, voice packets included.
    pub frames: u64,
    /// Bytes that belong to no packet.
    pub skipped_bytes: u64,
    /// How often a packet was found after bytes had to be skipped.
    pub resyncs: u64,
}

/// Where the window of a packet lies.
enum Found<'b> {
    /// In the bytes that were fed.
    Outside(&'b [u8; PACKET_LEN]),
    /// In the decoder.
    Inside,
}

enum Step<'b> {
    /// A packet was found.
    Found(Found<'b>),
    /// Bytes were skipped; go on.
    Skipped,
    /// All bytes are taken.
    Starved,
}

/// How many bytes lie before the next header after the first byte.
fn false_start_len<D: Direction>(window: &[u8; PACKET_LEN]) -> usize {
    window[1..]
        .iter()
        .position(|&byte| D::begins(byte))
        .map_or(PACKET_LEN, |at| at + 1)
}
