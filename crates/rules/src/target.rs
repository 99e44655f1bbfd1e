//! Where somebody wants the arm to go.

use dobot_wire::{Command, MoveJoints, MoveTo, MovingMode, Status};

/// Where somebody wants the arm to go; what is not told stays as it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// The place.
    pub place: TargetPlace,
    /// The servo's angle, in degrees; at a point a rotation takes its place.
    pub servo_deg: Option<f32>,
    /// The way there.
    pub mode: MovingMode,
    /// Whether the pump runs, once there.
    pub suction: Option<bool>,
    /// The gripper's angle, once there, in degrees from -90 to 90.
    pub gripper_deg: Option<f32>,
    /// How long to wait there, in seconds.
    pub pause_s: f32,
}

/// The place of a target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TargetPlace {
    /// A point.
    Point {
        /// X, y and z in the base frame, in millimetres.
        at_mm: [f32; 3],
        /// How the tool is turned relative to the base frame, in degrees; without it the servo decides.
        rotation_deg: Option<f32>,
    },
    /// Base, rear arm and forearm, in degrees.
    Joints([f32; 3]),
}

impl Target {
    /// The command that leads there from how the arm stands.
    #[must_use]
    pub fn command(&self, from: &Status) -> Command {
        let mode = self.mode;
        let servo_deg = self.servo_deg.unwrap_or(from.servo_deg);
        let suction = self.suction.unwrap_or(from.suction);
        let gripper_deg = self.gripper_deg.unwrap_or(from.gripper_deg);
        let pause_s = self.pause_s;
        match self.place {
            TargetPlace::Joints([base_deg, rear_deg, fore_deg]) => MoveJoints {
                base_deg,
                rear_deg,
                fore_deg,
                servo_deg,
                suction,
                mode,
                gripper_deg,
                pause_s,
            }
            .into(),
            TargetPlace::Point {
                at_mm: [x_mm, y_mm, z_mm],
                rotation_deg,
            } => {
                let base_deg = y_mm.atan2(x_mm).to_degrees();
                MoveTo {
                    x_mm,
                    y_mm,
                    z_mm,
                    rotation_deg: rotation_deg.unwrap_or(base_deg + servo_deg),
                    suction,
                    mode,
                    gripper_deg,
                    pause_s,
                }
                .into()
            }
        }
    }
}
