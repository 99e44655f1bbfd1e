//! What arm and link can do.

use dobot_arm::TICK_S;
use dobot_wire::Dialect;

use crate::error::{not_negative, positive};
use crate::speed::sampled_acceleration::WINDOW_S;
use crate::{Cornering, DrawingTool, PlanError};

/// What arm and link can do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmLimits {
    /// Largest acceleration of the tool, along its path and across it, in mm/s2.
    pub acceleration_mm_s2: f64,
    /// The largest speed of base, rear arm and forearm, in degrees per second. Where a millimetre
    /// takes them many degrees, near the axis of the base or with the arm stretched, the tool is
    /// planned slower.
    pub joint_speed_deg_s: f64,
    /// How near to its axis the arm gets, in mm: ways between strokes lead around what is nearer, and never behind the
    /// arm. 0 where they may all be straight.
    pub nearest_mm: f64,
    /// How far an imagined arc may cut a corner, in mm; best twice the tolerance of the drawing: where
    /// vectors stand for a curve their corners lie outside of it by up to the tolerance, and the
    /// arc then lies inside of it by no more. See [`Cornering`](crate::Cornering).
    pub corner_deviation_mm: f64,
    /// How fast vectors come.
    pub link: LinkRate,
    /// Whether the arm cuts each vector into whole ticks of 20 ms and begins it with the end speed
    /// of the one before, as a stock arm does (notes N5 and N48).
    pub has_ticks: bool,
}

impl ArmLimits {
    /// An arm that speaks this dialect.
    #[must_use]
    pub fn of(dialect: Dialect) -> Self {
        Self {
            link: LinkRate::of(dialect),
            has_ticks: !dialect.uses_start_speed,
            ..Self::default()
        }
    }

    /// How its corners are measured.
    #[must_use]
    pub const fn cornering(&self) -> Cornering {
        Cornering {
            acceleration_mm_s2: self.acceleration_mm_s2,
            deviation_mm: self.corner_deviation_mm,
            window_s: WINDOW_S,
        }
    }

    /// What speeds are planned with, in mm/s2: the spared part keeps rounded ones within the acceleration.
    pub(super) fn planned_acceleration_mm_s2(&self) -> f64 {
        self.acceleration_mm_s2 * (1.0 - 1e-5)
    }

    /// Whether the arm can keep the speeds of a tool: where it has ticks, speeds are whole multiples
    /// of what a tick changes, and less than half of that is none.
    pub(super) fn check_keeps(&self, tool: &DrawingTool) -> Result<(), PlanError> {
        let least = self.least_kept_mm_s();
        let speeds = tool.speeds_mm_s().into_iter();
        match speeds.filter(|_| self.has_ticks).find(|it| it.1 < least) {
            None => Ok(()),
            Some((name, found)) => Err(PlanError::TooSlow {
                name,
                found,
                least,
                acceleration: self.acceleration_mm_s2,
            }),
        }
    }

    /// The least speed that an arm with ticks keeps, in mm/s.
    pub(super) fn least_kept_mm_s(&self) -> f64 {
        self.acceleration_mm_s2 * TICK_S / 2.0
    }

    /// How long a vector from rest to rest has to be, in mm: where the arm has ticks a shorter one would
    /// not accelerate at all, and with the little speed that is kept from before it might never end
    /// (note N51).
    pub(super) fn least_from_rest_mm(&self) -> f64 {
        if self.has_ticks {
            // The peak is half of what a tick changes, and a bit: a length of a t2 / 4.
            FROM_REST * self.acceleration_mm_s2 * TICK_S * TICK_S / 4.0
        } else {
            0.0
        }
    }

    /// The largest speed for a vector from rest to rest, in mm/s: where the arm has ticks the next below
    /// this one with which as many ticks are faster as are slower.
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
/// How much above whole steps of a tick's change a largest speed is, so that it is rounded to these
/// whatever less than a step the arm has kept from before.
const KEPT_STEPS: f64 = 0.45;

impl Default for ArmLimits {
    /// An arm that does as the document says, behind a stock arm's link: 100 mm/s2, and 100 deg/s
    /// as in a stock arm's own moves.
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

/// How fast the link brings vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkRate {
    /// Seconds from one vector to the next; 0 where the link does not matter.
    pub period_s: f64,
}

impl LinkRate {
    /// One vector for each status that an arm of this dialect sends.
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
    /// One vector per status, which a stock arm sends every 80 ms.
    fn default() -> Self {
        Self::of(Dialect::SPECIFICATION)
    }
}
