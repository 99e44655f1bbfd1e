//! Jogging: one axis moves while a button is held (Tables 3.5 and 2.5).

use dobot_arm::{Degrees, Joints, Millimeters, Tool, Unreachable, inverse};
use dobot_motion::{PlanError, Ramp};
use dobot_wire::{JointJog, JointJogAxis, LinearJog, LinearJogAxis};

use super::settings::Settings;
use super::state::{Place, State};

/// One axis on the move, until told otherwise.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Jog {
    pub(crate) axis: Axis,
    from: Place,
    from_gripper_deg: f64,
    pub(crate) ramp: Ramp,
    pub(crate) acceleration: f64,
}

/// What a jog moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Axis {
    Base,
    Rear,
    Fore,
    Servo,
    Gripper,
    X,
    Y,
    Z,
}

/// What a button of the jog panel does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Button {
    Released,
    /// Towards plus or minus, with a share of the axis's speed.
    Held {
        axis: Axis,
        share: f64,
    },
    Suction(bool),
    Laser(bool),
}

impl Button {
    pub(crate) fn of_joint(jog: JointJog) -> Self {
        use JointJogAxis as A;
        let share = f64::from(jog.speed_percent) / 100.0;
        match jog.axis {
            A::Released => Self::Released,
            A::BasePlus => held(Axis::Base, share),
            A::BaseMinus => held(Axis::Base, -share),
            A::RearPlus => held(Axis::Rear, share),
            A::RearMinus => held(Axis::Rear, -share),
            A::ForePlus => held(Axis::Fore, share),
            A::ForeMinus => held(Axis::Fore, -share),
            A::ServoPlus => held(Axis::Servo, share),
            A::ServoMinus => held(Axis::Servo, -share),
            A::GripperOpen => held(Axis::Gripper, share),
            A::GripperClose => held(Axis::Gripper, -share),
            A::SuctionOn => Self::Suction(true),
            A::SuctionOff => Self::Suction(false),
            A::LaserOn => Self::Laser(true),
            A::LaserOff => Self::Laser(false),
        }
    }

    pub(crate) fn of_linear(jog: LinearJog) -> Self {
        use LinearJogAxis as A;
        let share = f64::from(jog.speed_percent) / 100.0;
        match jog.axis {
            A::Released => Self::Released,
            A::XPlus => held(Axis::X, share),
            A::XMinus => held(Axis::X, -share),
            A::YPlus => held(Axis::Y, share),
            A::YMinus => held(Axis::Y, -share),
            A::ZPlus => held(Axis::Z, share),
            A::ZMinus => held(Axis::Z, -share),
            A::ServoPlus => held(Axis::Servo, share),
            A::ServoMinus => held(Axis::Servo, -share),
            A::GripperOpen => held(Axis::Gripper, share),
            A::GripperClose => held(Axis::Gripper, -share),
            A::SuctionOn => Self::Suction(true),
            A::SuctionOff => Self::Suction(false),
            A::LaserOn => Self::Laser(true),
            A::LaserOff => Self::Laser(false),
        }
    }
}

impl Jog {
    /// Starts from where the arm is, with the speed that the axis has.
    pub(crate) fn start(
        state: &State,
        settings: &Settings,
        axis: Axis,
        share: f64,
        speed: f64,
    ) -> Result<Self, PlanError> {
        let (max, acceleration) = axis.speeds(settings);
        let target = max * share * settings.teach_percent / 100.0;
        Ok(Self {
            axis,
            from: state.place,
            from_gripper_deg: state.gripper_deg,
            ramp: Ramp::new(speed, target, acceleration)?,
            acceleration,
        })
    }

    /// Comes to rest from the speed that it has after `t_s`, where the arm is then.
    pub(crate) fn release(&self, state: &State, t_s: f64) -> Result<Self, PlanError> {
        Ok(Self {
            from: state.place,
            from_gripper_deg: state.gripper_deg,
            ramp: Ramp::to_rest(self.ramp.speed_at(t_s), self.acceleration)?,
            ..*self
        })
    }

    pub(crate) fn gripper_deg_at(&self, t_s: f64) -> f64 {
        match self.axis {
            Axis::Gripper => self.from_gripper_deg + self.ramp.distance_at(t_s),
            _ => self.from_gripper_deg,
        }
    }

    /// Where the arm is after a time; `None` while only the gripper moves.
    pub(crate) fn place_at(&self, t_s: f64, tool: Tool) -> Option<Result<Place, Unreachable>> {
        let by = self.ramp.distance_at(t_s);
        let joints = |change: fn(&mut Joints) -> &mut Degrees| {
            let mut joints = self.from.joints;
            *change(&mut joints) += Degrees(by);
            Ok(Place::at_joints(joints, tool))
        };
        let line = |x: f64, y: f64, z: f64| {
            let mut pose = self.from.pose;
            pose.position.x += Millimeters(x * by);
            pose.position.y += Millimeters(y * by);
            pose.position.z += Millimeters(z * by);
            inverse(&pose, tool).map(|joints| Place { joints, pose })
        };
        Some(match self.axis {
            Axis::Base => joints(|it| &mut it.base),
            Axis::Rear => joints(|it| &mut it.rear),
            Axis::Fore => joints(|it| &mut it.fore),
            Axis::Servo => joints(|it| &mut it.servo),
            Axis::X => line(1.0, 0.0, 0.0),
            Axis::Y => line(0.0, 1.0, 0.0),
            Axis::Z => line(0.0, 0.0, 1.0),
            Axis::Gripper => return None,
        })
    }
}

impl Axis {
    /// Speed and acceleration at 100 %.
    const fn speeds(self, settings: &Settings) -> (f64, f64) {
        let teach = &settings.teach;
        match self {
            Self::Base | Self::Rear | Self::Fore => (teach.joint_deg_s, teach.joint_deg_s2),
            Self::Servo | Self::Gripper => (teach.servo_deg_s, teach.servo_deg_s2),
            Self::X | Self::Y | Self::Z => (teach.line_mm_s, teach.line_mm_s2),
        }
    }
}

const fn held(axis: Axis, share: f64) -> Button {
    Button::Held { axis, share }
}
