//! The possible rest positions of an arm given commands whose end was not seen.

use std::fmt;

use dobot_arm::Position;
use dobot_motion::{Model, SAME_PLACE_MM};
use dobot_wire::{Command, WriteVector};

use crate::prelude::is_setting;

/// The progress of an arm in a job.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Located {
    /// The command to continue with, counted from 0: all before it are done, or are to be sent
    /// again without a motion.
    pub next: usize,
    /// Whether the pen was lifted after the last command: it has to be lowered first.
    pub lifted: bool,
}

impl fmt::Display for Located {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} commands done", self.next)?;
        f.write_str(if self.lifted { ", pen lifted" } else { "" })
    }
}

/// A possible rest position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// The progress if the arm rests there.
    pub located: Located,
    /// The position.
    pub position: Position,
}

impl End {
    /// Returns whether both can be distinguished by where the arm rests, or need not be.
    pub(crate) fn is_distinct_from(&self, other: &Self, commands: &[Command]) -> bool {
        self.located == other.located
            || self.distance_mm(other.position) >= SPACING_MM
            || self.is_equivalent_to(other, commands)
    }

    /// Returns whether it makes no difference which of the two it is: a pen lifted from the lower
    /// end of a lift (or a lowering) rests at its upper end, and can continue from there.
    pub(crate) fn is_equivalent_to(&self, other: &Self, commands: &[Command]) -> bool {
        let [first, last] = order(self.located.next, other.located.next);
        let mut way = commands[first..last]
            .iter()
            .filter(|command| !is_setting(command));
        self.located.lifted != other.located.lifted
            && self.distance_mm(other.position) < SPACING_MM
            && way.next().is_some_and(is_pen_vector)
            && way.next().is_none()
    }

    pub(crate) fn distance_mm(&self, position: Position) -> f64 {
        self.position.distance(position).0
    }

    fn lifted_by(self, lift_mm: f64) -> Self {
        let located = Located {
            lifted: true,
            ..self.located
        };
        Self {
            located,
            position: self.position + Position::new(0.0, 0.0, lift_mm),
        }
    }
}

impl fmt::Display for End {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = [self.position.x, self.position.y, self.position.z].map(|mm| mm.0);
        write!(f, "x {x:.3} y {y:.3} z {z:.3} mm ({})", self.located)
    }
}

/// Walks through commands from end to end.
pub(crate) struct Walk<'a> {
    commands: &'a [Command],
    lift_mm: Option<f64>,
    model: Model,
    /// The next command.
    index: usize,
    /// The last end that is distinguishable from the ends before it.
    last: End,
}

impl<'a> Walk<'a> {
    /// Starts where command `completed` starts.
    pub(crate) fn new(
        commands: &'a [Command],
        completed: usize,
        model: &Model,
        lift_mm: Option<f32>,
    ) -> Self {
        let located = Located {
            next: completed,
            lifted: false,
        };
        Self {
            commands,
            lift_mm: lift_mm.map(f64::from),
            model: *model,
            index: completed,
            last: End {
                located,
                position: model.place.pose.position,
            },
        }
    }

    /// Returns the position where the first command starts, also with the pen lifted.
    pub(crate) fn start(&self) -> impl Iterator<Item = End> + use<> {
        self.with_lifted(self.last)
    }

    /// Returns where the next command ends, also with the pen lifted; `None` after the last command
    /// whose end is known.
    pub(crate) fn step(&mut self) -> Option<impl Iterator<Item = End> + use<>> {
        let command = self.commands.get(self.index)?;
        let trajectory = self.model.trajectory(command).ok()?;
        let position = trajectory.end()?.pose.position;
        self.model = self.model.after(command, &trajectory);
        self.index += 1;
        let stays = !trajectory.moves() || is_target(command) && self.is_here(position);
        if !stays {
            self.last.located.next = self.index;
            self.last.position = position;
        }
        // A different tool means a different position, even without motion.
        let located = self.last.located;
        Some(self.with_lifted(End { located, position }))
    }

    fn is_here(&self, position: Position) -> bool {
        self.last.distance_mm(position) < SPACING_MM
    }

    fn with_lifted(&self, end: End) -> impl Iterator<Item = End> + use<> {
        let lifted = self.lift_mm.map(|lift_mm| end.lifted_by(lift_mm));
        std::iter::once(end).chain(lifted)
    }
}

/// A target is absolute: sending it again at the target has no effect.
const fn is_target(command: &Command) -> bool {
    matches!(command, Command::MoveTo(_) | Command::MoveJoints(_))
}

const fn is_pen_vector(command: &Command) -> bool {
    matches!(command, Command::WriteVector(WriteVector { laser, .. }) if !*laser)
}

const fn order(a: usize, b: usize) -> [usize; 2] {
    if a < b { [a, b] } else { [b, a] }
}

/// Ends closer than this are not distinguishable, in millimetres.
pub const SPACING_MM: f64 = SAME_PLACE_MM;
