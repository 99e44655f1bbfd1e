//! The policy's limits of measures.

use dobot_arm::{Calibration, Tool};

use crate::body::Measure;
use crate::{Area, Bounds, Policy};

/// A limit of a measure.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limit {
    /// The key in the policy.
    pub(crate) key: &'static str,
    pub(crate) measure: Measure,
    pub(crate) bounds: Bounds,
}

impl Policy {
    /// Returns the limits for an arm with this tool, with or without those of a burning laser.
    pub(crate) fn limits(&self, tool: Tool, arm: &Calibration, burning: bool) -> Vec<Limit> {
        let (joints, space) = (&self.joints, &self.workspace);
        let lowest_mm = self.table.z_mm + self.tool_length.of(tool);
        let mut limits = Vec::with_capacity(14);
        limits.extend([
            limit("joints.base", Measure::Base, joints.base_deg),
            limit("joints.rear", Measure::Rear, joints.rear_deg),
            limit("joints.fore", Measure::Fore, joints.fore_deg),
            limit("joints.servo", Measure::Servo, joints.servo_deg),
            limit("joints.opening", Measure::Opening, joints.opening_deg),
            limit("workspace.x", Measure::X, space.x_mm),
            limit("workspace.y", Measure::Y, space.y_mm),
            limit("workspace.z", Measure::Z, space.z_mm),
            limit(TABLE, Measure::Z, Bounds::new(lowest_mm, HIGHEST_MM)),
            limit("workspace.reach", Measure::Reach, space.reach_mm),
        ]);
        if arm.table.is_some() {
            limits.push(self.below_paper(tool));
        }
        if burning {
            limits.extend(burning_limits(&self.laser.area));
        }
        limits
    }

    fn below_paper(&self, tool: Tool) -> Limit {
        // The paper was touched with the pen.
        let longer_mm = self.tool_length.of(tool) - self.tool_length.suction_cup_mm;
        let lowest_mm = longer_mm - self.table.below_paper_mm;
        let above = Bounds::new(lowest_mm, HIGHEST_MM);
        limit(BELOW_PAPER, Measure::AboveTable, above)
    }
}

fn burning_limits(area: &Area) -> [Limit; 3] {
    let measures = [Measure::X, Measure::Y, Measure::Z];
    [0, 1, 2].map(|axis| limit(LASER_AREA, measures[axis], area.axes()[axis]))
}

const fn limit(key: &'static str, measure: Measure, bounds: Bounds) -> Limit {
    Limit {
        key,
        measure,
        bounds,
    }
}

/// The upper bound above the table: beyond the arm's reach, so that no other rule is meant.
const HIGHEST_MM: f64 = 1000.0;

/// The key of the rule for the table below the paper.
pub(crate) const BELOW_PAPER: &str = "table.below_paper";

/// The key of the table rule.
pub(crate) const TABLE: &str = "table";

/// The only rule into which a burning laser may not come back from outside.
pub(crate) const LASER_AREA: &str = "laser.area";
