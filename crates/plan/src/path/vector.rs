//! A vector of a plan.

use dobot_motion::Profile;
use dobot_wire::single;

/// A vector of a plan: an increment and its speeds, as in a packet (state 4; Table 2.6).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlannedVector {
    /// Forward, in mm.
    pub x_mm: f32,
    /// To the left, in mm.
    pub y_mm: f32,
    /// Up, in mm.
    pub z_mm: f32,
    /// The start speed: the end speed of the vector before, in mm/s.
    pub start_speed_mm_s: f32,
    /// The end speed, in mm/s.
    pub end_speed_mm_s: f32,
    /// The maximum speed, in mm/s.
    pub max_speed_mm_s: f32,
    /// The duration in s: acceleration, constant maximum speed if it is reached, braking; on a
    /// stock arm a whole number of ticks.
    pub duration_s: f32,
    /// The action of the tool.
    pub kind: MoveKind,
    /// The stroke, from 0, counted through all passes; for a travel, the next stroke.
    pub stroke: u32,
    /// The pass, from 0.
    pub pass: u32,
}

impl PlannedVector {
    /// Returns the increments along X, Y and Z in mm.
    #[must_use]
    pub fn increments(&self) -> [f64; 3] {
        [self.x_mm, self.y_mm, self.z_mm].map(f64::from)
    }

    /// Returns the length in mm.
    #[must_use]
    pub fn length_mm(&self) -> f64 {
        length(self.increments())
    }

    /// Splits the vector into two in the same direction; the second one has the given length, in
    /// mm.
    pub(crate) fn parts(&self, second_mm: f64) -> [Self; 2] {
        let share = second_mm / self.length_mm();
        // Round to whole parts of this size, so that the difference is exact.
        let second = |mm: f32| single((f64::from(mm) * share * PARTS_OF_MM).round() / PARTS_OF_MM);
        let [x_mm, y_mm, z_mm] = [self.x_mm, self.y_mm, self.z_mm].map(second);
        let first = Self {
            x_mm: self.x_mm - x_mm,
            y_mm: self.y_mm - y_mm,
            z_mm: self.z_mm - z_mm,
            ..*self
        };
        let second = Self {
            x_mm,
            y_mm,
            z_mm,
            ..*self
        };
        [first, second]
    }

    pub(crate) fn profile(&self, acceleration_mm_s2: f64) -> Profile {
        let speeds = [
            self.start_speed_mm_s,
            self.end_speed_mm_s,
            self.max_speed_mm_s,
        ];
        let [start, end, max] = speeds.map(f64::from);
        Profile::new(self.length_mm(), start, end, max, acceleration_mm_s2)
            .expect("a plan keeps its own limits")
    }
}

/// The action of the tool on a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MoveKind {
    /// Travels to the next stroke: pen up, or laser off.
    Travel,
    /// Lowers the pen to the paper.
    Lower,
    /// Draws with the pen.
    Draw,
    /// Lifts the pen from the paper.
    Lift,
    /// Accelerates with the laser off, straight into the stroke.
    RunUp,
    /// Burns.
    Burn,
    /// Switches the laser off in full motion, straight out of the stroke.
    RunOut,
    /// Brakes to rest with the laser off.
    Brake,
}

impl MoveKind {
    /// Whether it leaves a trace on the paper.
    #[must_use]
    pub const fn marks(self) -> bool {
        matches!(self, Self::Draw | Self::Burn)
    }
}

/// A power of two: single precision holds these parts of 256 mm, and no smaller ones.
const PARTS_OF_MM: f64 = 65_536.0;

pub(crate) fn length([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn the_two_parts_of_a_divided_vector_cover_its_length_and_hardly_turn(
            way in [-200.0..200.0_f32, -200.0..200.0_f32, -1.0..1.0_f32],
            share in 0.01..0.99_f64,
        ) {
            let [x_mm, y_mm, z_mm] = way;
            let vector = PlannedVector {
                x_mm, y_mm, z_mm,
                start_speed_mm_s: 0.0,
                end_speed_mm_s: 0.0,
                max_speed_mm_s: 40.0,
                duration_s: 1.0,
                kind: MoveKind::Draw,
                stroke: 0,
                pass: 0,
            };
            let second_mm = share * vector.length_mm();
            let [first, second] = vector.parts(second_mm);
            prop_assert_eq!([first.x_mm + second.x_mm, first.y_mm + second.y_mm, first.z_mm + second.z_mm], way);
            let off = [0, 1, 2].map(|i| second.increments()[i] - share * vector.increments()[i]);
            prop_assert!(length(off) < 0.0001, "{off:?}");
        }
    }
}
