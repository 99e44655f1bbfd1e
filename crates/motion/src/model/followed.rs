//! The packets of mouse and hand that a stock arm remembers (note N49).

use dobot_wire::{Gesture, MouseMove};

/// The packets of mouse and hand that a stock arm remembers, for it averages each with those before.
///
/// They lie in ten places that mouse and hand share. A row ends with any other command; what it
/// leaves in its places stays there, and the first nine averages of a hand reach one place of that.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Followed {
    row: Option<FollowedInput>,
    /// Another command came behind the row.
    is_over: bool,
    samples: [[f32; 3]; SAMPLES],
    /// How many places the row has filled.
    count: u8,
}

/// What is followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FollowedInput {
    Mouse,
    Hand,
}

/// What a packet may find when the arm comes to it. A release or a laser off, which wait for nothing,
/// may come between those of a row, or between others than was foreseen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Before {
    /// What was sent.
    AsSent,
    /// Another command: a row begins.
    Another,
    /// The row that is taken to be over goes on.
    TheRow,
}

impl Followed {
    /// Another command: what follows it begins a row.
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
        self.count = self.len(row, Before::AsSent);
        (self.row, self.is_over) = (Some(row), false);
        if usize::from(self.count) == SAMPLES {
            self.samples.copy_within(1.., 0);
            self.samples[SAMPLES - 1] = sample;
        } else {
            self.samples[usize::from(self.count)] = sample;
            self.count += 1;
        }
    }

    /// How many samples the next packet of a row finds.
    fn len(&self, row: FollowedInput, before: Before) -> u8 {
        let goes_on = match before {
            Before::AsSent => !self.is_over,
            Before::Another => false,
            Before::TheRow => true,
        };
        if goes_on && self.row == Some(row) {
            self.count
        } else {
            0
        }
    }

    /// Each sample before counts together with the new one, which counts once more.
    pub(crate) fn mouse_average(&self, sample: [f32; 3], before: Before) -> [f32; 3] {
        let len = self.len(FollowedInput::Mouse, before);
        core::array::from_fn(|axis| {
            let new = sample[axis];
            let row = self.samples[..usize::from(len)].iter();
            row.fold(new, |sum, it| sum + (new + it[axis])) / divisor(len)
        })
    }

    /// Half of it the new sample, half of it those before and one place more: what lies `behind` them,
    /// or behind ten samples the new one.
    pub(crate) fn hand_average(
        &self,
        sample: [f32; 3],
        before: Before,
        behind: Behind,
    ) -> [f32; 3] {
        let len = self.len(FollowedInput::Hand, before);
        let (row, left) = self.samples.split_at(usize::from(len));
        let behind = match (behind, left.first()) {
            (Behind::AsSent, Some(left)) => *left,
            _ => sample,
        };
        core::array::from_fn(|axis| {
            // A slip of the stock program: the height counts once more.
            let first = if axis == 2 { sample[2] } else { 0.0 };
            let sum = row.iter().fold(first, |sum, it| sum + it[axis]) + behind[axis];
            0.5 * sample[axis] + 0.5 * sum / divisor(len)
        })
    }
}

/// By how many packets a sum is divided: those before and the new one, ten at the most.
fn divisor(len: u8) -> f32 {
    f32::from((len + 1).min(10))
}

/// What lies in the place behind a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Behind {
    /// What was sent before; nothing since power-up.
    AsSent,
    /// The same as the new sample: whoever had the arm before held the hand still there.
    TheSame,
}

/// Floats 3 to 5 in their order.
pub(crate) const fn mouse_sample(by: &MouseMove) -> [f32; 3] {
    [by.y, by.x, by.z]
}

pub(crate) const fn hand_sample(hand: &Gesture) -> [f32; 3] {
    [hand.x, hand.y, hand.z]
}

/// So many packets are remembered.
pub(crate) const SAMPLES: usize = 10;
