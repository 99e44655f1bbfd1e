//! All joints at once (MOVJ).

use dobot_arm::Joints;

use crate::plan_error::finite;
use crate::timing_law::TimingLaw;
use crate::{PlanError, Profile, Speeds};

/// A move on which all four joints start and stop together (MOVJ; Table 3.7, note N29).
///
/// Each joint turns its own angle on the one profile that the slowest of them needs, so the share
/// of the way is the same for all at any time.
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
    /// Plans the move; it lasts 0 s where no joint has to turn.
    ///
    /// # Errors
    ///
    /// [`PlanError`] where an angle is not finite or a speed or acceleration is not positive.
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

    /// The joint angles at a time.
    #[must_use]
    pub fn joints_at(&self, t_s: f64) -> Joints {
        if t_s >= self.profile.duration_s() {
            return self.to;
        }
        self.from.towards(&self.to, self.profile.distance_at(t_s))
    }

    /// How long it takes.
    #[must_use]
    pub const fn duration_s(&self) -> f64 {
        self.profile.duration_s()
    }

    /// Where it ends.
    #[must_use]
    pub const fn target(&self) -> Joints {
        self.to
    }
}
