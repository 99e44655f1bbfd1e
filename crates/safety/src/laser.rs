//! The rules for a burning laser.

use dobot_arm::TICK_S;
use dobot_motion::{Model, Trajectory, burns};
use dobot_wire::{Command, WriteVector};

use crate::{Bounds, Policy, Violation};

impl Policy {
    /// Checks that the laser may burn as this command asks, apart from the area.
    pub(crate) fn check_laser(
        &self,
        model: &Model,
        command: &Command,
        trajectory: &Trajectory,
    ) -> Result<(), Violation> {
        let rules = &self.laser;
        if burns(command) && !rules.allowed {
            let message = "the command lights the laser; laser.allowed is false".to_owned();
            return Err(Violation::of_words("laser.allowed", message));
        }
        let is_still =
            burns(command) && !trajectory.moves() || model.laser && trajectory.pause_s() > 0.0;
        if is_still && !rules.standing {
            let message = "the laser would burn while the arm stands; laser.standing is false: light it in a vector, and switch it off before a pause".to_owned();
            return Err(Violation::of_words("laser.standing", message));
        }
        match command {
            Command::WriteVector(vector) if trajectory.laser() => {
                self.check_burning_speed(vector)?;
                self.check_burning_time(trajectory)
            }
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

    fn check_burning_time(&self, trajectory: &Trajectory) -> Result<(), Violation> {
        let found = trajectory.motion_s().unwrap_or_default();
        let allowed = Bounds::new(0.0, self.laser.longest_s);
        if found <= allowed.max + TICK_S {
            return Ok(());
        }
        let name = "the time of a burning vector";
        let violation = Violation::of_value("laser.longest", name, found, allowed, " s");
        let message = format!(
            "{}: cut it into shorter ones that begin and end at its speed",
            violation.message
        );
        Err(Violation {
            message,
            ..violation
        })
    }
}
