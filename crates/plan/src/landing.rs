//! Where a vector leads.

use dobot_arm::stock;

use crate::{DrawingTool, Machine};

/// Where a vector leads: exactly its increments further, or to where a stock arm takes itself to
/// be then.
#[derive(Clone, Copy, Debug)]
pub(super) struct Landing {
    /// How far the tool reaches beyond the wrist, where the arm is a stock arm.
    stock_tool_mm: Option<f32>,
}

impl Landing {
    pub(super) fn new(machine: &Machine, tool: &DrawingTool) -> Self {
        #[expect(clippy::cast_possible_truncation, reason = "as the arm holds it")]
        let stock_tool_mm = machine.has_ticks.then_some(tool.reach_mm() as f32);
        Self { stock_tool_mm }
    }

    /// Where these increments lead from here, in mm.
    pub(super) fn of(self, here: [f64; 3], way: [f32; 3]) -> [f64; 3] {
        match self.stock_tool_mm {
            Some(tool_mm) => stock::behind(here, way, tool_mm),
            None => [0, 1, 2].map(|i| here[i] + f64::from(way[i])),
        }
    }
}
