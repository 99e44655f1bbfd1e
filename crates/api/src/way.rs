//! Where a command would lead.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Where a command would lead if it were sent now, behind all that waits: it is allowed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct WayView {
    /// How long motion and pause take, in seconds; nothing for a button, which goes on until it is released.
    pub takes_s: Option<f64>,
    /// The places of the tool on its way, its beginning and its end among them, at equal distances in time: x, y and z
    /// in millimetres.
    #[schemars(length(min = 1))]
    pub path_mm: Vec<[f64; 3]>,
    /// Base, rear arm, forearm and servo at the end, in degrees.
    pub joints_deg: [f64; 4],
}
