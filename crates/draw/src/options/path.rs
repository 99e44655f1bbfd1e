//! The options that say how it is drawn.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::fields::Ranges;
use crate::arm::resume_point::ResumePoint;
use crate::prepare::{Settings, TRIES};

/// How it is drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
#[schemars(transform = Ranges("way"))]
pub struct PathOptions {
    /// How far the drawn path may leave the wanted one, in mm
    pub tolerance: f64,
    /// Join strokes whose ends lie so near to each other, in mm (default: the tolerance)
    pub join: Option<f64>,
    /// Leave out what lies on other lines, and of shapes to cut out only whole ones
    pub drop_doubles: bool,
    /// Draw in the order of the file
    pub keep_order: bool,
    /// How long to look for the shortest way with the pen up: so many tries, fewer from 10,000 strokes on
    pub tries: u32,
    /// Look elsewhere: the same number gives the same order
    pub seed: u64,
    /// Begin later: at a layer, a stroke or a share of the ink, as in layer:red, stroke:120 or 40%
    pub from: Option<ResumePoint>,
}

impl Default for PathOptions {
    /// As [`Settings`].
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
