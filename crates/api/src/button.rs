//! Jog buttons: their names and the commands that they send.

use std::str::FromStr;

use dobot_wire::{
    Command, JointJog, JointJogAxis, LinearJog, LinearJogAxis, MoveJoints, MoveTo, MovingMode,
    Status,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::Jog;

/// A button of joint jog or of linear jog (Table 2.5; note N14).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(
    tag = "frame",
    content = "axis",
    rename_all = "snake_case",
    deny_unknown_fields
)]
pub enum Button {
    /// State 2.
    Joint(JointJogAxis),
    /// State 7.
    Linear(LinearJogAxis),
}

/// One of the two jog frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JogFrame {
    /// State 2.
    Joint,
    /// State 7.
    Linear,
}

impl Button {
    /// Returns the same button in the named jog frame, if that frame has it.
    ///
    /// # Errors
    ///
    /// [`ButtonError`] if that frame has no such axis.
    pub fn with_frame(self, frame: Option<JogFrame>) -> Result<Self, ButtonError> {
        let code = self.code();
        let is_common = code > LAST_OWN_AXIS;
        match (self, frame) {
            (Self::Joint(_), Some(JogFrame::Linear)) if is_common => {
                Ok(Self::Linear(LinearJogAxis::ALL[code]))
            }
            (Self::Joint(_), Some(JogFrame::Linear)) => Err(ButtonError::JointAlone),
            (Self::Linear(_), Some(JogFrame::Joint)) => Err(ButtonError::LinearAlone),
            _ => Ok(self),
        }
    }

    /// Returns the button's name, as in `dobot jog x+`; a linear button that both frames have uses
    /// the joint jog's name.
    #[must_use]
    pub fn name(self) -> &'static str {
        let joint = |other: &Self| other.code() > LAST_OWN_AXIS && other.code() == self.code();
        let named = |(_, button): &&(&str, Self)| *button == self || joint(button);
        BUTTONS.iter().find(named).map_or("released", |row| row.0)
    }

    /// Returns the jog command sent while the button is pressed.
    #[must_use]
    pub const fn jog(self, speed_percent: f32) -> Jog {
        match self {
            Self::Joint(axis) => Jog::Joint(JointJog::new(axis, speed_percent)),
            Self::Linear(axis) => Jog::Linear(LinearJog::new(axis, speed_percent)),
        }
    }

    /// Returns the command for one step from this status, in mm or degrees; `None` for switches and
    /// for no button.
    ///
    /// Pump and gripper keep their state. A turn of the tool is a servo turn: a straight line to
    /// the tip's own position would make a stock arm lose its pose (note N34).
    #[must_use]
    pub fn step(self, from: &Status, size: f32) -> Option<Command> {
        use {JointJogAxis as J, LinearJogAxis as L};
        let mut place = [from.x_mm, from.y_mm, from.z_mm];
        let mut angles = [from.base_deg, from.rear_deg, from.fore_deg, from.servo_deg];
        match self {
            Self::Linear(L::XPlus) => place[0] += size,
            Self::Linear(L::XMinus) => place[0] -= size,
            Self::Linear(L::YPlus) => place[1] += size,
            Self::Linear(L::YMinus) => place[1] -= size,
            Self::Linear(L::ZPlus) => place[2] += size,
            Self::Linear(L::ZMinus) => place[2] -= size,
            Self::Joint(J::BasePlus) => angles[0] += size,
            Self::Joint(J::BaseMinus) => angles[0] -= size,
            Self::Joint(J::RearPlus) => angles[1] += size,
            Self::Joint(J::RearMinus) => angles[1] -= size,
            Self::Joint(J::ForePlus) => angles[2] += size,
            Self::Joint(J::ForeMinus) => angles[2] -= size,
            Self::Joint(J::ServoPlus) | Self::Linear(L::ServoPlus) => angles[3] += size,
            Self::Joint(J::ServoMinus) | Self::Linear(L::ServoMinus) => angles[3] -= size,
            Self::Joint(_) | Self::Linear(_) => return None,
        }
        let [x_mm, y_mm, z_mm] = place;
        let is_line = place != [from.x_mm, from.y_mm, from.z_mm];
        let Status {
            rotation_deg,
            suction,
            gripper_deg,
            ..
        } = *from;
        Some(if is_line {
            let target = MoveTo {
                rotation_deg,
                suction,
                gripper_deg,
                mode: MovingMode::MovL,
                ..MoveTo::to(x_mm, y_mm, z_mm)
            };
            target.into()
        } else {
            let target = MoveJoints {
                suction,
                gripper_deg,
                mode: MovingMode::MovJ,
                ..MoveJoints::to(angles)
            };
            target.into()
        })
    }

    /// Returns whether the button moves something while held; otherwise it is a switch.
    #[must_use]
    pub const fn moves(self) -> bool {
        match self {
            Self::Joint(axis) => axis.moves(),
            Self::Linear(axis) => axis.moves(),
        }
    }

    /// Returns the command that ends a switch that must not stay on: the laser goes off.
    #[must_use]
    pub const fn end(self) -> Option<Jog> {
        match self {
            Self::Joint(JointJogAxis::LaserOn) => {
                Some(Self::Joint(JointJogAxis::LaserOff).jog(0.0))
            }
            Self::Linear(LinearJogAxis::LaserOn) => {
                Some(Self::Linear(LinearJogAxis::LaserOff).jog(0.0))
            }
            Self::Joint(_) | Self::Linear(_) => None,
        }
    }

    /// Returns float 2 of its packet, the index in either list of axes.
    const fn code(self) -> usize {
        match self {
            Self::Joint(axis) => axis as usize,
            Self::Linear(axis) => axis as usize,
        }
    }
}

impl FromStr for Button {
    type Err = ButtonError;

    fn from_str(text: &str) -> Result<Self, ButtonError> {
        let named = |(name, _): &&(&str, Self)| *name == text;
        let found = BUTTONS.iter().find(named);
        found.map(|(_, button)| *button).ok_or(ButtonError::Unknown)
    }
}

impl FromStr for JogFrame {
    type Err = ButtonError;

    fn from_str(text: &str) -> Result<Self, ButtonError> {
        match text {
            "joint" => Ok(Self::Joint),
            "linear" => Ok(Self::Linear),
            _ => Err(ButtonError::UnknownFrame),
        }
    }
}

/// The error returned when there is no such button.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ButtonError {
    /// No button has this name.
    #[error("allowed are {}", BUTTONS.map(|row| row.0).join(", "))]
    Unknown,
    /// No jog has this name.
    #[error("allowed are joint and linear")]
    UnknownFrame,
    /// The linear jog does not have it.
    #[error("base, rear and fore are axes of the joint jog (state 2)")]
    JointAlone,
    /// The joint jog does not have it.
    #[error("x, y and z are axes of the linear jog (state 7)")]
    LinearAlone,
}

/// Beyond this code both jogs have the same axes (note N14).
const LAST_OWN_AXIS: usize = 6;

const BUTTONS: [(&str, Button); 20] = {
    use JointJogAxis as J;
    use LinearJogAxis as L;
    [
        ("base+", Button::Joint(J::BasePlus)),
        ("base-", Button::Joint(J::BaseMinus)),
        ("rear+", Button::Joint(J::RearPlus)),
        ("rear-", Button::Joint(J::RearMinus)),
        ("fore+", Button::Joint(J::ForePlus)),
        ("fore-", Button::Joint(J::ForeMinus)),
        ("servo+", Button::Joint(J::ServoPlus)),
        ("servo-", Button::Joint(J::ServoMinus)),
        ("gripper+", Button::Joint(J::GripperOpen)),
        ("gripper-", Button::Joint(J::GripperClose)),
        ("x+", Button::Linear(L::XPlus)),
        ("x-", Button::Linear(L::XMinus)),
        ("y+", Button::Linear(L::YPlus)),
        ("y-", Button::Linear(L::YMinus)),
        ("z+", Button::Linear(L::ZPlus)),
        ("z-", Button::Linear(L::ZMinus)),
        ("suction-on", Button::Joint(J::SuctionOn)),
        ("suction-off", Button::Joint(J::SuctionOff)),
        ("laser-on", Button::Joint(J::LaserOn)),
        ("laser-off", Button::Joint(J::LaserOff)),
    ]
};

#[cfg(test)]
mod tests {
    use super::*;

    const STATUS: Status = Status {
        x_mm: 200.0,
        y_mm: 0.0,
        z_mm: 50.0,
        rotation_deg: 10.0,
        base_deg: 5.0,
        rear_deg: 40.0,
        fore_deg: 30.0,
        servo_deg: 8.0,
        suction: true,
        gripper_deg: 20.0,
    };

    #[test]
    fn a_step_of_the_tip_is_a_straight_line_along_one_axis_and_does_not_turn_the_tool() {
        let step = Button::Linear(LinearJogAxis::YMinus).step(&STATUS, 10.0);
        let expected = MoveTo {
            x_mm: 200.0,
            y_mm: -10.0,
            z_mm: 50.0,
            rotation_deg: 10.0,
            suction: true,
            mode: MovingMode::MovL,
            gripper_deg: 20.0,
            pause_s: 0.0,
        };
        assert_eq!(step, Some(expected.into()));
    }

    #[test]
    fn a_step_of_a_joint_moves_that_joint_only() {
        let step = Button::Joint(JointJogAxis::RearPlus).step(&STATUS, 1.0);
        let expected = MoveJoints {
            base_deg: 5.0,
            rear_deg: 41.0,
            fore_deg: 30.0,
            servo_deg: 8.0,
            suction: true,
            mode: MovingMode::MovJ,
            gripper_deg: 20.0,
            pause_s: 0.0,
        };
        assert_eq!(step, Some(expected.into()));
    }

    #[test]
    fn a_tool_button_of_either_jog_turns_the_servo_by_one_step() {
        for (button, servo_deg) in [
            (Button::Linear(LinearJogAxis::ServoPlus), 18.0),
            (Button::Joint(JointJogAxis::ServoPlus), 18.0),
            (Button::Linear(LinearJogAxis::ServoMinus), -2.0),
            (Button::Joint(JointJogAxis::ServoMinus), -2.0),
        ] {
            let Some(Command::MoveJoints(step)) = button.step(&STATUS, 10.0) else {
                panic!("{button:?} turns no joint");
            };
            assert_eq!(
                [step.base_deg, step.rear_deg, step.fore_deg, step.servo_deg],
                [5.0, 40.0, 30.0, servo_deg]
            );
        }
    }

    #[test]
    fn a_switch_and_a_release_have_no_step() {
        for button in [
            Button::Joint(JointJogAxis::SuctionOn),
            Button::Linear(LinearJogAxis::LaserOn),
            Button::Linear(LinearJogAxis::Released),
        ] {
            assert_eq!(button.step(&STATUS, 1.0), None, "{button:?}");
        }
    }

    #[test]
    fn a_button_is_written_as_its_frame_and_its_axis() {
        let button = Button::Linear(LinearJogAxis::ServoPlus);
        let text = r#"{"frame":"linear","axis":"servo_plus"}"#;
        assert_eq!(serde_json::to_string(&button).ok().as_deref(), Some(text));
        assert_eq!(serde_json::from_str::<Button>(text).ok(), Some(button));
        assert!(
            serde_json::from_str::<Button>(r#"{"frame":"linear","axis":"base_plus"}"#).is_err()
        );
    }
}
