//! Jogging: one axis moves while a button is held (Tables 3.5 and 2.5).

use crate::{ArmPlace, ArmSettings, JogAxis, Model, PlanError, Ramp};
use dobot_arm::{Degrees, Joints, Millimeters, Tool, Unreachable};

/// The trajectory of one axis until the button is released.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JogTrajectory {
    axis: JogAxis,
    from: ArmPlace,
    tool: Tool,
    from_gripper_deg: f64,
    ramp: Ramp,
    acceleration: f64,
    target: f64,
}

impl JogTrajectory {
    /// Starts at the arm's position with the current speed of the axis (degrees/s or mm/s), towards
    /// a share of the axis's speed, -1 to 1.
    ///
    /// # Errors
    ///
    /// [`PlanError`] if the axis has no acceleration or a number is not finite.
    pub fn start(model: &Model, axis: JogAxis, share: f64, speed: f64) -> Result<Self, PlanError> {
        let (max, acceleration) = axis.speeds(&model.settings);
        let target = max * share * model.settings.teach_percent / 100.0;
        Ok(Self {
            axis,
            from: model.place,
            tool: model.tool,
            from_gripper_deg: model.gripper_deg,
            ramp: Ramp::new(speed, target, acceleration)?,
            acceleration,
            target,
        })
    }

    /// Ramps down to rest from the speed after `t_s`, at the position of the model.
    ///
    /// # Errors
    ///
    /// See [`JogTrajectory::start`].
    pub fn release(&self, model: &Model, t_s: f64) -> Result<Self, PlanError> {
        Ok(Self {
            from: model.place,
            from_gripper_deg: model.gripper_deg,
            ramp: Ramp::to_rest(self.ramp.speed_at(t_s), self.acceleration)?,
            target: 0.0,
            ..*self
        })
    }

    /// Returns the axis.
    #[must_use]
    pub const fn axis(&self) -> JogAxis {
        self.axis
    }

    /// Returns the target speed in degrees/s or mm/s; its sign is the direction.
    #[must_use]
    pub const fn target_speed(&self) -> f64 {
        self.target
    }

    /// Returns the acceleration in degrees/s2 or mm/s2, above 0.
    #[must_use]
    pub const fn acceleration(&self) -> f64 {
        self.acceleration
    }

    /// Returns the speed at a time, in degrees/s or mm/s.
    #[must_use]
    pub fn speed_at(&self, t_s: f64) -> f64 {
        self.ramp.speed_at(t_s)
    }

    /// Returns the time of the change to the target speed, in seconds.
    #[must_use]
    pub const fn change_s(&self) -> f64 {
        self.ramp.change_s()
    }

    /// Returns the gripper's angle in degrees at a time.
    #[must_use]
    pub fn gripper_deg_at(&self, t_s: f64) -> f64 {
        match self.axis {
            JogAxis::Gripper => self.from_gripper_deg + self.ramp.distance_at(t_s),
            _ => self.from_gripper_deg,
        }
    }

    /// Returns the position on its unbounded path nearest to another one along the moving axis: the
    /// start if the other lies behind it, or if the gripper moves.
    ///
    /// # Errors
    ///
    /// [`Unreachable`] if the position is outside the arm's workspace.
    pub fn nearest(&self, to: &ArmPlace) -> Result<ArmPlace, Unreachable> {
        let (from, way) = (&self.from, to.pose.position - self.from.pose.position);
        let turned = |of: fn(&Joints) -> Degrees| of(&to.joints).0 - of(&from.joints).0;
        let by = match self.axis {
            JogAxis::Base => turned(|joints| joints.base),
            JogAxis::Rear => turned(|joints| joints.rear),
            JogAxis::Fore => turned(|joints| joints.fore),
            JogAxis::Servo => turned(|joints| joints.servo),
            JogAxis::X => way.x.0,
            JogAxis::Y => way.y.0,
            JogAxis::Z => way.z.0,
            JogAxis::Gripper => 0.0,
        };
        self.moved(if by * self.target > 0.0 { by } else { 0.0 })
    }

    /// Returns the position at a time, ignoring limits.
    ///
    /// # Errors
    ///
    /// [`Unreachable`] if the position is outside the arm's workspace.
    pub fn place_at(&self, t_s: f64) -> Result<ArmPlace, Unreachable> {
        self.moved(self.ramp.distance_at(t_s))
    }

    /// Returns the position after a number of degrees or millimetres.
    fn moved(&self, by: f64) -> Result<ArmPlace, Unreachable> {
        let joints = |change: fn(&mut Joints) -> &mut Degrees| {
            let mut joints = self.from.joints;
            *change(&mut joints) += Degrees(by);
            Ok(ArmPlace::at_joints(joints, self.tool))
        };
        let line = |x: f64, y: f64, z: f64| {
            let mut pose = self.from.pose;
            pose.position.x += Millimeters(x * by);
            pose.position.y += Millimeters(y * by);
            pose.position.z += Millimeters(z * by);
            ArmPlace::at_pose(pose, self.tool)
        };
        match self.axis {
            JogAxis::Base => joints(|joints| &mut joints.base),
            JogAxis::Rear => joints(|joints| &mut joints.rear),
            JogAxis::Fore => joints(|joints| &mut joints.fore),
            JogAxis::Servo => joints(|joints| &mut joints.servo),
            JogAxis::X => line(1.0, 0.0, 0.0),
            JogAxis::Y => line(0.0, 1.0, 0.0),
            JogAxis::Z => line(0.0, 0.0, 1.0),
            JogAxis::Gripper => Ok(self.from),
        }
    }
}

impl JogAxis {
    /// Returns how far the axis moves on, in degrees or mm, if a button held at a share of its speed, 0 to 1, is
    /// released and the arm receives the release after a time, in seconds.
    #[must_use]
    pub fn coasting(self, settings: &ArmSettings, share: f64, delay_s: f64) -> f64 {
        let (max, acceleration) = self.speeds(settings);
        let speed = max * share * settings.teach_percent / 100.0;
        speed * delay_s + speed * speed / (2.0 * acceleration)
    }

    /// Returns speed and acceleration at 100 %, in degrees or millimetres.
    const fn speeds(self, settings: &ArmSettings) -> (f64, f64) {
        let teach = &settings.teach;
        match self {
            Self::Base | Self::Rear | Self::Fore => (teach.joint_deg_s, teach.joint_deg_s2),
            Self::Servo | Self::Gripper => (teach.servo_deg_s, teach.servo_deg_s2),
            Self::X | Self::Y | Self::Z => (teach.line_mm_s, teach.line_mm_s2),
        }
    }
}
