//! Jobs made by chance: what each of them has to be careful about.

use std::fmt;

use dobot_api::{JobKind, NewJob};
use dobot_wire::{Command, MoveTo, MovingMode};

use super::chance::Chance;
use super::commands::{settings, target, vector};

/// The kind of a job.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sort {
    /// A pen drawing: closed loops, some of them of tiny vectors.
    Pen,
    /// A burnt drawing.
    Burn,
    /// Targets with pauses and suction.
    Program,
}

impl Sort {
    /// All of them.
    pub(crate) const ALL: [Self; 3] = [Self::Pen, Self::Burn, Self::Program];

    /// A job of this sort.
    pub(crate) fn job(self, chance: &mut Chance) -> NewJob {
        let (commands, kind) = match self {
            Self::Pen => (loops(chance, false), JobKind::Drawing),
            Self::Burn => (loops(chance, true), JobKind::Drawing),
            Self::Program => (targets(chance), JobKind::Program),
        };
        NewJob {
            title: self.to_string(),
            kind,
            commands,
            lift_mm: if self == Self::Pen { 5.0 } else { 0.0 },
            pauses: Vec::new(),
            program: dobot_api::JobProgram::default(),
        }
    }
}

impl fmt::Display for Sort {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Pen => "pen drawing",
            Self::Burn => "burning job",
            Self::Program => "program",
        })
    }
}

/// Returns whether a command leaves a mark on the paper or moves things: none of these may be lost
/// or repeated. The station's own lifts are vertical and its own moves do not pause.
pub(crate) fn counts(command: &Command) -> bool {
    match command {
        Command::WriteVector(vector) => vector.x_mm != 0.0 || vector.y_mm != 0.0,
        Command::MoveTo(target) => target.pause_s > 0.0,
        _ => false,
    }
}

/// The drawing height of the pen.
pub(crate) const DOWN_MM: f32 = -30.0;
const UP_MM: f32 = -22.0;

/// Closed loops, with the pen lifted between them.
fn loops(chance: &mut Chance, burns: bool) -> Vec<Command> {
    let mut commands = settings(burns).to_vec();
    let start = MoveTo {
        pause_s: 0.05,
        ..target([215.0, -15.0, UP_MM])
    };
    commands.push(start.into());
    for _ in 0..2 + chance.below(2) {
        commands.push(vector([0.0, 0.0, DOWN_MM - UP_MM], false));
        let size_mm = chance.one(&[0.3, 0.8, 3.0, 12.0]) * chance.between(1.0, 1.5);
        let sides = loop_of(size_mm, chance.below(2) == 0);
        commands.extend(sides.map(|[x, y]| vector([x, y, 0.0], burns)));
        commands.push(vector([0.0, 0.0, UP_MM - DOWN_MM], false));
        let aside_mm = chance.between(5.0, 9.0);
        commands.push(vector([0.0, aside_mm, 0.0], false));
    }
    commands
}

/// A closed path of six vectors: a honeycomb cell, or a bow tie that passes one point twice.
fn loop_of(a_mm: f32, crosses: bool) -> [[f32; 2]; 6] {
    if crosses {
        let half = a_mm / 2.0;
        [
            [a_mm, 0.0],
            [-half, half],
            [-half, half],
            [a_mm, 0.0],
            [-half, -half],
            [-half, -half],
        ]
    } else {
        let (x, y) = (a_mm / 2.0, a_mm * 0.866);
        [
            [a_mm, 0.0],
            [x, y],
            [-x, y],
            [-a_mm, 0.0],
            [-x, -y],
            [x, -y],
        ]
    }
}

/// From place to place, and back to places where it has been.
fn targets(chance: &mut Chance) -> Vec<Command> {
    let places = [[200.0, -60.0], [230.0, 0.0], [200.0, 60.0], [240.0, 30.0]];
    let mut last = 4;
    let mut commands: Vec<Command> = Vec::new();
    for _ in 0..6 + chance.below(5) {
        let next = chance.below(4);
        if next == last {
            continue;
        }
        last = next;
        let [x, y] = places[usize::try_from(next).unwrap_or_default()];
        let z_mm = chance.one(&[10.0, 25.0]);
        let pause_s = chance.between(0.02, 0.6);
        let mode = chance.one(&[MovingMode::Jump, MovingMode::MovJ, MovingMode::MovL]);
        let target = MoveTo {
            mode,
            suction: chance.below(2) == 0,
            pause_s,
            ..target([x, y, z_mm])
        };
        commands.push(target.into());
    }
    commands
}
