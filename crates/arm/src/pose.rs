//! Where the tool is and which way it is turned.

use crate::{Degrees, Position};

/// The tool's place and turn in the base frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pose {
    /// Where the tool is; Z is the height of the wrist, real tools hang 20 to 100 mm lower.
    pub position: Position,
    /// How the tool is turned relative to the base frame (`rHead`): base angle plus servo angle.
    pub rotation: Degrees,
}
