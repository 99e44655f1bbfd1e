//! MOVJ of the stock controller: all joints start and arrive together (note N45).

use dobot_arm::stock::StockJoints;

use super::Progress;
use super::body::{Body, PERIOD_S};
use super::settings::RampSettings;

/// A motion of all joints to target angles.
#[derive(Debug)]
pub(crate) struct JointMotion {
    axes: [Axis; 4],
    /// The duration in seconds.
    pub(crate) total_s: f32,
    ticks: i16,
}

#[derive(Clone, Copy, Debug)]
struct Axis {
    target_deg: f32,
    is_done: bool,
    /// Signed, like the peak.
    acceleration: f32,
    peak: f32,
    /// The durations of acceleration and of constant speed.
    ramp_s: f32,
    cruise_s: f32,
}

impl JointMotion {
    /// Plans a motion from the current pose.
    pub(crate) fn plan(body: &Body, to: StockJoints, ramps: &[RampSettings; 4]) -> Self {
        let (from, to) = (angles(body.joints), angles(to));
        let ways: [f32; 4] = core::array::from_fn(|axis| to[axis] - from[axis]);
        let alone = |axis: usize| time_alone(ways[axis].abs(), ramps[axis]);
        // The base first; NaN replaces nothing.
        let total_s = (1..4).fold(alone(0), |longest, axis| {
            let alone = alone(axis);
            if alone > longest { alone } else { longest }
        });
        Self {
            axes: core::array::from_fn(|axis| {
                Axis::plan(ways[axis], to[axis], ramps[axis], total_s)
            }),
            total_s,
            ticks: 0,
        }
    }

    /// Whether the last tick was its first.
    pub(crate) const fn is_begun(&self) -> bool {
        self.ticks == 1
    }

    /// Advances by one tick; the tick after the last one detects the end.
    pub(crate) fn tick(&mut self, body: &mut Body) -> Progress {
        if self.axes.iter().all(|axis| axis.is_done) {
            return Progress::Arrived;
        }
        self.ticks = self.ticks.wrapping_add(1);
        let t_s = f32::from(self.ticks) * PERIOD_S;
        let from = angles(body.joints);
        let total_s = self.total_s;
        let speeds = core::array::from_fn(|axis| self.axes[axis].speed(from[axis], t_s, total_s));
        Progress::of(body.advance(speeds))
    }
}

impl Axis {
    /// Stretches the motion of one joint to the duration of the slowest.
    fn plan(way: f32, target_deg: f32, ramp: RampSettings, total_s: f32) -> Self {
        let (distance, sign) = (way.abs(), if way < 0.0 { -1.0 } else { 1.0 });
        let even_speed = 2.0 * distance / total_s;
        let (ramp_s, cruise_s, peak) = if even_speed <= ramp.speed {
            (total_s / 2.0, 0.0, even_speed)
        } else {
            let ramp_s = total_s - distance / ramp.speed;
            (ramp_s, total_s - 2.0 * ramp_s, ramp.speed)
        };
        Self {
            target_deg,
            is_done: distance < NO_WAY_DEG,
            acceleration: sign * (peak / ramp_s),
            peak: sign * (peak / ramp_s) * ramp_s,
            ramp_s,
            cruise_s,
        }
    }

    /// The speed in the tick that ends at `t_s`; the last one covers the remainder.
    fn speed(&mut self, from_deg: f32, t_s: f32, total_s: f32) -> f32 {
        if self.is_done {
            0.0
        } else if t_s >= total_s {
            self.is_done = true;
            (self.target_deg - from_deg) / PERIOD_S
        } else if t_s <= self.ramp_s {
            self.acceleration * t_s
        } else if t_s <= self.ramp_s + self.cruise_s {
            self.peak
        } else {
            self.peak - self.acceleration * (t_s - self.ramp_s - self.cruise_s)
        }
    }
}

/// The duration of one joint alone.
fn time_alone(
    distance: f32,
    RampSettings {
        speed,
        acceleration,
    }: RampSettings,
) -> f32 {
    if distance > speed * speed / acceleration {
        2.0 * (speed / acceleration) + (distance - speed * speed / acceleration) / speed
    } else {
        2.0 * (libm::sqrtf(acceleration * distance) / acceleration)
    }
}

const fn angles(joints: StockJoints) -> [f32; 4] {
    [
        joints.base_deg,
        joints.rear_deg,
        joints.fore_deg,
        joints.servo_deg,
    ]
}

/// A joint with a shorter distance stays.
const NO_WAY_DEG: f32 = 1e-6;
