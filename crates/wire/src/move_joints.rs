//! The target given as joint angles.

use crate::table::Table;
use crate::{Dialect, Frame, MovingMode, ParseError};

/// Go to joint angles, then set the tool (state 6; Table 3.7).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct MoveJoints {
    /// The base's angle (joint 1) in degrees, counter-clockwise seen from above.
    pub base_deg: f32,
    /// The rear arm's angle (joint 2) in degrees from the vertical, forward positive.
    pub rear_deg: f32,
    /// The forearm's angle (joint 3) in degrees below the horizontal.
    pub fore_deg: f32,
    /// The servo's angle (joint 4) in degrees; 0 is parallel to the forearm (note N19).
    pub servo_deg: f32,
    /// Whether the pump runs after the move.
    pub suction: bool,
    /// The way there.
    pub mode: MovingMode,
    /// The gripper's angle after the move, -90 to 90 degrees.
    pub gripper_deg: f32,
    /// The pause after the move, 0 to 655 seconds (note N10).
    pub pause_s: f32,
}

impl MoveJoints {
    /// Float 1 of this command.
    pub const STATE: f32 = 6.0;

    /// Jumps to base, rear arm, forearm and servo: with the pump off, the gripper at 0, and without a
    /// pause.
    #[must_use]
    pub const fn to([base_deg, rear_deg, fore_deg, servo_deg]: [f32; 4]) -> Self {
        Self {
            base_deg,
            rear_deg,
            fore_deg,
            servo_deg,
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
        TABLE.state(frame, Self::STATE, "6")?;
        Ok(Self {
            base_deg: TABLE.float(frame, 3, "Joint1 angle").finite()?,
            rear_deg: TABLE.float(frame, 4, "Joint2 angle").finite()?,
            fore_deg: TABLE.float(frame, 5, "Joint3 angle").finite()?,
            servo_deg: TABLE.float(frame, 6, "RHead").finite()?,
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
            .with(3, self.base_deg)
            .with(4, self.rear_deg)
            .with(5, self.fore_deg)
            .with(6, self.servo_deg)
            .with(7, f32::from(self.suction))
            .with(8, self.mode.emit(dialect))
            .with(9, self.gripper_deg)
            .with(10, self.pause_s)
    }
}

const TABLE: Table = Table("Table 3.7");
