//! A plan as a virtual arm carried it out: what was drawn, when, and how far off.

mod follow;

use std::time::Duration;

use dobot_arm::Position;
use dobot_geometry::{PathDistance, Stroke};
use dobot_plan::{Paper, Plan};
use thiserror::Error;

use crate::output::ink::{InkLine, point, writes};

/// A plan as a virtual arm carried it out.
///
/// It begins when the arm sets out from where the plan starts, and ends with the plan's last vector;
/// if that never came, with the last sample.
#[derive(Clone, Debug)]
pub struct Trace<'a> {
    pub(crate) plan: &'a Plan,
    began: Duration,
    pub(crate) moments: Vec<TracePoint>,
    /// For each vector that was carried out, the moment at which it was over.
    pub(crate) ends: Vec<usize>,
}

/// Where a virtual arm's tool was: once a tick of 20 ms while it moves, and at every corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// When, by the clock of the arm.
    pub at: Duration,
    /// Where the tool was.
    pub position: Position,
    /// Whether the laser was on, on the way here.
    pub laser: bool,
}

/// A sample of a trace.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TracePoint {
    /// Since the beginning.
    pub(crate) t_s: f64,
    pub(crate) position: Position,
    pub(crate) ink: Ink,
    /// How far the ink lies from the wanted path; 0 where there is none.
    pub(crate) error_mm: f64,
}

/// What a tool leaves at a moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ink {
    /// Nothing.
    None,
    /// A line from the moment before to here.
    Line,
    /// A dot, with which a line begins or not.
    Begin,
}

impl<'a> Trace<'a> {
    /// Reads what a virtual arm did for a plan on this paper, and compares its ink with the path
    /// that was wanted. What the arm did before it came to the plan's start does not count.
    ///
    /// # Errors
    ///
    /// [`StartNotReached`] where the samples never come to the plan's start.
    pub fn new(
        plan: &'a Plan,
        paper: &Paper,
        samples: &[Sample],
        wanted: &[Stroke],
    ) -> Result<Self, StartNotReached> {
        // At least the sample at which the plan begins is there.
        let samples = &samples[follow::beginning(plan, samples)?..];
        let ends = follow::ends(plan, samples);
        let all = ends.len() == plan.moves.len();
        let count = ends
            .last()
            .filter(|_| all)
            .map_or(samples.len(), |it| it + 1);
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

    /// The lines on the paper.
    #[must_use]
    pub fn ink(&self) -> Vec<InkLine> {
        lines(self.moments.iter().zip(self.passes()))
    }

    /// When it began, by the clock of the arm.
    #[must_use]
    pub const fn began(&self) -> Duration {
        self.began
    }

    /// How many vectors were carried out.
    #[must_use]
    pub const fn vectors(&self) -> usize {
        self.ends.len()
    }

    /// The pass that each moment belongs to: a way belongs to the moment at its end. What comes behind
    /// the last vector belongs to it too.
    pub(crate) fn passes(&self) -> impl Iterator<Item = u32> {
        let moves = &self.plan.moves;
        let mut vector = 0;
        (0..self.moments.len()).map(move |moment| {
            while vector + 1 < moves.len() && self.ends.get(vector).is_some_and(|&end| end < moment)
            {
                vector += 1;
            }
            moves.get(vector).map_or(0, |it| it.pass)
        })
    }
}

/// The samples of an arm never come to where the plan starts.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error(
    "the arm never came to the start of the plan at x {:.1}, y {:.1}, z {:.1} mm; the nearest it came is {nearest_mm:.1} mm away",
    start[0], start[1], start[2]
)]
pub struct StartNotReached {
    /// Where the plan starts: X, Y, Z in mm.
    pub start: [f64; 3],
    /// How near the samples come, in mm; infinite where there are none.
    pub nearest_mm: f64,
}

/// The lines on the paper, of moments with their passes.
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

/// What the tool leaves at each sample: a pen where it is down, a laser where it is on.
fn inks(plan: &Plan, paper: &Paper, samples: &[Sample]) -> Vec<Ink> {
    let burns = plan.burns();
    let here = |i: usize| match samples.get(i) {
        Some(it) if burns => it.laser || samples.get(i + 1).is_some_and(|it| it.laser),
        Some(it) => writes(it.position, paper),
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
