//! Random programs, and where they lead.

use dobot_arm::{Degrees, Pose, Position, Tool};
use dobot_motion::{ArmPlace, Model};
use dobot_wire::{Command, Configuration, Dialect, MoveTo, MovingMode};
use proptest::prelude::*;

use super::vector;

/// The lift of pens here, by programs and after their end, in millimetres.
pub(crate) const LIFT_MM: f32 = 5.0;

/// An arm in the middle of its space.
pub(crate) fn model(dialect: Dialect) -> Model {
    let pose = Pose {
        position: Position::new(220.0, 0.0, 20.0),
        rotation: Degrees(0.0),
    };
    Model::standing(dialect, ArmPlace::at_pose(pose, Tool::SuctionCup).unwrap())
}

/// Commands that an arm in the state of [`model`] can execute: vectors long and tiny, there and back,
/// around, lifts, targets and settings.
pub(crate) fn commands(dialect: Dialect, most: usize) -> impl Strategy<Value = Vec<Command>> {
    let any = proptest::collection::vec(command(), 1..most);
    any.prop_map(move |commands| doable(model(dialect), commands))
}

/// Both dialects.
pub(crate) fn dialect() -> impl Strategy<Value = Dialect> {
    proptest::sample::select(Dialect::ALL.to_vec())
}

fn command() -> impl Strategy<Value = Command> {
    let part = || proptest::sample::select(vec![-3.0_f32, -0.05, 0.0, 0.0, 0.05, 3.0]);
    prop_oneof![
        6 => (part(), part(), part()).prop_map(|(x, y, z)| vector(x, y, z)),
        2 => (-9.0_f32..9.0, -9.0_f32..9.0, -2.0_f32..2.0).prop_map(|(x, y, z)| vector(x, y, z)),
        1 => Just(vector(0.0, 0.0, LIFT_MM)),
        1 => Just(vector(0.0, 0.0, -LIFT_MM)),
        1 => (10.0_f32..200.0).prop_map(setting),
        1 => (0_u8..3, 0_u8..2).prop_map(|(x, z)| target(f32::from(x), f32::from(z))),
    ]
}

fn setting(acceleration_mm_s2: f32) -> Command {
    Configuration::Writing { acceleration_mm_s2 }.into()
}

fn target(x: f32, z: f32) -> Command {
    MoveTo::to(214.0 + 6.0 * x, 3.0, 20.0 + LIFT_MM * z)
        .with_mode(MovingMode::MovL)
        .into()
}

/// Leaves out what the arm cannot do.
fn doable(mut model: Model, commands: Vec<Command>) -> Vec<Command> {
    let mut doable = Vec::new();
    for command in commands {
        if let Ok(trajectory) = model.trajectory(&command) {
            model = model.after(&command, &trajectory);
            doable.push(command);
        }
    }
    doable
}

/// Returns where a command leads from a position, by adding.
pub(crate) fn end(from: Position, command: &Command) -> Position {
    match command {
        Command::WriteVector(vector) => {
            from + Position::new(vector.x_mm.into(), vector.y_mm.into(), vector.z_mm.into())
        }
        Command::MoveTo(target) => {
            Position::new(target.x_mm.into(), target.y_mm.into(), target.z_mm.into())
        }
        _ => from,
    }
}

/// The pen a lift higher.
pub(crate) fn lifted(at: Position) -> Position {
    at + Position::new(0.0, 0.0, LIFT_MM.into())
}

/// Returns the model after commands.
pub(crate) fn after(model: &Model, commands: &[Command]) -> Model {
    commands.iter().fold(*model, |model, command| {
        let trajectory = model.trajectory(command).unwrap();
        model.after(command, &trajectory)
    })
}
