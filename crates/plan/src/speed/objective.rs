//! The objective of speed planning.

use crate::DrawingTool;

/// The objective of speed planning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Objective {
    /// Even motion with the target times and speeds, for a laser.
    Even,
    /// Minimum time, for a pen. The positions at the ticks show whether it turns too fast.
    Fast,
}

impl Objective {
    pub(crate) const fn of(tool: &DrawingTool) -> Self {
        if tool.burns() { Self::Even } else { Self::Fast }
    }
}
