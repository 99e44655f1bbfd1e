//! From a command to what the arm does: pure, nothing has moved yet.

use core::time::Duration;

use dobot_arm::{Degrees, Joints, Limits, Millimeters, Pose, Position, Tool, Unreachable};
use dobot_motion::{JointMove, Jump, LineMove, Speeds, Stroke, StrokeSpeeds};
use dobot_wire::{
    Command, Configuration, EndEffector, MouseMove, MovingMode, Voice, VoiceOrder, WriteMode,
    WriteVector,
};

use super::jog::{Button, Jog};
use super::motion::{Motion, Then};
use super::settings::Settings;
use super::state::{Place, State};
use crate::Refused;

/// What a command makes the arm do.
pub(crate) enum Plan {
    /// A motion and what follows it; the tool is set first.
    Move {
        motion: Motion,
        then: Then,
        suction: Option<bool>,
        laser: Option<bool>,
    },
    /// New settings.
    Settings(Settings),
    /// A new state, at once and without motion.
    State(State),
}

/// Plans a command from where the arm is.
pub(crate) fn plan(command: &Command, state: &State, settings: &Settings) -> Result<Plan, Refused> {
    let speeds = settings.move_speeds();
    let from = state.place.pose;
    match command {
        Command::MoveTo(it) => {
            let to = Pose {
                position: position(it.x_mm, it.y_mm, it.z_mm),
                rotation: Degrees(it.rotation_deg.into()),
            };
            let motion = way(it.mode, Target::Pose(to), state, settings)?;
            let then = set_tool(it.suction, it.gripper_deg, it.pause_s, settings);
            Ok(moving(motion, then))
        }
        Command::MoveJoints(it) => {
            let [base, rear, fore, servo] =
                [it.base_deg, it.rear_deg, it.fore_deg, it.servo_deg].map(f64::from);
            let target = Target::Joints(Joints::new(base, rear, fore, servo));
            let motion = way(it.mode, target, state, settings)?;
            let then = set_tool(it.suction, it.gripper_deg, it.pause_s, settings);
            Ok(moving(motion, then))
        }
        Command::WriteVector(it) if it.stop => Ok(Plan::State(State {
            laser: false,
            ..*state
        })),
        Command::WriteVector(it) => write(it, state, settings),
        Command::MouseMove(it) => {
            let to = moused(it, from);
            grabbing_line(from, to, it.suction, &speeds)
        }
        Command::Gesture(it) => {
            let to = Pose {
                position: position(it.x, it.y, it.z),
                ..from
            };
            grabbing_line(from, to, it.grab, &speeds)
        }
        Command::Voice(it) => spoken(it, state, &speeds),
        Command::JointJog(it) => pressed(Button::of_joint(*it), state, settings),
        Command::LinearJog(it) => pressed(Button::of_linear(*it), state, settings),
        Command::Configuration(it) => configure(it, state, settings),
        Command::PlaybackAdjustment(it) => {
            let mut settings = *settings;
            settings.adjust(it);
            Ok(Plan::Settings(settings))
        }
    }
}

/// Refuses a motion whose way leaves the limits (note N30), or that takes too long to look all along
/// it. An arm that stands outside of the limits may come back in.
pub(crate) fn check_way(motion: &Motion, duration_s: f64, state: &State) -> Result<(), Refused> {
    if duration_s > LONGEST_S {
        return Err(Refused::TooSlow { found: duration_s });
    }
    let samples = libm::ceil(duration_s / SAMPLING_S).max(1.0);
    let mut inside = state.place.check().is_ok();
    let mut index = 0.0;
    while index <= samples {
        let t_s = duration_s * (index / samples);
        match motion
            .place_at(t_s, state.tool)
            .map(|it| it.and_then(checked))
        {
            Some(Ok(())) => inside = true,
            Some(Err(error)) if inside || index == samples => {
                return Err(Refused::Unreachable(error));
            }
            Some(Err(_)) | None => {}
        }
        index += 1.0;
    }
    Ok(())
}

#[derive(Clone, Copy)]
enum Target {
    Pose(Pose),
    Joints(Joints),
}

impl Target {
    fn pose(&self, tool: Tool) -> Pose {
        match self {
            Self::Pose(pose) => *pose,
            Self::Joints(joints) => dobot_arm::forward(joints, tool),
        }
    }

    fn joints(&self, tool: Tool) -> Result<Joints, Unreachable> {
        match self {
            Self::Pose(pose) => Limits::STOCK.solve(pose, tool),
            Self::Joints(joints) => Limits::STOCK.check(joints, tool).map(|()| *joints),
        }
    }
}

fn way(
    mode: MovingMode,
    target: Target,
    state: &State,
    settings: &Settings,
) -> Result<Motion, Refused> {
    let speeds = settings.move_speeds();
    let from = state.place.pose;
    // A target given as joint angles says more than its pose: is it within the limits?
    let joints = target.joints(state.tool).map_err(Refused::Unreachable)?;
    let to = target.pose(state.tool);
    match mode {
        MovingMode::Jump => Jump::new(from, to, settings.jump_height, &speeds).map(Motion::Jump),
        MovingMode::MovL => LineMove::new(from, to, &speeds).map(Motion::Line),
        MovingMode::MovJ => JointMove::new(state.place.joints, joints, &speeds).map(Motion::Joints),
    }
    .map_err(Refused::Unplannable)
}

/// Where a mouse increment leads: by that much of Y, X and Z (note N9).
fn moused(by: &MouseMove, from: Pose) -> Pose {
    Pose {
        position: from.position + position(by.x, by.y, by.z),
        rotation: Degrees(by.rotation_deg.into()),
    }
}

fn write(vector: &WriteVector, state: &State, settings: &Settings) -> Result<Plan, Refused> {
    let max_mm_s = f64::from(vector.max_speed_mm_s);
    let stroke = Stroke::new(
        state.place.pose.position,
        position(vector.x_mm, vector.y_mm, vector.z_mm),
        &StrokeSpeeds {
            // Speeds above the largest count as the largest (note N5).
            start_mm_s: f64::from(vector.start_speed_mm_s).min(max_mm_s),
            end_mm_s: f64::from(vector.end_speed_mm_s).min(max_mm_s),
            max_mm_s,
            acceleration_mm_s2: settings.write_acceleration_mm_s2,
        },
    )
    .map_err(Refused::Unplannable)?;
    Ok(Plan::Move {
        motion: Motion::Stroke {
            stroke,
            rotation: state.place.pose.rotation,
        },
        then: Then::EndStroke,
        suction: None,
        laser: Some(vector.mode == WriteMode::Laser && vector.laser),
    })
}

fn grabbing_line(from: Pose, to: Pose, grab: bool, speeds: &Speeds) -> Result<Plan, Refused> {
    let line = LineMove::new(from, to, speeds).map_err(Refused::Unplannable)?;
    Ok(Plan::Move {
        motion: Motion::Line(line),
        then: Then::Nothing,
        suction: Some(grab),
        laser: None,
    })
}

fn spoken(voice: &Voice, state: &State, speeds: &Speeds) -> Result<Plan, Refused> {
    let grab = |suction| Ok(Plan::State(State { suction, ..*state }));
    match VoiceOrder::parse(voice).ok_or(Refused::NotUnderstood)? {
        VoiceOrder::Catch => grab(true),
        VoiceOrder::Release => grab(false),
        VoiceOrder::Move { x_mm, y_mm, z_mm } => {
            let from = state.place.pose;
            let to = Pose {
                position: from.position + position(x_mm, y_mm, z_mm),
                ..from
            };
            let line = LineMove::new(from, to, speeds).map_err(Refused::Unplannable)?;
            Ok(moving(Motion::Line(line), Then::Nothing))
        }
    }
}

/// A button pressed while nothing moves.
fn pressed(button: Button, state: &State, settings: &Settings) -> Result<Plan, Refused> {
    Ok(match button {
        Button::Released => Plan::State(*state),
        Button::Suction(suction) => Plan::State(State { suction, ..*state }),
        Button::Laser(laser) => Plan::State(State { laser, ..*state }),
        Button::Held { axis, share } => {
            let jog =
                Jog::start(state, settings, axis, share, 0.0).map_err(Refused::Unplannable)?;
            moving(Motion::Jog(jog), Then::Nothing)
        }
    })
}

fn configure(
    configuration: &Configuration,
    state: &State,
    settings: &Settings,
) -> Result<Plan, Refused> {
    let mut settings = *settings;
    match *configuration {
        Configuration::Teach {
            joint_speed_deg_s,
            joint_acceleration_deg_s2,
            servo_speed_deg_s,
            servo_acceleration_deg_s2,
            linear_speed_mm_s,
            linear_acceleration_mm_s2,
        } => {
            settings.teach = Speeds {
                joint_deg_s: joint_speed_deg_s.into(),
                joint_deg_s2: joint_acceleration_deg_s2.into(),
                servo_deg_s: servo_speed_deg_s.into(),
                servo_deg_s2: servo_acceleration_deg_s2.into(),
                line_mm_s: linear_speed_mm_s.into(),
                line_mm_s2: linear_acceleration_mm_s2.into(),
            };
        }
        Configuration::Playback {
            joint_speed_deg_s,
            joint_acceleration_deg_s2,
            servo_speed_deg_s,
            servo_acceleration_deg_s2,
            linear_speed_mm_s,
            linear_acceleration_mm_s2,
            default_pause_s,
            jump_height_mm,
        } => {
            settings.playback = Speeds {
                joint_deg_s: joint_speed_deg_s.into(),
                joint_deg_s2: joint_acceleration_deg_s2.into(),
                servo_deg_s: servo_speed_deg_s.into(),
                servo_deg_s2: servo_acceleration_deg_s2.into(),
                line_mm_s: linear_speed_mm_s.into(),
                line_mm_s2: linear_acceleration_mm_s2.into(),
            };
            settings.default_pause_s = default_pause_s.into();
            settings.jump_height = Millimeters(jump_height_mm.into());
        }
        Configuration::Writing { acceleration_mm_s2 } => {
            settings.write_acceleration_mm_s2 = acceleration_mm_s2.into();
        }
        Configuration::InitialAngles { rear_deg, fore_deg } => {
            return calibrated(rear_deg, fore_deg, state);
        }
        Configuration::EndEffector { tool } => return Ok(Plan::State(equipped(tool, state))),
    }
    Ok(Plan::Settings(settings))
}

fn calibrated(rear_deg: f32, fore_deg: f32, state: &State) -> Result<Plan, Refused> {
    let servo_deg = state.place.joints.servo.0;
    let joints = Joints::new(0.0, rear_deg.into(), fore_deg.into(), servo_deg);
    let place = Place::at_joints(joints, state.tool);
    place.check().map_err(Refused::Unreachable)?;
    Ok(Plan::State(State { place, ..*state }))
}

fn equipped(tool: EndEffector, state: &State) -> State {
    let tool = match tool {
        EndEffector::SuctionCup => Tool::SuctionCup,
        EndEffector::Gripper => Tool::Gripper,
        EndEffector::Laser => Tool::Laser,
    };
    State {
        tool,
        place: Place::at_joints(state.place.joints, tool),
        ..*state
    }
}

const fn moving(motion: Motion, then: Then) -> Plan {
    Plan::Move {
        motion,
        then,
        suction: None,
        laser: None,
    }
}

/// A target without a pause of its own takes the default one (note N10).
fn set_tool(suction: bool, gripper_deg: f32, pause_s: f32, settings: &Settings) -> Then {
    let pause_s = if pause_s > 0.0 {
        pause_s.into()
    } else {
        settings.default_pause_s
    };
    Then::SetTool {
        suction,
        gripper_deg: gripper_deg.into(),
        pause: Duration::try_from_secs_f64(pause_s).unwrap_or_default(),
    }
}

fn position(x_mm: f32, y_mm: f32, z_mm: f32) -> Position {
    Position::new(x_mm.into(), y_mm.into(), z_mm.into())
}

fn checked(place: Place) -> Result<(), Unreachable> {
    place.check()
}

/// As often as this a way is checked against the limits: once a control tick.
const SAMPLING_S: f64 = 0.02;
/// Across the whole workspace at 0.2 mm/s, which nobody is slower than on purpose.
pub(crate) const LONGEST_S: f64 = 3600.0;
