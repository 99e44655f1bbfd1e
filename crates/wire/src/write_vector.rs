//! Writing and laser.

use crate::table::Table;
use crate::{Dialect, Frame, ParseError};

/// Draws a straight line to a point given relative to this one (state 4; Table 2.6).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct WriteVector {
    /// Pen or laser.
    pub mode: WriteMode,
    /// How far along X in the arm's frame, in millimetres, whatever the dialect's sign (note N4).
    pub x_mm: f32,
    /// How far along Y, in millimetres.
    pub y_mm: f32,
    /// How far along Z, in millimetres.
    pub z_mm: f32,
    /// Whether the laser is on.
    pub laser: bool,
    /// The speed at the start, 0 or above, in mm/s (note N5).
    pub start_speed_mm_s: f32,
    /// The speed at the end, 0 or above, in mm/s.
    pub end_speed_mm_s: f32,
    /// The largest speed on the way, above 0, in mm/s.
    pub max_speed_mm_s: f32,
    /// Laser off and no motion; only some dialects have it (note N7).
    pub stop: bool,
}

impl WriteVector {
    /// Float 1 of this command.
    pub const STATE: f32 = 4.0;

    /// Moves the pen by this vector, from rest to rest.
    ///
    /// ```
    /// # use dobot_wire::{WriteMode, WriteVector};
    /// let stroke = WriteVector::by(0.0, 20.0, 0.0, 40.0);
    /// assert_eq!(stroke.burning().mode, WriteMode::Laser);
    /// let through = WriteVector { end_speed_mm_s: 40.0, ..stroke };
    /// ```
    #[must_use]
    pub const fn by(x_mm: f32, y_mm: f32, z_mm: f32, max_speed_mm_s: f32) -> Self {
        Self {
            mode: WriteMode::Writing,
            x_mm,
            y_mm,
            z_mm,
            laser: false,
            start_speed_mm_s: 0.0,
            end_speed_mm_s: 0.0,
            max_speed_mm_s,
            stop: false,
        }
    }

    /// The same with the laser, which is on.
    #[must_use]
    pub const fn burning(self) -> Self {
        Self {
            mode: WriteMode::Laser,
            laser: true,
            ..self
        }
    }

    /// Reads the command.
    ///
    /// # Errors
    ///
    /// [`ParseError::OutOfRange`] where a float breaks its range in Table 2.6, or where the vector
    /// has no length and is not a stop (note N16).
    pub fn parse(frame: &Frame, dialect: &Dialect) -> Result<Self, ParseError> {
        TABLE.state(frame, Self::STATE, "4")?;
        let stop = parse_stop(frame, dialect)?;
        let vector = Self {
            mode: WriteMode::parse(frame)?,
            x_mm: dialect.write_x(TABLE.float(frame, 3, "X").finite()?),
            y_mm: TABLE.float(frame, 4, "Y").finite()?,
            z_mm: TABLE.float(frame, 5, "Z").finite()?,
            laser: TABLE.float(frame, 7, "isLaser").switch()?,
            start_speed_mm_s: TABLE.float(frame, 8, "StartVel").not_negative()?,
            end_speed_mm_s: TABLE.float(frame, 9, "EndVel").not_negative()?,
            max_speed_mm_s: parse_max_speed(frame, stop)?,
            stop,
        };
        vector.check_length()?;
        Ok(vector)
    }

    /// Writes the command; `parse` reads it back unchanged.
    ///
    /// A `stop` is written whatever the dialect: one that has none refuses it (note N7).
    #[must_use]
    pub fn emit(&self, dialect: &Dialect) -> Frame {
        Frame::ZERO
            .with(1, Self::STATE)
            .with(2, self.mode.emit())
            .with(3, dialect.write_x(self.x_mm))
            .with(4, self.y_mm)
            .with(5, self.z_mm)
            .with(6, f32::from(self.stop))
            .with(7, f32::from(self.laser))
            .with(8, self.start_speed_mm_s)
            .with(9, self.end_speed_mm_s)
            .with(10, self.max_speed_mm_s)
    }

    /// The longest of the three parts must be longer than what a stock arm takes for nothing.
    fn check_length(&self) -> Result<(), ParseError> {
        let longest = self.x_mm.abs().max(self.y_mm.abs()).max(self.z_mm.abs());
        let float = Table("note N16").value(3, "longest of X, Y, Z", longest);
        let good = |longest| self.stop || longest > SHORTEST_MM;
        float.only(good, "more than 0.0001 (mm)").map(|_| ())
    }
}

impl Dialect {
    /// Turns X of the frame into X of the arm, and back, without a negative zero (note N4).
    fn write_x(&self, x_mm: f32) -> f32 {
        if self.reverses_write_x {
            0.0 - x_mm
        } else {
            x_mm
        }
    }
}

/// Pen or laser (float 2 of state 4; Table 2.6).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[repr(u8)]
pub enum WriteMode {
    /// A pen.
    Writing = 0,
    /// The laser.
    Laser = 1,
}

impl WriteMode {
    fn parse(frame: &Frame) -> Result<Self, ParseError> {
        let choices = [Self::Writing, Self::Laser];
        TABLE
            .float(frame, 2, "mode")
            .code(&choices, "0 (writing) or 1 (laser)")
    }

    fn emit(self) -> f32 {
        f32::from(self as u8)
    }
}

fn parse_stop(frame: &Frame, dialect: &Dialect) -> Result<bool, ParseError> {
    if dialect.has_write_stop {
        return Table("note N7").float(frame, 6, "stop").switch();
    }
    TABLE.float(frame, 6, "reserved").code(&[false], "0")
}

/// A stop needs no speed.
fn parse_max_speed(frame: &Frame, stop: bool) -> Result<f32, ParseError> {
    let speed = TABLE.float(frame, 10, "MaxVel");
    if stop {
        speed.not_negative()
    } else {
        speed.positive()
    }
}

const TABLE: Table = Table("Table 2.6");

const SHORTEST_MM: f32 = 0.0001;
