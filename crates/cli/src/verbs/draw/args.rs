//! The arguments of `dobot draw`.

use std::path::{Path, PathBuf};
use std::time::Duration;

use dobot_draw::ExportFormat;
use dobot_import::Format;

use super::defaults::{self, Defaults};
use crate::connect::To;
use crate::drawing_options::DrawingOptions;
use crate::output::wrapped;
use crate::renamed::draw_option;
use crate::values::{extension, laser_seconds};

/// Draw a file, a picture or a text with a pen or the laser
#[derive(Debug, clap::Args)]
#[command(
    allow_negative_numbers = true,
    after_help = after_help()
)]
pub(crate) struct Args {
    /// Files, or - for standard input; several files share one sheet, each at its position on its own page
    #[arg(value_name = "FILE", required_unless_present_any = ["text", "card"], conflicts_with = "card")]
    pub(crate) files: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) options: DrawingOptions,
    #[command(flatten)]
    pub(crate) to: To,
    /// TOML file with more pens and materials; `dobot materials` lists the built-in ones
    #[arg(
        long,
        value_name = "FILE",
        help_heading = "Pen",
        hide_short_help = true
    )]
    pub(crate) materials: Option<PathBuf>,
    /// Calibration file of the arm: draw on its sheet, or on the paper that was touched, with its errors corrected
    #[arg(
        long,
        value_name = "ARM.toml",
        help_heading = "Paper",
        hide_short_help = true
    )]
    pub(crate) calibration: Option<PathBuf>,
    /// Arm the laser for this many seconds, 1 to 3600; everyone present must wear goggles
    #[arg(
        long,
        value_name = "SECONDS",
        help_heading = "Laser",
        value_parser = laser_seconds,
        requires = "laser"
    )]
    pub(crate) arm_laser: Option<Duration>,
    /// Trace the bounding rectangle of the drawing first, with pen up and laser off, and ask before drawing
    #[arg(long, help_heading = "Run")]
    pub(crate) outline: bool,
    /// Simulate only: report time, ink and reach without moving the arm
    #[arg(long, help_heading = "Run")]
    pub(crate) dry_run: bool,
    /// TOML file with default options, for example pen = "marker"; the command line takes precedence (default:
    /// draw.toml in the data folder, if it exists)
    #[arg(
        long,
        value_name = "FILE",
        help_heading = "Run",
        hide_short_help = true
    )]
    pub(crate) defaults: Option<PathBuf>,
    /// Ignore that file, or these of its options, separated by commas
    #[arg(
        long,
        value_name = "OPTION",
        help_heading = "Run",
        hide_short_help = true,
        value_parser = default_option,
        num_args = 0..,
        require_equals = true,
        value_delimiter = ',',
        default_missing_value = ALL_DEFAULTS
    )]
    pub(crate) no_defaults: Option<Vec<String>>,
    #[command(flatten)]
    pub(crate) result: Results,
    /// The file of defaults that these options come from, in addition to the command line.
    #[arg(skip)]
    pub(crate) from_file: Option<Defaults>,
}

/// Output files and the report.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Output")]
pub(crate) struct Results {
    /// Save a picture of the commanded and the drawn path, a .svg or .png file
    #[arg(long, value_name = "FILE", value_parser = picture_file)]
    pub(crate) picture: Option<PathBuf>,
    /// Export the ordered strokes for other programs, a .svg, .gcode, .plt or .json file
    #[arg(long, value_name = "FILE", value_parser = export_file, conflicts_with = "calibration")]
    pub(crate) export: Option<PathBuf>,
    /// Colour the drawn path in the picture by its error
    #[arg(long, requires = "picture", hide_short_help = true)]
    pub(crate) errors: bool,
    /// Show the whole reach of the arm in the picture, not only the paper
    #[arg(long, requires = "picture", hide_short_help = true)]
    pub(crate) whole_reach: bool,
    /// Write the timeline of the drawing as JSON, for programs that display it
    #[arg(long, value_name = "FILE", hide_short_help = true)]
    pub(crate) timeline: Option<PathBuf>,
    /// Print the report as JSON
    #[arg(long)]
    pub(crate) json: bool,
}

fn after_help() -> String {
    let drawings = indented(&Format::names(|format| !format.is_picture(), "and"));
    let pictures = indented(&Format::names(Format::is_picture, "and"));
    format!(
        "{EXAMPLES}
Formats of drawings:
{drawings}
Formats of pictures:
{pictures}
Files may be compressed with gzip. {AREA}"
    )
}

/// Wraps and indents a text for the help.
fn indented(text: &str) -> String {
    let lines = wrapped(text, 76).into_iter();
    let lines: Vec<String> = lines.map(|line| format!("  {line}")).collect();
    lines.join("\n")
}

/// Parses an option that a file of defaults may have, or `all`.
fn default_option(text: &str) -> Result<String, String> {
    let text = draw_option(text).0;
    let has_name = |arg: &clap::Arg| arg.get_long() == Some(&text);
    if text == ALL_DEFAULTS || defaults::known().iter().any(has_name) {
        return Ok(text);
    }
    Err("expected options of a file of defaults, without dashes".to_owned())
}

fn export_file(text: &str) -> Result<PathBuf, String> {
    let file = PathBuf::from(text);
    export_format(&file)?;
    Ok(file)
}

/// Returns the export format for a file name.
pub(crate) fn export_format(file: &Path) -> Result<ExportFormat, &'static str> {
    let extension = file.extension().and_then(|extension| extension.to_str());
    extension.unwrap_or_default().parse()
}

fn picture_file(text: &str) -> Result<PathBuf, String> {
    match extension(text).as_deref() {
        Some("svg" | "png") => Ok(text.into()),
        _ => Err("expected a file name that ends in .svg or .png".into()),
    }
}

/// The name for all defaults.
pub(super) const ALL_DEFAULTS: &str = "all";

const EXAMPLES: &str = "\
Examples:
  dobot draw picture.svg                              on the station's arm
  dobot draw photo.jpg --to virtual: --picture drawn.png
                                                      on a virtual arm, simulated
  dobot draw --text 'Hello, arm' --font script --height 20
                                                      a text in single-line letters
  dobot draw photo.jpg --shade stipple --dry-run      only report time, ink and reach
  dobot draw plan.dxf --fit --rotate 90 --margin 10   as large as possible, rotated
  dobot draw flag.svg --layers color --hatch 1        one pen per colour, areas hatched
  dobot draw sign.svg --laser plywood-engrave --outline
                                                      trace the outline, then burn
  dobot draw map.svg route.svg --text Tour            two files on one sheet, a text
  dobot draw a.svg b.svg c.dxf --grid 3x1             three files side by side
  dobot draw page.svg --paper-size a5 --landscape     a page on a sheet of paper
  dobot draw parts.svg --laser cardboard-cut --kerf 0.2 --tabs 3
                                                      cut out, held by tabs
  dobot draw long.svg --from 40%                      the rest of a drawing
";

const AREA: &str = "A picture fills the drawing area. A larger
drawing is placed where the arm reaches all of it, or is scaled down; --scale
prevents that. --paper-size places the page of the file on a sheet.

The drawing area is 200 mm wide and 120 mm deep: x 150 to 270, y -100 to 100.
Seen from behind the arm, the picture is upright. With a real arm, lower the pen
to the paper first (`dobot jog z-`): without --pen-down or --paper it draws at
the current height. Ctrl-C lifts the pen and reports the progress.

If a station runs, the drawing becomes one of its jobs: Ctrl-C pauses it, and
`dobot jobs start` resumes it; `dobot jobs speed` and `dobot jobs height` adjust
it while it is drawn.";

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
    fn json_gives_the_same_settings_in_the_same_words() {
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
