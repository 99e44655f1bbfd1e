//! A moment of a drawing.

use std::time::Duration;

use dobot_arm::Position;

/// Where a virtual arm's tool was: once a tick of 20 ms while it moves, and at every corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// When, by the clock of the arm.
    pub at: Duration,
    /// Where the tool was.
    pub position: Position,
    /// Whether the laser was on, on the way here.
    pub laser: bool,
}
