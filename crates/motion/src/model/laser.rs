//! Detection of commands that switch the laser.

use dobot_wire::{Command, JointJog, JointJogAxis, WriteMode, WriteVector};

use crate::{Button, Model};

/// Whether a command switches the laser on: jog axis 13, or a write vector with its laser switch
/// on, including the stop of stock arms and the writing mode.
///
/// Such commands may be sent only while a person has armed the laser.
///
/// ```
/// use dobot_motion::burns;
/// use dobot_wire::{Command, JointJog, JointJogAxis};
///
/// let button = |axis| Command::from(JointJog::new(axis, 0.0));
/// assert!(burns(&button(JointJogAxis::LaserOn)));
/// assert!(!burns(&button(JointJogAxis::LaserOff)));
/// ```
#[must_use]
pub fn burns(command: &Command) -> bool {
    match command {
        Command::WriteVector(vector) => vector.laser,
        _ => Button::of(command) == Some(Button::Laser(true)),
    }
}

/// The command that only switches the laser off: jog axis 14 (Table 2.5).
pub const LASER_OFF: Command = Command::JointJog(JointJog::new(JointJogAxis::LaserOff, 0.0));

impl Model {
    /// Whether the laser burns during a vector.
    pub(crate) const fn laser_during(&self, vector: &WriteVector) -> bool {
        if vector.stop {
            return self.dialect.has_rapid_laser_mode
                && matches!(vector.mode, WriteMode::Laser)
                && vector.laser;
        }
        match vector.mode {
            WriteMode::Laser => vector.laser,
            WriteMode::Writing => self.dialect.has_rapid_laser_mode && self.laser,
        }
    }
}
