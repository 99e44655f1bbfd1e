//! Gesture control.

use crate::table::Table;
use crate::{Dialect, Frame, ParseError};

/// Follows a hand (state 8; the document only names it, note N18 describes it).
///
/// The unit of the position is the dialect's (note N18): millimetres by the document as we read it,
/// units of the hand tracker on a stock arm.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Gesture {
    /// The hand's position along X.
    pub x: f32,
    /// The hand's position along Y.
    pub y: f32,
    /// The hand's position along Z.
    pub z: f32,
    /// Whether the hand is closed: pump and gripper act together.
    pub grab: bool,
}

impl Gesture {
    /// Float 1 of this command.
    pub const STATE: f32 = 8.0;

    /// Reads the command.
    ///
    /// # Errors
    ///
    /// [`ParseError::OutOfRange`] where a float breaks its range in note N18.
    pub fn parse(frame: &Frame, _: &Dialect) -> Result<Self, ParseError> {
        TABLE.state(frame, Self::STATE, "8")?;
        Ok(Self {
            x: TABLE.float(frame, 3, "X").finite()?,
            y: TABLE.float(frame, 4, "Y").finite()?,
            z: TABLE.float(frame, 5, "Z").finite()?,
            grab: TABLE.float(frame, 7, "isGrab").switch()?,
        })
    }

    /// Writes the command; `parse` reads it back unchanged.
    #[must_use]
    pub fn emit(&self, _: &Dialect) -> Frame {
        Frame::ZERO
            .with(1, Self::STATE)
            .with(3, self.x)
            .with(4, self.y)
            .with(5, self.z)
            .with(7, f32::from(self.grab))
    }
}

const TABLE: Table = Table("note N18");
