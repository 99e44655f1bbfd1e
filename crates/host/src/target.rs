//! Targets given by a person.

use std::str::FromStr;

use dobot_wire::{Command, MoveJoints, MoveTo, MovingMode, Status};

/// A target for the arm. Omitted parts keep their state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// The position.
    pub place: TargetPlace,
    /// The servo angle, in degrees; takes precedence over a rotation.
    pub servo_deg: Option<f32>,
    /// The path type.
    pub mode: MovingMode,
    /// Whether the pump runs after arrival.
    pub suction: Option<bool>,
    /// The gripper angle after arrival, -90 to 90 degrees.
    pub gripper_deg: Option<f32>,
    /// The pause after arrival, 0 to 655 seconds.
    pub pause_s: f32,
}

/// A target position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TargetPlace {
    /// A point in the base frame.
    Point {
        /// x forward, y left, z up from the pivot of the rear arm, in millimetres.
        mm: [f32; 3],
        /// The rotation of the tool relative to the base frame, in degrees; without it the servo
        /// keeps its angle.
        rotation_deg: Option<f32>,
    },
    /// The angles of base, rear arm and forearm, in degrees.
    Joints([f32; 3]),
}

impl Target {
    /// Returns the command to the target, for an arm with this status.
    ///
    /// ```
    /// use dobot_host::{Target, TargetPlace};
    /// use dobot_wire::{Command, MoveTo, MovingMode, Status};
    ///
    /// let target = Target {
    ///     place: TargetPlace::Point { mm: [200.0, 0.0, 20.0], rotation_deg: None },
    ///     servo_deg: None,
    ///     mode: MovingMode::MovL,
    ///     suction: None,
    ///     gripper_deg: None,
    ///     pause_s: 0.0,
    /// };
    /// let from = Status {
    ///     x_mm: 180.0, y_mm: 0.0, z_mm: 40.0, rotation_deg: 30.0,
    ///     base_deg: 0.0, rear_deg: 20.0, fore_deg: 30.0, servo_deg: 30.0,
    ///     suction: true, gripper_deg: 0.0,
    /// };
    /// let there = MoveTo { rotation_deg: 30.0, suction: true, mode: MovingMode::MovL, ..MoveTo::to(200.0, 0.0, 20.0) };
    /// assert_eq!(target.command(&from), Command::from(there));
    /// ```
    #[must_use]
    pub fn command(&self, from: &Status) -> Command {
        let servo_deg = self.servo_deg.unwrap_or(from.servo_deg);
        let suction = self.suction.unwrap_or(from.suction);
        let gripper_deg = self.gripper_deg.unwrap_or(from.gripper_deg);
        match self.place {
            TargetPlace::Point { mm, rotation_deg } => {
                let [x_mm, y_mm, z_mm] = mm;
                let base_deg = y_mm.atan2(x_mm).to_degrees();
                Command::from(MoveTo {
                    rotation_deg: rotation_deg.unwrap_or(base_deg + servo_deg),
                    suction,
                    mode: self.mode,
                    gripper_deg,
                    pause_s: self.pause_s,
                    ..MoveTo::to(x_mm, y_mm, z_mm)
                })
            }
            TargetPlace::Joints([base_deg, rear_deg, fore_deg]) => Command::from(MoveJoints {
                suction,
                mode: self.mode,
                gripper_deg,
                pause_s: self.pause_s,
                ..MoveJoints::to([base_deg, rear_deg, fore_deg, servo_deg])
            }),
        }
    }
}

/// A path type by its name: `jump`, `movl` or `movj`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PathName(pub MovingMode);

impl FromStr for PathName {
    type Err = UnknownPath;

    fn from_str(text: &str) -> Result<Self, UnknownPath> {
        match text.to_ascii_lowercase().as_str() {
            "jump" => Ok(Self(MovingMode::Jump)),
            "movl" => Ok(Self(MovingMode::MovL)),
            "movj" => Ok(Self(MovingMode::MovJ)),
            _ => Err(UnknownPath),
        }
    }
}

/// The error returned for an unknown path type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("allowed are jump (lift, across, down), movl (straight) and movj (all joints together)")]
pub struct UnknownPath;
