//! What a person asks for: the options of `dobot draw`, in JSON under the same names.

mod asked;
mod check;
mod error;

use std::str::FromStr;

use dobot_plan::Machine;
use dobot_source::{Align, LayersBy, ShadingStyle};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use self::asked::{DrawingRequest, Subject};
pub use self::error::OptionsError;
use crate::copies::Grid;
use crate::prepare::{Settings, TRIES};
use crate::sheet::PaperSize;
use crate::start::StartFrom;

/// What a person asks for. [`DrawingRequest::new`] makes [`Settings`] of it; `dobot draw` reads it from its
/// arguments, any other client from JSON:
///
/// ```
/// use dobot_draw::{DrawingRequest, Materials, Options, Subject};
///
/// let asked = r#"{"what": {"text": "Hello"}, "place": {"at": [210, 20]}, "tool": {"pen": "marker"}}"#;
/// let options: Options = serde_json::from_str(asked)?;
/// let text = Subject::of_text(&options.what).expect("there is one");
/// let asked = DrawingRequest::new(options, text, &Materials::built_in())?;
/// let (prepared, _) = asked.prepare(None, -40.0)?;
/// assert!(prepared.plan.summary().drawn_mm > 40.0); // of letters 10 mm high
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default, deny_unknown_fields)]
pub struct Options {
    /// What is drawn.
    #[command(flatten)]
    pub what: ContentOptions,
    /// Where it goes.
    #[command(flatten)]
    pub place: PlaceOptions,
    /// With what it is drawn.
    #[command(flatten)]
    pub tool: ToolOptions,
    /// How it is drawn.
    #[command(flatten)]
    pub way: PathOptions,
}

/// What is drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, clap::Args)]
#[command(next_help_heading = "What to draw")]
#[serde(default, deny_unknown_fields)]
pub struct ContentOptions {
    /// A text instead of a file; \n begins a new line
    #[arg(long, value_name = "TEXT", conflicts_with = "card")]
    pub text: Option<String>,
    /// The letters of --text: a single-line font (sans, script, serif, gothic), or any installed font
    /// (default: sans)
    #[arg(long, value_name = "NAME")]
    pub font: Option<String>,
    /// How tall the capitals of --text are, in mm (default: 10)
    #[arg(long, value_name = "MM")]
    pub height: Option<f64>,
    /// Where the lines of --text meet: left, center or right (default: left)
    #[arg(long, value_name = "SIDE")]
    pub align: Option<Align>,
    /// A test card for the laser: fields burned at these speeds in mm/s, once, twice and so on
    #[arg(long, value_name = "SPEEDS", num_args = 1.., value_delimiter = ',')]
    pub card: Option<Vec<f64>>,
    /// How often the lowest row of the test card is burned (default: 3)
    #[arg(long, value_name = "N")]
    pub card_passes: Option<u32>,
    /// How wide and high the fields of the test card are, in mm (default: 6)
    #[arg(long, value_name = "MM")]
    pub card_size: Option<f64>,
    /// How far the fields of the test card lie apart, in mm (default: 2)
    #[arg(long, value_name = "MM")]
    pub card_gap: Option<f64>,
    /// What is burned below the test card (default: the name of the material, and the day)
    #[arg(long, value_name = "TEXT")]
    pub card_label: Option<String>,
    /// Make layers of the colours or outermost groups of an SVG file, or of the layers of others: each is drawn
    /// for itself, and the arm waits for its pen
    #[arg(long, value_name = "BY")]
    pub layers: Option<LayersBy>,
    /// Draw a layer with a pen or material of its own
    #[arg(long, value_name = "NAME=PEN", requires = "layers")]
    pub layer: Vec<LayerTool>,
    /// Draw these layers only, by name: several with commas between them
    #[arg(long, value_name = "NAME", requires = "layers", value_delimiter = ',')]
    pub only: Vec<String>,
    /// Draw what lies beyond the page of an SVG file too, instead of cutting it at the page's edge
    #[arg(long)]
    pub no_crop: bool,
    /// Hatch filled areas, with lines so far apart, in mm (default: what suits the pen or material)
    #[arg(long, value_name = "MM", num_args = 0..=1, default_missing_value = "auto")]
    pub hatch: Option<Spacing>,
    /// The direction of the hatching, in degrees from left to right counterclockwise
    #[arg(
        long,
        value_name = "DEGREES",
        default_value_t = Self::default().hatch_angle,
        requires = "hatch"
    )]
    pub hatch_angle: f64,
    /// Hatch crosswise
    #[arg(long, requires = "hatch")]
    pub cross: bool,
    /// How a picture becomes ink: outline, lines, stipple or hatch
    #[arg(long, value_name = "STYLE")]
    pub shade: Option<ShadingStyle>,
    /// How far the lines or dots of a picture lie apart, or the lines of the test card, in mm on the paper
    #[arg(long, value_name = "MM")]
    pub spacing: Option<f64>,
    /// Draw the light parts of a picture instead of the dark ones
    #[arg(long)]
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
            hatch: None,
            hatch_angle: 45.0,
            cross: false,
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
        spacing_mm.map_err(|_| "expected a number of millimetres")
    }
}

/// Where it goes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, clap::Args)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is an option of its own"
)]
#[command(next_help_heading = "Where on the paper")]
#[serde(default, deny_unknown_fields)]
pub struct PlaceOptions {
    /// The sheet that it goes on: a3, a4, a5, a6, letter, legal, or `210x148` in mm; the page of the file
    /// keeps its upper left corner
    #[arg(long, value_name = "SIZE")]
    pub paper_size: Option<PaperSize>,
    /// The longer side of the sheet lies from left to right
    #[arg(long, requires = "paper_size")]
    pub landscape: bool,
    /// Where the lower left corner of the sheet lies, in mm: the one that is nearest to you behind the arm,
    /// on the left (default: the sheet lies in the middle before the arm)
    #[arg(long, num_args = 2, value_names = ["X", "Y"], requires = "paper_size", conflicts_with_all = ["at", "paper"])]
    pub corner: Option<Vec<f64>>,
    /// As large as the sheet or the drawing area allows
    #[arg(long, conflicts_with = "scale")]
    pub fit: bool,
    /// Times the true size
    #[arg(long, value_name = "FACTOR")]
    pub scale: Option<f64>,
    /// Where the middle of the drawing goes, or that of the sheet, in mm (default: the middle of the drawing
    /// area)
    #[arg(long, num_args = 2, value_names = ["X", "Y"])]
    pub at: Option<Vec<f64>>,
    /// Change left and right
    #[arg(long)]
    pub mirror: bool,
    /// Draw copies side by side, in columns and rows as in 3x2
    #[arg(long, value_name = "GRID")]
    pub grid: Option<Grid>,
    /// How far the copies lie apart, in mm of the file
    #[arg(long, value_name = "MM", default_value_t = Self::default().gap, requires = "grid")]
    pub gap: f64,
    /// Turn it counterclockwise
    #[arg(long, value_name = "DEGREES", default_value_t = 0.0)]
    pub rotate: f64,
    /// Leave so much of the sheet or the drawing area empty along its edges, in mm
    #[arg(long, value_name = "MM", default_value_t = 0.0)]
    pub margin: f64,
    /// Cut off what lies beyond the sheet or out of the arm's reach, instead of refusing the drawing
    #[arg(long)]
    pub clip: bool,
    /// Z where the pen draws, in mm (default: where the arm stands; a virtual arm -40)
    #[arg(long, value_name = "Z", conflicts_with = "paper")]
    pub pen_down: Option<f64>,
    /// Three points of the paper that the pen has touched, for paper that is not level; with --paper-size
    /// first the lower left corner of the sheet, then another place on its lower edge
    #[arg(long, num_args = 9, value_names = ["X", "Y", "Z", "X", "Y", "Z", "X", "Y", "Z"])]
    pub paper: Option<Vec<f64>>,
    /// Draw so much higher, in mm; negative presses harder
    #[arg(long, value_name = "MM", default_value_t = 0.0)]
    pub offset: f64,
}

impl Default for PlaceOptions {
    /// True size, in the middle of the drawing area.
    fn default() -> Self {
        Self {
            paper_size: None,
            landscape: false,
            corner: None,
            fit: false,
            scale: None,
            at: None,
            mirror: false,
            grid: None,
            gap: 5.0,
            rotate: 0.0,
            margin: 0.0,
            clip: false,
            pen_down: None,
            paper: None,
            offset: 0.0,
        }
    }
}

/// With what it is drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, clap::Args)]
#[command(next_help_heading = "Pen or laser")]
#[serde(default, deny_unknown_fields)]
pub struct ToolOptions {
    /// Draw with this pen
    #[arg(
        long,
        value_name = "PEN",
        default_value_t = Self::default().pen,
        conflicts_with = "laser"
    )]
    pub pen: String,
    /// Burn this material with the laser
    #[arg(long, value_name = "MATERIAL")]
    pub laser: Option<String>,
    /// How far the pen is lifted to travel, in mm
    #[arg(long, value_name = "MM")]
    pub lift: Option<f64>,
    /// Speed while drawing or burning, in mm/s
    #[arg(long, value_name = "MM/S")]
    pub speed: Option<f64>,
    /// Speed between the strokes, in mm/s
    #[arg(long, value_name = "MM/S")]
    pub travel_speed: Option<f64>,
    /// Draw or burn everything so often; a pen goes over each line so often before it is lifted
    #[arg(long, value_name = "N")]
    pub passes: Option<u32>,
    /// What the laser burns so often before it goes on: a shape, or all of the layer
    #[arg(long, value_name = "WHAT", default_value = "layer", requires = "laser")]
    pub passes_by: PassesBy,
    /// How wide the laser burns, in mm: closed shapes are cut larger by half of it, and holes in them smaller;
    /// below 0 the other way round
    #[arg(long, value_name = "MM", default_value_t = 0.0, requires = "laser")]
    pub kerf: f64,
    /// Begin each cut so far beside the shape, in mm
    #[arg(long, value_name = "MM", default_value_t = 0.0, requires = "laser")]
    pub lead_in: f64,
    /// Go on so far behind where a cut began, in mm
    #[arg(long, value_name = "MM", default_value_t = 0.0, requires = "laser")]
    pub overcut: f64,
    /// Leave so many places of each shape uncut, so that it does not fall out
    #[arg(long, value_name = "N", default_value_t = 0, requires = "laser")]
    pub tabs: u32,
    /// How wide these places are, in mm
    #[arg(long, value_name = "MM", default_value_t = Self::default().tab_width, requires = "tabs")]
    pub tab_width: f64,
    /// Acceleration, in mm/s²
    #[arg(long, value_name = "MM/S2", default_value_t = Self::default().acceleration)]
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
            acceleration: Machine::default().acceleration_mm_s2,
        }
    }
}

/// How it is drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, clap::Args)]
#[command(next_help_heading = "How it is drawn")]
#[serde(default, deny_unknown_fields)]
pub struct PathOptions {
    /// How far the drawn path may leave the wanted one, in mm
    #[arg(long, value_name = "MM", default_value_t = Self::default().tolerance)]
    pub tolerance: f64,
    /// Join strokes whose ends lie so near to each other, in mm (default: the tolerance)
    #[arg(long, value_name = "MM")]
    pub join: Option<f64>,
    /// Leave out lines that lie on others from end to end
    #[arg(long)]
    pub drop_doubles: bool,
    /// Draw in the order of the file
    #[arg(long)]
    pub keep_order: bool,
    /// How long to look for the shortest way with the pen up: so many tries
    #[arg(
        long,
        value_name = "N",
        default_value_t = Self::default().tries,
        conflicts_with = "keep_order"
    )]
    pub tries: u32,
    /// Look elsewhere: the same number gives the same order
    #[arg(long, value_name = "N", default_value_t = Self::default().seed)]
    pub seed: u64,
    /// Begin later: at a layer, a stroke or a share of the ink, as in layer:red, stroke:120 or 40%
    #[arg(long, value_name = "WHERE")]
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
