//! How slow an arm may be, as far as this session has told it.

use std::time::Duration;

use dobot_wire::{Command, Configuration};

/// The speeds and pauses that were configured, to tell a slow arm from a lost one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pace {
    /// Speed and acceleration of the joints, before the percentages.
    joints: (f64, f64),
    servo: (f64, f64),
    line: (f64, f64),
    /// Percentages of speed and acceleration.
    percent: (f64, f64),
    write_mm_s2: f64,
    jump_mm: f64,
    pause: Duration,
}

impl Default for Pace {
    /// As slow as nobody has made an arm on purpose.
    fn default() -> Self {
        Self {
            joints: (2.0, 100.0),
            servo: (2.0, 100.0),
            line: (4.0, 100.0),
            percent: (50.0, 50.0),
            write_mm_s2: 20.0,
            jump_mm: 20.0,
            pause: Duration::ZERO,
        }
    }
}

impl Pace {
    /// Takes note of what a command changes.
    pub(crate) fn note(&mut self, command: &Command) {
        match *command {
            Command::Configuration(Configuration::Playback {
                joint_speed_deg_s,
                joint_acceleration_deg_s2,
                servo_speed_deg_s,
                servo_acceleration_deg_s2,
                linear_speed_mm_s,
                linear_acceleration_mm_s2,
                default_pause_s,
                jump_height_mm,
            }) => {
                self.joints = (joint_speed_deg_s.into(), joint_acceleration_deg_s2.into());
                self.servo = (servo_speed_deg_s.into(), servo_acceleration_deg_s2.into());
                self.line = (linear_speed_mm_s.into(), linear_acceleration_mm_s2.into());
                self.jump_mm = jump_height_mm.into();
                self.pause = seconds(default_pause_s.into());
            }
            Command::Configuration(Configuration::Writing { acceleration_mm_s2 }) => {
                self.write_mm_s2 = acceleration_mm_s2.into();
            }
            Command::PlaybackAdjustment(it) => {
                self.percent = (it.speed_percent.into(), it.acceleration_percent.into());
            }
            _ => {}
        }
    }

    /// The pause of targets that have none.
    pub(crate) const fn default_pause(&self) -> Duration {
        self.pause
    }

    /// How long a command may move the arm at the most.
    pub(crate) fn longest(&self, command: &Command) -> Duration {
        match command {
            Command::MoveTo(_)
            | Command::MoveJoints(_)
            | Command::MouseMove(_)
            | Command::Gesture(_)
            | Command::Voice(_) => self.longest_move(),
            Command::WriteVector(it) if !it.stop => {
                let way_mm = [it.x_mm, it.y_mm, it.z_mm].map(f64::from);
                let way_mm = way_mm.into_iter().map(f64::abs).sum();
                takes(way_mm, it.max_speed_mm_s.into(), self.write_mm_s2)
            }
            _ => Duration::ZERO,
        }
    }

    fn longest_move(&self) -> Duration {
        let [speed, acceleration] = [self.percent.0 / 100.0, self.percent.1 / 100.0];
        let scaled = |way, (most, most_2)| takes(way, most * speed, most_2 * acceleration);
        scaled(LONGEST_TURN_DEG, self.joints)
            .max(scaled(LONGEST_TURN_DEG, self.servo))
            .max(scaled(LONGEST_WAY_MM + 2.0 * self.jump_mm, self.line))
    }
}

/// A way from rest to rest; twice that, to be patient.
fn takes(way: f64, speed: f64, acceleration: f64) -> Duration {
    seconds(2.0 * (way / speed + speed / acceleration))
}

fn seconds(seconds: f64) -> Duration {
    Duration::try_from_secs_f64(seconds).unwrap_or(FOR_EVER)
}

/// Across the whole workspace.
const LONGEST_WAY_MM: f64 = 700.0;
/// From one end of the base to the other.
const LONGEST_TURN_DEG: f64 = 360.0;
/// Many of them added up still are a duration.
const FOR_EVER: Duration = Duration::from_secs(u32::MAX as u64);
