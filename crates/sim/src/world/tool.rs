//! The tool that is mounted at the end of the arm.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The tool of a scene.
///
/// Heights are measured at the table: lower the arm until the tip touches the table; the z that the
/// arm then reports is `down_z_mm`. The height of the tip above the table is z less `down_z_mm`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(rename = "WorldTool")]
#[non_exhaustive]
pub struct Tool {
    /// Z of the wrist when the tip touches the table, in the base frame.
    pub down_z_mm: f64,
    /// The compliance of the tip before a collision is reported: a pen has a spring, a cup is soft.
    pub give_mm: f64,
    /// The kind of tool.
    #[serde(rename = "kind")]
    pub action: ToolAction,
}

/// The kind of a tool and its effect on the scene.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum ToolAction {
    /// A pen.
    Pen {
        /// The line width.
        width_mm: f64,
    },
    /// A laser.
    Laser {
        /// The distance from its tip down to its focus.
        focus_mm: f64,
        /// The range above and below the focus in which it burns.
        depth_mm: f64,
        /// Its power, in watts; the protocol has on and off only.
        power_w: f64,
    },
    /// A suction cup.
    SuctionCup {
        /// The diameter; it holds only objects that it covers completely.
        diameter_mm: f64,
        /// The heaviest load, in grams.
        lifts_g: f64,
    },
    /// A gripper, whose fingers move towards each other across the tool's direction.
    Gripper {
        /// The opening with the servo at 0 degrees.
        open_mm: f64,
        /// The opening with the servo at 90 degrees.
        closed_mm: f64,
        /// The heaviest load, in grams.
        lifts_g: f64,
    },
}

impl Tool {
    /// The corresponding tool of the arm.
    #[must_use]
    pub const fn tool(&self) -> dobot_arm::Tool {
        match self.action {
            ToolAction::Pen { .. } => dobot_arm::Tool::Pen,
            ToolAction::Laser { .. } => dobot_arm::Tool::Laser,
            ToolAction::SuctionCup { .. } => dobot_arm::Tool::SuctionCup,
            ToolAction::Gripper { .. } => dobot_arm::Tool::Gripper,
        }
    }

    /// The opening of the fingers at a servo angle, linear from 0 to 90 degrees and clamped there by
    /// the stops; 0 for other tools.
    #[must_use]
    pub fn opening_mm(&self, gripper_deg: f64) -> f64 {
        match self.action {
            ToolAction::Gripper {
                open_mm, closed_mm, ..
            } => open_mm + (closed_mm - open_mm) * (gripper_deg / 90.0).clamp(0.0, 1.0),
            _ => 0.0,
        }
    }

    /// The heaviest load; `None` for tools that hold nothing.
    pub(crate) const fn lifts_g(&self) -> f64 {
        match self.action {
            ToolAction::SuctionCup { lifts_g, .. } | ToolAction::Gripper { lifts_g, .. } => lifts_g,
            _ => 0.0,
        }
    }
}
