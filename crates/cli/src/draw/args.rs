//! The options of `dobot draw`.

use std::path::PathBuf;
use std::time::Duration;

use dobot_draw::{Settings, StartFrom};
use dobot_plan::Machine;
use dobot_source::{Align, LayersBy, Style};

use crate::connect::To;
use crate::jog::laser_seconds;

/// Draw a file, a picture or a text, or burn it with the laser
#[derive(Debug, clap::Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "\
Examples:
  dobot draw picture.svg                                 through the running station, if there is one
  dobot draw photo.jpg --to virtual: --picture drawn.png
                                                         a virtual arm draws, as fast as it can be calculated
  dobot draw --text 'Hello, arm' --font script --height 20
                                                         a text, in letters of single lines
  dobot draw photo.jpg --shade stipple --dry-run         what it would be: time, ink, reach; nothing moves
  dobot draw plan.dxf --fit --rotate 90 --margin 10      as large as the drawing area allows, turned
  dobot draw flag.svg --layers color --hatch 1           a pen for each colour, areas hatched 1 mm apart
  dobot draw sign.svg --laser plywood-engrave --frame    go around it with the laser off, then burn
  dobot draw long.svg --from 40%                         the rest of a drawing

It draws SVG, G-code, HPGL (.plt), DXF, PNG and JPEG files, and points as CSV or JSON; - reads standard
input. What is larger than the drawing area is made to fit, and a PNG or JPEG fills it; --scale insists.

The drawing area is 200 mm wide and 120 mm deep: x 150 to 270, y -100 to 100. Seen from behind the
arm the picture lies upright. On a real arm bring the pen down to the paper first (`dobot jog z-`): unless --pen-down or
--paper says otherwise, it draws at the height at which it stands. Ctrl-C lifts the pen and says how far it got.

When a station runs, the drawing becomes a job of it: Ctrl-C pauses it, and `dobot jobs start` goes on with it;
`dobot jobs speed` and `dobot jobs height` change it while it is drawn."
)]
pub(crate) struct Args {
    /// The file, or - for standard input
    #[arg(required_unless_present_any = ["text", "card"], conflicts_with_all = ["text", "card"])]
    pub(crate) file: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) to: To,
    #[command(flatten)]
    pub(crate) what: What,
    #[command(flatten)]
    pub(crate) place: Place,
    #[command(flatten)]
    pub(crate) tool: Tool,
    #[command(flatten)]
    pub(crate) way: Way,
    #[command(flatten)]
    pub(crate) result: Results,
}

/// What is drawn.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "What to draw")]
pub(crate) struct What {
    /// A text instead of a file; \n begins a new line
    #[arg(long, value_name = "TEXT", conflicts_with = "card")]
    pub(crate) text: Option<String>,
    /// The letters of --text: a single-line font (sans, script, serif, gothic), or any installed font
    /// (default: sans)
    #[arg(long, value_name = "NAME")]
    pub(crate) font: Option<String>,
    /// How tall the capitals of --text are, in mm (default: 10)
    #[arg(long, value_name = "MM")]
    pub(crate) height: Option<f64>,
    /// Where the lines of --text meet: left, center or right (default: left)
    #[arg(long, value_name = "SIDE", value_parser = align)]
    pub(crate) align: Option<Align>,
    /// A test card for the laser: fields burned at these speeds in mm/s, once, twice and so on
    #[arg(long, value_name = "SPEEDS", num_args = 1.., value_delimiter = ',')]
    pub(crate) card: Option<Vec<f64>>,
    /// How often the lowest row of the test card is burned (default: 3)
    #[arg(long, value_name = "N")]
    pub(crate) card_passes: Option<u32>,
    /// Make layers of the colours or outermost groups of an SVG file, or of the layers of others: each is drawn
    /// for itself, and the arm waits for its pen
    #[arg(long, value_name = "BY", value_parser = layers)]
    pub(crate) layers: Option<LayersBy>,
    /// Draw a layer with a pen or material of its own
    #[arg(long = "layer", value_name = "NAME=PEN", requires = "layers", value_parser = layer_tool)]
    pub(crate) layer_tools: Vec<(String, String)>,
    /// Draw these layers only, by name
    #[arg(long, value_name = "NAME", requires = "layers", num_args = 1.., value_delimiter = ',')]
    pub(crate) only: Vec<String>,
    /// Hatch filled areas, with lines so far apart, in mm (default: what suits the pen or material)
    #[arg(long, value_name = "MM", num_args = 0..=1, default_missing_value = "auto", value_parser = spacing)]
    pub(crate) hatch: Option<Spacing>,
    /// The direction of the hatching, in degrees from left to right counterclockwise
    #[arg(
        long,
        value_name = "DEGREES",
        default_value_t = 45.0,
        requires = "hatch"
    )]
    pub(crate) hatch_angle: f64,
    /// Hatch crosswise
    #[arg(long, requires = "hatch")]
    pub(crate) cross: bool,
    /// How a PNG or JPEG becomes ink: outline, lines, stipple or hatch
    #[arg(long, value_name = "STYLE", value_parser = style)]
    pub(crate) shade: Option<Style>,
    /// How far the lines or dots of a picture lie apart, in mm on the paper
    #[arg(long, value_name = "MM")]
    pub(crate) spacing: Option<f64>,
    /// Draw the light parts of a picture instead of the dark ones
    #[arg(long)]
    pub(crate) invert: bool,
}

/// How far apart the lines of a hatching are.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Spacing {
    /// As suits the pen or material.
    OfTool,
    /// So many millimetres.
    Millimeters(f64),
}

/// Where it goes.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Where on the paper")]
pub(crate) struct Place {
    /// As large as the drawing area allows
    #[arg(long, conflicts_with = "scale")]
    pub(crate) fit: bool,
    /// Times the true size
    #[arg(long, value_name = "FACTOR")]
    pub(crate) scale: Option<f64>,
    /// Where the middle of the drawing goes, in mm (default: the middle of the drawing area)
    #[arg(long, num_args = 2, value_names = ["X", "Y"])]
    pub(crate) at: Option<Vec<f64>>,
    /// Turn it counterclockwise
    #[arg(long, value_name = "DEGREES", default_value_t = 0.0)]
    pub(crate) rotate: f64,
    /// Leave so much of the drawing area empty along its edges, in mm
    #[arg(long, value_name = "MM", default_value_t = 0.0)]
    pub(crate) margin: f64,
    /// Cut off what the arm does not reach, instead of refusing the drawing
    #[arg(long)]
    pub(crate) clip: bool,
    /// Z where the pen draws, in mm (default: where the arm stands; a virtual arm -40)
    #[arg(long, value_name = "Z", conflicts_with = "paper")]
    pub(crate) pen_down: Option<f64>,
    /// Three points of the paper that the pen has touched, for paper that is not level
    #[arg(long, num_args = 9, value_names = ["X", "Y", "Z", "X", "Y", "Z", "X", "Y", "Z"])]
    pub(crate) paper: Option<Vec<f64>>,
    /// Draw so much higher, in mm; negative presses harder
    #[arg(long, value_name = "MM", default_value_t = 0.0)]
    pub(crate) offset: f64,
}

/// With what.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Pen or laser")]
pub(crate) struct Tool {
    /// Draw with this pen
    #[arg(
        long,
        value_name = "PEN",
        default_value = "fineliner",
        conflicts_with = "laser"
    )]
    pub(crate) pen: String,
    /// Burn this material with the laser
    #[arg(long, value_name = "MATERIAL")]
    pub(crate) laser: Option<String>,
    /// A TOML file with more pens and materials; `dobot materials` prints those that are known
    #[arg(long, value_name = "FILE")]
    pub(crate) materials: Option<PathBuf>,
    /// Let the laser be switched on for so many seconds: everybody's goggles are on
    #[arg(long, value_name = "SECONDS", value_parser = laser_seconds, requires = "laser")]
    pub(crate) arm_laser: Option<Duration>,
    /// How far the pen is lifted to travel, in mm
    #[arg(long, value_name = "MM")]
    pub(crate) lift: Option<f64>,
    /// Speed while drawing or burning, in mm/s
    #[arg(long, value_name = "MM/S")]
    pub(crate) speed: Option<f64>,
    /// Speed between the strokes, in mm/s
    #[arg(long, value_name = "MM/S")]
    pub(crate) travel_speed: Option<f64>,
    /// Burn everything so often
    #[arg(long, value_name = "N", requires = "laser")]
    pub(crate) passes: Option<u32>,
    /// Acceleration, in mm/s²
    #[arg(long, value_name = "MM/S2", default_value_t = Machine::default().acceleration_mm_s2)]
    pub(crate) acceleration: f64,
}

/// How.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "How it is drawn")]
pub(crate) struct Way {
    /// How far the drawn path may leave the wanted one, in mm
    #[arg(long, value_name = "MM", default_value_t = Settings::default().tolerance_mm)]
    pub(crate) tolerance: f64,
    /// Draw in the order of the file
    #[arg(long)]
    pub(crate) keep_order: bool,
    /// How long to look for the shortest way with the pen up: so many tries
    #[arg(
        long,
        value_name = "N",
        default_value_t = 20_000,
        conflicts_with = "keep_order"
    )]
    pub(crate) tries: u32,
    /// Look elsewhere: the same number gives the same order
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) seed: u64,
    /// Begin later: at a layer, a stroke or a share of the ink, as in layer:red, stroke:120 or 40%
    #[arg(long, value_name = "WHERE", value_parser = from)]
    pub(crate) from: Option<StartFrom>,
    /// First go around the drawing, pen up and laser off, to see where it will be
    #[arg(long)]
    pub(crate) frame: bool,
    /// Move nothing: a virtual arm tells what it would be
    #[arg(long)]
    pub(crate) dry_run: bool,
}

/// What comes out.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "What comes out")]
pub(crate) struct Results {
    /// Make a picture of the commanded and the drawn path, in a file that ends in .svg or .png
    #[arg(long, value_name = "FILE", value_parser = picture_file)]
    pub(crate) picture: Option<PathBuf>,
    /// Colour the drawn path in the picture by how far it is from the wanted one
    #[arg(long, requires = "picture")]
    pub(crate) errors: bool,
    /// Show all that the arm reaches in the picture, not only the paper
    #[arg(long, requires = "picture")]
    pub(crate) whole_reach: bool,
    /// Write what happens when, as JSON, for programs that show it
    #[arg(long, value_name = "FILE")]
    pub(crate) timeline: Option<PathBuf>,
    /// Print the report as JSON
    #[arg(long)]
    pub(crate) json: bool,
}

fn layers(text: &str) -> Result<LayersBy, String> {
    match text {
        "color" | "colour" => Ok(LayersBy::Color),
        "group" => Ok(LayersBy::Group),
        _ => Err("allowed are color and group".into()),
    }
}

fn align(text: &str) -> Result<Align, String> {
    match text {
        "left" => Ok(Align::Left),
        "center" | "centre" => Ok(Align::Center),
        "right" => Ok(Align::Right),
        _ => Err("allowed are left, center and right".into()),
    }
}

fn layer_tool(text: &str) -> Result<(String, String), String> {
    match text.rsplit_once('=') {
        Some((layer, tool)) if !layer.is_empty() && !tool.is_empty() => {
            Ok((layer.to_owned(), tool.to_owned()))
        }
        _ => Err("expected the layer's name, = and a pen or material, as in red=marker".into()),
    }
}

fn from(text: &str) -> Result<StartFrom, String> {
    let told = || "expected layer:NAME, stroke:NUMBER or a share such as 40%".to_owned();
    if let Some(percent) = text.strip_suffix('%') {
        return percent.parse().map(StartFrom::Percent).map_err(|_| told());
    }
    match text.split_once(':') {
        Some(("layer", name)) => Ok(StartFrom::Pass(name.to_owned())),
        Some(("stroke", number)) => number.parse().map(StartFrom::Stroke).map_err(|_| told()),
        _ => Err(told()),
    }
}

fn spacing(text: &str) -> Result<Spacing, String> {
    if text == "auto" {
        return Ok(Spacing::OfTool);
    }
    let spacing_mm = text.parse().map(Spacing::Millimeters);
    spacing_mm.map_err(|_| "expected a number of millimetres".into())
}

fn style(text: &str) -> Result<Style, String> {
    match text {
        "outline" => Ok(Style::Outline),
        "lines" => Ok(Style::Lines),
        "stipple" => Ok(Style::Stipple),
        "hatch" => Ok(Style::Hatch),
        _ => Err("allowed are outline, lines, stipple and hatch".into()),
    }
}

fn picture_file(text: &str) -> Result<PathBuf, String> {
    let file = PathBuf::from(text);
    let ending = file
        .extension()
        .and_then(|it| it.to_str())
        .map(str::to_ascii_lowercase);
    match ending.as_deref() {
        Some("svg" | "png") => Ok(file),
        _ => Err("allowed are names that end in .svg or .png".into()),
    }
}
