//! What a controller tells the machine: motor pulses, servos and switches.

use dobot_arm::stock::{short_unsigned, whole};

/// What a controller told the machine in a control tick.
///
/// Pulses and servo values go out a tick after they were calculated: they are those of the tick
/// before (note N37).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outputs {
    /// Pulses to the motors of base, rear arm and forearm, clocked out evenly over the tick; their
    /// signs are those of [`STEPS_PER_DEG`].
    pub pulses: [i32; 3],
    /// The head servo's value: 500 at 0 degrees, 1000 more at 180.
    pub head_servo: u16,
    /// The gripper servo's value, likewise.
    pub gripper_servo: u16,
    /// Whether the pump runs.
    pub pump: bool,
    /// Whether the valve that lets air into the suction cup is closed.
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

/// What moves at the arm's end, as its program wants it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hands {
    pub(crate) head_servo: u16,
    pub(crate) gripper_servo: u16,
    pub(crate) pump: bool,
    pub(crate) valve: bool,
    pub(crate) laser: bool,
}

/// The motors' side of the program: from degrees to whole pulses (note N37).
#[derive(Debug, Default)]
pub(crate) struct Steppers {
    /// What was too little for a pulse so far.
    residues: [f32; 3],
    pending: [i32; 3],
    /// The pulses of the tick before.
    last: [i32; 3],
    sent: [i64; 3],
}

impl Steppers {
    /// Takes the way of the joints in a tick, in degrees: base, rear, fore.
    pub(crate) fn turn(&mut self, way_deg: [f32; 3]) {
        for (index, (way_deg, direction)) in way_deg.into_iter().zip(DIRECTIONS).enumerate() {
            let residue = &mut self.residues[index];
            *residue += way_deg / 1.8 * 16.0 * 10.0;
            let pulses = whole(*residue);
            #[expect(
                clippy::cast_precision_loss,
                reason = "the processor has no more of it"
            )]
            let sent = pulses as f32;
            *residue -= sent;
            self.pending[index] = direction.saturating_mul(pulses);
        }
    }

    /// Takes the pulses of the last tick once more (note N50).
    pub(crate) const fn repeat(&mut self) {
        self.pending = self.last;
    }

    /// Sends the pulses of the tick before.
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

/// The value that turns a servo to an angle: the length of its pulse, which is 1500 microseconds at 0
/// degrees, less a thousand, in sixteen bits without a sign. Angles a hair below a whole number are rounded up by it.
pub(crate) fn servo_value(angle_deg: f32) -> u16 {
    short_unsigned((angle_deg * 1000.0 / 180.0 + 1500.0) - 1000.0)
}

/// Pulses per degree for base, rear arm and forearm: 1.8 degrees a step, 16 microsteps, a gear of ten. Base and
/// forearm count backwards (note N37).
pub const STEPS_PER_DEG: [f64; 3] = [-160.0 / 1.8, 160.0 / 1.8, -160.0 / 1.8];

const DIRECTIONS: [i32; 3] = [-1, 1, -1];
