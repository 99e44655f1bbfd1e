//! The commands that jobs are made of, in short.

use dobot_arm::Tool;
use dobot_wire::{Command, Configuration, MoveTo, WriteVector};

/// The settings at the start of a drawing: tool and acceleration.
pub(crate) fn settings(burns: bool) -> [Command; 2] {
    let tool = if burns { Tool::Laser } else { Tool::SuctionCup };
    let acceleration_mm_s2 = 100.0;
    [
        Configuration::EndEffector { tool: tool.into() }.into(),
        Configuration::Writing { acceleration_mm_s2 }.into(),
    ]
}

/// A jump to a place.
pub(crate) const fn target([x_mm, y_mm, z_mm]: [f32; 3]) -> MoveTo {
    MoveTo::to(x_mm, y_mm, z_mm)
}

/// A vector that begins and ends at rest, as stock arms make them exactly.
pub(crate) fn vector([x_mm, y_mm, z_mm]: [f32; 3], burns: bool) -> Command {
    let stroke = WriteVector::by(x_mm, y_mm, z_mm, 40.0);
    if burns { stroke.burning() } else { stroke }.into()
}
