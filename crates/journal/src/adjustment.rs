//! Adjustments of a job by a person while it runs.

use serde::{Deserialize, Serialize};

/// The adjustments of a job by a person while it runs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Adjustment {
    /// The speed of its vectors, in percent of the plan.
    pub speed_percent: f64,
    /// Its height changes: the last one before the completed commands, and all later ones.
    pub heights: Vec<HeightChange>,
}

impl Default for Adjustment {
    fn default() -> Self {
        Self {
            speed_percent: 100.0,
            heights: Vec::new(),
        }
    }
}

/// A change of height from a command on.
///
/// ```text
///   z above the plan
///                       .------------- offset_mm
///   begin_mm  ---.    .'
///                 '--'   a bit with each vector
///   --------------|-------------------
///                from                   commands
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HeightChange {
    /// The first changed command.
    pub from: usize,
    /// The height above the plan at the start of that command, in millimetres.
    pub begin_mm: f64,
    /// The wanted height above the plan, in millimetres.
    pub offset_mm: f64,
}
