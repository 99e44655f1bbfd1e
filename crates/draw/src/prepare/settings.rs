//! How a drawing is to be made.

use std::sync::Arc;

use dobot_api::CalibrationFile;
use dobot_geometry::Area;
use dobot_import::fontdb;
use dobot_import::{LayersBy, Shading, ShadingStyle};
use dobot_plan::{ArmLimits, DrawingTool, Paper};

use super::PrepareError;
use crate::arm::resume_point::ResumePoint;
use crate::layout::copies::Grid;
use crate::layout::place::Placement;
use crate::preparation::cancel::CancelToken;
use crate::preparation::progress::Progress;
use crate::strokes::cutting::Cutting;
use crate::strokes::hatch::{Hatch, hatch};
use crate::strokes::order::{Search, Travel};
use crate::strokes::simplify::MIN_VECTOR_MM;

/// How a drawing is to be made.
#[derive(Clone, Debug)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is a setting of its own"
)]
pub struct Settings {
    /// How far the drawn path may leave the wanted one, in mm on the paper; from 0.02 to 10.
    pub tolerance_mm: f64,
    /// Where on the paper, and how large.
    pub placement: Placement,
    /// Copies of the source, or all of several sources, side by side; otherwise there is one of each, where
    /// it is on its page.
    pub grid: Option<Grid>,
    /// How far apart what is side by side lies, and a text below the drawing, in mm of the page.
    pub gap_mm: f64,
    /// Where the paper lies.
    pub paper: Paper,
    /// What is wrong with the arm; nothing if not given. Drawings are told in the arm's own places
    /// then, and [`paper`](Self::paper) must be as the arm sees it.
    pub calibration: Option<CalibrationFile>,
    /// What arm and link can do.
    pub arm_limits: ArmLimits,
    /// What draws.
    pub tool: DrawingTool,
    /// Whether it does so at its own speed, whatever the file says.
    pub keeps_speed: bool,
    /// Whether layers are drawn each for itself, and what makes them; otherwise all are one.
    pub layers: Option<LayersBy>,
    /// The layers to draw, by name, also several with commas between them; all of them if none is named.
    pub only: Vec<String>,
    /// What draws the layers that have tools of their own, by name.
    pub tools: Vec<(String, DrawingTool)>,
    /// Whether what lies beyond the page of an SVG file is cut off.
    pub crops: bool,
    /// Whether the filled shapes of an SVG, DXF or HP-GL file hide what lies under them.
    pub hides: bool,
    /// How near to each other strokes end that are joined, in mm; the tolerance if not given.
    pub join_mm: Option<f64>,
    /// Whether lines that lie on others are left out.
    pub drops_doubles: bool,
    /// How often a pen goes over each line, from 1 up.
    pub pen_passes: u32,
    /// How a laser cuts shapes out.
    pub cutting: Cutting,
    /// How filled areas become lines; they stay empty if not given.
    pub hatch: Option<Hatch>,
    /// How a picture's tones become lines.
    pub shading: Shading,
    /// How often a good order of the strokes is disturbed to find a better one; the file's own order
    /// is kept if not given.
    pub tries: Option<u32>,
    /// Decides where it is disturbed: the same seed gives the same order.
    pub seed: u64,
    /// Where to begin; at the beginning if not given.
    pub from: Option<ResumePoint>,
    /// The fonts that text is drawn with.
    pub fonts: Arc<fontdb::Database>,
    /// Ends the preparation before it is done.
    pub cancel: CancelToken,
    /// Tells how far it is.
    pub progress: Progress,
}

impl Settings {
    /// How a tool cuts shapes out: where the material of the drawing is cut through, a layer that is engraved has no kerf or tabs.
    pub(super) fn cutting_of(&self, tool: DrawingTool) -> Cutting {
        if tool.cuts() || !self.tool.cuts() {
            self.cutting
        } else {
            Cutting::default()
        }
    }

    /// How near ends are joined, in mm.
    pub(super) fn join_mm(&self) -> f64 {
        self.join_mm.unwrap_or(self.tolerance_mm)
    }
    pub(super) fn check(&self) -> Result<(), PrepareError> {
        let tolerance_mm = self.tolerance_mm;
        let [least_mm, most_mm] = TOLERANCE_MM;
        if !(least_mm..=most_mm).contains(&tolerance_mm) {
            return Err(PrepareError::Tolerance(tolerance_mm));
        }
        // Told for a drawing without areas, too.
        if let Some(hatching) = &self.hatch {
            hatch(&Area::default(), hatching)?;
        }
        Ok(())
    }

    /// How to look for a good order of the strokes that this tool draws.
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

    /// The share of the tolerance that goes into reading curves.
    pub(super) fn flatten_mm(&self) -> f64 {
        self.tolerance_mm * FLATTEN_SHARE
    }
}

impl Default for Settings {
    /// 0.05 mm, true size, a pen on level paper, all layers as one, no fonts.
    fn default() -> Self {
        Self {
            tolerance_mm: 0.05,
            placement: Placement::default(),
            grid: None,
            gap_mm: 5.0,
            paper: Paper::default(),
            calibration: None,
            arm_limits: ArmLimits::default(),
            tool: DrawingTool::default(),
            keeps_speed: false,
            layers: None,
            only: Vec::new(),
            tools: Vec::new(),
            crops: true,
            hides: false,
            join_mm: None,
            drops_doubles: false,
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

/// Enough for ordinary drawings, in well under a second, and a second or so for each 100,000 strokes.
pub(crate) const TRIES: u32 = 80_000;
const FLATTEN_SHARE: f64 = 0.1;
/// The tolerances that can be met, in mm; with larger ones nothing of a drawing would be left.
pub(crate) const TOLERANCE_MM: [f64; 2] = [4.0 * MIN_VECTOR_MM, 10.0];
