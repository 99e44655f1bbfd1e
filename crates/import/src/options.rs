//! Options of readers.

use std::str::FromStr;
use std::sync::Arc;

use dobot_geometry::CancelToken;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use usvg::fontdb;

use dobot_shading::Shading;

/// Options of readers.
#[derive(Clone, Debug)]
#[expect(clippy::struct_excessive_bools, reason = "each is asked for by itself")]
pub struct ReadOptions {
    /// The largest deviation of a line from its curve, in millimetres on the page; 1e-6 or more.
    pub tolerance_mm: f64,
    /// Millimetres on the paper per millimetre of the page. Distances on the paper (between the
    /// lines of a shaded picture) are divided by it on the page.
    pub scale: f64,
    /// The layers of an SVG file.
    pub layers: LayersBy,
    /// Whether an SVG file is clipped to its page.
    pub crops: bool,
    /// Whether the filled shapes of an SVG, DXF or HP-GL file hide what is under them.
    pub hides: bool,
    /// Whether the edges of white shapes are drawn where they lie on darker ones; hiding draws them
    /// too.
    pub white_edges: bool,
    /// Whether the areas of partly hidden shapes are needed, which takes most of the time.
    pub fills: bool,
    /// Whether a laser draws: then nothing is burned while G-code switches it off (M5, M107, S0),
    /// and warnings mention differences from a laser's burn.
    pub burns: bool,
    /// What a G-code file controls; `None` to infer it from the file.
    pub gcode: Option<GcodeTool>,
    /// Whether a source with a mistake is refused; otherwise everything up to the mistake, or all
    /// other elements, are drawn with a warning.
    pub strict: bool,
    /// The fonts for text.
    pub fonts: Arc<fontdb::Database>,
    /// The conversion of picture tones to lines or dots.
    pub shading: Shading,
    /// Cancels the reading.
    pub cancel: CancelToken,
}

impl Default for ReadOptions {
    /// The defaults: 0.005 mm at true size, a layer per colour, clipped to the page, nothing
    /// hidden, for a laser, mistakes reported, no fonts, pictures hatched.
    fn default() -> Self {
        Self {
            tolerance_mm: 0.005,
            scale: 1.0,
            layers: LayersBy::default(),
            crops: true,
            hides: false,
            white_edges: false,
            fills: true,
            burns: true,
            gcode: None,
            strict: false,
            fonts: Arc::default(),
            shading: Shading::default(),
            cancel: CancelToken::default(),
        }
    }
}

/// The layers of an SVG file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum LayersBy {
    /// A layer per colour: that of the line, or of the fill if there is no line.
    #[default]
    Color,
    /// A layer per outermost group.
    Group,
    /// A layer per line width; fills without lines have one of their own.
    Width,
    /// A single layer.
    Nothing,
}

impl FromStr for LayersBy {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text {
            "color" | "colour" => Ok(Self::Color),
            "group" => Ok(Self::Group),
            "width" => Ok(Self::Width),
            _ => Err("allowed are color, group and width"),
        }
    }
}

/// The tool that a G-code file controls.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum GcodeTool {
    /// A laser, switched by M3, M4, M106, M5, M107 and S.
    Laser,
    /// A pen, lifted by a servo, by Z, or by M3 and M5.
    Pen,
    /// A mill or drill, lifted by Z; M3 turns its spindle.
    Mill,
}

impl FromStr for GcodeTool {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text {
            "laser" => Ok(Self::Laser),
            "pen" => Ok(Self::Pen),
            "mill" => Ok(Self::Mill),
            _ => Err("allowed are laser, pen and mill"),
        }
    }
}
