//! Execution of a vector on a stock arm, tick by tick (note N48).

use dobot_arm::TICK;

use crate::TickStroke;

/// The progress of a stock arm along a vector, in the controller's own arithmetic.
#[derive(Clone, Copy, Debug, Default)]
pub struct TickProgress {
    /// The remaining ticks that accelerate, keep the speed, and decelerate.
    counts: [i16; 3],
    speed_mm_s: f32,
    /// The distance of the last tick.
    step_mm: f32,
    travelled_mm: [f32; 3],
}

impl TickProgress {
    /// Begins a vector with these ticks. With `None` it has no ticks, and the speed of the vector
    /// before remains.
    pub fn begin(&mut self, tick_stroke: Option<&TickStroke>) {
        self.travelled_mm = [0.0; 3];
        self.counts = [0; 3];
        if let Some(tick_stroke) = tick_stroke {
            self.counts = tick_stroke.counts;
            self.speed_mm_s = tick_stroke.first_mm_s;
        }
    }

    /// Advances by one tick along a vector of this length; `change_mm_s` is the speed change per
    /// tick.
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

    /// Returns the number of remaining ticks. A sum below zero never reaches zero: such a vector
    /// creeps forever.
    #[must_use]
    pub fn ticks_left(&self) -> i16 {
        added(self.counts)
    }

    /// Returns the displacement since the start of the vector.
    #[must_use]
    pub const fn travelled_mm(&self) -> [f32; 3] {
        self.travelled_mm
    }
}

/// Adds the counts in 16 bits, as the stock processor does.
pub(crate) fn added(counts: [i16; 3]) -> i16 {
    counts.into_iter().fold(0, i16::wrapping_add)
}

pub(crate) const TICK_S: f32 = TICK.as_secs_f32();
