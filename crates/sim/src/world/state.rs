//! The state of a world: all that can be known of it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Burn, Happened, Hole, Object, Paper, Stroke, Tool};

/// All that can be known of a world at a moment, to be kept, sent and drawn. Lengths are told to a
/// thousandth of a millimetre.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct WorldState {
    /// The time, in seconds since power-up.
    pub time_s: f64,
    /// Where the arm really is; nothing where it has not been told yet.
    pub arm: Option<ArmState>,
    /// What is mounted at its end.
    pub tool: Tool,
    /// The height of the table in the base frame.
    pub table_z_mm: f64,
    /// The paper.
    pub paper: Option<Paper>,
    /// The objects, those in the grip where they are now.
    pub objects: Vec<Object>,
    /// The names of the objects that move with the tool: the one in its grip first, then those
    /// that stand on it.
    pub held: Vec<String>,
    /// The ink, in the order in which it was drawn.
    pub strokes: Vec<Stroke>,
    /// What the laser burned on its way.
    pub burns: Vec<Burn>,
    /// What the laser burned where it stood.
    pub holes: Vec<Hole>,
    /// How many events there were.
    pub event_count: u64,
    /// The last of them, at most 100, the oldest first.
    pub events: Vec<Happened>,
}

/// Where an arm really is and what acts at its tool.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(rename = "TrueArm")]
pub struct ArmState {
    /// Joint 1.
    pub base_deg: f64,
    /// Joint 2.
    pub rear_deg: f64,
    /// Joint 3.
    pub fore_deg: f64,
    /// Joint 4.
    pub servo_deg: f64,
    /// Forward.
    pub x_mm: f64,
    /// To the left.
    pub y_mm: f64,
    /// The height of the wrist in the base frame.
    pub z_mm: f64,
    /// How the tool is turned in the base frame.
    pub rotation_deg: f64,
    /// The height of the tip above the table.
    pub tip_mm: f64,
    /// Whether the pump runs.
    pub pump: bool,
    /// Whether the laser is on.
    pub laser: bool,
    /// The angle of the gripper's servo.
    pub gripper_deg: f64,
    /// How far the fingers of a gripper are apart; 0 with another tool.
    pub opening_mm: f64,
}
