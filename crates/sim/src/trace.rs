//! Traces: the statuses and outputs of an arm, tick by tick, as text for other programs.

mod compare;
mod number;
mod read;

use dobot_arm::TICK;
use dobot_controller::Outputs;

pub use self::compare::{Comparison, Deviation};
use self::number::{push_float, push_int};
pub use self::read::TraceError;

/// The statuses, outputs and printed text of an arm.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Trace {
    /// The statuses, in order.
    pub statuses: Vec<TracedStatus>,
    /// A row for each control tick, from the first on.
    pub ticks: Vec<TracedTick>,
    /// The text printed on the unused port.
    pub other_port: Vec<u8>,
}

/// A status as sent.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct TracedStatus {
    /// The control tick that queued it; tick n happens at 20 n ms.
    pub tick: u32,
    /// Its ten floats in the order of Table 2.3.
    pub floats: [f32; 10],
}

/// The outputs of a control tick.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct TracedTick {
    /// Motor pulses, servos and pins.
    pub outputs: Outputs,
    /// Motor pulses since power-up: base, rear arm, forearm.
    pub sums: [i64; 3],
}

impl Trace {
    /// The statuses as CSV: a row each, `t_ms` being the nominal time of the tick that queued it.
    /// Floats have nine significant digits, so that they come back as they were.
    #[must_use]
    pub fn statuses_csv(&self) -> Vec<u8> {
        let mut csv = Vec::with_capacity(100 * (self.statuses.len() + 1));
        csv.extend_from_slice(STATUS_FIELDS.join(",").as_bytes());
        csv.push(b'\n');
        for status in &self.statuses {
            push_int(&mut csv, status.t_ms());
            for &float in &status.floats {
                csv.push(b',');
                push_float(&mut csv, float);
            }
            csv.push(b'\n');
        }
        csv
    }

    /// The control ticks as CSV: a row each.
    #[must_use]
    pub fn ticks_csv(&self) -> Vec<u8> {
        let mut csv = Vec::with_capacity(60 * (self.ticks.len() + 2));
        csv.extend_from_slice(TICK_FIELDS.join(",").as_bytes());
        csv.push(b'\n');
        for (tick, row) in (0..).zip(&self.ticks) {
            push_int(&mut csv, tick * i64::from(TICK_MS));
            for value in row.values() {
                csv.push(b',');
                push_int(&mut csv, value);
            }
            csv.push(b'\n');
        }
        csv
    }
}

impl TracedStatus {
    /// The nominal time of its tick, in milliseconds.
    #[must_use]
    pub fn t_ms(&self) -> i64 {
        i64::from(self.tick) * i64::from(TICK_MS)
    }
}

impl TracedTick {
    /// The values in the order of [`TICK_FIELDS`], without the time.
    const fn values(&self) -> [i64; 11] {
        let it = &self.outputs;
        [
            it.pulses[0] as i64,
            it.pulses[1] as i64,
            it.pulses[2] as i64,
            self.sums[0],
            self.sums[1],
            self.sums[2],
            it.head_servo as i64,
            it.gripper_servo as i64,
            it.pump as i64,
            it.valve as i64,
            it.laser as i64,
        ]
    }
}

/// The fields of a status row.
pub(crate) const STATUS_FIELDS: [&str; 11] = [
    "t_ms", "x", "y", "z", "rHead", "base", "rear", "fore", "servo", "isGrab", "gripper",
];

/// The fields of a tick row.
pub(crate) const TICK_FIELDS: [&str; 12] = [
    "t_ms",
    "p_base",
    "p_rear",
    "p_fore",
    "sum_base",
    "sum_rear",
    "sum_fore",
    "servo_head",
    "servo_grip",
    "pump",
    "valve",
    "laser",
];

/// The control tick in milliseconds (note N27).
pub(crate) const TICK_MS: u32 = TICK.subsec_millis();

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test fails by it")]
mod tests;
