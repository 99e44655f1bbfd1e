//! The three ways to a target.

use crate::table::Table;
use crate::{Dialect, Frame, ParseError};

/// The way to a target (float 8 of states 3 and 6; Table 3.7).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum MovingMode {
    /// Lift, move across, lower (note N11).
    Jump,
    /// A straight line of the end effector (note N12).
    MovL,
    /// All joints start and stop together.
    MovJ,
}

impl MovingMode {
    /// Reads float 8.
    pub(crate) fn parse(frame: &Frame, dialect: &Dialect) -> Result<Self, ParseError> {
        if dialect.codes_movj_before_movl {
            let float = Table("note N2").float(frame, 8, "MovingMode");
            let choices = [Self::Jump, Self::MovJ, Self::MovL];
            return float.code(&choices, "0 (jump), 1 (joint) or 2 (linear)");
        }
        let float = Table("Table 3.7").float(frame, 8, "MovingMode");
        let choices = [Self::Jump, Self::MovL, Self::MovJ];
        float.code(&choices, "0 (jump), 1 (linear) or 2 (joint)")
    }

    /// Writes float 8.
    pub(crate) const fn emit(self, dialect: &Dialect) -> f32 {
        match (self, dialect.codes_movj_before_movl) {
            (Self::Jump, _) => 0.0,
            (Self::MovL, false) | (Self::MovJ, true) => 1.0,
            (Self::MovJ, false) | (Self::MovL, true) => 2.0,
        }
    }
}
