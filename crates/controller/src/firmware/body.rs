//! The stock controller's estimate of the arm, and the only function that moves it.

use dobot_arm::stock::{StockJoints, StockPose, forward, inverse, reach, sensed};
use dobot_arm::{TICK, Tool};
use dobot_wire::single;

use super::ahead::Ahead;
use crate::outputs::{Hands, servo_value};

/// The controller's estimate of the arm. Pulses never feed back into it.
#[derive(Debug, Default)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is a flag of the stock controller's own"
)]
pub(crate) struct Body {
    pub(crate) joints: StockJoints,
    /// The pose of the joint angles, updated at the end of each tick.
    pub(crate) pose: StockPose,
    pub(crate) gripper_deg: f32,
    /// The distance from the wrist to the tool.
    pub(crate) tool_mm: f32,
    pub(crate) hands: Hands,
    /// The joint motion of this tick, in degrees: base, rear, fore.
    pub(crate) motion_deg: [f32; 3],
    /// Whether an increment was calculated in this tick, even if refused.
    pub(crate) is_driven: bool,
    /// Whether the motors got no new increment in this tick and repeat their last pulses.
    pub(crate) repeats: bool,
    /// Whether the soft limits are off, after the first refusal and until the arm is inside again.
    forgiven: bool,
    /// Whether there was a first refusal.
    forgave: bool,
    /// Whether the current command is planned. All planned commands share this and `start`, so an
    /// interrupted command leaves them to the voice routine (note N50).
    pub(crate) is_planned: bool,
    /// The start of the last line, vector or JUMP.
    pub(crate) start: [f32; 3],
    /// Whether the pose is up to date with the angles.
    is_settled: bool,
    ahead: Ahead,
}

impl Body {
    /// Adopts the sensor readings. The rear arm's sensor measures from level.
    pub(crate) fn power_up(rear_deg: f64, fore_deg: f64) -> Self {
        Self {
            joints: StockJoints {
                rear_deg: 90.0 - sensed(90.0 - rear_deg),
                fore_deg: sensed(fore_deg),
                ..StockJoints::default()
            },
            tool_mm: LONG_TOOL_MM,
            hands: Hands {
                head_servo: servo_value(0.0),
                gripper_servo: servo_value(0.0),
                ..Hands::default()
            },
            ..Self::default()
        }
    }

    /// Moves all joints at these speeds (degrees per second: base, rear, fore, servo) for a tick, or
    /// not at all where a limit forbids it (note N42). An angle that is not a number passes every limit.
    #[must_use]
    pub(crate) fn advance(&mut self, speeds: [f32; 4]) -> bool {
        self.is_driven = true;
        let [base, rear, fore, servo] = speeds.map(|speed| speed * PERIOD_S);
        let from = self.joints;
        let candidate = StockJoints {
            base_deg: from.base_deg + base,
            rear_deg: from.rear_deg + rear,
            fore_deg: from.fore_deg + fore,
            servo_deg: from.servo_deg + servo,
        };
        let pose = forward(candidate, self.tool_mm);
        let is_outside = is_outside(&candidate, pose);
        if is_beyond(&candidate, speeds) || (is_outside && !self.forgiven) {
            self.forgiven |= !self.forgave;
            self.forgave = true;
            return false;
        }
        self.forgiven &= is_outside;
        self.joints = candidate;
        self.pose = pose;
        self.is_settled = true;
        self.motion_deg = [base, rear, fore];
        true
    }

    /// Moves all joints to the inverse kinematics of a pose within a tick.
    #[must_use]
    pub(crate) fn advance_to(&mut self, pose: StockPose) -> bool {
        self.turn_to(inverse(pose, self.tool_mm))
    }

    /// Moves to a position and keeps the tool direction. `next` is the probable position of the next
    /// tick.
    #[must_use]
    pub(crate) fn advance_along(&mut self, place: [f32; 3], next: Option<[f32; 3]>) -> bool {
        let to = self.ahead.solve(place, next, self.tool_mm);
        self.turn_to(StockJoints {
            servo_deg: self.pose.rotation_deg - to.base_deg,
            ..to
        })
    }

    fn turn_to(&mut self, to: StockJoints) -> bool {
        let from = self.joints;
        self.advance([
            (to.base_deg - from.base_deg) / PERIOD_S,
            (to.rear_deg - from.rear_deg) / PERIOD_S,
            (to.fore_deg - from.fore_deg) / PERIOD_S,
            (to.servo_deg - from.servo_deg) / PERIOD_S,
        ])
    }

    /// Starts a line, a vector or a JUMP at the current pose.
    pub(crate) const fn begin(&mut self) {
        self.start = [self.pose.x_mm, self.pose.y_mm, self.pose.z_mm];
    }

    /// Updates the pose.
    pub(crate) fn settle(&mut self) {
        if !self.is_settled {
            self.pose = forward(self.joints, self.tool_mm);
            self.is_settled = true;
        }
    }

    /// Turns the servo immediately, without checking its limits.
    pub(crate) const fn set_servo(&mut self, servo_deg: f32) {
        self.joints.servo_deg = servo_deg;
        self.is_settled = false;
    }

    /// Sets the estimated angles.
    pub(crate) const fn set_arms(&mut self, base_deg: f32, rear_deg: f32, fore_deg: f32) {
        self.joints = StockJoints {
            base_deg,
            rear_deg,
            fore_deg,
            servo_deg: self.joints.servo_deg,
        };
        self.is_settled = false;
    }

    /// Sets the tool.
    pub(crate) const fn set_tool(&mut self, tool_mm: f32) {
        self.tool_mm = tool_mm;
        self.is_settled = false;
    }

    pub(crate) fn tool(&self) -> Tool {
        if self.tool_mm == LASER_MM {
            Tool::Laser
        } else {
            Tool::SuctionCup
        }
    }

    /// Switches the pump and turns the gripper's servo.
    pub(crate) fn grab(&mut self, pump: bool, servo_deg: f32) {
        self.hands.pump = pump;
        self.hands.valve = pump;
        self.hands.gripper_servo = servo_value(servo_deg);
    }

    /// Turns the head's servo output.
    pub(crate) fn turn_head(&mut self, servo_deg: f32) {
        self.hands.head_servo = servo_value(servo_deg.clamp(-90.0, 90.0));
    }

    /// Whether the pose is NaN.
    pub(crate) const fn is_lost(&self) -> bool {
        let StockJoints {
            base_deg,
            rear_deg,
            fore_deg,
            servo_deg,
        } = self.joints;
        !(base_deg.is_finite()
            && rear_deg.is_finite()
            && fore_deg.is_finite()
            && servo_deg.is_finite())
    }
}

/// Whether angles are beyond a hard limit and moving further out.
fn is_beyond(joints: &StockJoints, [base, rear, fore, servo]: [f32; 4]) -> bool {
    let beyond = |angle: f32, speed: f32, [low, high]: [f32; 2]| {
        (angle > high && speed > 0.0) || (angle < low && speed < 0.0)
    };
    beyond(joints.base_deg, base, BASE_DEG)
        || beyond(joints.rear_deg, rear, REAR_DEG)
        || beyond(joints.fore_deg, fore, FORE_DEG)
        || beyond(joints.servo_deg, servo, SERVO_DEG)
}

/// Whether angles are outside of the soft limits.
fn is_outside(joints: &StockJoints, pose: StockPose) -> bool {
    let reach_mm = reach(pose);
    // NaN is neither.
    let is_far = reach_mm > REACH_MM[1];
    let is_near = reach_mm < REACH_MM[0];
    is_far
        || is_near
        || pose.z_mm > HEIGHT_MM
        || 90.0 + joints.rear_deg - joints.fore_deg > ELBOW_DEG
}

/// The control tick in seconds.
pub(crate) const PERIOD_S: f32 = TICK.as_secs_f32();
/// The distance from the wrist to the suction cup, the pen or the gripper.
pub(crate) const LONG_TOOL_MM: f32 = single(Tool::SuctionCup.reach().0);
/// The distance from the wrist to the laser.
pub(crate) const LASER_MM: f32 = single(Tool::Laser.reach().0);

const BASE_DEG: [f32; 2] = [-180.0, 180.0];
pub(crate) const REAR_DEG: [f32; 2] = [-5.0, 85.0];
pub(crate) const FORE_DEG: [f32; 2] = [-10.0, 95.0];
const SERVO_DEG: [f32; 2] = [-90.0, 90.0];
/// The nominal 130 to 320, 135 and 124, and one more.
const REACH_MM: [f32; 2] = [129.0, 321.0];
const HEIGHT_MM: f32 = 136.0;
const ELBOW_DEG: f32 = 125.0;
