//! The complete state of a world.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Burn, Happened, Hole, Object, Paper, Stroke, Tool};

/// The complete state of a world at a moment, to be stored, sent and drawn. Lengths are rounded to a
/// thousandth of a millimetre.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[non_exhaustive]
pub struct WorldState {
    /// The time, in seconds since power-up.
    pub time_s: f64,
    /// The true state of the arm; `None` before the first update.
    pub arm: Option<ArmState>,
    /// The mounted tool.
    pub tool: Tool,
    /// The height of the table in the base frame.
    pub table_z_mm: f64,
    /// The paper.
    pub paper: Option<Paper>,
    /// The objects at their current positions.
    pub objects: Vec<Object>,
    /// The names of the objects that move with the tool: the gripped one first, then those on it.
    pub held: Vec<String>,
    /// The ink, in the order in which it was drawn.
    pub strokes: Vec<Stroke>,
    /// The lines burned by the laser.
    pub burns: Vec<Burn>,
    /// The holes burned by the standing laser.
    pub holes: Vec<Hole>,
    /// The total number of events.
    pub event_count: u64,
    /// The last events, at most 100, oldest first.
    pub events: Vec<Happened>,
}

/// The true pose of an arm and its actuators.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(rename = "TrueArm")]
#[non_exhaustive]
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
    /// The rotation of the tool in the base frame.
    pub rotation_deg: f64,
    /// The height of the tip above the table.
    pub tip_mm: f64,
    /// Whether the pump is on.
    pub pump: bool,
    /// Whether the laser is on.
    pub laser: bool,
    /// The angle of the gripper's servo.
    pub gripper_deg: f64,
    /// The opening of a gripper's fingers; 0 with another tool.
    pub opening_mm: f64,
}
