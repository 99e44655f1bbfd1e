//! One profile for things that move together.

use crate::{PlanError, Profile};

/// The fastest profile from 0 to 1, at rest at both ends, within everyone's limits.
///
/// Each thing goes its whole way while the profile goes from 0 to 1. The pace is that of the
/// slowest in speed and that of the slowest in acceleration. Nothing to move takes no time;
/// nor does a way too small to calculate with (below 1e-300).
#[derive(Clone, Copy, Debug)]
pub(crate) struct TimingLaw {
    /// How long the slowest would take at full speed all the way.
    pub(crate) per_speed_s: f64,
    /// The largest way per acceleration.
    pub(crate) per_acceleration_s2: f64,
}

impl TimingLaw {
    /// The pace of a thing that goes `way` within `speed` and `acceleration`.
    pub(crate) fn of(way: f64, speed: f64, acceleration: f64) -> Self {
        Self {
            per_speed_s: way / speed,
            per_acceleration_s2: way / acceleration,
        }
    }

    /// The pace of both together.
    pub(crate) const fn with(self, other: Self) -> Self {
        Self {
            per_speed_s: self.per_speed_s.max(other.per_speed_s),
            per_acceleration_s2: self.per_acceleration_s2.max(other.per_acceleration_s2),
        }
    }

    /// The profile over shares of the way, 0 to 1.
    pub(crate) fn profile(self) -> Result<Profile, PlanError> {
        let (speed, acceleration) = (1.0 / self.per_speed_s, 1.0 / self.per_acceleration_s2);
        if !(speed.is_finite() && acceleration.is_finite()) {
            return Ok(Profile::default());
        }
        Profile::plan(1.0, 0.0, 0.0, speed, acceleration).finite()
    }
}
