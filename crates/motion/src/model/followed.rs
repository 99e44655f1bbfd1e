//! The history of mouse and hand packets in a stock arm (note N49).

use dobot_wire::{Gesture, MouseMove};

/// The mouse and hand packets that a stock arm remembers to average each with its predecessors.
///
/// They occupy ten slots shared by mouse and hand. A series ends with any other command; its
/// samples stay in their slots, and the first nine averages of a hand include one stale slot.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Followed {
    row: Option<FollowedInput>,
    /// Another command followed the series.
    is_over: bool,
    samples: [[f32; 3]; SAMPLES],
    /// The number of slots filled by the series.
    count: u8,
}

/// The followed input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FollowedInput {
    Mouse,
    Hand,
}

/// The possible predecessor of a packet. A release or a laser off, which do not wait, may come
/// between packets of a series, or at another point than expected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Predecessor {
    /// The predecessor as sent.
    AsSent,
    /// Another command: a series begins.
    OtherCommand,
    /// The series assumed to be over continues.
    SameSeries,
}

impl Followed {
    /// Records another command: the next packet begins a series.
    pub(crate) const fn end_row(&mut self) {
        self.is_over = true;
    }

    pub(crate) fn take_mouse(&mut self, by: &MouseMove) {
        self.take(FollowedInput::Mouse, mouse_sample(by));
    }

    pub(crate) fn take_hand(&mut self, hand: &Gesture) {
        self.take(FollowedInput::Hand, hand_sample(hand));
    }

    fn take(&mut self, row: FollowedInput, sample: [f32; 3]) {
        self.count = self.len(row, Predecessor::AsSent);
        (self.row, self.is_over) = (Some(row), false);
        if usize::from(self.count) == SAMPLES {
            self.samples.copy_within(1.., 0);
            self.samples[SAMPLES - 1] = sample;
        } else {
            self.samples[usize::from(self.count)] = sample;
            self.count += 1;
        }
    }

    /// Returns the number of earlier samples for the next packet of a series.
    fn len(&self, row: FollowedInput, before: Predecessor) -> u8 {
        let goes_on = match before {
            Predecessor::AsSent => !self.is_over,
            Predecessor::OtherCommand => false,
            Predecessor::SameSeries => true,
        };
        if goes_on && self.row == Some(row) {
            self.count
        } else {
            0
        }
    }

    /// Averages each earlier sample with the new one, which counts once more.
    pub(crate) fn mouse_average(&self, sample: [f32; 3], before: Predecessor) -> [f32; 3] {
        let len = self.len(FollowedInput::Mouse, before);
        core::array::from_fn(|axis| {
            let new = sample[axis];
            let row = self.samples[..usize::from(len)].iter();
            row.fold(new, |sum, sample| sum + (new + sample[axis])) / divisor(len)
        })
    }

    /// Returns half the new sample plus half the average of the earlier samples and one further
    /// slot: its stale content `behind` them, or the new sample once ten are stored.
    pub(crate) fn hand_average(
        &self,
        sample: [f32; 3],
        before: Predecessor,
        behind: StaleSlot,
    ) -> [f32; 3] {
        let len = self.len(FollowedInput::Hand, before);
        let (row, left) = self.samples.split_at(usize::from(len));
        let behind = match (behind, left.first()) {
            (StaleSlot::AsSent, Some(left)) => *left,
            _ => sample,
        };
        core::array::from_fn(|axis| {
            // A bug of the stock firmware: the height counts once more.
            let first = if axis == 2 { sample[2] } else { 0.0 };
            let sum = row.iter().fold(first, |sum, sample| sum + sample[axis]) + behind[axis];
            0.5 * sample[axis] + 0.5 * sum / divisor(len)
        })
    }
}

/// Returns the divisor of the sum: the earlier packets and the new one, at most ten.
fn divisor(len: u8) -> f32 {
    f32::from((len + 1).min(10))
}

/// The content of the slot after a series.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StaleSlot {
    /// As sent before; zero since power-up.
    AsSent,
    /// Equal to the new sample, as if the previous user held the hand still at this position.
    SameAsNew,
}

/// Floats 3 to 5 in order.
pub(crate) const fn mouse_sample(by: &MouseMove) -> [f32; 3] {
    [by.y, by.x, by.z]
}

pub(crate) const fn hand_sample(hand: &Gesture) -> [f32; 3] {
    [hand.x, hand.y, hand.z]
}

/// The number of remembered packets.
pub(crate) const SAMPLES: usize = 10;
