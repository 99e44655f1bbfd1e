//! What matters where speeds are chosen.

use crate::DrawingTool;

/// What matters where speeds are chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Objective {
    /// That the way is run evenly, with the times and the speeds wanted: for what has to keep its speed, as a laser has.
    Even,
    /// That the way is over soon: for a pen. Whether it turns too fast in ticks is told by where they lie.
    Fast,
}

impl Objective {
    pub(crate) const fn of(tool: &DrawingTool) -> Self {
        if tool.burns() { Self::Even } else { Self::Fast }
    }
}
