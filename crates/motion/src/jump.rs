//! Moves up, across and down (JUMP).

use dobot_arm::{Degrees, Millimeters, Pose, Position};

use crate::plan_error::{finite, not_negative};
use crate::timing_law::TimingLaw;
use crate::{PlanError, Profile, Speeds};

/// A move over obstacles (JUMP; Table 3.7, Figure 3.2, note N11).
///
/// ```text
///        _______________        height above the higher end
///       |    across     |
///    up |               | down
///       |               * to
///  from *
/// ```
///
/// Each of the three phases starts and ends at rest; a phase without a distance takes no time. In
/// the phase across, reach and base angle are interpolated linearly, so that the reach stays
/// between that of the two ends, and the tool rotates. The base turns in the direction that avoids
/// the angle straight behind it, as its joint requires.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jump {
    from: Pose,
    to: Pose,
    top: Millimeters,
    start: Polar,
    way: Polar,
    up: Profile,
    across: Profile,
    down: Profile,
}

impl Jump {
    /// Plans the jump, which rises to `height` above the higher of its two ends (0 or more).
    ///
    /// # Errors
    ///
    /// [`PlanError`] if a coordinate is not finite, the height is negative, or a speed or
    /// acceleration is not positive.
    pub fn new(
        from: Pose,
        to: Pose,
        height: Millimeters,
        speeds: &Speeds,
    ) -> Result<Self, PlanError> {
        speeds.check()?;
        not_negative("jump height", height.0)?;
        let (start, end) = (Polar::of(from.position), Polar::of(to.position));
        let way = start.way_to(end);
        let top = Millimeters(from.position.z.0.max(to.position.z.0) + height.0);
        let turn = to.rotation - from.rotation;
        finite(
            "top of the jump",
            top.0 + from.position.z.0 + to.position.z.0,
        )?;
        finite("reach of the jump's start", start.reach.0)?;
        finite("reach of the jump's end", end.reach.0)?;
        finite("turn of the tool", turn.0)?;
        let farthest = Millimeters(start.reach.0.max(end.reach.0));
        Ok(Self {
            from,
            to,
            top,
            start,
            way,
            up: vertical(top - from.position.z, speeds)?,
            across: across(way, farthest, turn - way.base, speeds)?,
            down: vertical(top - to.position.z, speeds)?,
        })
    }

    /// Returns the pose at a time.
    #[must_use]
    pub fn pose_at(&self, t_s: f64) -> Pose {
        let across_from_s = self.up.duration_s();
        let down_from_s = across_from_s + self.across.duration_s();
        if t_s >= self.duration_s() {
            self.to
        } else if t_s >= down_from_s {
            let below = self.down.distance_at(t_s - down_from_s);
            at_height(self.to, self.top - Millimeters(below))
        } else if t_s >= across_from_s {
            self.across_at(t_s - across_from_s)
        } else {
            let above = self.up.distance_at(t_s);
            at_height(self.from, self.from.position.z + Millimeters(above))
        }
    }

    /// Returns the duration of all three phases.
    #[must_use]
    pub const fn duration_s(&self) -> f64 {
        self.up.duration_s() + self.across.duration_s() + self.down.duration_s()
    }

    /// Returns when the phase across begins and ends, in seconds since the start.
    #[must_use]
    pub const fn corners_s(&self) -> [f64; 2] {
        let across_from_s = self.up.duration_s();
        [across_from_s, across_from_s + self.across.duration_s()]
    }

    /// Returns the end.
    #[must_use]
    pub const fn target(&self) -> Pose {
        self.to
    }

    fn across_at(&self, t_s: f64) -> Pose {
        let share = self.across.distance_at(t_s);
        let reach = self.start.reach + self.way.reach * share;
        let base = self.start.base + self.way.base * share;
        Pose {
            position: Position::polar(reach, base, self.top),
            rotation: self.from.rotation + (self.to.rotation - self.from.rotation) * share,
        }
    }
}

/// A position in polar coordinates seen from above, or a displacement between two.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Polar {
    reach: Millimeters,
    base: Degrees,
}

impl Polar {
    fn of(position: Position) -> Self {
        Self {
            reach: position.reach(),
            base: position.direction(),
        }
    }

    fn way_to(self, end: Self) -> Self {
        Self {
            reach: end.reach - self.reach,
            base: end.base - self.base,
        }
    }
}

fn at_height(pose: Pose, z: Millimeters) -> Pose {
    Pose {
        position: Position { z, ..pose.position },
        ..pose
    }
}

fn vertical(height: Millimeters, speeds: &Speeds) -> Result<Profile, PlanError> {
    Profile::plan(height.0, 0.0, 0.0, speeds.line_mm_s, speeds.line_mm_s2).finite()
}

/// Returns the timing law of the phase across, which keeps the tool's total acceleration within the
/// line's.
///
/// At a rate `u'` and its change `u''` (shares of the path per s and s2), the acceleration is at
/// most `length u'' + bend u'^2`: the first term along the path, the second from its curvature.
/// With the change `way` of reach, the change `turn` of the base angle, and the larger `reach` of
/// the two ends, `length = hypot(way, reach turn)` and `bend = turn hypot(reach turn, 2 way)`. At
/// full rate the curvature may use half of the limit; the ramps get the rest.
fn across(
    way: Polar,
    farthest: Millimeters,
    servo: Degrees,
    speeds: &Speeds,
) -> Result<Profile, PlanError> {
    let arc_mm = way.base.arc(farthest).abs().0;
    let length_mm = libm::hypot(way.reach.0, arc_mm);
    let bend = Millimeters(libm::hypot(2.0 * way.reach.0, arc_mm));
    let bend_mm = way.base.arc(bend).abs().0;
    let servo = TimingLaw::of(servo.abs().0, speeds.servo_deg_s, speeds.servo_deg_s2);
    let per_speed_s = (length_mm / speeds.line_mm_s)
        .max(libm::sqrt(2.0 * bend_mm / speeds.line_mm_s2))
        .max(servo.per_speed_s);
    let bending_mm_s2 = if bend_mm > 0.0 {
        bend_mm / (per_speed_s * per_speed_s)
    } else {
        0.0
    };
    let along = TimingLaw {
        per_speed_s,
        per_acceleration_s2: length_mm / (speeds.line_mm_s2 - bending_mm_s2),
    };
    along.with(servo).profile()
}
