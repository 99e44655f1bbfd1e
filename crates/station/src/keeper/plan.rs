//! A job looked at from its beginning to its end, before anything moves.

use std::sync::Arc;

use dobot_arm::{Joints, Position, Tool};
use dobot_client::position;
use dobot_course::{Model, Place};
use dobot_safety::{Policy, burns};
use dobot_wire::{Command, Configuration, Status};

use crate::words::Refusal;

/// A job whose whole way has been checked: where each command ends, and how long it takes.
#[derive(Clone, Debug)]
pub struct JobPlan {
    commands: Arc<[Command]>,
    steps: Arc<[Step]>,
    burns: bool,
    lift_mm: f32,
}

/// One command of a job.
#[derive(Clone, Copy, Debug)]
struct Step {
    /// The arm when it is over.
    end: Status,
    moves: bool,
    /// How long it and all before it take, in seconds.
    until_s: f64,
}

impl JobPlan {
    /// Looks at every command of a job, from where the arm is. The way to its first target is not
    /// judged where the job has gone on from there already.
    ///
    /// # Errors
    ///
    /// [`Refusal::BadJob`] with the first command that is not allowed, and why.
    pub fn new(
        policy: &Policy,
        mut model: Model,
        commands: Vec<Command>,
        lift_mm: f32,
        completed: usize,
    ) -> Result<Self, Refusal> {
        let first = check_beginning(&commands)?;
        let mut steps = Vec::with_capacity(commands.len());
        let mut until_s = 0.0;
        for (index, command) in commands.iter().enumerate() {
            let bad = |why: String| Refusal::BadJob { index, why };
            let course = if index == first && completed > first {
                // To stand there already is no reason to refuse what is done.
                model.place = somewhere(model.tool);
                model
                    .course(command)
                    .map_err(|error| bad(error.to_string()))?
            } else {
                let checked = policy.check(&model, command);
                checked.map_err(|violation| bad(violation.to_string()))?
            };
            let takes_s = course.duration_s().ok_or_else(|| {
                bad("a jog goes on until it is released; a job may not hold one".into())
            })?;
            model = model.after(command, &course);
            until_s += takes_s;
            steps.push(Step {
                end: model.status(),
                moves: course.moves(),
                until_s,
            });
        }
        Ok(Self {
            burns: commands.iter().any(burns),
            commands: commands.into(),
            steps: steps.into(),
            lift_mm,
        })
    }

    /// How many commands there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.commands.len()
    }

    /// Whether there is nothing to do.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.commands.is_empty()
    }

    /// The commands.
    #[must_use]
    pub fn commands(&self) -> &[Command] {
        &self.commands
    }

    /// Whether the laser burns somewhere.
    #[must_use]
    pub const fn burns(&self) -> bool {
        self.burns
    }

    /// How far the tool is lifted in a pause, in millimetres.
    #[must_use]
    pub const fn lift_mm(&self) -> f32 {
        self.lift_mm
    }

    /// The same, where it is lifted at all.
    #[must_use]
    pub fn lift(&self) -> Option<f32> {
        Some(self.lift_mm).filter(|it| *it > 0.0)
    }

    /// The arm when all before a command is over; `None` before the first motion, which begins
    /// wherever the arm is.
    #[must_use]
    pub fn start(&self, index: usize) -> Option<Status> {
        let before = index.min(self.steps.len());
        let moved = before > self.first_motion();
        let last = before.checked_sub(1).filter(|_| moved)?;
        self.steps.get(last).map(|it| it.end)
    }

    /// Where the tool is then.
    #[must_use]
    pub fn start_position(&self, index: usize) -> Option<Position> {
        self.start(index).as_ref().map(position)
    }

    fn first_motion(&self) -> usize {
        let first = self.steps.iter().position(|it| it.moves);
        first.unwrap_or(self.steps.len())
    }

    /// How long all of it takes, in seconds.
    #[must_use]
    pub fn planned_s(&self) -> f64 {
        self.steps.last().map_or(0.0, |it| it.until_s)
    }

    /// How long all from a command on takes, in seconds.
    #[must_use]
    pub fn left_s(&self, index: usize) -> f64 {
        let over = index.checked_sub(1).and_then(|it| self.steps.get(it));
        self.planned_s() - over.map_or(0.0, |it| it.until_s)
    }
}

/// A place from which every target can be come to.
fn somewhere(tool: Tool) -> Place {
    Place::at_joints(Joints::new(0.0, 45.0, 45.0, 0.0), tool)
}

/// What is relative needs to know where it begins, wherever the arm was before: the first command
/// that moves has to say it. Gives its index.
fn check_beginning(commands: &[Command]) -> Result<usize, Refusal> {
    let calm = |it: &Command| {
        matches!(
            it,
            Command::Configuration(_) | Command::PlaybackAdjustment(_) | Command::JointJog(_)
        )
    };
    let first = commands.iter().position(|it| !calm(it));
    let bad = |index, why: &str| {
        Err(Refusal::BadJob {
            index,
            why: why.to_owned(),
        })
    };
    match first.map(|index| (index, &commands[index])) {
        None => bad(0, "nothing in it moves the arm"),
        Some((index, Command::MoveTo(_) | Command::MoveJoints(_))) => {
            no_references(commands).map(|()| index)
        }
        Some((index, _)) => bad(
            index,
            "the first motion has to be a target (state 3 or 6), which says where the job begins",
        ),
    }
}

/// After new initial angles nobody knows where the arm is by the places before them.
fn no_references(commands: &[Command]) -> Result<(), Refusal> {
    let reference = |it: &Command| {
        matches!(
            it,
            Command::Configuration(Configuration::InitialAngles { .. })
        )
    };
    match commands.iter().position(reference) {
        None => Ok(()),
        Some(index) => Err(Refusal::BadJob {
            index,
            why: "initial angles are set by hand, not in a job".into(),
        }),
    }
}
