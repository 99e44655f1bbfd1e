//! Writing and laser vectors.

use dobot_arm::Position;

use crate::plan_error::finite;
use crate::{PlanError, Profile};

/// A straight stroke with a speed at each end (state 4; Table 2.6).
///
/// Strokes join without stopping: the end speed of one is the start speed of the next.
///
/// ```
/// # use dobot_arm::Position;
/// # use dobot_motion::{Stroke, StrokeSpeeds};
/// let speeds = StrokeSpeeds { start_mm_s: 0.0, end_mm_s: 20.0, max_mm_s: 40.0, acceleration_mm_s2: 100.0 };
/// let stroke = Stroke::new(Position::new(200.0, 0.0, 0.0), Position::new(0.0, 30.0, 0.0), &speeds)?;
/// assert_eq!(stroke.position_at(0.2), Position::new(200.0, 2.0, 0.0));
/// assert_eq!(stroke.end_speed(), 20.0);
/// # Ok::<(), dobot_motion::PlanError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    from: Position,
    to: Position,
    profile: Profile,
}

impl Stroke {
    /// Plans the stroke from a position along a vector; a vector of length 0 takes 0 s.
    ///
    /// If a vector is too short for its two speeds, one of them is lowered as in [`Profile`].
    ///
    /// # Errors
    ///
    /// [`PlanError`] if a coordinate is not finite, or as in [`Profile::new`].
    pub fn new(from: Position, vector: Position, speeds: &StrokeSpeeds) -> Result<Self, PlanError> {
        let to = from + vector;
        finite("end of the stroke", to.x.0 + to.y.0 + to.z.0)?;
        let profile = Profile::new(
            vector.length().0,
            speeds.start_mm_s,
            speeds.end_mm_s,
            speeds.max_mm_s,
            speeds.acceleration_mm_s2,
        )?;
        Ok(Self { from, to, profile })
    }

    /// Returns the position at a time.
    #[must_use]
    pub fn position_at(&self, t_s: f64) -> Position {
        if t_s >= self.profile.duration_s() {
            return self.to;
        }
        let share = self.profile.distance_at(t_s) / self.profile.distance();
        self.from + (self.to - self.from) * share
    }

    /// Returns the speed in mm/s at a time.
    #[must_use]
    pub fn speed_at(&self, t_s: f64) -> f64 {
        self.profile.speed_at(t_s)
    }

    /// Returns the duration.
    #[must_use]
    pub const fn duration_s(&self) -> f64 {
        self.profile.duration_s()
    }

    /// Returns the start speed in mm/s: as requested, or lower if the vector is too short.
    #[must_use]
    pub const fn start_speed(&self) -> f64 {
        self.profile.start_speed()
    }

    /// Returns the end speed in mm/s: as requested, or lower if the vector is too short.
    #[must_use]
    pub const fn end_speed(&self) -> f64 {
        self.profile.end_speed()
    }

    /// Returns the end.
    #[must_use]
    pub const fn target(&self) -> Position {
        self.to
    }
}

/// The speeds of a stroke (Table 2.6) and its acceleration (Table 3.9, state 9, mode 2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrokeSpeeds {
    /// Speed at the start, 0 to the maximum.
    pub start_mm_s: f64,
    /// Speed at the end, 0 to the maximum.
    pub end_mm_s: f64,
    /// The maximum speed, above 0.
    pub max_mm_s: f64,
    /// The maximum acceleration, above 0.
    pub acceleration_mm_s2: f64,
}
