//! The commands that the benchmarks send.

use dobot_wire::{Command, MoveTo, MovingMode, WriteMode, WriteVector};

/// A place at which the arm can write.
pub(crate) const START: MoveTo = MoveTo {
    x_mm: 200.0,
    y_mm: 0.0,
    z_mm: 50.0,
    rotation_deg: 0.0,
    suction: false,
    mode: MovingMode::MovJ,
    gripper_deg: 0.0,
    pause_s: 0.0,
};

/// A level vector from rest to rest.
pub(crate) fn vector([x_mm, y_mm]: [f32; 2]) -> Command {
    WriteVector {
        mode: WriteMode::Writing,
        x_mm,
        y_mm,
        z_mm: 0.0,
        laser: false,
        start_speed_mm_s: 0.0,
        end_speed_mm_s: 0.0,
        max_speed_mm_s: 20.0,
        stop: false,
    }
    .into()
}
