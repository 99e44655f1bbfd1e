//! A job that burns, and the end of that.

use dobot_api::{JobKind, JobProgram, NewJob};
use dobot_arm::Tool;
use dobot_wire::{Command, Configuration, JointJog, JointJogAxis, MoveTo, WriteVector};

/// The first and the last packets to an arm.
pub(crate) const LASER_OFF: Command = Command::JointJog(JointJog::new(JointJogAxis::LaserOff, 0.0));

/// A spiral to be burnt: no two of its points are near each other.
pub(crate) fn spiral() -> NewJob {
    let mut commands: Vec<Command> = vec![
        Configuration::EndEffector {
            tool: Tool::Laser.into(),
        }
        .into(),
        MoveTo::to(220.0, 0.0, -20.0).into(),
        vector([0.0, 0.0, -10.0], false),
    ];
    commands.extend((0_u8..16).map(|line| {
        let side_mm = 4.0 + f32::from(line / 2) * 2.0;
        let way = [
            [side_mm, 0.0],
            [0.0, side_mm],
            [-side_mm, 0.0],
            [0.0, -side_mm],
        ];
        let [x, y] = way[usize::from(line % 4)];
        vector([x, y, 0.0], true)
    }));
    commands.push(vector([0.0, 0.0, 10.0], false));
    NewJob {
        title: "a burnt spiral".into(),
        kind: JobKind::Drawing,
        commands,
        lift_mm: 0.0,
        pauses: Vec::new(),
        program: JobProgram::default(),
    }
}

fn vector([x_mm, y_mm, z_mm]: [f32; 3], laser: bool) -> Command {
    let stroke = WriteVector::by(x_mm, y_mm, z_mm, 40.0);
    if laser { stroke.burning() } else { stroke }.into()
}

pub(crate) fn burns(command: &Command) -> bool {
    matches!(command, Command::WriteVector(vector) if vector.laser)
}
