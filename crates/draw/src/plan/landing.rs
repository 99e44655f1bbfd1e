//! Where a vector leads.

use dobot_arm::stock::{Pose, forward, inverse};

use super::{Machine, Tool};

/// Where a vector leads: exactly its increments further, or to where a stock arm takes itself to
/// be then. That calculates in single precision and begins each vector from its own rounded pose:
/// a hundredth of a micrometre short each time, always in the same direction, half a millimetre in a
/// drawing of 50,000 vectors.
#[derive(Clone, Copy, Debug)]
pub(super) struct Landing {
    /// How far the tool reaches beyond the wrist, where the arm is a stock arm.
    stock_tool_mm: Option<f32>,
}

impl Landing {
    pub(super) fn new(machine: &Machine, tool: &Tool) -> Self {
        #[expect(clippy::cast_possible_truncation, reason = "as the arm holds it")]
        let stock_tool_mm = machine.has_ticks.then_some(tool.reach_mm() as f32);
        Self { stock_tool_mm }
    }

    /// Where these increments lead from here, in mm.
    pub(super) fn of(self, here: [f64; 3], way: [f32; 3]) -> [f64; 3] {
        let Some(tool_mm) = self.stock_tool_mm else {
            return [0, 1, 2].map(|i| here[i] + f64::from(way[i]));
        };
        #[expect(clippy::cast_possible_truncation, reason = "as the arm holds it")]
        let [x_mm, y_mm, z_mm] = [0, 1, 2].map(|i| here[i] as f32 + way[i]);
        let wanted = Pose {
            x_mm,
            y_mm,
            z_mm,
            rotation_deg: 0.0,
        };
        let pose = forward(inverse(wanted, tool_mm), tool_mm);
        let found = [pose.x_mm, pose.y_mm, pose.z_mm];
        if found.iter().all(|it| it.is_finite()) {
            found.map(f64::from)
        } else {
            // Out of reach; whoever checks that is to see where it would lead.
            [x_mm, y_mm, z_mm].map(f64::from)
        }
    }
}
