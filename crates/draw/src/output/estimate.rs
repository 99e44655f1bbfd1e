//! Statistics of a plan executed by a virtual arm.

use dobot_arm::Tool;
use dobot_plan::PlannedPass;
use schemars::JsonSchema;
use serde::Serialize;

use crate::output::ink::point;
use crate::output::trace::{Ink, Trace};

/// The statistics of a drawing. The estimate of a later run is the run of a virtual arm.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct Estimate {
    /// The time from the start of the move to the first stroke to the end, in seconds.
    pub time_s: f64,
    /// The length of the lines on the paper, in mm.
    pub ink_mm: f64,
    /// The length of the tool's path without ink, seen from above, in mm.
    pub travel_mm: f64,
    /// The number of strokes, counting repetitions.
    pub strokes: usize,
    /// The number of vectors, which is the number of packets.
    pub vectors: usize,
    /// The maximum distance of the ink from the wanted path, in mm.
    pub error_mm: f64,
    /// The statistics of each pass.
    pub passes: Vec<PassFigures>,
}

/// The statistics of a pass.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PassFigures {
    /// The name.
    pub name: String,
    /// Red, green and blue, if the file specifies a colour.
    pub color: Option<[u8; 3]>,
    /// The tool: `pen` or `laser`.
    pub tool: Tool,
    /// The number of strokes, counting repetitions.
    pub strokes: usize,
    /// The number of vectors, which is the number of packets.
    pub vectors: usize,
    /// The length of its lines on the paper, in mm.
    pub ink_mm: f64,
    /// The length of the tool's path without ink, including the way to its first stroke, in mm.
    pub travel_mm: f64,
    /// The time from the end of the pass before to its own end, in seconds.
    pub time_s: f64,
    /// The maximum distance of its ink from the wanted path, in mm.
    pub error_mm: f64,
}

impl Trace<'_> {
    /// Returns the statistics of the execution.
    #[must_use]
    pub fn estimate(&self) -> Estimate {
        let mut passes: Vec<PassFigures> = self.plan.passes.iter().map(PassFigures::of).collect();
        self.count(&mut passes);
        self.measure(&mut passes);
        let sum = |of: fn(&PassFigures) -> f64| passes.iter().map(of).fold(0.0, |a, b| a + b);
        Estimate {
            time_s: self.moments.last().map_or(0.0, |moment| moment.t_s),
            ink_mm: sum(|pass| pass.ink_mm),
            travel_mm: sum(|pass| pass.travel_mm),
            strokes: passes.iter().map(|pass| pass.strokes).sum(),
            vectors: self.ends.len(),
            error_mm: passes.iter().map(|pass| pass.error_mm).fold(0.0, f64::max),
            passes,
        }
    }

    fn count(&self, passes: &mut [PassFigures]) {
        let mut last = None;
        for (vector, _) in self.plan.moves.iter().zip(&self.ends) {
            let figures = &mut passes[vector.pass as usize];
            figures.vectors += 1;
            figures.strokes += usize::from(last.replace(vector.stroke) != Some(vector.stroke));
        }
    }

    fn measure(&self, passes: &mut [PassFigures]) {
        let ways = self.moments.windows(2).zip(self.passes().skip(1));
        for (way, pass) in ways {
            let [from, to] = [way[0], way[1]];
            let length_mm = point(from.position).distance(point(to.position));
            let figures = &mut passes[pass as usize];
            figures.time_s += to.t_s - from.t_s;
            figures.error_mm = figures.error_mm.max(to.error_mm);
            if to.ink == Ink::Line {
                figures.ink_mm += length_mm;
            } else {
                figures.travel_mm += length_mm;
            }
        }
    }
}

impl PassFigures {
    pub(crate) fn of(pass: &PlannedPass) -> Self {
        Self {
            name: pass.name.clone(),
            color: pass.color,
            tool: pass.tool.tool(),
            strokes: 0,
            vectors: 0,
            ink_mm: 0.0,
            travel_mm: 0.0,
            time_s: 0.0,
            error_mm: 0.0,
        }
    }
}
