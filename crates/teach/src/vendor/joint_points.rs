//! The joint points of a program, for the formats that have no others.

use dobot_arm::{Degrees, Limits, Pose, Position, Tool};
use dobot_wire::{Command, Configuration, MovingMode};

use super::VendorPoint;
use crate::{Compiled, Files, Program, ProgramError};

/// The points of a compiled program, and what the formats cannot express.
pub(super) fn read(
    program: &Program,
    files: &mut dyn Files,
) -> Result<(Vec<VendorPoint>, Vec<String>), ProgramError> {
    // A soft start would make the first cycle another one.
    let hard = Program {
        start_speed_percent: None,
        ..program.clone()
    };
    let compiled = hard.compile(files)?;
    let mut walk = Walk {
        compiled: &compiled,
        tool: Tool::default(),
        points: Vec::new(),
        lost: Vec::new(),
        mistakes: Vec::new(),
    };
    for (at, command) in compiled.commands.iter().enumerate() {
        walk.command(at, command);
    }
    if let Some(error) = ProgramError::merge(walk.mistakes) {
        return Err(error);
    }
    let mut lost = walk.lost;
    if compiled.repeat.is_some() {
        lost.push("the repetition of the program: its points are written once".to_owned());
    }
    if program.start_speed_percent.is_some() {
        lost.push("start_speed_percent: a soft start".to_owned());
    }
    Ok((walk.points, lost))
}

struct Walk<'a> {
    compiled: &'a Compiled,
    /// The tool for which positions are computed.
    tool: Tool,
    points: Vec<VendorPoint>,
    lost: Vec<String>,
    /// The points out of reach.
    mistakes: Vec<ProgramError>,
}

impl Walk<'_> {
    fn command(&mut self, at: usize, command: &Command) {
        let pauses = &self.compiled.pauses;
        let waits = pauses
            .binary_search_by_key(&at, |pause| pause.before)
            .is_ok();
        if waits {
            self.lose(at, "a wait");
        }
        match command {
            Command::MoveTo(_) | Command::MoveJoints(_) => match self.point(command) {
                Ok(point) => {
                    // After a wait, the arm is sent to where it stands.
                    let is_again =
                        waits && self.points.last().is_some_and(|last| is_same(last, &point));
                    if !is_again {
                        self.points.push(point);
                    }
                }
                Err(reason) => self.refuse(at, &reason),
            },
            Command::Configuration(Configuration::EndEffector { tool }) => {
                self.tool = (*tool).into();
                self.lose(at, "the tool, which must be mounted before");
            }
            Command::Configuration(_) | Command::PlaybackAdjustment(_) => {
                self.lose(at, "speeds, which are in PlayBackParams.json");
            }
            Command::WriteVector(_) => self.lose(at, "a drawing"),
            _ => self.lose(at, "the laser"),
        }
    }

    /// The point of a target, with angles to a ten-thousandth of a degree.
    fn point(&self, target: &Command) -> Result<VendorPoint, String> {
        let (joints_deg, mode, grab, gripper_deg, pause_s) = match target {
            Command::MoveTo(to) => {
                let [x, y, z] = [to.x_mm, to.y_mm, to.z_mm].map(f64::from);
                let pose = Pose {
                    position: Position::new(x, y, z),
                    rotation: Degrees(to.rotation_deg.into()),
                };
                let joints = Limits::STOCK.solve(&pose, self.tool);
                let joints = joints.map_err(|error| error.to_string())?;
                let joints = [joints.base, joints.rear, joints.fore, joints.servo];
                let joints_deg = joints.map(|angle| angle.0);
                (joints_deg, to.mode, to.suction, to.gripper_deg, to.pause_s)
            }
            Command::MoveJoints(to) => {
                let joints = [to.base_deg, to.rear_deg, to.fore_deg, to.servo_deg];
                let joints_deg = joints.map(f64::from);
                (joints_deg, to.mode, to.suction, to.gripper_deg, to.pause_s)
            }
            _ => unreachable!("only targets are points"),
        };
        Ok(VendorPoint {
            joints_deg: joints_deg.map(rounded),
            mode,
            grab,
            gripper_deg: rounded(gripper_deg.into()),
            pause_s: rounded(pause_s.into()),
        })
    }

    fn refuse(&mut self, at: usize, reason: &str) {
        let Some(number) = self.compiled.step_of(at) else {
            return;
        };
        let step = &self.compiled.steps[number];
        self.mistakes.push(ProgramError {
            file: step.file.as_deref().map(str::to_owned),
            line: Some(step.line),
            reason: format!(
                "step {} ({}): {reason}; choose a point within reach",
                number + 1,
                step.label
            ),
            others: Vec::new(),
        });
    }

    /// Reports once for each line what is left out.
    fn lose(&mut self, at: usize, what: &str) {
        let Some(step) = self.compiled.step_of(at) else {
            return;
        };
        let step = &self.compiled.steps[step];
        let file = step
            .file
            .as_ref()
            .map(|file| format!("{file}, "))
            .unwrap_or_default();
        let lost = format!(
            "{file}line {}: {what}: left out, because the format has points only",
            step.line
        );
        if !self.lost.contains(&lost) {
            self.lost.push(lost);
        }
    }
}

/// Whether a point only repeats where the arm stands.
fn is_same(last: &VendorPoint, point: &VendorPoint) -> bool {
    let moved = VendorPoint {
        mode: MovingMode::MovJ,
        pause_s: 0.0,
        ..*last
    };
    *point == moved
}

/// Rounds away what single precision adds.
fn rounded(value: f64) -> f64 {
    (value * 1e4).round() / 1e4
}
