//! What arm and link can do: heights, speeds and the rate of vectors.

use thiserror::Error;

/// Heights and speeds of the pen. Heights are those of the wrist in the base frame, whose origin
/// is about 103 mm above the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pen {
    /// Z where the pen draws, in mm.
    pub down_z_mm: f64,
    /// Z where it travels, in mm; above `down_z_mm`.
    pub up_z_mm: f64,
    /// Largest speed while drawing, in mm/s.
    pub draw_speed_mm_s: f64,
    /// Largest speed while travelling, in mm/s.
    pub travel_speed_mm_s: f64,
    /// Largest speed up and down, in mm/s.
    pub lift_speed_mm_s: f64,
    /// Acceleration along the path, in mm/s2.
    pub acceleration_mm_s2: f64,
    /// How far an imagined arc may cut a corner, in mm; see [`Cornering`](crate::Cornering).
    pub corner_deviation_mm: f64,
    /// Whether it comes to rest at the end of each vector. On a stock arm it has to: there only a
    /// vector that begins and ends at rest is as long as it should be (note N48).
    pub stops_at_corners: bool,
}

impl Pen {
    pub(crate) fn check(&self) -> Result<(), PlanError> {
        positive("draw speed", self.draw_speed_mm_s, "mm/s")?;
        positive("travel speed", self.travel_speed_mm_s, "mm/s")?;
        positive("lift speed", self.lift_speed_mm_s, "mm/s")?;
        positive("acceleration", self.acceleration_mm_s2, "mm/s2")?;
        positive("corner deviation", self.corner_deviation_mm, "mm")?;
        let (down_mm, up_mm) = (self.down_z_mm, self.up_z_mm);
        if up_mm - down_mm >= LEAST_LIFT_MM && (up_mm - down_mm).is_finite() {
            return Ok(());
        }
        Err(PlanError::PenHeights { down_mm, up_mm })
    }
}

impl Default for Pen {
    /// Down at -40 mm, up at -30 mm; 40 mm/s to draw and to lift, 80 mm/s to travel, 100 mm/s2.
    fn default() -> Self {
        Self {
            down_z_mm: -40.0,
            up_z_mm: -30.0,
            draw_speed_mm_s: 40.0,
            travel_speed_mm_s: 80.0,
            lift_speed_mm_s: 40.0,
            acceleration_mm_s2: 100.0,
            corner_deviation_mm: 0.02,
            stops_at_corners: false,
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
    pub(crate) fn check(self) -> Result<(), PlanError> {
        if self.period_s >= 0.0 && self.period_s.is_finite() {
            return Ok(());
        }
        let period_s = self.period_s;
        Err(PlanError::LinkPeriod { period_s })
    }
}

impl Default for LinkRate {
    /// One vector per status, which a stock arm sends every 80 ms, and 5 % to spare.
    fn default() -> Self {
        Self { period_s: 0.084 }
    }
}

/// Why strokes cannot be planned.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PlanError {
    /// There is no stroke.
    #[error("there is no stroke to plan")]
    NoStrokes,
    /// A setting that must be positive is not.
    #[error("{name} is {found} {unit}; it must be a number above 0")]
    NotPositive {
        /// Which setting.
        name: &'static str,
        /// Its unit.
        unit: &'static str,
        /// What it is.
        found: f64,
    },
    /// The time between vectors makes no sense.
    #[error("the link period is {period_s} s; it must be a number from 0 up")]
    LinkPeriod {
        /// What it is.
        period_s: f64,
    },
    /// The pen would not leave the paper.
    #[error(
        "pen up is at {up_mm} mm and pen down at {down_mm} mm; up must be at least 0.1 mm higher"
    )]
    PenHeights {
        /// Z where the pen draws.
        down_mm: f64,
        /// Z where it travels.
        up_mm: f64,
    },
}

fn positive(name: &'static str, found: f64, unit: &'static str) -> Result<(), PlanError> {
    if found > 0.0 && found.is_finite() {
        return Ok(());
    }
    Err(PlanError::NotPositive { name, unit, found })
}

const LEAST_LIFT_MM: f64 = 0.1;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    fn error(pen: Pen) -> String {
        pen.check().unwrap_err().to_string()
    }

    #[test]
    fn the_defaults_make_sense() {
        Pen::default().check().unwrap();
        LinkRate::default().check().unwrap();
        LinkRate { period_s: 0.0 }.check().unwrap();
    }

    #[test]
    fn settings_that_make_no_sense_are_refused() {
        let pen = Pen::default();
        assert_eq!(
            error(Pen {
                draw_speed_mm_s: 0.0,
                ..pen
            }),
            "draw speed is 0 mm/s; it must be a number above 0"
        );
        assert_eq!(
            error(Pen {
                acceleration_mm_s2: f64::NAN,
                ..pen
            }),
            "acceleration is NaN mm/s2; it must be a number above 0"
        );
        assert_eq!(
            error(Pen {
                up_z_mm: -40.0,
                ..pen
            }),
            "pen up is at -40 mm and pen down at -40 mm; up must be at least 0.1 mm higher"
        );
        assert_eq!(
            LinkRate { period_s: -1.0 }.check().unwrap_err().to_string(),
            "the link period is -1 s; it must be a number from 0 up"
        );
    }
}
