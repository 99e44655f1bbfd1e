//! The settings of a preparation.

use std::sync::Arc;

use dobot_api::CalibrationFile;
use dobot_geometry::Area;
use dobot_import::fontdb;
use dobot_import::{GcodeTool, LayersBy, Shading, ShadingStyle};
use dobot_plan::{ArmLimits, DrawingTool, Paper};

use super::PrepareError;
use crate::arm::resume_point::ResumePoint;
use crate::layout::copies::Grid;
use crate::layout::marks::Marks;
use crate::layout::place::Placement;
use crate::preparation::progress::Progress;
use crate::strokes::cutting::Cutting;
use crate::strokes::hatch::{Hatch, hatch};
use crate::strokes::order::{Search, Travel};
use crate::strokes::simplify::MIN_VECTOR_MM;
use dobot_geometry::CancelToken;

/// The settings of a preparation.
#[derive(Clone, Debug)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is a setting of its own"
)]
pub struct Settings {
    /// The maximum deviation of the drawn path, in mm on the paper; 0.02 to 10.
    pub tolerance_mm: f64,
    /// The position and size on the paper.
    pub placement: Placement,
    /// The grid for copies of the source or several sources; by default each is drawn once, at its
    /// place on the page.
    pub grid: Option<Grid>,
    /// The gap in the grid, and between drawing and text, in mm of the page.
    pub gap_mm: f64,
    /// What is drawn around the drawing.
    pub marks: Marks,
    /// Whether texts keep their height on the paper, however the drawing is scaled.
    pub keeps_text_height: bool,
    /// The paper.
    pub paper: Paper,
    /// The calibration; none by default. With one, drawings are converted to raw positions, and
    /// [`paper`](Self::paper) must be in raw positions.
    pub calibration: Option<CalibrationFile>,
    /// The limits of arm and link.
    pub arm_limits: ArmLimits,
    /// The tool.
    pub tool: DrawingTool,
    /// Whether the tool keeps its own speed, regardless of the file.
    pub keeps_speed: bool,
    /// How the drawing is split into layers that are drawn separately; by default there is one
    /// layer.
    pub layers: Option<LayersBy>,
    /// The names of the layers to draw, also several separated by commas; all layers if empty.
    pub only: Vec<String>,
    /// The tools of layers, by name.
    pub tools: Vec<(String, DrawingTool)>,
    /// Whether an SVG file is cropped to its page.
    pub crops: bool,
    /// What G-code controls; `None` to infer it from each file.
    pub gcode: Option<GcodeTool>,
    /// Whether a file with a mistake is refused.
    pub strict: bool,
    /// Whether filled shapes of an SVG, DXF or HP-GL file hide what lies below.
    pub hides: bool,
    /// Whether the edges of white shapes of an SVG file are drawn where they lie on darker ones.
    pub white_edges: bool,
    /// The distance up to which stroke ends are joined, in mm; the tolerance by default.
    pub join_mm: Option<f64>,
    /// Whether duplicate lines are removed.
    pub drops_duplicates: bool,
    /// The number of passes of a pen over each line, at least 1.
    pub pen_passes: u32,
    /// The settings for cutting shapes out with a laser.
    pub cutting: Cutting,
    /// The hatching of filled areas; without it they stay empty.
    pub hatch: Option<Hatch>,
    /// The conversion of a picture's tones to lines.
    pub shading: Shading,
    /// The number of attempts to improve the stroke order; without it the file's order is kept.
    pub tries: Option<u32>,
    /// The seed of these attempts: the same seed gives the same order.
    pub seed: u64,
    /// The resume point; the beginning by default.
    pub from: Option<ResumePoint>,
    /// The fonts for text.
    pub fonts: Arc<fontdb::Database>,
    /// Cancels the preparation.
    pub cancel: CancelToken,
    /// Reports the progress.
    pub progress: Progress,
}

impl Settings {
    /// Returns the cutting settings of a tool: if the drawing's material is cut through, an
    /// engraved layer has no kerf or tabs.
    pub(super) fn cutting_of(&self, tool: DrawingTool) -> Cutting {
        if tool.cuts() || !self.tool.cuts() {
            self.cutting
        } else {
            Cutting::default()
        }
    }

    /// Returns the distance up to which ends are joined, in mm.
    pub(super) fn join_mm(&self) -> f64 {
        self.join_mm.unwrap_or(self.tolerance_mm)
    }
    pub(super) fn check(&self) -> Result<(), PrepareError> {
        let tolerance_mm = self.tolerance_mm;
        let [least_mm, most_mm] = TOLERANCE_MM;
        if !(least_mm..=most_mm).contains(&tolerance_mm) {
            return Err(PrepareError::Tolerance(tolerance_mm));
        }
        // Report invalid settings even for a drawing without areas.
        if let Some(hatching) = &self.hatch {
            hatch(&Area::default(), hatching)?;
        }
        Ok(())
    }

    /// Returns the settings of the stroke order search for this tool.
    pub(super) fn search(&self, tool: DrawingTool) -> Option<Search> {
        let by_time = Travel::Time {
            speed_mm_s: tool.travel_speed_mm_s(),
            acceleration_mm_s2: self.arm_limits.acceleration_mm_s2,
            least_s: self.arm_limits.link.period_s,
        };
        Some(Search {
            travel: if self.joins_dots() {
                Travel::Length
            } else {
                by_time
            },
            kicks: self.tries?,
            seed: self.seed,
        })
    }

    /// Whether dots become one line.
    pub(super) fn joins_dots(&self) -> bool {
        self.shading.style == ShadingStyle::Tsp
    }

    /// Returns the share of the tolerance for reading curves.
    pub(crate) fn flatten_mm(&self) -> f64 {
        self.tolerance_mm * FLATTEN_SHARE
    }
}

impl Default for Settings {
    /// Returns 0.05 mm, true size, a pen on level paper, one layer, no fonts.
    fn default() -> Self {
        Self {
            tolerance_mm: 0.05,
            placement: Placement::default(),
            grid: None,
            gap_mm: 5.0,
            marks: Marks::default(),
            keeps_text_height: false,
            paper: Paper::default(),
            calibration: None,
            arm_limits: ArmLimits::default(),
            tool: DrawingTool::default(),
            keeps_speed: false,
            layers: None,
            only: Vec::new(),
            tools: Vec::new(),
            crops: true,
            gcode: None,
            strict: false,
            hides: false,
            white_edges: false,
            join_mm: None,
            drops_duplicates: false,
            pen_passes: 1,
            cutting: Cutting::default(),
            hatch: None,
            shading: Shading::default(),
            tries: Some(TRIES),
            seed: 1,
            from: None,
            fonts: Arc::default(),
            cancel: CancelToken::default(),
            progress: Progress::default(),
        }
    }
}

/// Enough for ordinary drawings in well under a second, and about a second per 100,000 strokes.
pub(crate) const TRIES: u32 = 30_000;
const FLATTEN_SHARE: f64 = 0.1;
/// The range of tolerances, in mm; larger ones would leave nothing of a drawing.
pub(crate) const TOLERANCE_MM: [f64; 2] = [4.0 * MIN_VECTOR_MM, 10.0];
