//! The options for the placement.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::fields::Ranges;
use crate::layout::copies::Grid;
use crate::layout::sheet::PaperSize;

/// Where to draw it
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is an option of its own"
)]
#[serde(default, deny_unknown_fields)]
#[schemars(transform = Ranges("place"))]
pub struct PlaceOptions {
    /// Sheet to draw on: a3 to a7, b5, b6, letter, legal, tabloid, postcard, `210x148` in mm or
    /// `5x7in`; the page of the file keeps its upper left corner
    pub paper_size: Option<PaperSize>,
    /// Place the sheet with its longer side from left to right
    pub landscape: bool,
    /// Position of the sheet's lower left corner, in mm: the corner closest to you on the left when
    /// you stand behind the arm (default: the sheet is centred in front of the arm)
    pub corner: Option<Vec<f64>>,
    /// Fit to the sheet or the drawing area
    pub fit: bool,
    /// Scale factor relative to the true size
    pub scale: Option<f64>,
    /// Centre of the drawing or the sheet, in mm (default: the centre of the drawing area)
    pub at: Option<Vec<f64>>,
    /// Mirror left and right
    pub mirror: bool,
    /// Draw copies in a grid of columns and rows, as in 3x2; several files fill the cells in turn,
    /// with `place.fit` each as large as its cell allows
    pub grid: Option<Grid>,
    /// Gap between the copies or files of `place.grid`, between a file and `what.text` below it, and
    /// inside `place.border`, in mm of the file
    pub gap: f64,
    /// Rotation counterclockwise, in degrees
    pub rotate: f64,
    /// Margin of the sheet or the drawing area, in mm
    pub margin: f64,
    /// Draw a border at the margin of the sheet, or around the drawing
    pub border: bool,
    /// Draw crop marks outside the corners of the border
    pub crop_marks: bool,
    /// Sign in the lower right corner with this text, in script letters 4 mm high
    pub sign: Option<String>,
    /// Cut off what lies beyond the sheet or out of reach, instead of refusing the drawing
    pub clip: bool,
    /// Z at which the pen draws, in mm (default: the current height of the arm; -40 for a virtual
    /// arm)
    pub pen_down: Option<f64>,
    /// Three touched points of the paper, for paper that is not level; with `place.paper_size`
    /// first the lower left corner of the sheet, then another point on its lower edge
    pub paper: Option<Vec<f64>>,
    /// Height offset of the pen, in mm; a negative offset presses harder
    pub offset: f64,
}

impl Default for PlaceOptions {
    /// Returns true size, centred in the drawing area.
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
            border: false,
            crop_marks: false,
            sign: None,
            clip: false,
            pen_down: None,
            paper: None,
            offset: 0.0,
        }
    }
}
