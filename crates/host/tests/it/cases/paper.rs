//! The ink of a pen drawing, as recorded by the machine.

use dobot_api::NewJob;
use dobot_arm::{Millimeters, Position};
use dobot_sim::Sample;
use dobot_wire::Command;

use super::jobs::DOWN_MM;

/// The deviation of the ink from the planned lines.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Paper {
    /// The greatest distance of the ink from the lines that were wanted.
    pub aside_mm: f64,
    /// The length of all the ink, less what was wanted.
    pub longer_mm: f64,
    /// The number of planned lines.
    pub lines: u16,
}

impl Paper {
    /// Looks at the ink of a drawing.
    pub(crate) fn of(samples: &[Sample], job: &NewJob) -> Self {
        let wanted = wanted(job);
        let ink: Vec<[Position; 2]> = samples
            .windows(2)
            .map(|pair| [pair[0].position, pair[1].position])
            .filter(|pair| pair.iter().all(|sample| is_down(*sample)))
            .map(|pair| pair.map(flat))
            .collect();
        let off = |at: Position| {
            let distances = wanted.iter().map(|line| distance_mm(at, *line));
            distances.fold(f64::INFINITY, f64::min)
        };
        let length =
            |lines: &[[Position; 2]]| lines.iter().map(|[a, b]| a.distance(*b).0).sum::<f64>();
        Self {
            aside_mm: ink.iter().map(|[_, end]| off(*end)).fold(0.0, f64::max),
            longer_mm: length(&ink) - length(&wanted),
            lines: u16::try_from(wanted.len()).unwrap_or(u16::MAX),
        }
    }

    /// Returns whether the drawing is right. The steps of the motors make each line slightly
    /// longer.
    pub(crate) fn is_right(&self) -> bool {
        let teeth_mm = 0.1 * f64::from(self.lines);
        self.aside_mm < ASIDE_MM && (-ASIDE_MM..=teeth_mm).contains(&self.longer_mm)
    }
}

/// The lines that a job is to draw.
fn wanted(job: &NewJob) -> Vec<[Position; 2]> {
    let mut at = Position::new(0.0, 0.0, 0.0);
    let mut lines = Vec::new();
    for command in &job.commands {
        let before = at;
        match command {
            Command::MoveTo(target) => {
                at = Position::new(target.x_mm.into(), target.y_mm.into(), target.z_mm.into());
                continue;
            }
            Command::WriteVector(vector) => {
                at = at + Position::new(vector.x_mm.into(), vector.y_mm.into(), vector.z_mm.into());
            }
            _ => continue,
        }
        if is_down(before) && is_down(at) {
            lines.push([flat(before), flat(at)]);
        }
    }
    lines
}

fn is_down(at: Position) -> bool {
    (at.z.0 - f64::from(DOWN_MM)).abs() < 0.2
}

fn flat(at: Position) -> Position {
    Position {
        z: Millimeters(0.0),
        ..at
    }
}

/// Ink that is nearer than this to its line is where it was wanted.
pub(crate) const ASIDE_MM: f64 = 0.3;

/// Returns the distance from a point to the line between two others.
fn distance_mm(point: Position, [from, to]: [Position; 2]) -> f64 {
    let (dx, dy) = (to.x.0 - from.x.0, to.y.0 - from.y.0);
    let length2 = dx * dx + dy * dy;
    let along = (point.x.0 - from.x.0) * dx + (point.y.0 - from.y.0) * dy;
    let share = if length2 > 0.0 {
        (along / length2).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let nearest = Position::new(from.x.0 + share * dx, from.y.0 + share * dy, 0.0);
    point.distance(nearest).0
}
