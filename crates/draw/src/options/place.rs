//! The options that say where it goes.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::layout::copies::Grid;
use crate::layout::sheet::PaperSize;

/// Where it goes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[cfg_attr(feature = "options", derive(clap::Args))]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is an option of its own"
)]
#[cfg_attr(feature = "options", command(next_help_heading = "Paper"))]
#[serde(default, deny_unknown_fields)]
pub struct PlaceOptions {
    /// The sheet that it goes on: a3, a4, a5, a6, letter, legal, or `210x148` in mm; the page of the file
    /// keeps its upper left corner
    #[cfg_attr(feature = "options", arg(long, value_name = "SIZE"))]
    pub paper_size: Option<PaperSize>,
    /// The longer side of the sheet lies from left to right
    #[cfg_attr(feature = "options", arg(long, requires = "paper_size"))]
    pub landscape: bool,
    /// Where the lower left corner of the sheet lies, in mm: the one that is nearest to you behind the arm,
    /// on the left (default: the sheet lies in the middle before the arm)
    #[cfg_attr(feature = "options", arg(long, num_args = 2, value_names = ["X", "Y"], requires = "paper_size", conflicts_with_all = ["at", "paper"]))]
    pub corner: Option<Vec<f64>>,
    /// As large as the sheet or the drawing area allows
    #[cfg_attr(feature = "options", arg(long, conflicts_with = "scale"))]
    pub fit: bool,
    /// Times the true size
    #[cfg_attr(feature = "options", arg(long, value_name = "FACTOR"))]
    pub scale: Option<f64>,
    /// Where the middle of the drawing goes, or that of the sheet, in mm (default: the middle of the drawing
    /// area)
    #[cfg_attr(feature = "options", arg(long, num_args = 2, value_names = ["X", "Y"]))]
    pub at: Option<Vec<f64>>,
    /// Change left and right
    #[cfg_attr(feature = "options", arg(long))]
    pub mirror: bool,
    /// Draw copies side by side, in columns and rows as in 3x2; several files one in each cell, then from the
    /// first again
    #[cfg_attr(feature = "options", arg(long, value_name = "GRID"))]
    pub grid: Option<Grid>,
    /// How far the copies or files of --grid lie apart, and how far --text stands below a file, in mm of the file
    #[cfg_attr(feature = "options", arg(long, value_name = "MM", default_value_t = Self::default().gap))]
    pub gap: f64,
    /// Turn it counterclockwise
    #[cfg_attr(
        feature = "options",
        arg(long, value_name = "DEGREES", default_value_t = 0.0)
    )]
    pub rotate: f64,
    /// Leave so much of the sheet or the drawing area empty along its edges, in mm
    #[cfg_attr(
        feature = "options",
        arg(long, value_name = "MM", default_value_t = 0.0)
    )]
    pub margin: f64,
    /// Cut off what lies beyond the sheet or out of the arm's reach, instead of refusing the drawing
    #[cfg_attr(feature = "options", arg(long))]
    pub clip: bool,
    /// Z where the pen draws, in mm (default: where the arm stands; a virtual arm -40)
    #[cfg_attr(
        feature = "options",
        arg(long, value_name = "Z", conflicts_with = "paper")
    )]
    pub pen_down: Option<f64>,
    /// Three points of the paper that the pen has touched, for paper that is not level; with --paper-size
    /// first the lower left corner of the sheet, then another place on its lower edge
    #[cfg_attr(feature = "options", arg(long, num_args = 9, value_names = ["X", "Y", "Z", "X", "Y", "Z", "X", "Y", "Z"]))]
    pub paper: Option<Vec<f64>>,
    /// Draw so much higher, in mm; negative presses harder
    #[cfg_attr(
        feature = "options",
        arg(long, value_name = "MM", default_value_t = 0.0)
    )]
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
