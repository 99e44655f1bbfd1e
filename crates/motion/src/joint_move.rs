//! Coordinated joint moves (MOVJ).

use dobot_arm::Joints;

use crate::plan_error::finite;
use crate::timing_law::TimingLaw;
use crate::{PlanError, Profile, Speeds};

/// A move in which all four joints start and stop together (MOVJ; Table 3.7, note N29).
///
/// All joints follow the profile of the slowest one, so at any time they have covered the same
/// share of their angles.
///
/// ```
/// # use dobot_arm::Joints;
/// # use dobot_motion::{JointMove, Speeds};
/// let target = Joints::new(90.0, 30.0, 0.0, 0.0);
/// let movement = JointMove::new(Joints::default(), target, &Speeds::STOCK)?;
/// let half_way = movement.joints_at(movement.duration_s() / 2.0);
/// assert!((half_way.base.0 - 45.0).abs() < 1e-9 && (half_way.rear.0 - 15.0).abs() < 1e-9);
/// # Ok::<(), dobot_motion::PlanError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointMove {
    from: Joints,
    to: Joints,
    profile: Profile,
}

impl JointMove {
    /// Plans the move; it takes 0 s if no joint has to turn.
    ///
    /// # Errors
    ///
    /// [`PlanError`] if an angle is not finite or a speed or acceleration is not positive.
    pub fn new(from: Joints, to: Joints, speeds: &Speeds) -> Result<Self, PlanError> {
        speeds.check()?;
        let [base, rear, fore, servo] = [
            to.base - from.base,
            to.rear - from.rear,
            to.fore - from.fore,
            to.servo - from.servo,
        ]
        .map(|way| way.0);
        finite("base angle's way", base)?;
        finite("rear arm angle's way", rear)?;
        finite("forearm angle's way", fore)?;
        finite("servo angle's way", servo)?;
        let joints_deg = base.abs().max(rear.abs()).max(fore.abs());
        let law = TimingLaw::of(joints_deg, speeds.joint_deg_s, speeds.joint_deg_s2).with(
            TimingLaw::of(servo.abs(), speeds.servo_deg_s, speeds.servo_deg_s2),
        );
        Ok(Self {
            from,
            to,
            profile: law.profile()?,
        })
    }

    /// Returns the joint angles at a time.
    #[must_use]
    pub fn joints_at(&self, t_s: f64) -> Joints {
        if t_s >= self.profile.duration_s() {
            return self.to;
        }
        self.from.towards(&self.to, self.profile.distance_at(t_s))
    }

    /// Returns the duration.
    #[must_use]
    pub const fn duration_s(&self) -> f64 {
        self.profile.duration_s()
    }

    /// Returns the end.
    #[must_use]
    pub const fn target(&self) -> Joints {
        self.to
    }
}
