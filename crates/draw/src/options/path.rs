//! The options for the path.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::fields::Ranges;
use crate::arm::resume_point::ResumePoint;
use crate::prepare::{Settings, TRIES};

/// How to draw it
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
#[schemars(transform = Ranges("way"))]
pub struct PathOptions {
    /// Maximum deviation of the drawn path, in mm
    pub tolerance: f64,
    /// Join strokes whose ends are this close, in mm (default: the tolerance)
    pub join: Option<f64>,
    /// Remove duplicate lines; of shapes to cut out, only complete duplicates
    pub drop_doubles: bool,
    /// Keep the stroke order of the file
    pub keep_order: bool,
    /// Number of attempts to shorten the pen-up travel for 10,000 strokes and more; fewer for fewer
    pub tries: u32,
    /// Random seed for the stroke order; the same seed gives the same order
    pub seed: u64,
    /// Resume at a layer, a stroke or a share of the ink, as in layer:red, stroke:120 or 40%
    pub from: Option<ResumePoint>,
}

impl Default for PathOptions {
    /// Returns the defaults of [`Settings`].
    fn default() -> Self {
        let settings = Settings::default();
        Self {
            tolerance: settings.tolerance_mm,
            join: None,
            drop_doubles: false,
            keep_order: false,
            tries: TRIES,
            seed: settings.seed,
            from: None,
        }
    }
}
