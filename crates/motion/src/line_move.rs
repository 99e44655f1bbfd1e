//! Straight moves (MOVL).

use dobot_arm::Pose;

use crate::plan_error::finite;
use crate::timing_law::TimingLaw;
use crate::{PlanError, Profile, Speeds};

/// A move of the tool along a straight line (MOVL; Table 3.7, note N12).
///
/// The tool rotates in proportion to the distance; if that is too fast for the servo, the line is
/// slowed down to match the rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineMove {
    from: Pose,
    to: Pose,
    profile: Profile,
}

impl LineMove {
    /// Plans the move; it takes 0 s if there is nothing to move or rotate.
    ///
    /// # Errors
    ///
    /// [`PlanError`] if a coordinate is not finite or a speed or acceleration is not positive.
    pub fn new(from: Pose, to: Pose, speeds: &Speeds) -> Result<Self, PlanError> {
        speeds.check()?;
        let length_mm = from.position.distance(to.position).0;
        let turn_deg = (to.rotation - from.rotation).abs().0;
        finite("length of the line", length_mm)?;
        finite("turn of the tool", turn_deg)?;
        let law = TimingLaw::of(length_mm, speeds.line_mm_s, speeds.line_mm_s2).with(
            TimingLaw::of(turn_deg, speeds.servo_deg_s, speeds.servo_deg_s2),
        );
        Ok(Self {
            from,
            to,
            profile: law.profile()?,
        })
    }

    /// Returns the pose at a time.
    #[must_use]
    pub fn pose_at(&self, t_s: f64) -> Pose {
        if t_s >= self.profile.duration_s() {
            return self.to;
        }
        let share = self.profile.distance_at(t_s);
        let Pose { position, rotation } = self.from;
        Pose {
            position: position + (self.to.position - position) * share,
            rotation: rotation + (self.to.rotation - rotation) * share,
        }
    }

    /// Returns the duration.
    #[must_use]
    pub const fn duration_s(&self) -> f64 {
        self.profile.duration_s()
    }

    /// Returns the end.
    #[must_use]
    pub const fn target(&self) -> Pose {
        self.to
    }
}
