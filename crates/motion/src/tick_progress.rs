//! How a stock arm goes along a vector, tick by tick (note N48).

use dobot_arm::TICK;

use crate::TickStroke;

/// How far a stock arm has gone along a vector, and how it goes on, in the controller's own arithmetic.
#[derive(Clone, Copy, Debug, Default)]
pub struct TickProgress {
    /// Ticks left that accelerate, go on as fast, and slow down.
    counts: [i16; 3],
    speed_mm_s: f32,
    /// How far the last tick went.
    step_mm: f32,
    travelled_mm: [f32; 3],
}

impl TickProgress {
    /// Begins a vector that is cut like that. Without a cut it has no ticks; the speed of the one before stays.
    pub fn begin(&mut self, tick_stroke: Option<&TickStroke>) {
        self.travelled_mm = [0.0; 3];
        self.counts = [0; 3];
        if let Some(tick_stroke) = tick_stroke {
            self.counts = tick_stroke.counts;
            self.speed_mm_s = tick_stroke.first_mm_s;
        }
    }

    /// A tick further along a vector of this length, each tick of which is so much faster or slower than the one before.
    #[must_use]
    pub fn tick(mut self, vector_mm: [f32; 3], length_mm: f32, change_mm_s: f32) -> Self {
        let [up, even, down] = &mut self.counts;
        if *up > 0 {
            *up -= 1;
            self.step_mm = self.speed_mm_s * TICK_S;
            self.speed_mm_s += change_mm_s;
        } else if *even > 0 {
            *even -= 1;
            self.step_mm = self.speed_mm_s * TICK_S;
        } else if *down > 0 {
            *down -= 1;
            self.speed_mm_s -= change_mm_s;
            self.step_mm = self.speed_mm_s * TICK_S;
        }
        for (travelled, part) in self.travelled_mm.iter_mut().zip(vector_mm) {
            *travelled += part * self.step_mm / length_mm;
        }
        self
    }

    /// How many ticks are left. A sum below zero never comes to zero: such a vector creeps on for ever.
    #[must_use]
    pub fn ticks_left(&self) -> i16 {
        added(self.counts)
    }

    /// How far it has gone from where the vector began.
    #[must_use]
    pub const fn travelled_mm(&self) -> [f32; 3] {
        self.travelled_mm
    }
}

/// In sixteen bits, as the stock processor adds.
pub(crate) fn added(counts: [i16; 3]) -> i16 {
    counts.into_iter().fold(0, i16::wrapping_add)
}

pub(crate) const TICK_S: f32 = TICK.as_secs_f32();
