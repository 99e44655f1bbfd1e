//! Playback adjustment.

use crate::table::Table;
use crate::{Dialect, Frame, ParseError};

/// Scales the configured speeds and accelerations (state 10; Table 3.9).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct PlaybackAdjustment {
    /// The speed of targets in percent of the configured one, above 0 to 100.
    pub speed_percent: f32,
    /// The acceleration of targets in percent of the configured one, above 0 to 100.
    pub acceleration_percent: f32,
    /// The speed of jogs in percent, above 0 to 100; each jog carries its own too (note N15).
    pub teach_speed_percent: f32,
}

impl PlaybackAdjustment {
    /// Float 1 of this command.
    pub const STATE: f32 = 10.0;

    /// Reads the command; the dialect defines which of floats 3 and 4 is the speed (note N3).
    ///
    /// # Errors
    ///
    /// [`ParseError::OutOfRange`] where a float breaks its range in Table 3.9.
    pub fn parse(frame: &Frame, dialect: &Dialect) -> Result<Self, ParseError> {
        TABLE.state(frame, Self::STATE, "10")?;
        TABLE.float(frame, 2, "mode").code(&[()], "0")?;
        let (speed, acceleration) = dialect.adjustment_floats();
        let percent = |n, name| TABLE.float(frame, n, name).percent();
        Ok(Self {
            speed_percent: percent(speed, "playback speed")?,
            acceleration_percent: percent(acceleration, "playback acceleration")?,
            teach_speed_percent: percent(5, "teaching speed")?,
        })
    }

    /// Writes the command; `parse` reads it back unchanged.
    #[must_use]
    pub fn emit(&self, dialect: &Dialect) -> Frame {
        let (speed, acceleration) = dialect.adjustment_floats();
        Frame::ZERO
            .with(1, Self::STATE)
            .with(speed, self.speed_percent)
            .with(acceleration, self.acceleration_percent)
            .with(5, self.teach_speed_percent)
    }
}

impl Dialect {
    /// The numbers of the floats that hold speed and acceleration (note N3).
    const fn adjustment_floats(&self) -> (usize, usize) {
        if self.adjusts_speed_first {
            (3, 4)
        } else {
            (4, 3)
        }
    }
}

const TABLE: Table = Table("Table 3.9");
