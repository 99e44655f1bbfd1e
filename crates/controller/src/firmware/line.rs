//! MOVL of the stock controller: a straight line (note N46).

use super::Progress;
use super::body::{Body, PERIOD_S};
use super::settings::RampSettings;

/// A straight line. There is only one: the next line starts with the distance travelled by a line
/// that was cut short.
#[derive(Debug, Default)]
pub(crate) struct StraightLine {
    direction: [f32; 3],
    length: f32,
    acceleration: f32,
    peak: f32,
    /// The durations of acceleration, of constant speed and in total.
    ramp_s: f32,
    cruise_s: f32,
    pub(crate) total_s: f32,
    stride: Stride,
    /// The state after the next tick, calculated a tick ahead.
    next: Option<Stride>,
}

/// The progress along a line.
#[derive(Clone, Copy, Debug, Default)]
struct Stride {
    ticks: i16,
    travelled: f32,
    is_done: bool,
}

impl StraightLine {
    /// Plans a line from the current pose. Without length it has no direction: its components are NaN.
    pub(crate) fn plan(&mut self, body: &mut Body, [x, y, z]: [f32; 3], ramp: RampSettings) {
        let from = body.pose;
        let [dx, dy, dz] = [x - from.x_mm, y - from.y_mm, z - from.z_mm];
        let length = libm::sqrtf(dx * dx + dy * dy + dz * dz);
        let direction = [dx / length, dy / length, dz / length];
        self.plan_along(body, direction, length, ramp);
    }

    /// Plans a line from the current pose.
    pub(crate) fn plan_along(
        &mut self,
        body: &mut Body,
        direction: [f32; 3],
        length: f32,
        ramp: RampSettings,
    ) {
        body.begin();
        let (ramp_s, cruise_s, peak) = profile(length, ramp);
        *self = Self {
            direction,
            length,
            acceleration: ramp.acceleration,
            peak,
            ramp_s,
            cruise_s,
            total_s: 2.0 * ramp_s + cruise_s,
            stride: Stride {
                travelled: self.stride.travelled,
                ..Stride::default()
            },
            next: None,
        };
    }

    /// Advances by one tick and keeps the tool direction; the tick after the last one detects the end.
    pub(crate) fn tick(&mut self, body: &mut Body) -> Progress {
        if self.stride.is_done {
            self.forget_travelled();
            return Progress::Arrived;
        }
        self.stride = self.next.unwrap_or_else(|| self.step(self.stride));
        self.next = (!self.stride.is_done).then(|| self.step(self.stride));
        let next = self.next.map(|next| self.place(body.start, next));
        let place = self.place(body.start, self.stride);
        Progress::of(body.advance_along(place, next))
    }

    pub(crate) const fn forget_travelled(&mut self) {
        self.stride.travelled = 0.0;
        self.next = None;
    }

    fn step(
        &self,
        Stride {
            ticks, travelled, ..
        }: Stride,
    ) -> Stride {
        let ticks = ticks.wrapping_add(1);
        let t_s = f32::from(ticks) * PERIOD_S;
        let is_done = t_s >= self.total_s;
        let travelled = if is_done {
            self.length
        } else {
            travelled + self.speed(t_s) * PERIOD_S
        };
        Stride {
            ticks,
            travelled,
            is_done,
        }
    }

    fn place(&self, start: [f32; 3], stride: Stride) -> [f32; 3] {
        moved(start, self.direction.map(|part| part * stride.travelled))
    }

    fn speed(&self, t_s: f32) -> f32 {
        if t_s <= self.ramp_s {
            self.acceleration * t_s
        } else if t_s <= self.ramp_s + self.cruise_s {
            self.peak
        } else {
            self.peak - self.acceleration * (t_s - self.ramp_s - self.cruise_s)
        }
    }
}

/// The durations of acceleration and of constant speed in seconds, and the highest speed.
fn profile(length: f32, ramp: RampSettings) -> (f32, f32, f32) {
    let RampSettings {
        speed,
        acceleration,
    } = ramp;
    // If one of the two is NaN, the line counts as short.
    if speed * speed / acceleration < length {
        let cruise_s = (length - speed * speed / acceleration) / speed;
        (speed / acceleration, cruise_s, speed)
    } else {
        let peak = libm::sqrtf(acceleration * length);
        (peak / acceleration, 0.0, peak)
    }
}

/// The end position of a displacement.
pub(crate) fn moved(start: [f32; 3], way: [f32; 3]) -> [f32; 3] {
    [start[0] + way[0], start[1] + way[1], start[2] + way[2]]
}
