//! Mouse control.

use crate::table::Table;
use crate::{Dialect, Frame, ParseError, Status};

/// Moves the end effector by a little, as a mouse does (state 1; Table 2.4).
///
/// Float 3 is Y and float 4 is X, in that order: Table 2.4 and Appendix 1 agree. The unit of the
/// increments is the dialect's (note N9): millimetres by the document, units of the mouse on a stock
/// arm.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct MouseMove {
    /// How far along Y; on a stock arm the base swings by -0.225 degrees for each unit.
    pub y: f32,
    /// How far along X; on a stock arm the reach grows by 0.4 mm for each unit.
    pub x: f32,
    /// How far along Z; on a stock arm 0.4 mm for each unit.
    pub z: f32,
    /// The rotation of the end effector, absolute, in degrees (note N9).
    pub rotation_deg: f32,
    /// Whether the pump runs.
    pub suction: bool,
}

impl MouseMove {
    /// Float 1 of this command.
    pub const STATE: f32 = 1.0;

    /// Returns the rotation that leaves the tool of an arm with this status as it is, in degrees (notes N9
    /// and N49).
    #[must_use]
    pub const fn kept_rotation_deg(from: &Status, dialect: Option<Dialect>) -> f32 {
        match dialect {
            Some(dialect) if dialect.mouse_swings => from.servo_deg,
            _ => from.rotation_deg,
        }
    }

    /// Reads the command.
    ///
    /// # Errors
    ///
    /// [`ParseError::OutOfRange`] where a float breaks its range in Table 2.4.
    pub fn parse(frame: &Frame, _: &Dialect) -> Result<Self, ParseError> {
        TABLE.state(frame, Self::STATE, "1")?;
        Ok(Self {
            y: TABLE.float(frame, 3, "Y").finite()?,
            x: TABLE.float(frame, 4, "X").finite()?,
            z: TABLE.float(frame, 5, "Z").finite()?,
            rotation_deg: TABLE.float(frame, 6, "RHead").finite()?,
            suction: TABLE.float(frame, 7, "isGrab").switch()?,
        })
    }

    /// Writes the command; `parse` reads it back unchanged.
    #[must_use]
    pub fn emit(&self, _: &Dialect) -> Frame {
        Frame::ZERO
            .with(1, Self::STATE)
            .with(3, self.y)
            .with(4, self.x)
            .with(5, self.z)
            .with(6, self.rotation_deg)
            .with(7, f32::from(self.suction))
    }
}

const TABLE: Table = Table("Table 2.4");
