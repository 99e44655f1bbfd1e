//! The tool that is mounted at the end of the arm.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The tool of a scene.
///
/// Heights are measured where a person measures them: the arm is lowered until the tip touches the
/// table, and the z that the arm tells then is `down_z_mm`. From there the height of the tip above
/// the table is z less `down_z_mm`, wherever the wrist and the table really are.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(rename = "WorldTool")]
pub struct Tool {
    /// Z of the wrist when the tip touches the table, in the base frame.
    pub down_z_mm: f64,
    /// How far the tip may be pressed into something before that counts as a collision: a pen has
    /// a spring, a cup is soft.
    pub give_mm: f64,
    /// Which tool it is, and how it acts on the scene.
    #[serde(rename = "kind")]
    pub action: ToolAction,
}

/// How a tool acts on the scene.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum ToolAction {
    /// A pen.
    Pen {
        /// How wide its line is.
        width_mm: f64,
    },
    /// A laser.
    Laser {
        /// From its tip down to its focus.
        focus_mm: f64,
        /// How far above and below the focus it still burns.
        depth_mm: f64,
        /// Its power, in watts; the protocol knows on and off only.
        power_w: f64,
    },
    /// A suction cup.
    SuctionCup {
        /// How wide it is: it holds only what it covers as a whole.
        diameter_mm: f64,
        /// The heaviest load, in grams.
        lifts_g: f64,
    },
    /// A gripper, whose fingers move towards each other across the tool's direction.
    Gripper {
        /// Between the fingers with the servo at 0 degrees.
        open_mm: f64,
        /// Between the fingers with the servo at 90 degrees.
        closed_mm: f64,
        /// The heaviest load, in grams.
        lifts_g: f64,
    },
}

impl Tool {
    /// Which of the arm's tools it is.
    #[must_use]
    pub const fn tool(&self) -> dobot_arm::Tool {
        match self.action {
            ToolAction::Pen { .. } => dobot_arm::Tool::Pen,
            ToolAction::Laser { .. } => dobot_arm::Tool::Laser,
            ToolAction::SuctionCup { .. } => dobot_arm::Tool::SuctionCup,
            ToolAction::Gripper { .. } => dobot_arm::Tool::Gripper,
        }
    }

    /// How far the fingers are apart with the servo at an angle, linear from 0 to 90 degrees and
    /// no farther: there they stand against their stops. 0 where there are none.
    #[must_use]
    pub fn opening_mm(&self, gripper_deg: f64) -> f64 {
        match self.action {
            ToolAction::Gripper {
                open_mm, closed_mm, ..
            } => open_mm + (closed_mm - open_mm) * (gripper_deg / 90.0).clamp(0.0, 1.0),
            _ => 0.0,
        }
    }

    /// The heaviest load; nothing where it holds nothing.
    pub(crate) const fn lifts_g(&self) -> f64 {
        match self.action {
            ToolAction::SuctionCup { lifts_g, .. } | ToolAction::Gripper { lifts_g, .. } => lifts_g,
            _ => 0.0,
        }
    }
}
