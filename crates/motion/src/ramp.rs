//! Ramps from one speed to another (jog).

use crate::PlanError;
use crate::plan_error::{finite, positive};

/// A change of speed at constant acceleration, followed by constant speed.
///
/// Jogging moves an axis this way: a button sets the target speed, its release sets 0, the opposite
/// button the opposite speed; each starts from the current speed. The sign of a speed is its
/// direction. The unit of length is the caller's.
///
/// ```
/// # use dobot_motion::Ramp;
/// let pressed = Ramp::new(0.0, 15.0, 50.0)?;
/// let released = Ramp::to_rest(pressed.speed_at(2.0), 50.0)?;
/// assert_eq!(released.change_s(), 0.3);
/// assert_eq!(released.change_distance(), 2.25);
/// # Ok::<(), dobot_motion::PlanError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ramp {
    from_speed: f64,
    to_speed: f64,
    /// Signed acceleration of the change.
    acceleration: f64,
    change_s: f64,
}

impl Ramp {
    /// Plans the change from one speed to another.
    ///
    /// # Errors
    ///
    /// [`PlanError`] if a speed is not finite or the acceleration is not positive.
    pub fn new(from_speed: f64, to_speed: f64, acceleration: f64) -> Result<Self, PlanError> {
        finite("speed of the moment", from_speed)?;
        finite("speed aimed at", to_speed)?;
        positive("acceleration", acceleration)?;
        let change = to_speed - from_speed;
        let change_s = change.abs() / acceleration;
        if !change_s.is_finite() {
            return Err(PlanError::Endless { found: change_s });
        }
        Ok(Self {
            from_speed,
            to_speed,
            acceleration: acceleration.copysign(change),
            change_s,
        })
    }

    /// Plans the ramp from a speed down to rest.
    ///
    /// # Errors
    ///
    /// See [`new`](Self::new).
    pub fn to_rest(speed: f64, acceleration: f64) -> Result<Self, PlanError> {
        Self::new(speed, 0.0, acceleration)
    }

    /// Returns the speed at a time; the first speed before the start, the second once it is
    /// reached.
    #[must_use]
    pub fn speed_at(&self, t_s: f64) -> f64 {
        if t_s >= self.change_s {
            self.to_speed
        } else {
            self.from_speed + self.acceleration * t_s.max(0.0)
        }
    }

    /// Returns the signed distance since the start; 0 before the start.
    #[must_use]
    pub fn distance_at(&self, t_s: f64) -> f64 {
        if t_s >= self.change_s {
            self.change_distance() + self.to_speed * (t_s - self.change_s)
        } else {
            let t_s = t_s.max(0.0);
            (self.from_speed + 0.5 * self.acceleration * t_s) * t_s
        }
    }

    /// Returns the duration of the change of speed.
    #[must_use]
    pub const fn change_s(&self) -> f64 {
        self.change_s
    }

    /// Returns the signed distance of the change of speed.
    #[must_use]
    pub const fn change_distance(&self) -> f64 {
        0.5 * (self.from_speed + self.to_speed) * self.change_s
    }
}
