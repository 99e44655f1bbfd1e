//! The target given as a point.

use crate::table::Table;
use crate::{Dialect, Frame, MovingMode, ParseError};

/// Go to a point, then set the tool (state 3; Table 3.7).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct MoveTo {
    /// Forward of the base's axis, in millimetres.
    pub x_mm: f32,
    /// To the left of it, in millimetres.
    pub y_mm: f32,
    /// Above the rear arm's pivot, in millimetres.
    pub z_mm: f32,
    /// The end effector's rotation relative to the base, in degrees: servo plus base angle, not the
    /// joint 4 angle.
    pub rotation_deg: f32,
    /// Whether the pump runs after the move.
    pub suction: bool,
    /// The way there.
    pub mode: MovingMode,
    /// The gripper's angle after the move, -90 to 90 degrees.
    pub gripper_deg: f32,
    /// The pause after the move, 0 to 655 seconds (note N10).
    pub pause_s: f32,
}

impl MoveTo {
    /// Float 1 of this command.
    pub const STATE: f32 = 3.0;

    /// Jumps to a point: with the pump off, rotation and gripper at 0, and without a pause.
    ///
    /// ```
    /// # use dobot_wire::{MoveTo, MovingMode};
    /// let over = MoveTo::to(200.0, 0.0, 20.0);
    /// let down = MoveTo::to(200.0, 0.0, -30.0).with_mode(MovingMode::MovL);
    /// let grab = MoveTo { suction: true, pause_s: 0.5, ..down };
    /// ```
    #[must_use]
    pub const fn to(x_mm: f32, y_mm: f32, z_mm: f32) -> Self {
        Self {
            x_mm,
            y_mm,
            z_mm,
            rotation_deg: 0.0,
            suction: false,
            mode: MovingMode::Jump,
            gripper_deg: 0.0,
            pause_s: 0.0,
        }
    }

    /// The same by another way.
    #[must_use]
    pub const fn with_mode(self, mode: MovingMode) -> Self {
        Self { mode, ..self }
    }

    /// Reads the command.
    ///
    /// # Errors
    ///
    /// [`ParseError::OutOfRange`] where a float breaks its range in Table 3.7.
    pub fn parse(frame: &Frame, dialect: &Dialect) -> Result<Self, ParseError> {
        TABLE.state(frame, Self::STATE, "3")?;
        Ok(Self {
            x_mm: TABLE.float(frame, 3, "X").finite()?,
            y_mm: TABLE.float(frame, 4, "Y").finite()?,
            z_mm: TABLE.float(frame, 5, "Z").finite()?,
            rotation_deg: TABLE.float(frame, 6, "RHead").finite()?,
            suction: TABLE.float(frame, 7, "isGrab").switch()?,
            mode: MovingMode::parse(frame, dialect)?,
            gripper_deg: TABLE.float(frame, 9, "GripperValue").gripper()?,
            pause_s: TABLE.float(frame, 10, "PauseTime").pause()?,
        })
    }

    /// Writes the command; `parse` reads it back unchanged.
    #[must_use]
    pub fn emit(&self, dialect: &Dialect) -> Frame {
        Frame::ZERO
            .with(1, Self::STATE)
            .with(3, self.x_mm)
            .with(4, self.y_mm)
            .with(5, self.z_mm)
            .with(6, self.rotation_deg)
            .with(7, f32::from(self.suction))
            .with(8, self.mode.emit(dialect))
            .with(9, self.gripper_deg)
            .with(10, self.pause_s)
    }
}

const TABLE: Table = Table("Table 3.7");
