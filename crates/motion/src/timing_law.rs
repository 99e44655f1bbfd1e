//! The timing law of several axes that move together.

use crate::{PlanError, Profile};

/// The fastest timing law from 0 to 1 that starts and ends at rest and respects the limits of all
/// axes.
///
/// Each axis covers its distance while the law goes from 0 to 1. The axis slowest in speed and the
/// one slowest in acceleration determine it. No distance, or one below 1e-300, takes no time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TimingLaw {
    /// The time of the slowest axis at full speed.
    pub(crate) per_speed_s: f64,
    /// The largest ratio of distance to acceleration.
    pub(crate) per_acceleration_s2: f64,
}

impl TimingLaw {
    /// Creates the law of one axis with a distance, a speed and an acceleration.
    pub(crate) fn of(way: f64, speed: f64, acceleration: f64) -> Self {
        Self {
            per_speed_s: way / speed,
            per_acceleration_s2: way / acceleration,
        }
    }

    /// Combines the laws of two axes.
    pub(crate) const fn with(self, other: Self) -> Self {
        Self {
            per_speed_s: self.per_speed_s.max(other.per_speed_s),
            per_acceleration_s2: self.per_acceleration_s2.max(other.per_acceleration_s2),
        }
    }

    /// Returns the profile over shares of the distance, 0 to 1.
    pub(crate) fn profile(self) -> Result<Profile, PlanError> {
        let (speed, acceleration) = (1.0 / self.per_speed_s, 1.0 / self.per_acceleration_s2);
        if !(speed.is_finite() && acceleration.is_finite()) {
            return Ok(Profile::default());
        }
        Profile::plan(1.0, 0.0, 0.0, speed, acceleration).finite()
    }
}
