//! The tool mounted at the end of the arm.

use dobot_arm::{Millimeters, Tool};

/// The tool mounted at the end of the arm, with its length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MountedTool {
    kind: Tool,
    length: Millimeters,
}

/// Why a tool is refused.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error(
    "the length of the tool is {found}; allowed are {} to {} mm, from the height of the wrist down to the tip",
    MountedTool::SHORTEST.0,
    MountedTool::LONGEST.0
)]
pub struct BadLength {
    /// The length that was asked for.
    pub found: Millimeters,
}

impl MountedTool {
    /// The shortest tool that reaches below the servo.
    pub const SHORTEST: Millimeters = Millimeters(20.0);

    /// The longest tool, as in a policy.
    pub const LONGEST: Millimeters = Millimeters(200.0);

    /// A tool whose tip hangs so far below the wrist: 20 to 200 mm.
    ///
    /// # Errors
    ///
    /// [`BadLength`] for any other length.
    pub fn new(kind: Tool, length: Millimeters) -> Result<Self, BadLength> {
        if length >= Self::SHORTEST && length <= Self::LONGEST {
            Ok(Self { kind, length })
        } else {
            Err(BadLength { found: length })
        }
    }

    /// The kind of tool.
    #[must_use]
    pub const fn kind(self) -> Tool {
        self.kind
    }

    /// How far its tip hangs below the wrist.
    #[must_use]
    pub const fn length(self) -> Millimeters {
        self.length
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tool_that_ends_within_the_servo_or_has_no_valid_length_is_refused() {
        for found in [0.0, 19.9, 200.1, -40.0, f64::NAN, f64::INFINITY] {
            let error = MountedTool::new(Tool::Laser, Millimeters(found)).expect_err("it is bad");
            assert!(error.to_string().contains("20 to 200 mm"), "{error}");
        }
        for good in [20.0, 38.0, 200.0] {
            assert!(MountedTool::new(Tool::Laser, Millimeters(good)).is_ok());
        }
    }
}
