//! The status: the only message of the controller.

use crate::table::Table;
use crate::{Frame, ParseError};

/// Where the arm is (Table 2.3); each one received permits one command (note N20).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Status {
    /// Forward of the base's axis, in millimetres.
    pub x_mm: f32,
    /// To the left of it, in millimetres.
    pub y_mm: f32,
    /// Above the rear arm's pivot, in millimetres.
    pub z_mm: f32,
    /// The end effector's rotation relative to the base, in degrees: servo plus base angle.
    pub rotation_deg: f32,
    /// The base's angle in degrees, counter-clockwise seen from above.
    pub base_deg: f32,
    /// The rear arm's angle in degrees from the vertical, forward positive.
    pub rear_deg: f32,
    /// The forearm's angle in degrees below the horizontal.
    pub fore_deg: f32,
    /// The servo's angle in degrees.
    pub servo_deg: f32,
    /// Whether the pump runs; the laser does not show (note N21).
    pub suction: bool,
    /// The gripper's angle in degrees.
    pub gripper_deg: f32,
}

impl Status {
    /// All joint angles are 0: the rear arm is upright and the forearm level.
    pub const AT_ZERO: Self = Self {
        x_mm: 215.07,
        y_mm: 0.0,
        z_mm: 135.0,
        rotation_deg: 0.0,
        base_deg: 0.0,
        rear_deg: 0.0,
        fore_deg: 0.0,
        servo_deg: 0.0,
        suction: false,
        gripper_deg: 0.0,
    };

    /// Reads the status.
    ///
    /// # Errors
    ///
    /// [`ParseError::OutOfRange`] where a float is not finite, or isGrab not 0 or 1 (Table 2.3).
    pub fn parse(frame: &Frame) -> Result<Self, ParseError> {
        Ok(Self {
            x_mm: TABLE.float(frame, 1, "X").finite()?,
            y_mm: TABLE.float(frame, 2, "Y").finite()?,
            z_mm: TABLE.float(frame, 3, "Z").finite()?,
            rotation_deg: TABLE.float(frame, 4, "rHead").finite()?,
            base_deg: TABLE.float(frame, 5, "baseAngle").finite()?,
            rear_deg: TABLE.float(frame, 6, "longArmAngle").finite()?,
            fore_deg: TABLE.float(frame, 7, "shortArmAngle").finite()?,
            servo_deg: TABLE.float(frame, 8, "pawArmAngle").finite()?,
            suction: TABLE.float(frame, 9, "isGrab").switch()?,
            gripper_deg: TABLE.float(frame, 10, "GripperAngle").finite()?,
        })
    }

    /// The status in a message of the Bluetooth port, which permits no command: the same with
    /// 1000 mm less in X (note N38). No arm reaches an X of 500 mm.
    #[must_use]
    pub fn message(self) -> Option<Self> {
        (self.x_mm > 500.0).then_some(Self {
            x_mm: self.x_mm - 1000.0,
            ..self
        })
    }

    /// Writes the status; `parse` reads it back unchanged.
    #[must_use]
    pub fn emit(&self) -> Frame {
        Frame::ZERO
            .with(1, self.x_mm)
            .with(2, self.y_mm)
            .with(3, self.z_mm)
            .with(4, self.rotation_deg)
            .with(5, self.base_deg)
            .with(6, self.rear_deg)
            .with(7, self.fore_deg)
            .with(8, self.servo_deg)
            .with(9, f32::from(self.suction))
            .with(10, self.gripper_deg)
    }
}

const TABLE: Table = Table("Table 2.3");
