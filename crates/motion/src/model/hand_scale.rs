//! The units of gesture packets.

use dobot_arm::Tool;
use dobot_wire::Dialect;

use super::followed::SAMPLES;

/// The units of a hand's position in a gesture packet (state 8; note N18).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HandScale {
    /// Along X.
    pub x: HandAxis,
    /// Along Y.
    pub y: HandAxis,
    /// Along Z.
    pub z: HandAxis,
}

/// One axis of a hand's position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HandAxis {
    /// The position that 0 in a packet stands for, in mm.
    pub zero_mm: f64,
    /// Units of the packet per mm from there.
    pub units_per_mm: f64,
}

impl HandScale {
    /// The scale for an arm with this tool.
    #[must_use]
    pub const fn of(dialect: &Dialect, tool: Tool) -> Self {
        const MM: HandAxis = HandAxis::new(0.0, 1.0);
        if dialect.scales_gesture {
            Self {
                x: HandAxis::new(230.0, 2.0),
                y: MM,
                z: HandAxis::new(lowest_mm(tool) - 100.0, 2.0),
            }
        } else {
            Self {
                x: MM,
                y: MM,
                z: MM,
            }
        }
    }

    /// The number of equal packets after which the arm is at the hand's position: a stock arm
    /// averages the last ones.
    #[must_use]
    pub const fn samples(dialect: &Dialect) -> usize {
        if dialect.scales_gesture { SAMPLES } else { 1 }
    }
}

impl HandAxis {
    const fn new(zero_mm: f64, units_per_mm: f64) -> Self {
        Self {
            zero_mm,
            units_per_mm,
        }
    }

    /// The position in mm that a value of a packet stands for.
    #[must_use]
    pub fn place_mm(self, units: f32) -> f64 {
        self.zero_mm + f64::from(units) / self.units_per_mm
    }
}

/// The lowest height to which a stock arm follows, in mm.
pub(crate) const fn lowest_mm(tool: Tool) -> f64 {
    match tool.end_effector() {
        Tool::Gripper => 20.0,
        _ => -30.0,
    }
}
