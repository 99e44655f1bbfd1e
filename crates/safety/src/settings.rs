//! The check of speeds, accelerations and the JUMP height against their ceilings.

use dobot_motion::{ArmSettings, JogAxis, Model, Speeds, Trajectory};
use dobot_wire::{Command, Configuration, MovingMode, WriteVector};

use crate::{Bounds, Policy, Violation};

impl Policy {
    /// Checks that what a command sets or uses is within the ceilings.
    pub(crate) fn check_settings(
        &self,
        model: &Model,
        command: &Command,
        trajectory: &Trajectory,
    ) -> Result<(), Violation> {
        let settings = model.begun(command).settings;
        let moves = settings.move_speeds();
        match command {
            Command::Configuration(configuration) => {
                self.check_configuration(configuration, &settings)
            }
            Command::PlaybackAdjustment(_) => self.check_speeds(&moves),
            Command::MoveTo(target) => self.check_target(target.mode, &settings),
            Command::MoveJoints(target) => self.check_target(target.mode, &settings),
            Command::WriteVector(vector) => self.check_vector(vector, &settings),
            Command::JointJog(jog) => self.check_jog_speed(jog.speed_percent, trajectory),
            Command::LinearJog(jog) => self.check_jog_speed(jog.speed_percent, trajectory),
            Command::MouseMove(_) if model.dialect.mouse_swings => self.check_followed(trajectory),
            Command::Gesture(_) if model.dialect.scales_gesture => self.check_followed(trajectory),
            Command::MouseMove(_) | Command::Gesture(_) | Command::Voice(_) => {
                self.check_line(&moves)
            }
        }
    }

    /// Checks the distance of a spoken order, which may have been misunderstood.
    ///
    /// # Errors
    ///
    /// [`Violation`] of the rule `voice.largest`.
    pub fn check_spoken(&self, distance_mm: f64) -> Result<(), Violation> {
        let most_mm = self.voice.largest_mm;
        at_most(
            "voice.largest",
            "the distance of a spoken order",
            distance_mm,
            most_mm,
            " mm",
        )
    }

    fn check_configuration(
        &self,
        configuration: &Configuration,
        settings: &ArmSettings,
    ) -> Result<(), Violation> {
        match configuration {
            Configuration::Teach { .. } => {
                self.check_speeds(&settings.teach.scaled(self.speed.jog_percent, 100.0))
            }
            Configuration::Playback { .. } => {
                self.check_jump(settings)?;
                self.check_speeds(&settings.move_speeds())
            }
            Configuration::Writing { .. } => self.check_writing(settings),
            Configuration::InitialAngles { .. } | Configuration::EndEffector { .. } => Ok(()),
        }
    }

    fn check_target(&self, mode: MovingMode, settings: &ArmSettings) -> Result<(), Violation> {
        let speeds = settings.move_speeds();
        match mode {
            MovingMode::MovJ => self.check_joints(&speeds),
            MovingMode::MovL => self.check_line(&speeds),
            MovingMode::Jump => {
                self.check_jump(settings)?;
                self.check_speeds(&speeds)
            }
        }
    }

    fn check_vector(&self, vector: &WriteVector, settings: &ArmSettings) -> Result<(), Violation> {
        let speed_mm_s = vector.max_speed_mm_s.into();
        at_most(
            "speed.writing",
            "the largest speed",
            speed_mm_s,
            self.speed.writing_mm_s,
            " mm/s",
        )?;
        self.check_writing(settings)
    }

    fn check_jog_speed(&self, percent: f32, trajectory: &Trajectory) -> Result<(), Violation> {
        let Some(jog) = trajectory.jog() else {
            return Ok(());
        };
        let (speed, most) = (&self.speed, &self.acceleration);
        at_most(
            "speed.jog",
            "the speed of the jog",
            percent.into(),
            speed.jog_percent,
            " %",
        )?;
        let [key, acceleration_key, unit, unit_2] = match jog.axis() {
            JogAxis::Base | JogAxis::Rear | JogAxis::Fore => {
                ["speed.joint", "acceleration.joint", "°/s", "°/s²"]
            }
            JogAxis::Servo | JogAxis::Gripper => {
                ["speed.servo", "acceleration.servo", "°/s", "°/s²"]
            }
            JogAxis::X | JogAxis::Y | JogAxis::Z => {
                ["speed.line", "acceleration.line", " mm/s", " mm/s²"]
            }
        };
        let (fastest, steepest) = match jog.axis() {
            JogAxis::Base | JogAxis::Rear | JogAxis::Fore => (speed.joint_deg_s, most.joint_deg_s2),
            JogAxis::Servo | JogAxis::Gripper => (speed.servo_deg_s, most.servo_deg_s2),
            JogAxis::X | JogAxis::Y | JogAxis::Z => (speed.line_mm_s, most.line_mm_s2),
        };
        at_most(
            key,
            "the speed of the jog",
            jog.target_speed().abs(),
            fastest,
            unit,
        )?;
        let name = "the acceleration of the jog";
        at_most(acceleration_key, name, jog.acceleration(), steepest, unit_2)
    }

    /// A stock arm follows mouse and hand packets with all joints at a constant speed of its own.
    fn check_followed(&self, trajectory: &Trajectory) -> Result<(), Violation> {
        let duration_s = trajectory.motion_s().unwrap_or_default();
        let ends = [trajectory.place_at(0.0), trajectory.place_at(duration_s)];
        let [Ok(from), Ok(to)] = ends.map(|ends| ends.map(|place| place.joints)) else {
            return Ok(()); // The way is checked besides.
        };
        let ways = [
            to.base - from.base,
            to.rear - from.rear,
            to.fore - from.fore,
        ];
        let longest_deg = ways.iter().fold(0.0, |most, way| way.abs().0.max(most));
        if longest_deg == 0.0 {
            return Ok(());
        }
        let found = longest_deg / duration_s;
        at_most(
            "speed.joint",
            "the joint speed",
            found,
            self.speed.joint_deg_s,
            "°/s",
        )
    }

    fn check_speeds(&self, speeds: &Speeds) -> Result<(), Violation> {
        self.check_joints(speeds)?;
        self.check_line(speeds)
    }

    fn check_joints(&self, found: &Speeds) -> Result<(), Violation> {
        let (speed, most) = (&self.speed, &self.acceleration);
        at_most(
            "speed.joint",
            "the joint speed",
            found.joint_deg_s,
            speed.joint_deg_s,
            "°/s",
        )?;
        let name = "the joint acceleration";
        at_most(
            "acceleration.joint",
            name,
            found.joint_deg_s2,
            most.joint_deg_s2,
            "°/s²",
        )?;
        self.check_servo(found)
    }

    fn check_servo(&self, found: &Speeds) -> Result<(), Violation> {
        let (speed, most) = (&self.speed, &self.acceleration);
        at_most(
            "speed.servo",
            "the servo speed",
            found.servo_deg_s,
            speed.servo_deg_s,
            "°/s",
        )?;
        let name = "the servo acceleration";
        at_most(
            "acceleration.servo",
            name,
            found.servo_deg_s2,
            most.servo_deg_s2,
            "°/s²",
        )
    }

    fn check_line(&self, found: &Speeds) -> Result<(), Violation> {
        let (speed, most) = (&self.speed, &self.acceleration);
        at_most(
            "speed.line",
            "the line speed",
            found.line_mm_s,
            speed.line_mm_s,
            " mm/s",
        )?;
        let name = "the line acceleration";
        at_most(
            "acceleration.line",
            name,
            found.line_mm_s2,
            most.line_mm_s2,
            " mm/s²",
        )?;
        self.check_servo(found)
    }

    fn check_writing(&self, settings: &ArmSettings) -> Result<(), Violation> {
        let found = settings.write_acceleration_mm_s2;
        let most = self.acceleration.writing_mm_s2;
        at_most(
            "acceleration.writing",
            "the writing acceleration",
            found,
            most,
            " mm/s²",
        )
    }

    fn check_jump(&self, settings: &ArmSettings) -> Result<(), Violation> {
        let found = settings.jump_height.0;
        at_most(
            "jump.height",
            "the height of a jump",
            found,
            self.jump.height_mm,
            " mm",
        )
    }
}

fn at_most(key: &str, name: &str, found: f64, most: f64, unit: &str) -> Result<(), Violation> {
    if found <= most * (1.0 + ROUNDING) {
        return Ok(());
    }
    let allowed = Bounds::new(0.0, most);
    Err(Violation::of_value(key, name, found, allowed, unit))
}

/// The wire uses single precision, and percentages are multiplied.
const ROUNDING: f64 = 1e-6;
