//! How a source is read.

use std::str::FromStr;
use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use usvg::fontdb;

use crate::picture::shading::Shading;

/// How a source is read.
#[derive(Clone, Debug)]
#[expect(clippy::struct_excessive_bools, reason = "each is asked for by itself")]
pub struct ReadOptions {
    /// How far a line may leave the curve that it stands for, in millimetres on the page; from
    /// 1e-6 up.
    pub tolerance_mm: f64,
    /// How many millimetres on the paper one millimetre of the page becomes. Distances that hold on
    /// the paper (between the lines of a shaded picture) are divided by it on the page.
    pub scale: f64,
    /// What makes a layer of an SVG file.
    pub layers: LayersBy,
    /// Whether what lies beyond the page of an SVG file is cut off.
    pub crops: bool,
    /// Whether the filled shapes of an SVG, DXF or HP-GL file hide what lies under them.
    pub hides: bool,
    /// Whether the areas of what is partly hidden are wanted, which takes most of the time.
    pub fills: bool,
    /// Whether a laser draws it: then nothing is burned while G-code says off (M5, M107, S0), and it is told what of a laser's file
    /// the arm burns otherwise.
    pub burns: bool,
    /// The fonts that text is drawn with.
    pub fonts: Arc<fontdb::Database>,
    /// How the tones of a picture become lines or dots.
    pub shading: Shading,
}

impl Default for ReadOptions {
    /// 0.005 mm at true size, a layer for each colour, cut at the page's edge, nothing hidden, for a laser, no fonts, pictures hatched.
    fn default() -> Self {
        Self {
            tolerance_mm: 0.005,
            scale: 1.0,
            layers: LayersBy::default(),
            crops: true,
            hides: false,
            fills: true,
            burns: true,
            fonts: Arc::default(),
            shading: Shading::default(),
        }
    }
}

/// What makes a layer of an SVG file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum LayersBy {
    /// Each colour: of the line, or of the fill where there is no line.
    #[default]
    Color,
    /// Each outermost group.
    Group,
    /// All of it is one layer.
    Nothing,
}

impl FromStr for LayersBy {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text {
            "color" | "colour" => Ok(Self::Color),
            "group" => Ok(Self::Group),
            _ => Err("allowed are color and group"),
        }
    }
}
