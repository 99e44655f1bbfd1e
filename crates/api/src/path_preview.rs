//! Previews of paths.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The path a command would take if it were sent now, after all queued commands. The command is
/// allowed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PathPreview {
    /// The duration of motion and pause, in seconds; absent for a button, which lasts until it is
    /// released.
    pub takes_s: Option<f64>,
    /// Positions of the tool along the path, including its start and end, at equal time intervals:
    /// x, y and z in millimetres.
    #[schemars(length(min = 1))]
    pub path_mm: Vec<[f64; 3]>,
    /// Base, rear arm, forearm and servo angles at the end, in degrees.
    pub joints_deg: [f64; 4],
}

/// The planned path of a job, once through its commands.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct JobPath {
    /// Successive positions of the tool: x, y and z in millimetres. Between two of them the tool
    /// moves in a straight line, or visually close to one.
    pub path_mm: Vec<[f64; 3]>,
    /// The command that each position belongs to, from 0; the last position of a command is its
    /// end.
    pub commands: Vec<usize>,
    /// Whether the segment to each position is drawn or burnt: the laser is on or the pen is down.
    pub marks: Vec<bool>,
    /// When each position is reached, in seconds since the job began, including the arm's pauses.
    pub until_s: Vec<f64>,
}
