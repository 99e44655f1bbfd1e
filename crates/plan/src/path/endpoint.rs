//! The endpoint of a vector.

use dobot_arm::stock;

use crate::path::commands::write;
use crate::ticks::ticker::Ticker;
use crate::{ArmLimits, DrawingTool, PlannedVector};

/// Computes endpoints: exact increments, or the position of a stock arm in its own arithmetic.
#[derive(Clone, Debug)]
pub(crate) struct Endpoint {
    stock: Option<StockEndpoint>,
}

#[derive(Clone, Debug)]
struct StockEndpoint {
    /// The distance of the tool from the wrist.
    tool_mm: f32,
    /// The state carried from vector to vector.
    ticker: Ticker,
}

impl Endpoint {
    pub(crate) fn new(arm_limits: &ArmLimits, tool: &DrawingTool) -> Self {
        #[expect(clippy::cast_possible_truncation, reason = "as the arm holds it")]
        let tool_mm = tool.reach_mm() as f32;
        let stock = |ticker| StockEndpoint { tool_mm, ticker };
        Self {
            stock: Ticker::of(arm_limits, 0.0).map(stock),
        }
    }

    /// Returns the endpoint of these increments, in mm, as far as it is known without their speeds.
    pub(crate) fn estimate(&self, here: [f64; 3], way: [f32; 3]) -> [f64; 3] {
        match &self.stock {
            Some(endpoint) => stock::behind(here, way, endpoint.tool_mm),
            None => [0, 1, 2].map(|i| here[i] + f64::from(way[i])),
        }
    }

    /// Returns the endpoint of the next vector, in mm. A stock arm sums its ticks in single
    /// precision, which changes a vector by a millionth of a millimetre, thousands of times in the
    /// same direction.
    pub(crate) fn after(&mut self, here: [f64; 3], vector: &PlannedVector) -> [f64; 3] {
        let way = [vector.x_mm, vector.y_mm, vector.z_mm];
        let way = match &mut self.stock {
            Some(endpoint) => endpoint.ticker.displacement_mm(&write(vector)),
            None => way,
        };
        self.estimate(here, way)
    }
}
