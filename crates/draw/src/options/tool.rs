//! The options for the tool.

use std::str::FromStr;

use dobot_plan::ArmLimits;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::fields::Ranges;

/// The tool to draw with
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
#[schemars(transform = Ranges("tool"))]
pub struct ToolOptions {
    /// Pen to draw with
    pub pen: String,
    /// Material to burn with the laser
    pub laser: Option<String>,
    /// Lift of the pen while travelling, in mm
    pub lift: Option<f64>,
    /// Speed while drawing or burning, in mm/s
    pub speed: Option<f64>,
    /// Travel speed between strokes, in mm/s
    pub travel_speed: Option<f64>,
    /// Number of passes; a pen repeats each line before it is lifted
    pub passes: Option<u32>,
    /// What the laser repeats before continuing: each shape, or the whole layer
    pub passes_by: PassesBy,
    /// Width of the laser's cut, in mm: closed shapes are cut larger by half of it, and holes in
    /// them smaller; a negative width does the opposite
    pub kerf: f64,
    /// Length of the lead-in to each cut, in mm
    pub lead_in: f64,
    /// Distance to cut past the start point, in mm
    pub overcut: f64,
    /// Number of tabs that hold each shape in place
    pub tabs: u32,
    /// Width of a tab, in mm
    pub tab_width: f64,
    /// Acceleration, in mm/s²
    pub acceleration: f64,
}

/// What a laser repeats before it continues.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum PassesBy {
    /// Each shape.
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
    /// Returns a fineliner.
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
