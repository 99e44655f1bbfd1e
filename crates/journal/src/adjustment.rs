//! What a person changes on a job while it runs.

use serde::{Deserialize, Serialize};

/// What a person has changed on a job while it runs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Adjustment {
    /// How fast its vectors are drawn, in percent of what was planned.
    pub speed_percent: f64,
    /// How far above the plan it is drawn: the last change before the commands that are done, and
    /// all behind it.
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

/// From where on a job is drawn at another height than planned.
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
    /// The first command that is changed.
    pub from: usize,
    /// How far above the plan that command begins, in millimetres.
    pub begin_mm: f64,
    /// How far above the plan is wanted, in millimetres.
    pub offset_mm: f64,
}
