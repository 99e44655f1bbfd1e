//! The options that say where it goes.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::fields::Ranges;
use crate::layout::copies::Grid;
use crate::layout::sheet::PaperSize;

/// Where it goes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is an option of its own"
)]
#[serde(default, deny_unknown_fields)]
#[schemars(transform = Ranges("place"))]
pub struct PlaceOptions {
    /// The sheet that it goes on: a3, a4, a5, a6, letter, legal, or `210x148` in mm; the page of the file
    /// keeps its upper left corner
    pub paper_size: Option<PaperSize>,
    /// The longer side of the sheet lies from left to right
    pub landscape: bool,
    /// Where the lower left corner of the sheet lies, in mm: the one that is nearest to you behind the arm,
    /// on the left (default: the sheet lies in the middle before the arm)
    pub corner: Option<Vec<f64>>,
    /// As large as the sheet or the drawing area allows
    pub fit: bool,
    /// Times the true size
    pub scale: Option<f64>,
    /// Where the middle of the drawing goes, or that of the sheet, in mm (default: the middle of the drawing
    /// area)
    pub at: Option<Vec<f64>>,
    /// Change left and right
    pub mirror: bool,
    /// Draw copies side by side, in columns and rows as in 3x2; several files one in each cell, then from the
    /// first again
    pub grid: Option<Grid>,
    /// How far the copies or files of `place.grid` lie apart, and how far `what.text` stands below a file, in mm of the file
    pub gap: f64,
    /// Turn it counterclockwise
    pub rotate: f64,
    /// Leave so much of the sheet or the drawing area empty along its edges, in mm
    pub margin: f64,
    /// Cut off what lies beyond the sheet or out of the arm's reach, instead of refusing the drawing
    pub clip: bool,
    /// Z where the pen draws, in mm (default: where the arm stands; a virtual arm -40)
    pub pen_down: Option<f64>,
    /// Three points of the paper that the pen has touched, for paper that is not level; with `place.paper_size`
    /// first the lower left corner of the sheet, then another place on its lower edge
    pub paper: Option<Vec<f64>>,
    /// Draw so much higher, in mm; negative presses harder
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
