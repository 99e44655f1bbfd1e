//! The outputs of a controller: motor pulses, servos and switches.

use dobot_arm::stock::{short_unsigned, whole};

/// The outputs of a controller in a control tick.
///
/// Pulses and servo values are sent one tick after their calculation (note N37).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outputs {
    /// Pulses to the motors of base, rear arm and forearm, spread evenly over the tick, with
    /// the signs of [`STEPS_PER_DEG`].
    pub pulses: [i32; 3],
    /// The head servo's value: 500 at 0 degrees, 1000 more at 180.
    pub head_servo: u16,
    /// The gripper servo's value, likewise.
    pub gripper_servo: u16,
    /// Whether the pump is on.
    pub pump: bool,
    /// Whether the vent valve of the suction cup is closed.
    pub valve: bool,
    /// Whether the laser is on.
    pub laser: bool,
}

impl Outputs {
    pub(crate) const fn new(pulses: [i32; 3], hands: Hands) -> Self {
        Self {
            pulses,
            head_servo: hands.head_servo,
            gripper_servo: hands.gripper_servo,
            pump: hands.pump,
            valve: hands.valve,
            laser: hands.laser,
        }
    }
}

/// The commanded state of the end effector and its servos.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Hands {
    pub(crate) head_servo: u16,
    pub(crate) gripper_servo: u16,
    pub(crate) pump: bool,
    pub(crate) valve: bool,
    pub(crate) laser: bool,
}

/// The conversion from degrees to whole motor pulses (note N37).
#[derive(Debug, Default)]
pub(crate) struct Steppers {
    /// The remainder below one pulse.
    residues: [f32; 3],
    pending: [i32; 3],
    /// The pulses of the previous tick.
    last: [i32; 3],
    sent: [i64; 3],
}

impl Steppers {
    /// Converts the joint motion of a tick, in degrees: base, rear, fore.
    pub(crate) fn turn(&mut self, motion_deg: [f32; 3]) {
        for (index, (motion_deg, direction)) in motion_deg.into_iter().zip(DIRECTIONS).enumerate() {
            let residue = &mut self.residues[index];
            *residue += motion_deg / 1.8 * 16.0 * 10.0;
            let pulses = whole(*residue);
            #[expect(
                clippy::cast_precision_loss,
                reason = "the processor calculates in single precision"
            )]
            let sent = pulses as f32;
            *residue -= sent;
            self.pending[index] = direction.saturating_mul(pulses);
        }
    }

    /// Repeats the pulses of the last tick (note N50).
    pub(crate) const fn repeat(&mut self) {
        self.pending = self.last;
    }

    /// Returns the pulses of the previous tick.
    pub(crate) fn exchange(&mut self) -> [i32; 3] {
        let pulses = core::mem::take(&mut self.pending);
        self.last = pulses;
        for (sent, pulses) in self.sent.iter_mut().zip(pulses) {
            *sent += i64::from(pulses);
        }
        pulses
    }

    pub(crate) const fn sent(&self) -> [i64; 3] {
        self.sent
    }
}

/// The servo value of an angle: its pulse length in microseconds (1500 at 0 degrees) less 1000, as an
/// unsigned 16-bit number. Angles just below a whole number are rounded up.
pub(crate) fn servo_value(angle_deg: f32) -> u16 {
    short_unsigned((angle_deg * 1000.0 / 180.0 + 1500.0) - 1000.0)
}

/// Pulses per degree of base, rear arm and forearm: 1.8 degrees per step, 16 microsteps, 10:1 gear. Base
/// and forearm are reversed (note N37).
pub const STEPS_PER_DEG: [f64; 3] = [-160.0 / 1.8, 160.0 / 1.8, -160.0 / 1.8];

const DIRECTIONS: [i32; 3] = [-1, 1, -1];
