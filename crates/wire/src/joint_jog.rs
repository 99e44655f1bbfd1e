//! Joint jog.

use crate::{Dialect, Frame, ParseError, jog};

/// Moves one joint while a button is held (state 2; Tables 3.5 and 2.5).
///
/// The arm keeps moving until the next jog packet: there is no dead-man in it
/// (note N13).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct JointJog {
    /// The axis or switch of the button.
    pub axis: JointJogAxis,
    /// The speed in percent of the largest: 1 to 100, and 0 too for a release or a switch.
    pub speed_percent: f32,
}

impl JointJog {
    /// Float 1 of this command.
    pub const STATE: f32 = 2.0;

    /// Presses or releases a button.
    #[must_use]
    pub const fn new(axis: JointJogAxis, speed_percent: f32) -> Self {
        Self {
            axis,
            speed_percent,
        }
    }

    /// The jog that moves over the Bluetooth port what this one moves over USB, and the other way
    /// round: base and rear arm change places, and the two directions of the forearm (note N38).
    #[must_use]
    pub const fn over_bluetooth(self) -> Self {
        use JointJogAxis as A;
        let axis = match self.axis {
            A::BasePlus => A::RearPlus,
            A::BaseMinus => A::RearMinus,
            A::RearPlus => A::BasePlus,
            A::RearMinus => A::BaseMinus,
            A::ForePlus => A::ForeMinus,
            A::ForeMinus => A::ForePlus,
            axis => axis,
        };
        Self { axis, ..self }
    }

    /// Reads the command.
    ///
    /// # Errors
    ///
    /// [`ParseError::OutOfRange`] where a float breaks its range in Table 3.5 or Table 2.5.
    pub fn parse(frame: &Frame, _: &Dialect) -> Result<Self, ParseError> {
        jog::TABLE.state(frame, Self::STATE, "2")?;
        let (axis, speed_percent) = jog::parse(frame, &JointJogAxis::ALL)?;
        Ok(Self::new(axis, speed_percent))
    }

    /// Writes the command; `parse` reads it back unchanged.
    #[must_use]
    pub fn emit(&self, _: &Dialect) -> Frame {
        jog::emit(Self::STATE, self.axis as u8, self.speed_percent)
    }
}

/// The axis or switch of a joint jog button (Table 2.5; note N14).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[repr(u8)]
pub enum JointJogAxis {
    /// The button is released.
    Released = 0,
    /// The base, counter-clockwise seen from above.
    BasePlus = 1,
    /// The base, clockwise.
    BaseMinus = 2,
    /// The rear arm, forward.
    RearPlus = 3,
    /// The rear arm, back.
    RearMinus = 4,
    /// The forearm, down.
    ForePlus = 5,
    /// The forearm, up.
    ForeMinus = 6,
    /// The servo, counter-clockwise.
    ServoPlus = 7,
    /// The servo, clockwise.
    ServoMinus = 8,
    /// The pump on.
    SuctionOn = 9,
    /// The pump off.
    SuctionOff = 10,
    /// The gripper opens.
    GripperOpen = 11,
    /// The gripper closes.
    GripperClose = 12,
    /// The laser on.
    LaserOn = 13,
    /// The laser off.
    LaserOff = 14,
}

impl JointJogAxis {
    /// All fifteen, in the order of Table 2.5.
    pub const ALL: [Self; 15] = [
        Self::Released,
        Self::BasePlus,
        Self::BaseMinus,
        Self::RearPlus,
        Self::RearMinus,
        Self::ForePlus,
        Self::ForeMinus,
        Self::ServoPlus,
        Self::ServoMinus,
        Self::SuctionOn,
        Self::SuctionOff,
        Self::GripperOpen,
        Self::GripperClose,
        Self::LaserOn,
        Self::LaserOff,
    ];

    /// Whether something moves for as long as the button is held: all but the release and the
    /// switches of pump and laser.
    #[must_use]
    pub const fn moves(self) -> bool {
        jog::moves(self as u8)
    }
}
