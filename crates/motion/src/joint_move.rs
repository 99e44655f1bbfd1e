//! All joints at once (MOVJ).

use dobot_arm::{Degrees, Joints};

use crate::pace::Pace;
use crate::plan_error::finite;
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
        let [base, rear, fore, servo] = ways(&from, &to);
        finite("base angle's way", base)?;
        finite("rear arm angle's way", rear)?;
        finite("forearm angle's way", fore)?;
        finite("servo angle's way", servo)?;
        let joints_deg = base.abs().max(rear.abs()).max(fore.abs());
        let pace = Pace::of(joints_deg, speeds.joint_deg_s, speeds.joint_deg_s2).with(Pace::of(
            servo.abs(),
            speeds.servo_deg_s,
            speeds.servo_deg_s2,
        ));
        Ok(Self {
            from,
            to,
            profile: pace.profile()?,
        })
    }

    /// The joint angles at a time.
    #[must_use]
    pub fn joints_at(&self, t_s: f64) -> Joints {
        if t_s >= self.profile.duration_s() {
            return self.to;
        }
        let share = self.profile.distance_at(t_s);
        let [base, rear, fore, servo] = ways(&self.from, &self.to);
        Joints {
            base: self.from.base + Degrees(base * share),
            rear: self.from.rear + Degrees(rear * share),
            fore: self.from.fore + Degrees(fore * share),
            servo: self.from.servo + Degrees(servo * share),
        }
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

fn ways(from: &Joints, to: &Joints) -> [f64; 4] {
    [
        to.base.0 - from.base.0,
        to.rear.0 - from.rear.0,
        to.fore.0 - from.fore.0,
        to.servo.0 - from.servo.0,
    ]
}
