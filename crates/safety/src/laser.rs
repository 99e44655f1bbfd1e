//! When the laser may burn.

use dobot_course::{Button, Course, Model};
use dobot_wire::{Command, WriteVector};

use crate::{Bounds, Policy, Violation};

/// Whether a command lights the laser, in whatever form: jog axis 13, or a write vector with its laser
/// switch on, the stop of stock arms and the writing mode included.
///
/// Such a command may be sent only while a person has armed the laser.
///
/// ```
/// use dobot_safety::burns;
/// use dobot_wire::{Command, JointJog, JointJogAxis};
///
/// let button = |axis| Command::from(JointJog { axis, speed_percent: 0.0 });
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

impl Policy {
    /// Whether the laser may burn as this command wants it, the area not looked at.
    pub(crate) fn check_laser(
        &self,
        model: &Model,
        command: &Command,
        course: &Course,
    ) -> Result<(), Violation> {
        let rules = &self.laser;
        if burns(command) && !rules.allowed {
            let message = "the command lights the laser; laser.allowed is false".to_owned();
            return Err(Violation::of_words("laser.allowed", message));
        }
        let stands = burns(command) && !course.moves() || model.laser && course.pause_s() > 0.0;
        if stands && !rules.standing {
            let message = "the laser would burn while the arm stands; laser.standing is false: light it in a vector, and switch it off before a pause".to_owned();
            return Err(Violation::of_words("laser.standing", message));
        }
        match command {
            Command::WriteVector(vector) if course.laser() => self.check_burning_speed(vector),
            _ => Ok(()),
        }
    }

    fn check_burning_speed(&self, vector: &WriteVector) -> Result<(), Violation> {
        let found = f64::from(vector.max_speed_mm_s);
        let allowed = Bounds::new(self.laser.least_speed_mm_s, self.speed.writing_mm_s);
        if allowed.contains(found) {
            return Ok(());
        }
        let name = "the largest speed of a burning vector";
        Err(Violation::of_value(
            "laser.least_speed",
            name,
            found,
            allowed,
            " mm/s",
        ))
    }
}
