//! The state of the arm while a program is compiled.

use dobot_arm::{Degrees, Joints, Pose, Position, Tool};
use dobot_motion::Speeds;
use dobot_wire::{Command, Configuration, MovingMode, PlaybackAdjustment, single};

use super::resolve::Spot;
use crate::program::{Here, MountedTool, Speed};

/// The state that the commands of a program have set.
#[derive(Clone, Debug)]
pub(super) struct State {
    pub(super) tool: Tool,
    /// The distance from the wrist down to the tip.
    pub(super) length_mm: f64,
    pub(super) suction: bool,
    pub(super) gripper_deg: f64,
    pub(super) has_moved: bool,
    /// The target at which the arm stands.
    last: Option<Command>,
    speeds: [f64; 6],
    jump_height_mm: f64,
    percent: f64,
    acceleration_percent: f64,
    /// The speed of the first motion, in percent.
    soft_percent: Option<f64>,
}

impl State {
    /// The state of an arm after power-up.
    pub(super) const fn new(soft_percent: Option<f64>) -> Self {
        Self {
            tool: Tool::SuctionCup,
            length_mm: 0.0,
            suction: false,
            gripper_deg: 0.0,
            has_moved: false,
            last: None,
            speeds: Speeds::STOCK.numbers(),
            jump_height_mm: 20.0,
            percent: 50.0,
            acceleration_percent: 50.0,
            soft_percent,
        }
    }

    pub(super) fn grip(&mut self, then: &Here) {
        self.suction = then.suction.unwrap_or(self.suction);
        self.gripper_deg = then.gripper.unwrap_or(self.gripper_deg);
    }

    pub(super) fn mount(&mut self, tool: &MountedTool) {
        self.tool = tool.kind;
        self.length_mm = tool.length;
    }

    pub(super) const fn arrived(&mut self, target: Command) {
        self.has_moved = true;
        self.soft_percent = None;
        self.last = Some(target);
    }

    /// Records a drawing, which ends at its last vector, with its own speeds, pump and gripper
    /// state.
    pub(super) const fn drawn(&mut self) {
        self.has_moved = true;
        self.soft_percent = None;
        self.last = None;
    }

    /// Repeats the target at which the arm stands, with the current state of the tool.
    pub(super) fn again(&self, pause: Option<f64>) -> Option<Command> {
        let pause_s = single(pause.unwrap_or(0.0));
        let (suction, gripper_deg) = (self.suction, single(self.gripper_deg));
        let mode = MovingMode::MovJ;
        match self.last? {
            Command::MoveTo(move_to) => Some(
                dobot_wire::MoveTo {
                    suction,
                    gripper_deg,
                    pause_s,
                    mode,
                    ..move_to
                }
                .into(),
            ),
            Command::MoveJoints(move_joints) => Some(
                dobot_wire::MoveJoints {
                    suction,
                    gripper_deg,
                    pause_s,
                    mode,
                    ..move_joints
                }
                .into(),
            ),
            _ => None,
        }
    }

    /// The place of that target.
    pub(super) fn spot(&self) -> Option<Spot> {
        match self.last? {
            Command::MoveTo(move_to) => {
                let [x, y, z, rotation] = [
                    move_to.x_mm,
                    move_to.y_mm,
                    move_to.z_mm,
                    move_to.rotation_deg,
                ]
                .map(f64::from);
                Some(Spot::wrist(Position::new(x, y, z), rotation))
            }
            Command::MoveJoints(move_joints) => {
                let [base, rear, fore, servo] = [
                    move_joints.base_deg,
                    move_joints.rear_deg,
                    move_joints.fore_deg,
                    move_joints.servo_deg,
                ]
                .map(f64::from);
                Some(Spot::joints(Joints::new(base, rear, fore, servo)))
            }
            _ => None,
        }
    }

    /// Sets speeds and returns the commands for it.
    pub(super) fn set_speed(&mut self, speed: &Speed) -> Vec<Command> {
        let new = [
            speed.joint,
            speed.joint_acceleration,
            speed.servo,
            speed.servo_acceleration,
            speed.line,
            speed.line_acceleration,
        ];
        let mut commands = Vec::new();
        if new.iter().any(Option::is_some) || speed.jump_height.is_some() {
            for (known, new) in self.speeds.iter_mut().zip(new) {
                *known = new.unwrap_or(*known);
            }
            self.jump_height_mm = speed.jump_height.unwrap_or(self.jump_height_mm);
            let speeds = self.speeds.map(single);
            commands.push(Configuration::playback(speeds, 0.0, single(self.jump_height_mm)).into());
        }
        if speed.percent.is_some() || speed.acceleration_percent.is_some() {
            self.percent = speed.percent.unwrap_or(self.percent);
            self.acceleration_percent = speed
                .acceleration_percent
                .unwrap_or(self.acceleration_percent);
            commands.push(self.adjustment(self.percent));
        }
        commands
    }

    /// The commands before and after the first motion, if it starts softly.
    pub(super) fn soft_start(&self) -> Option<[Command; 2]> {
        let soft = self.soft_percent.filter(|_| !self.has_moved)?;
        let slow = self.adjustment(self.percent * soft / 100.0);
        Some([slow, self.adjustment(self.percent)])
    }

    fn adjustment(&self, percent: f64) -> Command {
        PlaybackAdjustment {
            speed_percent: single(percent),
            acceleration_percent: single(self.acceleration_percent),
            teach_speed_percent: 100.0,
        }
        .into()
    }
}

impl Spot {
    /// The numbers of a pose: x, y, z and rotation.
    pub(super) const fn numbers(pose: &Pose) -> [f64; 4] {
        let Position { x, y, z } = pose.position;
        let Degrees(rotation) = pose.rotation;
        [x.0, y.0, z.0, rotation]
    }
}
