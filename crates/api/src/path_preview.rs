//! Where a command would lead.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Where a command would lead if it were sent now, behind all that waits: it is allowed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PathPreview {
    /// How long motion and pause take, in seconds; nothing for a button, which goes on until it is released.
    pub takes_s: Option<f64>,
    /// The places of the tool on its way, its beginning and its end among them, at equal distances in time: x, y and z
    /// in millimetres.
    #[schemars(length(min = 1))]
    pub path_mm: Vec<[f64; 3]>,
    /// Base, rear arm, forearm and servo at the end, in degrees.
    pub joints_deg: [f64; 4],
}

/// The way of a job, once through its commands, as it was planned.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct JobPath {
    /// Places of the tool, one after the other: x, y and z in millimetres of each. Between two of them the tool goes
    /// straight, or as near to straight as can be seen.
    pub path_mm: Vec<[f64; 3]>,
    /// To which command each place belongs, from 0; the last place of a command is its end.
    pub commands: Vec<usize>,
    /// Whether the way to each place is drawn or burnt: the laser is on, or the pen is down.
    pub marks: Vec<bool>,
    /// When each place is reached, in seconds since the job began, pauses of the arm included.
    pub until_s: Vec<f64>,
}
