//! The options of `dobot draw`.

use std::path::{Path, PathBuf};
use std::time::Duration;

use dobot_draw::ExportFormat;
use dobot_import::Format;

use super::defaults::{self, Defaults};
use crate::connect::To;
use crate::drawing_options::DrawingOptions;
use crate::verbs::jog::laser_seconds;

/// Draw a file, a picture or a text, or burn it with the laser
#[derive(Debug, clap::Args)]
#[command(
    allow_negative_numbers = true,
    after_help = after_help()
)]
pub(crate) struct Args {
    /// The file, or - for standard input; several go on one sheet, each where it is on its own page
    #[arg(value_name = "FILE", required_unless_present_any = ["text", "card"], conflicts_with = "card")]
    pub(crate) files: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) options: DrawingOptions,
    #[command(flatten, next_help_heading = "Run")]
    pub(crate) to: To,
    /// A TOML file with more pens and materials; `dobot materials` prints those that are known
    #[arg(long, value_name = "FILE", help_heading = "Pen")]
    pub(crate) materials: Option<PathBuf>,
    /// Draw where the sheet of a calibration says, with an arm of which `dobot calibrate` found what is
    /// wrong; the paper lies where it was touched, unless told otherwise
    #[arg(long, value_name = "ARM.toml", help_heading = "Paper")]
    pub(crate) calibration: Option<PathBuf>,
    /// Let the laser be switched on for so many seconds: everybody's goggles are on
    #[arg(
        long,
        value_name = "SECONDS",
        help_heading = "Laser",
        value_parser = laser_seconds,
        requires = "laser"
    )]
    pub(crate) arm_laser: Option<Duration>,
    /// First go around the drawing, pen up and laser off, to see where it will be
    #[arg(long, help_heading = "Run")]
    pub(crate) frame: bool,
    /// Move nothing: a virtual arm tells what it would be
    #[arg(long, help_heading = "Run")]
    pub(crate) dry_run: bool,
    /// A TOML file with options for every drawing, as in pen = "marker"; what the command line gives wins (default:
    /// draw.toml in the data folder, if there is one)
    #[arg(long, value_name = "FILE", help_heading = "Run")]
    pub(crate) defaults: Option<PathBuf>,
    /// Leave that file out, or these options of it: several with commas between them
    #[arg(
        long,
        value_name = "OPTION",
        help_heading = "Run",
        value_parser = default_option,
        num_args = 0..,
        require_equals = true,
        value_delimiter = ',',
        default_missing_value = ALL_DEFAULTS
    )]
    pub(crate) no_defaults: Option<Vec<String>>,
    #[command(flatten)]
    pub(crate) result: Results,
    /// The file of defaults that these options come from, beside the command line.
    #[arg(skip)]
    pub(crate) from_file: Option<Defaults>,
}

/// What comes out.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Run")]
pub(crate) struct Results {
    /// Make a picture of the commanded and the drawn path, in a file that ends in .svg or .png
    #[arg(long, value_name = "FILE", value_parser = picture_file)]
    pub(crate) picture: Option<PathBuf>,
    /// Write the strokes in their order for other programs, in a file that ends in .svg, .gcode, .plt or .json
    #[arg(long, value_name = "FILE", value_parser = export_file, conflicts_with = "calibration")]
    pub(crate) export: Option<PathBuf>,
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

fn after_help() -> String {
    let drawings = Format::names(|format| !format.is_picture(), "and");
    let pictures = Format::names(Format::is_picture, "and");
    format!(
        "{EXAMPLES}
It draws files in these formats: {drawings}, and pictures: {pictures}.
- reads standard input, and gzip is unpacked. A picture fills the drawing area; what is larger than it goes where
the arm reaches all of it, or is made to fit; --scale insists. --paper-size puts the page of the file on a sheet.
{AREA}"
    )
}

/// An option that a file of defaults may have, or all of them.
fn default_option(text: &str) -> Result<String, String> {
    let is_it = |it: &clap::Arg| it.get_long() == Some(text);
    if text == ALL_DEFAULTS || defaults::known().iter().any(is_it) {
        return Ok(text.to_owned());
    }
    Err("allowed are options that a file of defaults may have, without their dashes".to_owned())
}

fn export_file(text: &str) -> Result<PathBuf, String> {
    let file = PathBuf::from(text);
    export_format(&file)?;
    Ok(file)
}

/// The kind of file that its name asks for.
pub(crate) fn export_format(file: &Path) -> Result<ExportFormat, &'static str> {
    let ending = file.extension().and_then(|it| it.to_str());
    ending.unwrap_or_default().parse()
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

/// What leaves all defaults out.
pub(super) const ALL_DEFAULTS: &str = "all";

const EXAMPLES: &str = "\
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
  dobot draw map.svg route.svg --text Tour               one sheet: each where it is on its page, a text below
  dobot draw a.svg b.svg c.dxf --grid 3x1                one sheet: side by side
  dobot draw page.svg --paper-size a5 --landscape        the page where it is on the sheet
  dobot draw parts.svg --laser cardboard-cut --kerf 0.2 --tabs 3
                                                         cut out, inside first, held by tabs
  dobot draw long.svg --from 40%                         the rest of a drawing
";

const AREA: &str = "
The drawing area is 200 mm wide and 120 mm deep: x 150 to 270, y -100 to 100. Seen from behind the
arm the picture lies upright. On a real arm bring the pen down to the paper first (`dobot jog z-`): unless --pen-down or
--paper says otherwise, it draws at the height at which it stands. Ctrl-C lifts the pen and says how far it got.

When a station runs, the drawing becomes a job of it: Ctrl-C pauses it, and `dobot jobs start` goes on with it;
`dobot jobs speed` and `dobot jobs height` change it while it is drawn.";

#[cfg(test)]
mod tests {
    use clap::Parser;
    use dobot_draw::Options;
    use serde_json::json;

    use super::*;

    #[derive(Debug, Parser)]
    struct Program {
        #[command(flatten)]
        args: Args,
    }

    fn options(arguments: &[&str]) -> Options {
        let all = [&["draw", "a.svg"], arguments].concat();
        Program::try_parse_from(all)
            .expect("they are allowed")
            .args
            .options
            .0
    }

    #[test]
    fn json_says_the_same_in_the_same_words() {
        for (arguments, json) in [
            (&[][..], json!({})),
            (
                &[
                    "--layers",
                    "color",
                    "--layer",
                    "red=marker",
                    "--only",
                    "red,blue",
                ],
                json!({"what": {"layers": "color", "layer": [{"name": "red", "pen": "marker"}], "only": ["red,blue"]}}),
            ),
            (&["--hatch"], json!({"what": {"hatch": "auto"}})),
            (
                &["--hatch", "1.5", "--hatch-angle", "0", "--cross"],
                json!({"what": {"hatch": 1.5, "hatch_angle": 0, "cross": true}}),
            ),
            (
                &["--shade", "stipple", "--spacing", "2", "--invert"],
                json!({"what": {"shade": "stipple", "spacing": 2, "invert": true}}),
            ),
            (
                &["--at", "200", "-20", "--rotate", "90", "--pen-down", "-35"],
                json!({"place": {"at": [200, -20], "rotate": 90, "pen_down": -35}}),
            ),
            (
                &["--laser", "cardboard-engrave", "--passes", "2"],
                json!({"tool": {"laser": "cardboard-engrave", "passes": 2}}),
            ),
            (
                &["--tolerance", "0.1", "--seed", "7", "--from", "40%"],
                json!({"way": {"tolerance": 0.1, "seed": 7, "from": "40%"}}),
            ),
        ] {
            let from_json: Options = serde_json::from_value(json).expect("it is allowed");
            assert_eq!(options(arguments), from_json);
        }
    }
}
