//! The trace of a plan executed by a virtual arm: ink, times and deviations.

mod follow;

use std::time::Duration;

use dobot_arm::Position;
use dobot_geometry::{PathDistance, Stroke};
use dobot_plan::{Paper, Plan};
use thiserror::Error;

use crate::output::ink::{InkLine, point, writes};

/// The trace of a plan executed by a virtual arm.
///
/// It begins when the arm leaves the start of the plan, and ends with the plan's last vector, or
/// with the last sample if that vector was not executed.
#[derive(Clone, Debug)]
pub struct Trace<'a> {
    pub(crate) plan: &'a Plan,
    began: Duration,
    pub(crate) moments: Vec<TracePoint>,
    /// The index of the moment at which each executed vector ended.
    pub(crate) ends: Vec<usize>,
}

/// A sample of a virtual arm's tool: once per tick of 20 ms while it moves, and at every corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The time on the arm's clock.
    pub at: Duration,
    /// The position of the tool.
    pub position: Position,
    /// Whether the laser was on, on the way here.
    pub laser: bool,
}

/// A point of a trace.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TracePoint {
    /// The time since the start.
    pub(crate) t_s: f64,
    pub(crate) position: Position,
    pub(crate) ink: Ink,
    /// The distance of the ink from the wanted path; 0 without ink.
    pub(crate) error_mm: f64,
}

/// The ink of a moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ink {
    /// Nothing.
    None,
    /// A line from the moment before.
    Line,
    /// A dot, which may begin a line.
    Begin,
}

impl<'a> Trace<'a> {
    /// Evaluates the samples of a virtual arm for a plan on this paper and compares its ink with
    /// the wanted path. Samples before the start of the plan are ignored.
    ///
    /// # Errors
    ///
    /// [`StartNotReached`] if the samples never reach the start of the plan.
    pub fn new(
        plan: &'a Plan,
        paper: &Paper,
        samples: &[Sample],
        wanted: &[Stroke],
    ) -> Result<Self, StartNotReached> {
        // There is at least the sample at the start of the plan.
        let samples = &samples[follow::beginning(plan, samples)?..];
        let ends = follow::ends(plan, samples);
        let all = ends.len() == plan.moves.len();
        let count = ends
            .last()
            .filter(|_| all)
            .map_or(samples.len(), |index| index + 1);
        let samples = &samples[..count];
        let mut near = PathDistance::new(wanted);
        let moment = |(sample, ink): (&Sample, Ink)| TracePoint {
            t_s: sample.at.saturating_sub(samples[0].at).as_secs_f64(),
            position: sample.position,
            ink,
            error_mm: if ink == Ink::None {
                0.0
            } else {
                near.distance_mm(point(sample.position))
            },
        };
        let moments = samples.iter().zip(inks(plan, paper, samples)).map(moment);
        Ok(Self {
            plan,
            began: samples[0].at,
            moments: moments.collect(),
            ends,
        })
    }

    /// Returns the lines on the paper.
    #[must_use]
    pub fn ink(&self) -> Vec<InkLine> {
        lines(self.moments.iter().zip(self.passes()))
    }

    /// Returns the start time on the arm's clock.
    #[must_use]
    pub const fn began(&self) -> Duration {
        self.began
    }

    /// Returns the number of executed vectors.
    #[must_use]
    pub const fn vectors(&self) -> usize {
        self.ends.len()
    }

    /// Returns the pass of each moment: a path belongs to the moment at its end, and everything
    /// after the last vector to its pass.
    pub(crate) fn passes(&self) -> impl Iterator<Item = u32> {
        let moves = &self.plan.moves;
        let mut vector = 0;
        (0..self.moments.len()).map(move |moment| {
            while vector + 1 < moves.len() && self.ends.get(vector).is_some_and(|&end| end < moment)
            {
                vector += 1;
            }
            moves.get(vector).map_or(0, |vector| vector.pass)
        })
    }
}

/// The error returned when the samples never reach the start of the plan.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error(
    "the arm never reached the start of the plan at x {:.1}, y {:.1}, z {:.1} mm; the closest sample is {nearest_mm:.1} mm away",
    start[0], start[1], start[2]
)]
pub struct StartNotReached {
    /// The start of the plan: X, Y, Z in mm.
    pub start: [f64; 3],
    /// The minimum distance of the samples from it, in mm; infinite without samples.
    pub nearest_mm: f64,
}

/// Returns the lines on the paper from moments with their passes.
pub(crate) fn lines<'a>(moments: impl Iterator<Item = (&'a TracePoint, u32)>) -> Vec<InkLine> {
    let mut lines: Vec<InkLine> = Vec::new();
    for (moment, pass) in moments {
        if moment.ink == Ink::Begin {
            lines.push(InkLine {
                stroke: Stroke::default(),
                errors_mm: Vec::new(),
                pass,
            });
        }
        if let Some(line) = lines.last_mut().filter(|_| moment.ink != Ink::None) {
            line.stroke.points.push(point(moment.position));
            line.errors_mm.push(moment.error_mm);
        }
    }
    lines
}

/// Returns the ink of each sample: a pen writes when it is down, a laser when it is on.
fn inks(plan: &Plan, paper: &Paper, samples: &[Sample]) -> Vec<Ink> {
    let burns = plan.burns();
    let here = |i: usize| match samples.get(i) {
        Some(sample) if burns => sample.laser || samples.get(i + 1).is_some_and(|next| next.laser),
        Some(sample) => writes(sample.position, paper),
        None => false,
    };
    let on_the_way = |i: usize| match (burns, i) {
        (_, 0) => false,
        (true, _) => samples[i].laser,
        (false, _) => here(i - 1) && here(i),
    };
    let ink = |i| match (on_the_way(i), here(i)) {
        (true, _) => Ink::Line,
        (false, true) => Ink::Begin,
        (false, false) => Ink::None,
    };
    (0..samples.len()).map(ink).collect()
}
