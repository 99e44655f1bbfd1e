//! The options that say with what it is drawn.

use std::str::FromStr;

use dobot_plan::ArmLimits;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::fields::Ranges;

/// With what it is drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
#[schemars(transform = Ranges("tool"))]
pub struct ToolOptions {
    /// Draw with this pen
    pub pen: String,
    /// Burn this material with the laser
    pub laser: Option<String>,
    /// How far the pen is lifted to travel, in mm
    pub lift: Option<f64>,
    /// Speed while drawing or burning, in mm/s
    pub speed: Option<f64>,
    /// Speed between the strokes, in mm/s
    pub travel_speed: Option<f64>,
    /// Draw or burn everything so often; a pen goes over each line so often before it is lifted
    pub passes: Option<u32>,
    /// What the laser burns so often before it goes on: a shape, or all of the layer
    pub passes_by: PassesBy,
    /// How wide the laser burns, in mm: closed shapes are cut larger by half of it, and holes in them smaller;
    /// below 0 the other way round
    pub kerf: f64,
    /// Begin each cut so far beside the shape, in mm
    pub lead_in: f64,
    /// Go on so far behind where a cut began, in mm
    pub overcut: f64,
    /// Leave so many places of each shape uncut, so that it does not fall out
    pub tabs: u32,
    /// How wide these places are, in mm
    pub tab_width: f64,
    /// Acceleration, in mm/s²
    pub acceleration: f64,
}

/// What a laser burns several times before it goes on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum PassesBy {
    /// Each shape for itself.
    Shape,
    /// All shapes of a layer.
    #[default]
    Layer,
}

impl FromStr for PassesBy {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text {
            "shape" => Ok(Self::Shape),
            "layer" => Ok(Self::Layer),
            _ => Err("allowed are shape and layer"),
        }
    }
}

impl Default for ToolOptions {
    /// A fineliner.
    fn default() -> Self {
        Self {
            pen: "fineliner".to_owned(),
            laser: None,
            lift: None,
            speed: None,
            travel_speed: None,
            passes: None,
            passes_by: PassesBy::Layer,
            kerf: 0.0,
            lead_in: 0.0,
            overcut: 0.0,
            tabs: 0,
            tab_width: 1.0,
            acceleration: ArmLimits::default().acceleration_mm_s2,
        }
    }
}
