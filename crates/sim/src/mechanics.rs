//! The true machine, independent of the controller's estimate.

use std::time::Duration;

use dobot_arm::{Joints, TICK};
use dobot_controller::STEPS_PER_DEG;

/// The true joint angles, turned by the motors pulse by pulse.
///
/// The pulses of a control tick are spread evenly over the 20 ms from that tick on. The controller
/// gets no feedback: after a lost pulse, backlash or a restart its estimate differs from the true
/// angles, as with a real arm.
///
/// ```
/// use std::time::Duration;
/// use dobot_arm::Joints;
/// use dobot_sim::Mechanics;
///
/// let mut machine = Mechanics::new(Joints::new(0.0, 45.0, 45.0, 0.0));
/// // 200 pulses of the base in one tick, and the servo of the tool stays in the middle.
/// machine.handle_tick(Duration::ZERO, [-200, 0, 0], 500);
/// assert_eq!(machine.joints_at(Duration::from_millis(10)).base.0, 1.125);
/// assert_eq!(machine.joints_at(Duration::from_millis(20)).base.0, 2.25);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Mechanics {
    /// The time of the last control tick.
    tick: Duration,
    /// The motor positions at the last tick, as joint angles.
    from_deg: [f64; 4],
    /// The motor positions a tick later.
    to_deg: [f64; 4],
    /// The joint angles at the last tick.
    joints_deg: [f64; 4],
    backlash_deg: [f64; 4],
    servo_zero_deg: f64,
}

/// One of the four joints.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Joint {
    /// Joint 1.
    Base,
    /// Joint 2, the rear arm.
    Rear,
    /// Joint 3, the forearm.
    Fore,
    /// Joint 4, the servo of the tool.
    Servo,
}

impl Mechanics {
    /// Creates a machine at these angles, without faults.
    #[must_use]
    pub const fn new(joints: Joints) -> Self {
        let angles = joints.angles_deg();
        Self {
            tick: Duration::ZERO,
            from_deg: angles,
            to_deg: angles,
            joints_deg: angles,
            backlash_deg: [0.0; 4],
            servo_zero_deg: 0.0,
        }
    }

    /// Sets the backlash of a joint: after a reversal the motor turns this many degrees before the joint
    /// moves. After power-up a positive turn moves the joint immediately.
    pub const fn set_backlash(&mut self, joint: Joint, backlash_deg: f64) {
        self.backlash_deg[joint as usize] = backlash_deg;
    }

    /// Turns the joints by these degrees without the controller.
    pub(crate) fn set_zeros(&mut self, zeros_deg: [f64; 4]) {
        for (joint, zero_deg) in zeros_deg.into_iter().enumerate() {
            self.from_deg[joint] += zero_deg;
            self.joints_deg[joint] += zero_deg;
        }
        self.to_deg = self.from_deg;
        self.servo_zero_deg = zeros_deg[Joint::Servo as usize];
    }

    /// Applies the outputs of a control tick: the pulses that the motors of base, rear and fore really
    /// make, signed as the controller counts them, and the signal of the tool's servo (500 is the
    /// middle, 1000 is 90 degrees).
    pub fn handle_tick(&mut self, at: Duration, pulses: [i32; 3], head_servo: u16) {
        self.halt(at);
        for (joint, count) in pulses.into_iter().enumerate() {
            self.to_deg[joint] += f64::from(count) / STEPS_PER_DEG[joint];
        }
        self.to_deg[3] = (f64::from(head_servo) - 500.0) * 0.18 + self.servo_zero_deg;
    }

    /// Stops at the current angles.
    pub fn halt(&mut self, at: Duration) {
        let share = self.share(at);
        for joint in 0..4 {
            self.joints_deg[joint] = self.joint_deg(joint, share);
            self.from_deg[joint] = self.motor_deg(joint, share);
        }
        self.to_deg = self.from_deg;
        self.tick = at;
    }

    /// The joint angles at a time since the last control tick.
    #[must_use]
    pub fn joints_at(&self, at: Duration) -> Joints {
        let share = self.share(at);
        let [base, rear, fore, servo] = [0, 1, 2, 3].map(|joint| self.joint_deg(joint, share));
        Joints::new(base, rear, fore, servo)
    }

    /// Whether it is at rest from the last control tick to the next.
    #[must_use]
    pub fn is_still(&self) -> bool {
        self.from_deg == self.to_deg
    }

    /// The elapsed fraction of the tick.
    fn share(&self, at: Duration) -> f64 {
        if self.is_still() {
            return 1.0;
        }
        (at.saturating_sub(self.tick).as_secs_f64() / TICK.as_secs_f64()).min(1.0)
    }

    fn motor_deg(&self, joint: usize, share: f64) -> f64 {
        let (from, to) = (self.from_deg[joint], self.to_deg[joint]);
        if share >= 1.0 {
            to
        } else {
            from + (to - from) * share
        }
    }

    /// Turns the motor within the backlash; at its end the joint follows.
    fn joint_deg(&self, joint: usize, share: f64) -> f64 {
        let motor = self.motor_deg(joint, share);
        self.joints_deg[joint]
            .max(motor)
            .min(motor + self.backlash_deg[joint])
    }
}

impl Joint {
    /// All joints in numerical order.
    pub const ALL: [Self; 4] = [Self::Base, Self::Rear, Self::Fore, Self::Servo];

    /// The name used in texts.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Base => "base",
            Self::Rear => "rear",
            Self::Fore => "fore",
            Self::Servo => "servo",
        }
    }
}

impl std::fmt::Display for Joint {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn ms(ms: u64) -> Duration {
        Duration::from_millis(ms)
    }

    fn machine() -> Mechanics {
        Mechanics::new(Joints::new(0.0, 45.0, 45.0, 0.0))
    }

    #[test]
    fn pulses_turn_the_joints_evenly_over_their_tick_each_its_own_way() {
        let mut machine = machine();
        machine.handle_tick(ms(100), [-160, 320, 160], 500);
        assert!(!machine.is_still());
        let half = machine.joints_at(ms(110));
        for (found, expected) in [(half.base, 0.9), (half.rear, 46.8), (half.fore, 44.1)] {
            assert!((found.0 - expected).abs() < 1e-12, "{half:?}");
        }
        let end = machine.joints_at(ms(120));
        for (found, expected) in [(end.base, 1.8), (end.rear, 48.6), (end.fore, 43.2)] {
            assert!((found.0 - expected).abs() < 1e-12, "{end:?}");
        }
        assert_eq!(machine.joints_at(ms(5000)), end);
    }

    #[test]
    fn ninety_degrees_of_the_servo_are_five_hundred_of_its_signal() {
        let mut machine = machine();
        for (signal, angle) in [(1000, 90.0), (0, -90.0), (750, 45.0)] {
            machine.handle_tick(ms(0), [0; 3], signal);
            let found = machine.joints_at(ms(20)).servo.0;
            assert!((found - angle).abs() < 1e-9, "{signal}: {found}");
        }
    }

    #[test]
    fn a_servo_put_on_askew_stays_askew() {
        let mut machine = machine();
        machine.set_zeros([0.0, 0.0, 0.0, 3.0]);
        assert_eq!(machine.joints_at(ms(0)).servo.0, 3.0);
        machine.handle_tick(ms(0), [0; 3], 750);
        assert!((machine.joints_at(ms(20)).servo.0 - 48.0).abs() < 1e-9);
    }

    #[test]
    fn a_machine_that_is_stopped_in_the_middle_of_a_tick_stays_there() {
        let mut machine = machine();
        machine.handle_tick(ms(0), [0, 160, 0], 500);
        machine.halt(ms(5));
        assert!((machine.joints_at(ms(20)).rear.0 - 45.45).abs() < 1e-12);
        assert!(machine.is_still());
    }

    #[test]
    fn a_slack_joint_loses_its_backlash_at_each_reversal_and_only_there() {
        let mut machine = machine();
        machine.set_backlash(Joint::Rear, 0.3);
        let mut at = ms(0);
        let mut turn = |pulses: i32| {
            machine.handle_tick(at, [0, pulses, 0], 500);
            at += ms(20);
            machine.joints_at(at).rear.0
        };
        for (pulses, expected) in [
            (160, 46.8),
            (160, 48.6),
            // Back: 1.8 degrees, of which 0.3 are lost.
            (-160, 47.1),
            (-160, 45.3),
            (160, 46.8),
            // 0.09 degrees to and fro in a gap of 0.3 move nothing.
            (-8, 46.8),
            (8, 46.8),
        ] {
            let found = turn(pulses);
            assert!((found - expected).abs() < 1e-9, "{pulses}: {found}");
        }
    }

    #[test]
    fn the_gap_is_crossed_within_a_tick() {
        let mut machine = machine();
        machine.set_backlash(Joint::Rear, 0.9);
        machine.handle_tick(ms(0), [0, -160, 0], 500);
        assert_eq!(machine.joints_at(ms(5)).rear.0, 45.0);
        assert!((machine.joints_at(ms(15)).rear.0 - 44.55).abs() < 1e-12);
    }
}
