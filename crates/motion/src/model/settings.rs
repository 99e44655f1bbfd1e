//! The settings from configuration commands.

use crate::Speeds;
use dobot_arm::Millimeters;
use dobot_wire::{Command, Configuration, Dialect, PlaybackAdjustment, single};

/// The settings from configuration commands (states 9 and 10; Table 3.9).
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ArmSettings {
    /// The speeds of point-to-point moves, before percentages.
    pub playback: Speeds,
    /// The percentage of the speeds of point-to-point moves, above 0 to 100.
    pub speed_percent: f64,
    /// The percentage of their accelerations, above 0 to 100.
    pub acceleration_percent: f64,
    /// The percentage of all jogs, above 0 to 100; each jog has its own percentage as well (note
    /// N15).
    pub teach_percent: f64,
    /// The jog speeds at 100 %.
    pub teach: Speeds,
    /// The acceleration of write vectors in mm/s2.
    pub write_acceleration_mm_s2: f64,
    /// The lift of a JUMP.
    pub jump_height: Millimeters,
    /// The pause of targets without one, in seconds, if the dialect has it (note N10).
    pub default_pause_s: f64,
}

impl ArmSettings {
    /// Returns the settings at power-up.
    #[must_use]
    pub fn stock(dialect: &Dialect) -> Self {
        Self {
            playback: Speeds::STOCK,
            speed_percent: 50.0,
            acceleration_percent: 50.0,
            teach_percent: 100.0,
            teach: Speeds::new([15.0, 50.0, 30.0, 50.0, 60.0, 60.0]),
            write_acceleration_mm_s2: 100.0,
            jump_height: Millimeters(dialect.default_jump_height_mm.into()),
            default_pause_s: 0.0,
        }
    }

    /// Returns the speeds of point-to-point moves with percentages applied.
    #[must_use]
    pub const fn move_speeds(&self) -> Speeds {
        self.playback
            .scaled(self.speed_percent, self.acceleration_percent)
    }

    /// Applies a playback adjustment (state 10).
    pub(crate) fn adjust(&mut self, adjustment: &PlaybackAdjustment, dialect: &Dialect) {
        self.speed_percent = adjustment.speed_percent.into();
        self.acceleration_percent = adjustment.acceleration_percent.into();
        if dialect.scales_jogs {
            self.teach_percent = adjustment.teach_speed_percent.into();
        }
    }

    /// Applies the speeds, heights and pauses of a configuration (state 9, modes 0 to 2).
    pub(crate) fn configure(&mut self, configuration: &Configuration) {
        let speeds = configuration.speeds().unwrap_or_default();
        let speeds = Speeds::new(speeds.map(f64::from));
        match *configuration {
            Configuration::Teach { .. } => self.teach = speeds,
            Configuration::Playback {
                default_pause_s,
                jump_height_mm,
                ..
            } => {
                self.playback = speeds;
                self.default_pause_s = default_pause_s.into();
                self.jump_height = Millimeters(jump_height_mm.into());
            }
            Configuration::Writing { acceleration_mm_s2 } => {
                self.write_acceleration_mm_s2 = acceleration_mm_s2.into();
            }
            Configuration::InitialAngles { .. } | Configuration::EndEffector { .. } => {}
        }
    }

    /// Returns the commands that give these settings to an arm that was just switched on; none for
    /// settings that it has anyway.
    pub fn commands(&self, dialect: &Dialect) -> impl Iterator<Item = Command> + use<> {
        let (dialect, stock) = (*dialect, Self::stock(dialect));
        let [
            joint_speed_deg_s,
            joint_acceleration_deg_s2,
            servo_speed_deg_s,
            servo_acceleration_deg_s2,
            linear_speed_mm_s,
            linear_acceleration_mm_s2,
        ] = self.teach.numbers().map(single);
        let teach = Configuration::Teach {
            joint_speed_deg_s,
            joint_acceleration_deg_s2,
            servo_speed_deg_s,
            servo_acceleration_deg_s2,
            linear_speed_mm_s,
            linear_acceleration_mm_s2,
        };
        let [
            joint_speed_deg_s,
            joint_acceleration_deg_s2,
            servo_speed_deg_s,
            servo_acceleration_deg_s2,
            linear_speed_mm_s,
            linear_acceleration_mm_s2,
        ] = self.playback.numbers().map(single);
        let playback = Configuration::Playback {
            joint_speed_deg_s,
            joint_acceleration_deg_s2,
            servo_speed_deg_s,
            servo_acceleration_deg_s2,
            linear_speed_mm_s,
            linear_acceleration_mm_s2,
            default_pause_s: single(self.default_pause_s),
            jump_height_mm: single(self.jump_height.0),
        };
        let writing = Configuration::Writing {
            acceleration_mm_s2: single(self.write_acceleration_mm_s2),
        };
        let percentages = PlaybackAdjustment {
            speed_percent: single(self.speed_percent),
            acceleration_percent: single(self.acceleration_percent),
            teach_speed_percent: single(self.teach_percent),
        };
        let commands = [
            teach.into(),
            playback.into(),
            writing.into(),
            percentages.into(),
        ];
        commands.into_iter().filter(move |command: &Command| {
            let mut after = stock;
            match command {
                Command::Configuration(configuration) => after.configure(configuration),
                Command::PlaybackAdjustment(adjustment) => after.adjust(adjustment, &dialect),
                _ => {}
            }
            after != stock
        })
    }

    /// Overwrites the joint speeds: a stock arm follows mouse and hand at its own speeds and
    /// forgets the configured ones (note N43).
    pub(crate) const fn overwrite_joints(&mut self, acceleration_deg_s2: f64) {
        self.playback.joint_deg_s = FOLLOW_DEG_S;
        self.playback.servo_deg_s = FOLLOW_DEG_S;
        self.playback.joint_deg_s2 = acceleration_deg_s2;
        self.playback.servo_deg_s2 = acceleration_deg_s2;
    }
}

const FOLLOW_DEG_S: f64 = 200.0;
