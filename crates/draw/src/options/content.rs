//! The options that say what is drawn.

use std::str::FromStr;

use dobot_import::{Align, LayersBy, ShadingStyle};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::fields::Ranges;
use crate::strokes::hatch::HatchStyle;

/// What is drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is an option of its own"
)]
#[serde(default, deny_unknown_fields)]
#[schemars(transform = Ranges("what"))]
pub struct ContentOptions {
    /// A text, alone or below the files; \n begins a new line
    pub text: Option<String>,
    /// The letters of `what.text`: a single-line font (sans, script, serif, gothic), or any installed font
    /// (default: sans)
    pub font: Option<String>,
    /// How tall the capitals of `what.text` are, in mm (default: 10)
    pub height: Option<f64>,
    /// Where the lines of `what.text` meet: left, center or right (default: left)
    pub align: Option<Align>,
    /// A test card for the laser: fields burned at these speeds in mm/s, once, twice and so on
    pub card: Option<Vec<f64>>,
    /// How often the lowest row of the test card is burned (default: 3)
    pub card_passes: Option<u32>,
    /// How wide and high the fields of the test card are, in mm (default: 6)
    pub card_size: Option<f64>,
    /// How far the fields of the test card lie apart, in mm (default: 2)
    pub card_gap: Option<f64>,
    /// What is burned below the test card (default: the name of the material, and the day)
    pub card_label: Option<String>,
    /// Make layers of the colours or outermost groups of an SVG file, or of the layers of others: each is drawn
    /// for itself, and the arm waits for its pen
    pub layers: Option<LayersBy>,
    /// Draw a layer with a pen or material of its own
    pub layer: Vec<LayerTool>,
    /// Draw these layers only, by name: several with commas between them, or one for each `what.only`
    pub only: Vec<String>,
    /// Draw what lies beyond the page of an SVG file too, instead of cutting it at the page's edge
    pub no_crop: bool,
    /// Leave out what lies under filled shapes that are painted over it, white ones too, as in a picture
    pub hide: bool,
    /// Hatch filled areas, with lines so far apart, in mm (default: what suits the pen or material)
    pub hatch: Option<Spacing>,
    /// The direction of the hatching, in degrees from left to right counterclockwise
    pub hatch_angle: f64,
    /// What areas are hatched with: lines, concentric (the outline again and again, farther inside) or
    /// spiral (the same in one line)
    pub hatch_style: HatchStyle,
    /// How far the hatching stays away from the edge, in mm: half the width of the pen keeps the ink inside
    pub hatch_inset: f64,
    /// Hatch crosswise
    pub cross: bool,
    /// How a picture becomes ink: hatch, lines, spiral, flow, stipple, tsp (one line from dot to dot) or outline
    pub shade: Option<ShadingStyle>,
    /// How far the lines or dots of a picture lie apart, or the lines of the test card, in mm on the paper
    pub spacing: Option<f64>,
    /// Make a picture lighter, or darker below 0: from -100 to 100 percent
    pub brightness: f64,
    /// Set the tones of a picture farther apart, or nearer below 0: from -100 to 100 percent
    pub contrast: f64,
    /// Make the middle tones of a picture lighter above 1, darker below
    pub gamma: f64,
    /// Make a picture black where it is darker than so much, and white elsewhere: between 0 (white) and 1
    pub threshold: Option<f64>,
    /// How many tones beside white the styles outline and hatch tell apart, from 1 to 8 (default: 4)
    pub levels: Option<u8>,
    /// Draw the light parts of a picture instead of the dark ones
    pub invert: bool,
}

impl Default for ContentOptions {
    /// A file, all of it, its areas empty.
    fn default() -> Self {
        Self {
            text: None,
            font: None,
            height: None,
            align: None,
            card: None,
            card_passes: None,
            card_size: None,
            card_gap: None,
            card_label: None,
            layers: None,
            layer: Vec::new(),
            only: Vec::new(),
            no_crop: false,
            hide: false,
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

/// A layer that has a pen or a material of its own: `NAME=PEN`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LayerTool {
    /// The layer's name.
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

/// How far apart the lines of a hatching are: `auto` or millimetres.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged, expecting = "expected \"auto\" or a number of millimetres")]
pub enum Spacing {
    /// So many millimetres.
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
            "expected a number of millimetres; a file stands before the option, or the option has `=auto` behind it"
        })
    }
}
