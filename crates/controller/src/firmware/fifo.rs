//! The queue of the stock controller (note N40).

use dobot_wire::Frame;

/// A ring of six slots. A slot returns what was last written to it, which is not always what was
/// queued: a voice command takes a slot and writes nothing.
#[derive(Debug)]
pub(crate) struct Fifo {
    places: [Frame; PLACES],
    next_out: usize,
    count: usize,
}

impl Fifo {
    pub(crate) const fn new() -> Self {
        Self {
            places: [Frame::ZERO; PLACES],
            next_out: 0,
            count: 0,
        }
    }

    /// The number of waiting commands.
    pub(crate) const fn len(&self) -> usize {
        self.count
    }

    /// Queues a frame; returns whether there was a free slot.
    pub(crate) const fn push(&mut self, frame: Frame) -> bool {
        if self.count >= PLACES {
            return false;
        }
        self.places[(self.next_out + self.count) % PLACES] = frame;
        self.count += 1;
        true
    }

    /// Takes a slot without writing to it. The firmware does not check for a free slot: with more than
    /// six the queue is locked forever, and the last command repeats.
    pub(crate) const fn take_slot(&mut self) {
        self.count += 1;
    }

    /// Takes the next frame.
    pub(crate) const fn pop(&mut self) -> Option<Frame> {
        if self.count == 0 || self.count > PLACES {
            return None;
        }
        let frame = self.places[self.next_out];
        self.next_out = (self.next_out + 1) % PLACES;
        self.count -= 1;
        Some(frame)
    }
}

const PLACES: usize = crate::refused::QUEUE_LEN;
