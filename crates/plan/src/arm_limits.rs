//! The limits of arm and link.

use dobot_arm::TICK_S;
use dobot_wire::Dialect;

use crate::error::{not_negative, positive};
use crate::speed::sampled_acceleration::WINDOW_S;
use crate::{Cornering, DrawingTool, PlanError};

/// The limits of arm and link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmLimits {
    /// The maximum acceleration of the tool, along its path and across it, in mm/s2.
    pub acceleration_mm_s2: f64,
    /// The maximum speed of base, rear arm and forearm, in degrees per second. Where a millimetre
    /// turns them by many degrees, near the axis of the base or with the arm stretched, the tool is
    /// planned slower.
    pub joint_speed_deg_s: f64,
    /// The minimum distance from the axis, in mm: paths between strokes detour around it, always in
    /// front of the arm. 0 if all may be straight.
    pub nearest_mm: f64,
    /// How far an imagined arc may cut a corner, in mm; ideally twice the tolerance of the drawing:
    /// the corners of vectors that approximate a curve lie outside it by up to the tolerance, and
    /// the arc then lies inside it by at most as much. See [`Cornering`](crate::Cornering).
    pub corner_deviation_mm: f64,
    /// The rate of the link.
    pub link: LinkRate,
    /// Whether the arm divides each vector into whole ticks of 20 ms and begins it with the end
    /// speed of the one before, as a stock arm does (notes N5 and N48).
    pub has_ticks: bool,
}

impl ArmLimits {
    /// Returns the limits of an arm with this dialect.
    #[must_use]
    pub fn of(dialect: Dialect) -> Self {
        Self {
            link: LinkRate::of(dialect),
            has_ticks: !dialect.uses_start_speed,
            ..Self::default()
        }
    }

    /// Returns the limits at corners.
    #[must_use]
    pub const fn cornering(&self) -> Cornering {
        Cornering {
            acceleration_mm_s2: self.acceleration_mm_s2,
            deviation_mm: self.corner_deviation_mm,
            window_s: WINDOW_S,
        }
    }

    /// Returns the acceleration for planning, in mm/s2: slightly lower, so that rounded speeds stay
    /// within the limit.
    pub(super) fn planned_acceleration_mm_s2(&self) -> f64 {
        self.acceleration_mm_s2 * (1.0 - 1e-5)
    }

    /// Checks that the arm can keep the speeds of a tool: with ticks, speeds are whole multiples of
    /// the change per tick, and less than half of that rounds to zero.
    pub(super) fn check_keeps(&self, tool: &DrawingTool) -> Result<(), PlanError> {
        let least = self.least_kept_mm_s();
        let speeds = tool.speeds_mm_s().into_iter();
        match speeds
            .filter(|_| self.has_ticks)
            .find(|speed| speed.1 < least)
        {
            None => Ok(()),
            Some((name, found)) => Err(PlanError::TooSlow {
                name,
                found,
                least,
                acceleration: self.acceleration_mm_s2,
            }),
        }
    }

    /// Returns the lowest speed that an arm with ticks keeps, in mm/s.
    pub(super) fn least_kept_mm_s(&self) -> f64 {
        self.acceleration_mm_s2 * TICK_S / 2.0
    }

    /// Returns the minimum length of a vector from rest to rest, in mm: on an arm with ticks a
    /// shorter one would not accelerate, and with a small residual speed it might never end (note
    /// N51).
    pub(super) fn least_from_rest_mm(&self) -> f64 {
        if self.has_ticks {
            // The peak is slightly above half the change per tick: a length of a t2 / 4.
            FROM_REST * self.acceleration_mm_s2 * TICK_S * TICK_S / 4.0
        } else {
            0.0
        }
    }

    /// Returns the maximum speed of a vector from rest to rest, in mm/s: on an arm with ticks the
    /// next lower speed with equal numbers of accelerating and decelerating ticks.
    pub(super) fn rest_to_rest_mm_s(&self, wanted_mm_s: f64) -> f64 {
        if !self.has_ticks {
            return wanted_mm_s;
        }
        let step_mm_s = self.acceleration_mm_s2 * TICK_S;
        let steps = (wanted_mm_s / step_mm_s - KEPT_STEPS).floor().max(1.0);
        (steps + KEPT_STEPS) * step_mm_s
    }

    pub(super) fn check(&self) -> Result<(), PlanError> {
        positive("acceleration", self.acceleration_mm_s2, "mm/s2")?;
        positive("joint speed", self.joint_speed_deg_s, "deg/s")?;
        not_negative("nearest distance", self.nearest_mm, "mm")?;
        positive("corner deviation", self.corner_deviation_mm, "mm")?;
        self.link.check()
    }
}

const FROM_REST: f64 = 1.2;
/// The offset of a maximum speed above whole steps, so that it rounds to them with any residual
/// speed below one step.
const KEPT_STEPS: f64 = 0.45;

impl Default for ArmLimits {
    /// Returns the limits of an arm as documented, behind a stock arm's link: 100 mm/s2, and 100
    /// deg/s as in a stock arm's own moves.
    fn default() -> Self {
        Self {
            acceleration_mm_s2: 100.0,
            joint_speed_deg_s: 100.0,
            nearest_mm: 0.0,
            corner_deviation_mm: 0.1,
            link: LinkRate::default(),
            has_ticks: false,
        }
    }
}

/// The rate at which the link delivers vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkRate {
    /// The seconds between two vectors; 0 if the link does not matter.
    pub period_s: f64,
}

impl LinkRate {
    /// Returns a rate of one vector per status of an arm with this dialect.
    #[must_use]
    pub const fn of(dialect: Dialect) -> Self {
        Self {
            period_s: dialect.status_period().as_secs_f64(),
        }
    }

    fn check(self) -> Result<(), PlanError> {
        not_negative("link period", self.period_s, "s")
    }
}

impl Default for LinkRate {
    /// Returns one vector per status, which a stock arm sends every 80 ms.
    fn default() -> Self {
        Self::of(Dialect::SPECIFICATION)
    }
}
