//! What configuration can change.

use dobot_arm::Millimeters;
use dobot_motion::Speeds;
use dobot_wire::{Dialect, PlaybackAdjustment};

/// What configuration can change (Table 3.9), with the values of a stock arm at power-up.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Settings {
    /// Speeds of the point to point moves, before the percentages.
    pub(crate) playback: Speeds,
    pub(crate) speed_percent: f64,
    pub(crate) acceleration_percent: f64,
    /// Of the teaching speeds; each jog has a percentage of its own besides.
    pub(crate) teach_percent: f64,
    /// Jog speeds at 100 %.
    pub(crate) teach: Speeds,
    pub(crate) write_acceleration_mm_s2: f64,
    pub(crate) jump_height: Millimeters,
    pub(crate) default_pause_s: f64,
}

impl Settings {
    pub(crate) fn new() -> Self {
        Self {
            playback: Speeds::STOCK,
            speed_percent: 50.0,
            acceleration_percent: 50.0,
            teach_percent: 100.0,
            teach: Speeds {
                joint_deg_s: 15.0,
                joint_deg_s2: 50.0,
                servo_deg_s: 30.0,
                servo_deg_s2: 50.0,
                line_mm_s: 60.0,
                line_mm_s2: 60.0,
            },
            write_acceleration_mm_s2: 100.0,
            jump_height: Millimeters(Dialect::SPECIFICATION.default_jump_height_mm.into()),
            default_pause_s: 0.0,
        }
    }

    /// Speeds of the point to point moves.
    pub(crate) const fn move_speeds(&self) -> Speeds {
        self.playback
            .scaled(self.speed_percent, self.acceleration_percent)
    }

    pub(crate) fn adjust(&mut self, adjustment: &PlaybackAdjustment) {
        self.speed_percent = adjustment.speed_percent.into();
        self.acceleration_percent = adjustment.acceleration_percent.into();
        self.teach_percent = adjustment.teach_speed_percent.into();
    }
}
