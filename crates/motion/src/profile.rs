//! Speed profiles along a distance.

use crate::PlanError;
use crate::plan_error::{not_negative, positive};

/// A trapezoidal speed profile over a distance, from a start speed to an end speed.
///
/// ```text
/// speed       peak
///   |       ________
///   |      /        \       1. never above the maximum speed, never steeper than the acceleration
///   |     /          \      2. the area is the distance
///   |    /            \     3. as short a time as 1 and 2 allow
///   | start            end
///   +----+--------+---+---> time
///     speed up  cruise  slow down
/// ```
///
/// If the distance is too short for the two speeds, one of them is lowered: an end speed to the
/// highest that can be reached, or a start speed to the highest from which braking is possible
/// (note N5). [`start_speed`](Self::start_speed) and [`end_speed`](Self::end_speed) return the
/// resulting speeds.
///
/// The unit of length is the caller's: millimetres, degrees, or shares of a whole.
///
/// ```
/// # use dobot_motion::Profile;
/// let profile = Profile::new(100.0, 0.0, 0.0, 50.0, 100.0)?;
/// assert_eq!(profile.duration_s(), 2.5);
/// assert_eq!(profile.distance_at(0.5), 12.5);
///
/// let too_short = Profile::new(2.0, 0.0, 30.0, 50.0, 100.0)?;
/// assert_eq!(too_short.end_speed(), 20.0);
/// # Ok::<(), dobot_motion::PlanError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Profile {
    distance: f64,
    start_speed: f64,
    end_speed: f64,
    peak_speed: f64,
    acceleration: f64,
    /// The end of the acceleration.
    cruise_from_s: f64,
    /// The start of the deceleration.
    cruise_to_s: f64,
    /// The distance of the acceleration.
    cruise_from: f64,
    duration_s: f64,
}

impl Profile {
    /// Plans the fastest profile over `distance` within the limits.
    ///
    /// # Errors
    ///
    /// [`PlanError`] if the distance or a speed is negative, a limit is not positive, a start or
    /// end speed exceeds `max_speed`, or a number is not finite or too large.
    pub fn new(
        distance: f64,
        start_speed: f64,
        end_speed: f64,
        max_speed: f64,
        acceleration: f64,
    ) -> Result<Self, PlanError> {
        not_negative("distance", distance)?;
        positive("maximum speed", max_speed)?;
        positive("acceleration", acceleration)?;
        speed_within("start speed", start_speed, max_speed)?;
        speed_within("end speed", end_speed, max_speed)?;
        Self::plan(distance, start_speed, end_speed, max_speed, acceleration).finite()
    }

    /// Returns the distance covered at a time; 0 before the start, exactly the distance after the
    /// end.
    #[must_use]
    pub fn distance_at(&self, t_s: f64) -> f64 {
        let left_s = self.duration_s - t_s;
        if left_s <= 0.0 {
            self.distance
        } else if t_s <= 0.0 {
            0.0
        } else if t_s < self.cruise_from_s {
            (self.start_speed + 0.5 * self.acceleration * t_s) * t_s
        } else if t_s < self.cruise_to_s {
            self.cruise_from + self.peak_speed * (t_s - self.cruise_from_s)
        } else {
            self.distance - (self.end_speed + 0.5 * self.acceleration * left_s) * left_s
        }
    }

    /// Returns the speed at a time; the start speed before the start, the end speed after the end.
    #[must_use]
    pub fn speed_at(&self, t_s: f64) -> f64 {
        let left_s = self.duration_s - t_s;
        if left_s <= 0.0 {
            self.end_speed
        } else if t_s <= 0.0 {
            self.start_speed
        } else if t_s < self.cruise_from_s {
            self.start_speed + self.acceleration * t_s
        } else if t_s < self.cruise_to_s {
            self.peak_speed
        } else {
            self.end_speed + self.acceleration * left_s
        }
    }

    /// Returns the duration.
    #[must_use]
    pub const fn duration_s(&self) -> f64 {
        self.duration_s
    }

    /// Returns the distance.
    #[must_use]
    pub const fn distance(&self) -> f64 {
        self.distance
    }

    /// Returns the start speed: as requested, or the highest from which braking is possible.
    #[must_use]
    pub const fn start_speed(&self) -> f64 {
        self.start_speed
    }

    /// Returns the end speed: as requested, or the highest that can be reached.
    #[must_use]
    pub const fn end_speed(&self) -> f64 {
        self.end_speed
    }

    /// Returns the peak speed.
    #[must_use]
    pub const fn peak_speed(&self) -> f64 {
        self.peak_speed
    }

    /// Plans like [`new`](Self::new), for valid numbers.
    ///
    /// The speed after accelerating over a distance `d` is `sqrt(v * v + 2 * a * d)`. The curves
    /// from both ends meet at the peak, whose square is the mean of the squared end speeds plus
    /// `a * distance`.
    pub(crate) fn plan(distance: f64, start: f64, end: f64, max_speed: f64, a: f64) -> Self {
        if distance == 0.0 {
            return Self::standstill(start.min(end), a);
        }
        let gain_v2 = 2.0 * a * distance;
        let (start_speed, end_speed) = reachable_speeds(start, end, gain_v2);
        let peak_speed = peak_speed([start_speed, end_speed], gain_v2, max_speed);
        let per_a = 1.0 / a;
        let up_s = (peak_speed - start_speed) * per_a;
        let down_s = (peak_speed - end_speed) * per_a;
        let up = 0.5 * (peak_speed + start_speed) * up_s;
        let down = 0.5 * (peak_speed + end_speed) * down_s;
        let cruise_s = ((distance - up - down) / peak_speed).max(0.0);
        Self {
            distance,
            start_speed,
            end_speed,
            peak_speed,
            acceleration: a,
            cruise_from_s: up_s,
            cruise_to_s: up_s + cruise_s,
            cruise_from: up,
            duration_s: up_s + cruise_s + down_s,
        }
    }

    pub(crate) fn finite(self) -> Result<Self, PlanError> {
        if self.duration_s.is_finite() {
            Ok(self)
        } else {
            Err(PlanError::Endless {
                found: self.duration_s,
            })
        }
    }

    /// Without a distance there is no time: both ends have the lower of the two speeds.
    const fn standstill(speed: f64, acceleration: f64) -> Self {
        Self {
            distance: 0.0,
            start_speed: speed,
            end_speed: speed,
            peak_speed: speed,
            acceleration,
            cruise_from_s: 0.0,
            cruise_to_s: 0.0,
            cruise_from: 0.0,
            duration_s: 0.0,
        }
    }
}

/// Lowers the start or the end speed to one that the other one allows, if the squared speed can change by
/// at most `gain_v2`.
fn reachable_speeds(start: f64, end: f64, gain_v2: f64) -> (f64, f64) {
    let (start_v2, end_v2) = (start * start, end * end);
    if end_v2 > start_v2 + gain_v2 {
        (start, libm::sqrt(start_v2 + gain_v2))
    } else if start_v2 > end_v2 + gain_v2 {
        (libm::sqrt(end_v2 + gain_v2), end)
    } else {
        (start, end)
    }
}

fn peak_speed([start, end]: [f64; 2], gain_v2: f64, max_speed: f64) -> f64 {
    let meet_v2 = 0.5 * (start * start + end * end + gain_v2);
    if meet_v2 < max_speed * max_speed {
        libm::sqrt(meet_v2).max(start).max(end)
    } else {
        max_speed
    }
}

fn speed_within(name: &'static str, found: f64, max: f64) -> Result<(), PlanError> {
    not_negative(name, found)?;
    if found > max {
        return Err(PlanError::AboveMaximum { name, found, max });
    }
    Ok(())
}
