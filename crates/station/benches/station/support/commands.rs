//! The commands that the benchmarks send.

use dobot_wire::{Command, MoveTo, MovingMode, WriteVector};

/// A position at which the arm can write.
pub(crate) const START: MoveTo = MoveTo::to(200.0, 0.0, 50.0).with_mode(MovingMode::MovJ);

/// A level vector from rest to rest.
pub(crate) fn vector([x_mm, y_mm]: [f32; 2]) -> Command {
    WriteVector::by(x_mm, y_mm, 0.0, 20.0).into()
}
