//! From a command to its trajectory, without any side effect.

use crate::{JointMove, Jump, LineMove, Speeds};
use dobot_arm::{Degrees, Joints, Limits, Pose, Position, Unreachable, forward};
use dobot_wire::{
    Command, Configuration, Gesture, MouseMove, MoveJoints, MovingMode, Voice, VoiceOrder,
};

use super::Lines;
use super::follow::{follow_hand, follow_mouse};
use super::lifts::Lifts;
use super::motion::Motion;
use super::place::position;
use super::stretched_move::StretchedMove;
use super::vector::vector;
use crate::{ArmPlace, Button, JogTrajectory, Model, Trajectory, TrajectoryError};

/// Plans a command from the arm's position.
fn plan(model: &Model, command: &Command) -> Result<Trajectory, TrajectoryError> {
    match command {
        Command::MoveTo(move_to) => {
            let target = Target::Pose(Pose {
                position: position(move_to.x_mm, move_to.y_mm, move_to.z_mm),
                rotation: Degrees(move_to.rotation_deg.into()),
            });
            target.trajectory(model, move_to.mode, command)
        }
        Command::MoveJoints(move_joints) => {
            Target::Joints(joints(move_joints)).trajectory(model, move_joints.mode, command)
        }
        Command::WriteVector(write) if write.stop => Ok(rest(model)),
        Command::WriteVector(write) => vector(write, model),
        Command::MouseMove(by) => mouse(by, model),
        Command::Gesture(hand) => gesture(hand, model),
        Command::Voice(voice) => spoken(voice, model),
        Command::JointJog(_) | Command::LinearJog(_) => pressed(command, model),
        Command::Configuration(configuration) => configured(configuration, model),
        Command::PlaybackAdjustment(_) => Ok(rest(model)),
    }
}

#[derive(Clone, Copy)]
enum Target {
    Pose(Pose),
    Joints(Joints),
}

impl Target {
    /// Returns the position of the target. Joint angles are more specific than their pose.
    fn place(self, model: &Model) -> Result<ArmPlace, Unreachable> {
        match self {
            Self::Pose(pose) => Limits::STOCK
                .solve(&pose, model.tool)
                .map(|joints| ArmPlace { joints, pose }),
            Self::Joints(joints) => {
                Limits::STOCK.check(&joints, model.tool)?;
                Ok(ArmPlace::at_joints(joints, model.tool))
            }
        }
    }

    fn trajectory(
        self,
        model: &Model,
        mode: MovingMode,
        command: &Command,
    ) -> Result<Trajectory, TrajectoryError> {
        let to = self.place(model)?;
        let motion = motion(model, mode, &to)?;
        Ok(Trajectory {
            pause_s: model.pause_s(command),
            // The target defines its end, whatever the start.
            knows_end: true,
            ..Trajectory::moving(motion, to, model)
        })
    }
}

fn motion(model: &Model, mode: MovingMode, to: &ArmPlace) -> Result<Motion, TrajectoryError> {
    let speeds = model.settings.move_speeds();
    let height = model.settings.jump_height;
    let from = model.place;
    Ok(match mode {
        MovingMode::Jump if model.dialect.jumps_by_joints => Motion::Lifts(Lifts::new(
            from, to.pose, to.joints, height, &speeds, model.tool,
        )?),
        MovingMode::Jump => Motion::Jump(Jump::new(from.pose, to.pose, height, &speeds)?),
        MovingMode::MovL => line(model, to.pose)?,
        MovingMode::MovJ if model.dialect.stretches_joints => {
            let speeds = Speeds {
                servo_deg_s2: speeds.joint_deg_s2,
                ..speeds
            };
            Motion::Stretched(StretchedMove::new(from.joints, to.joints, &speeds)?)
        }
        MovingMode::MovJ => Motion::Joints(JointMove::new(from.joints, to.joints, &speeds)?),
    })
}

/// Plans a straight line with the rotation of the tool.
fn line(model: &Model, to: Pose) -> Result<Motion, TrajectoryError> {
    let from = model.place.pose;
    let length_mm = from.position.distance(to.position).0;
    if model.dialect.loses_pose_on_the_spot && model.knows_place && length_mm < ON_THE_SPOT_MM {
        return Err(TrajectoryError::OnTheSpot);
    }
    check_lines(model)?;
    let held = Pose {
        rotation: if model.dialect.turns_after_line {
            from.rotation
        } else {
            to.rotation
        },
        ..to
    };
    let line = LineMove::new(from, held, &model.settings.move_speeds())?;
    Ok(Motion::Line(line, to.rotation))
}

/// Checks that a straight line begins at the arm's position.
fn check_lines(model: &Model) -> Result<(), TrajectoryError> {
    if model.dialect.resumes_cut_lines && model.lines == Lines::Cut {
        return Err(TrajectoryError::BehindCutLine);
    }
    Ok(())
}

/// Plans a mouse increment of Y, X and Z as documented (note N9).
fn mouse(by: &MouseMove, model: &Model) -> Result<Trajectory, TrajectoryError> {
    if model.dialect.mouse_swings {
        return follow_mouse(by, model);
    }
    let from = model.place.pose;
    let to = Pose {
        position: from.position + position(by.x, by.y, by.z),
        rotation: Degrees(by.rotation_deg.into()),
    };
    Trajectory::relative(
        Motion::Line(
            LineMove::new(from, to, &model.settings.move_speeds())?,
            to.rotation,
        ),
        model,
    )
}

/// Plans a move to the position of the hand, with constant rotation (note N18).
fn gesture(hand: &Gesture, model: &Model) -> Result<Trajectory, TrajectoryError> {
    if model.dialect.scales_gesture {
        return follow_hand(hand, model);
    }
    straight(position(hand.x, hand.y, hand.z), model)
}

fn spoken(voice: &Voice, model: &Model) -> Result<Trajectory, TrajectoryError> {
    if !model.dialect.accepts_voice && !model.is_bluetooth {
        return Err(TrajectoryError::NotHeard);
    }
    match VoiceOrder::parse(voice).ok_or(TrajectoryError::NotUnderstood)? {
        VoiceOrder::Catch | VoiceOrder::Release => Ok(rest(model)),
        VoiceOrder::Move { x_mm, y_mm, z_mm } => {
            let from = model.place.pose.position;
            straight(from + position(x_mm, y_mm, z_mm), model)
        }
    }
}

fn straight(to: Position, model: &Model) -> Result<Trajectory, TrajectoryError> {
    check_lines(model)?;
    let from = model.place.pose;
    let to = Pose {
        position: to,
        ..from
    };
    let line = LineMove::new(from, to, &model.settings.move_speeds())?;
    Trajectory::relative(Motion::Line(line, to.rotation), model)
}

/// Plans a pressed button; a jogging arm continues from its current speed.
fn pressed(command: &Command, model: &Model) -> Result<Trajectory, TrajectoryError> {
    let speed = |axis| match &model.jog {
        Some(jog) if jog.axis() == axis || model.dialect.keeps_jog_speed => jog.target_speed(),
        _ => 0.0,
    };
    let motion = match Button::of(command) {
        Some(Button::Held { axis, share }) => {
            Motion::Jog(JogTrajectory::start(model, axis, share, speed(axis))?)
        }
        Some(Button::Released) => match &model.jog {
            Some(jog) => Motion::RunDown(jog.release(model, f64::MAX)?),
            None => Motion::Rest,
        },
        _ => Motion::Rest,
    };
    let goes_on = matches!(motion, Motion::Jog(_) | Motion::RunDown(_));
    let trajectory = Trajectory::moving(motion, model.place, model);
    Ok(Trajectory {
        knows_end: trajectory.knows_end && !goes_on,
        burns: model.begun(command).laser && goes_on,
        ..trajectory
    })
}

fn configured(configuration: &Configuration, model: &Model) -> Result<Trajectory, TrajectoryError> {
    let joints = model.place.joints;
    let to = match *configuration {
        Configuration::InitialAngles { rear_deg, fore_deg } => {
            let raw = Joints::new(0.0, rear_deg.into(), fore_deg.into(), joints.servo.0);
            let place = ArmPlace::at_joints(raw, model.tool);
            place.check()?;
            return Ok(Trajectory {
                knows_end: true,
                ..Trajectory::moving(Motion::Rest, place, model)
            });
        }
        Configuration::EndEffector { tool } => ArmPlace::at_joints(joints, tool.into()),
        _ => model.place,
    };
    Ok(Trajectory::moving(Motion::Rest, to, model))
}

impl Model {
    /// Plans the trajectory of a command.
    ///
    /// # Errors
    ///
    /// [`TrajectoryError`] if a value violates its table, the end is out of reach or beyond the
    /// limits of a stock arm, it cannot be planned, or the arm would hang or lose its pose.
    pub fn trajectory(&self, command: &Command) -> Result<Trajectory, TrajectoryError> {
        Command::parse(&command.emit(&self.dialect), &self.dialect)
            .map_err(TrajectoryError::Invalid)?;
        let trajectory = plan(self, command)?;
        trajectory.check_duration()?;
        if self.dialect.counts_ticks_in_16_bits {
            trajectory.check_counters()?;
        }
        if trajectory.motion_s().is_some() && trajectory.knows_end && trajectory.to.check().is_err()
        {
            // The end exceeds a limit; report where the path leaves it.
            trajectory.check()?;
        }
        Ok(trajectory)
    }

    /// Returns the arm's pause after a command, in seconds. A target without its own pause uses the
    /// default one, if the dialect has it (note N10).
    #[must_use]
    pub fn pause_s(&self, command: &Command) -> f64 {
        let own_s = match command {
            Command::MoveTo(move_to) => move_to.pause_s,
            Command::MoveJoints(move_joints) => move_joints.pause_s,
            _ => return 0.0,
        };
        if own_s > 0.0 || !self.dialect.uses_default_pause {
            own_s.into()
        } else {
            self.settings.default_pause_s
        }
    }

    /// Returns the point that a command names, in reach or not: a target, or a displacement from a
    /// known position. `None` if it names none, or a stock arm changes it (notes N9 and N18).
    #[must_use]
    pub fn target(&self, command: &Command) -> Option<Position> {
        let by = |x, y, z| {
            let from = self.knows_place.then_some(self.place.pose.position)?;
            Some(from + position(x, y, z))
        };
        match command {
            Command::MoveTo(move_to) => Some(position(move_to.x_mm, move_to.y_mm, move_to.z_mm)),
            Command::MoveJoints(move_joints) => {
                Some(forward(&joints(move_joints), self.tool).position)
            }
            Command::WriteVector(write) if !write.stop => by(write.x_mm, write.y_mm, write.z_mm),
            Command::MouseMove(mouse) if !self.dialect.mouse_swings => {
                by(mouse.x, mouse.y, mouse.z)
            }
            Command::Gesture(hand) if !self.dialect.scales_gesture => {
                Some(position(hand.x, hand.y, hand.z))
            }
            Command::Voice(voice) => match VoiceOrder::parse(voice)? {
                VoiceOrder::Move { x_mm, y_mm, z_mm } => by(x_mm, y_mm, z_mm),
                VoiceOrder::Catch | VoiceOrder::Release => None,
            },
            _ => None,
        }
    }
}

fn joints(target: &MoveJoints) -> Joints {
    let [base, rear, fore, servo] = [
        target.base_deg,
        target.rear_deg,
        target.fore_deg,
        target.servo_deg,
    ]
    .map(f64::from);
    Joints::new(base, rear, fore, servo)
}

fn rest(model: &Model) -> Trajectory {
    Trajectory::moving(Motion::Rest, model.place, model)
}

/// The accuracy of a position in a status.
const ON_THE_SPOT_MM: f64 = 0.001;
