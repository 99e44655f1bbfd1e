//! What draws: a pen or a laser, and how it is moved.

use dobot_arm::Tool;

use crate::error::{not_negative, positive};
use crate::laser::laser_path::run_mm;
use crate::{ArmLimits, PlanError};

/// What draws, and how it is moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DrawingTool {
    /// A pen, lifted between strokes.
    Pen(Pen),
    /// A laser, off between strokes.
    Laser(Laser),
}

impl DrawingTool {
    /// The same tool, drawing or burning at this speed, in mm/s.
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

    /// Largest speed while drawing or burning, in mm/s.
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

    /// Whether it is a laser that cuts the material through.
    #[must_use]
    pub const fn cuts(&self) -> bool {
        matches!(self, Self::Laser(laser) if laser.cuts)
    }

    /// How often it goes over each stroke, lifted or switched off in between.
    #[must_use]
    pub const fn times(&self) -> u32 {
        match self {
            Self::Pen(_) => 1,
            Self::Laser(laser) => laser.times,
        }
    }

    /// The same tool, going over each stroke so often; a pen does so once.
    #[must_use]
    pub const fn times_over(self, times: u32) -> Self {
        match self {
            Self::Pen(_) => self,
            Self::Laser(laser) => Self::Laser(Laser { times, ..laser }),
        }
    }

    /// How high above the paper it travels, in mm; 0 for a laser.
    #[must_use]
    pub const fn lift_mm(&self) -> f64 {
        match self {
            Self::Pen(pen) => pen.lift_mm,
            Self::Laser(_) => 0.0,
        }
    }

    /// Largest speed between strokes, in mm/s.
    #[must_use]
    pub const fn travel_speed_mm_s(&self) -> f64 {
        match self {
            Self::Pen(pen) => pen.travel_speed_mm_s,
            Self::Laser(laser) => laser.travel_speed_mm_s,
        }
    }

    /// How far beyond the ends of a stroke it goes at the most, in mm: a laser gets to its speed before a stroke and loses
    /// it behind.
    #[must_use]
    pub fn run_mm(&self, arm_limits: &ArmLimits) -> f64 {
        match self {
            Self::Pen(_) => 0.0,
            Self::Laser(laser) => run_mm(laser, arm_limits),
        }
    }

    /// The tool that has to be mounted for it.
    #[must_use]
    pub const fn tool(&self) -> Tool {
        match self {
            Self::Pen(_) => Tool::Pen,
            Self::Laser(_) => Tool::Laser,
        }
    }

    /// The tool that the arm is configured for: the laser is nearer to the arm than the pen.
    #[must_use]
    pub const fn end_effector(&self) -> Tool {
        self.tool().end_effector()
    }

    /// How far it reaches beyond the wrist, in mm.
    pub(super) const fn reach_mm(&self) -> f64 {
        self.tool().reach().0
    }

    /// Its speeds by name, in mm/s.
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

/// How a pen is moved.
///
/// It settles on the paper by touching it slowly: the last part of the way down is a vector of its
/// own. The protocol has no wait that is safe everywhere: a pause belongs to a target, and a target
/// where the arm stands makes a stock arm lose its pose (note N34).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pen {
    /// How high above the paper it travels, in mm; from 0.1 up.
    pub lift_mm: f64,
    /// Largest speed while drawing, in mm/s.
    pub draw_speed_mm_s: f64,
    /// Largest speed while travelling, in mm/s.
    pub travel_speed_mm_s: f64,
    /// Largest speed up and down, in mm/s.
    pub lift_speed_mm_s: f64,
    /// Over how much of the way down it touches the paper slowly, in mm; 0 for not at all.
    pub touch_mm: f64,
    /// How slowly, in mm/s.
    pub touch_speed_mm_s: f64,
}

impl Pen {
    fn check(&self) -> Result<(), PlanError> {
        positive("touch speed", self.touch_speed_mm_s, "mm/s")?;
        not_negative("touch way", self.touch_mm, "mm")?;
        if self.lift_mm >= LEAST_LIFT_MM && self.lift_mm.is_finite() {
            return Ok(());
        }
        Err(PlanError::Lift(self.lift_mm))
    }
}

impl Default for Pen {
    /// 10 mm up; 40 mm/s to draw and to lift, 80 mm/s to travel. It touches the paper as it comes to
    /// rest there anyway; a soft one may want `touch_mm` of 1 at 10 mm/s.
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

/// How a laser is moved. It is on or off: its power on the material is set by the speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Laser {
    /// Speed while burning, in mm/s: the same all along a stroke, where its corners allow that.
    pub burn_speed_mm_s: f64,
    /// Largest speed between strokes, laser off, in mm/s.
    pub travel_speed_mm_s: f64,
    /// How often everything is burned, one time after the other; from 1 up.
    pub times: u32,
    /// Whether a stroke is burned so often before the next one is, and not all of them once before all
    /// of them again.
    pub by_stroke: bool,
    /// Whether it burns through: what is cut out moves, so that what lies inside has to come first.
    pub cuts: bool,
}

impl Default for Laser {
    /// Once, at 10 mm/s; 80 mm/s to travel.
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

const LEAST_LIFT_MM: f64 = 0.1;
