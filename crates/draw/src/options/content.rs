//! The options for the content.

use std::str::FromStr;

use dobot_import::{Align, GcodeTool, LayersBy, ShadingStyle};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::fields::Ranges;
use crate::strokes::hatch::HatchStyle;

/// What to draw
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is an option of its own"
)]
#[serde(default, deny_unknown_fields)]
#[schemars(transform = Ranges("what"))]
pub struct ContentOptions {
    /// Text to draw, alone or below the files; \n starts a new line
    pub text: Option<String>,
    /// Font of `what.text`: a single-stroke font (sans, bold, script, serif, italic, gothic, hand),
    /// an SVG font (its file; in JSON its content), or any installed font (default: sans)
    pub font: Option<String>,
    /// Capital height of `what.text` on the paper, in mm (default: 10 mm, scaled with the drawing)
    pub height: Option<f64>,
    /// Alignment of `what.text`: left, center or right (default: left)
    pub align: Option<Align>,
    /// Width at which lines of `what.text` are wrapped, in mm (default: at the margins of
    /// `place.paper_size`)
    pub wrap: Option<f64>,
    /// Widen spaces so that wrapped lines have the full width
    pub justify: bool,
    /// Burn a laser test card with a column for each of these speeds, in mm/s
    pub card: Option<Vec<f64>>,
    /// Number of rows of the test card: row n is burned n times (default: 3)
    pub card_passes: Option<u32>,
    /// Size of the fields of the test card, in mm (default: 6)
    pub card_size: Option<f64>,
    /// Gap between the fields of the test card, in mm (default: 2)
    pub card_gap: Option<f64>,
    /// Label below the test card (default: the name of the material and the date)
    pub card_label: Option<String>,
    /// Split an SVG file into layers by `color`, outermost `group` or line `width`, other files by
    /// their layers; each is drawn separately, and the arm waits for its pen
    pub layers: Option<LayersBy>,
    /// Draw a layer with its own pen or material
    pub layer: Vec<LayerTool>,
    /// Draw only these layers, by name; separate several by commas, or repeat `what.only`
    pub only: Vec<String>,
    /// Also draw content beyond the page of an SVG file, instead of cropping it
    pub no_crop: bool,
    /// Read G-code as a program for a laser, a pen or a mill (default: as the file suggests)
    pub gcode: Option<GcodeTool>,
    /// Refuse a file with a mistake, instead of drawing it without what the mistake spoils
    pub strict: bool,
    /// Remove what is covered by filled shapes painted over it, including white ones
    pub hide: bool,
    /// Draw the edges of white shapes of an SVG file that lie on darker ones, as `what.hide` does
    pub white_edges: bool,
    /// Hatch filled areas with this line spacing, in mm (default: as suits the pen or material)
    pub hatch: Option<Spacing>,
    /// Hatch angle, in degrees counterclockwise from left to right
    pub hatch_angle: f64,
    /// Hatch style: lines, concentric (the outline repeated inwards) or spiral (concentric in a
    /// single line)
    pub hatch_style: HatchStyle,
    /// Distance of the hatching from the edge, in mm; half the width of the pen keeps the ink
    /// inside
    pub hatch_inset: f64,
    /// Cross-hatch
    pub cross: bool,
    /// Rendering of a picture: hatch, lines, spiral, flow, stipple, tsp (a single line through
    /// dots) or outline
    pub shade: Option<ShadingStyle>,
    /// Spacing of the lines or dots of a picture, or of the lines of the test card, in mm on the
    /// paper
    pub spacing: Option<f64>,
    /// Picture brightness, -100 to 100 percent
    pub brightness: f64,
    /// Picture contrast, -100 to 100 percent
    pub contrast: f64,
    /// Picture gamma: above 1 makes the midtones lighter, below 1 darker
    pub gamma: f64,
    /// Convert a picture to black and white at this darkness, between 0 (white) and 1
    pub threshold: Option<f64>,
    /// Number of tones besides white in the styles outline and hatch, 1 to 8 (default: 4)
    pub levels: Option<u8>,
    /// Draw the light parts of a picture instead of the dark ones
    pub invert: bool,
}

impl Default for ContentOptions {
    /// Returns the options for a whole file with unfilled areas.
    fn default() -> Self {
        Self {
            text: None,
            font: None,
            height: None,
            align: None,
            wrap: None,
            justify: false,
            card: None,
            card_passes: None,
            card_size: None,
            card_gap: None,
            card_label: None,
            layers: None,
            layer: Vec::new(),
            only: Vec::new(),
            no_crop: false,
            gcode: None,
            strict: false,
            hide: false,
            white_edges: false,
            hatch: None,
            hatch_angle: 45.0,
            hatch_style: HatchStyle::Lines,
            hatch_inset: 0.0,
            cross: false,
            brightness: 0.0,
            contrast: 0.0,
            gamma: 1.0,
            threshold: None,
            levels: None,
            shade: None,
            spacing: None,
            invert: false,
        }
    }
}

/// A layer with its own pen or material: `NAME=PEN`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LayerTool {
    /// The name of the layer.
    pub name: String,
    /// The name of its pen or material.
    pub pen: String,
}

impl FromStr for LayerTool {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text.rsplit_once('=') {
            Some((name, pen)) if !name.is_empty() && !pen.is_empty() => Ok(Self {
                name: name.to_owned(),
                pen: pen.to_owned(),
            }),
            _ => Err("expected the layer's name, = and a pen or material, as in red=marker"),
        }
    }
}

/// The line spacing of a hatching: `auto` or millimetres.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged, expecting = "expected \"auto\" or a number of millimetres")]
pub enum Spacing {
    /// A spacing in millimetres.
    Millimeters(f64),
    /// As suits the pen or material.
    OfTool(Auto),
}

/// The word `auto`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Auto {
    /// `auto`.
    Auto,
}

impl FromStr for Spacing {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        if text == "auto" {
            return Ok(Self::OfTool(Auto::Auto));
        }
        let spacing_mm = text.parse().map(Self::Millimeters);
        spacing_mm.map_err(|_| {
            "expected a number of millimetres; put the file before the option, or append `=auto` to the option"
        })
    }
}
