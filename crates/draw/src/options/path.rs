//! The options that say how it is drawn.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::arm::resume_point::StartFrom;
use crate::prepare::{Settings, TRIES};

/// How it is drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[cfg_attr(feature = "options", derive(clap::Args))]
#[cfg_attr(feature = "options", command(next_help_heading = "Run"))]
#[serde(default, deny_unknown_fields)]
pub struct PathOptions {
    /// How far the drawn path may leave the wanted one, in mm
    #[cfg_attr(feature = "options", arg(long, value_name = "MM", default_value_t = Self::default().tolerance))]
    pub tolerance: f64,
    /// Join strokes whose ends lie so near to each other, in mm (default: the tolerance)
    #[cfg_attr(feature = "options", arg(long, value_name = "MM"))]
    pub join: Option<f64>,
    /// Leave out what lies on other lines, and of shapes to cut out only whole ones
    #[cfg_attr(feature = "options", arg(long))]
    pub drop_doubles: bool,
    /// Draw in the order of the file
    #[cfg_attr(feature = "options", arg(long))]
    pub keep_order: bool,
    /// How long to look for the shortest way with the pen up: so many tries, fewer from 10,000 strokes on
    #[cfg_attr(feature = "options", arg(
        long,
        value_name = "N",
        default_value_t = Self::default().tries,
        conflicts_with = "keep_order"
    ))]
    pub tries: u32,
    /// Look elsewhere: the same number gives the same order
    #[cfg_attr(feature = "options", arg(long, value_name = "N", default_value_t = Self::default().seed))]
    pub seed: u64,
    /// Begin later: at a layer, a stroke or a share of the ink, as in layer:red, stroke:120 or 40%
    #[cfg_attr(feature = "options", arg(long, value_name = "WHERE"))]
    pub from: Option<StartFrom>,
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
