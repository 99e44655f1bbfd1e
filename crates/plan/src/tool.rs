//! The drawing tools: pen and laser.

use dobot_arm::Tool;

use crate::error::{not_negative, positive};
use crate::laser::laser_path::run_mm;
use crate::{ArmLimits, PlanError};

/// A drawing tool with its motion settings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DrawingTool {
    /// A pen, lifted between strokes.
    Pen(Pen),
    /// A laser, switched off between strokes.
    Laser(Laser),
}

impl DrawingTool {
    /// Returns the tool with another drawing or burning speed, in mm/s.
    #[must_use]
    pub const fn at_speed(self, speed_mm_s: f64) -> Self {
        match self {
            Self::Pen(pen) => Self::Pen(Pen {
                draw_speed_mm_s: speed_mm_s,
                ..pen
            }),
            Self::Laser(laser) => Self::Laser(Laser {
                burn_speed_mm_s: speed_mm_s,
                ..laser
            }),
        }
    }

    /// Returns the maximum speed while drawing or burning, in mm/s.
    #[must_use]
    pub const fn speed_mm_s(&self) -> f64 {
        match self {
            Self::Pen(pen) => pen.draw_speed_mm_s,
            Self::Laser(laser) => laser.burn_speed_mm_s,
        }
    }

    /// Whether it is a laser.
    #[must_use]
    pub const fn burns(&self) -> bool {
        self.tool().burns()
    }

    /// Whether it is a laser that cuts through the material.
    #[must_use]
    pub const fn cuts(&self) -> bool {
        matches!(self, Self::Laser(laser) if laser.cuts)
    }

    /// Returns the number of separate passes over each stroke.
    #[must_use]
    pub const fn times(&self) -> u32 {
        match self {
            Self::Pen(_) => 1,
            Self::Laser(laser) => laser.times,
        }
    }

    /// Returns the tool with this number of passes over each stroke; a pen always has one.
    #[must_use]
    pub const fn times_over(self, times: u32) -> Self {
        match self {
            Self::Pen(_) => self,
            Self::Laser(laser) => Self::Laser(Laser { times, ..laser }),
        }
    }

    /// Returns the travel height above the paper, in mm; 0 for a laser.
    #[must_use]
    pub const fn lift_mm(&self) -> f64 {
        match self {
            Self::Pen(pen) => pen.lift_mm,
            Self::Laser(_) => 0.0,
        }
    }

    /// Returns the maximum speed between strokes, in mm/s.
    #[must_use]
    pub const fn travel_speed_mm_s(&self) -> f64 {
        match self {
            Self::Pen(pen) => pen.travel_speed_mm_s,
            Self::Laser(laser) => laser.travel_speed_mm_s,
        }
    }

    /// Returns the maximum distance beyond the ends of a stroke, in mm: a laser accelerates before
    /// and brakes after it.
    #[must_use]
    pub fn run_mm(&self, arm_limits: &ArmLimits) -> f64 {
        match self {
            Self::Pen(_) => 0.0,
            Self::Laser(laser) => run_mm(laser, arm_limits),
        }
    }

    /// Returns the tool that must be mounted.
    #[must_use]
    pub const fn tool(&self) -> Tool {
        match self {
            Self::Pen(_) => Tool::Pen,
            Self::Laser(_) => Tool::Laser,
        }
    }

    /// Returns the tool in the arm's configuration: the laser is closer to the arm than the pen.
    #[must_use]
    pub const fn end_effector(&self) -> Tool {
        self.tool().end_effector()
    }

    /// Returns the distance of the tool from the wrist, in mm.
    pub(super) const fn reach_mm(&self) -> f64 {
        self.tool().reach().0
    }

    /// Returns its speeds by name, in mm/s.
    pub(super) fn speeds_mm_s(&self) -> Vec<(&'static str, f64)> {
        match self {
            Self::Pen(pen) => {
                let touches = pen.touch_mm > 0.0;
                let touch = touches.then_some(("touch speed", pen.touch_speed_mm_s));
                let speeds = [
                    ("draw speed", pen.draw_speed_mm_s),
                    ("travel speed", pen.travel_speed_mm_s),
                    ("lift speed", pen.lift_speed_mm_s),
                ];
                speeds.into_iter().chain(touch).collect()
            }
            Self::Laser(laser) => vec![
                ("burn speed", laser.burn_speed_mm_s),
                ("travel speed", laser.travel_speed_mm_s),
            ],
        }
    }

    pub(super) fn check(&self) -> Result<(), PlanError> {
        for (name, found) in self.speeds_mm_s() {
            positive(name, found, "mm/s")?;
        }
        match self {
            Self::Pen(pen) => pen.check(),
            Self::Laser(laser) => positive("number of times to burn", laser.times.into(), ""),
        }
    }
}

impl Default for DrawingTool {
    fn default() -> Self {
        Self::Pen(Pen::default())
    }
}

/// The motion settings of a pen.
///
/// It touches the paper slowly: the last part of the way down is a separate vector. The protocol
/// has no safe wait: a pause belongs to a target, and a target at the current position makes a
/// stock arm lose its pose (note N34).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pen {
    /// The travel height above the paper, in mm; at least 0.1.
    pub lift_mm: f64,
    /// The maximum speed while drawing, in mm/s.
    pub draw_speed_mm_s: f64,
    /// The maximum speed while travelling, in mm/s.
    pub travel_speed_mm_s: f64,
    /// The maximum speed up and down, in mm/s.
    pub lift_speed_mm_s: f64,
    /// The last part of the way down that is slow, in mm; 0 for none.
    pub touch_mm: f64,
    /// The speed of that part, in mm/s.
    pub touch_speed_mm_s: f64,
}

impl Pen {
    fn check(&self) -> Result<(), PlanError> {
        positive("touch speed", self.touch_speed_mm_s, "mm/s")?;
        not_negative("touch way", self.touch_mm, "mm")?;
        if self.lift_mm >= MIN_LIFT_MM && self.lift_mm.is_finite() {
            return Ok(());
        }
        Err(PlanError::Lift(self.lift_mm))
    }
}

impl Default for Pen {
    /// Returns a lift of 10 mm; 40 mm/s for drawing and lifting, 80 mm/s for travelling. The pen
    /// touches the paper as it comes to rest there anyway; a soft pen may need `touch_mm` of 1 at
    /// 10 mm/s.
    fn default() -> Self {
        Self {
            lift_mm: 10.0,
            draw_speed_mm_s: 40.0,
            travel_speed_mm_s: 80.0,
            lift_speed_mm_s: 40.0,
            touch_mm: 0.0,
            touch_speed_mm_s: 10.0,
        }
    }
}

/// The motion settings of a laser. It is on or off; the speed determines its effect on the
/// material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Laser {
    /// The burning speed, in mm/s: constant along a stroke if its corners allow that.
    pub burn_speed_mm_s: f64,
    /// The maximum speed between strokes, laser off, in mm/s.
    pub travel_speed_mm_s: f64,
    /// The number of passes over everything, at least 1.
    pub times: u32,
    /// Whether each stroke is burned this many times before the next one, instead of all strokes in
    /// turn.
    pub by_stroke: bool,
    /// Whether it cuts through: cut-out parts move, so inner strokes come first.
    pub cuts: bool,
}

impl Default for Laser {
    /// Returns one pass at 10 mm/s; 80 mm/s for travelling.
    fn default() -> Self {
        Self {
            burn_speed_mm_s: 10.0,
            travel_speed_mm_s: 80.0,
            times: 1,
            by_stroke: false,
            cuts: false,
        }
    }
}

const MIN_LIFT_MM: f64 = 0.1;
