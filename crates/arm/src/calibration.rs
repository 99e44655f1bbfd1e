//! The calibration of an arm: its deviations from the drawing and the resulting positions.

use crate::{
    Degrees, Joints, Millimeters, Plane, Pose, Position, Tool, Unreachable, forward, inverse,
};

/// The calibration of an arm: the offset between its true and its reported pose.
///
/// A *raw* position is what the arm reports and accepts; a *calibrated* position is that of the tool. Both belong together as
/// long as each joint was turned on last; a joint that was turned back stands further by its backlash.
///
/// ```
/// use dobot_arm::{Calibration, Position, Tool};
///
/// // Nothing but the base is wrong: straight ahead is 90 degrees to the left.
/// let arm = Calibration { base_deg: 90.0, ..Calibration::default() };
/// let true_place = arm.true_place(Position::new(200.0, 0.0, -40.0), Tool::SuctionCup)?;
/// assert!((true_place.y.0 - 200.0).abs() < 1e-9);
/// # Ok::<(), dobot_arm::Unreachable>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Calibration {
    /// The offset of the base from its reported angle, in degrees.
    pub base_deg: f64,
    /// The offset of the rear arm from its reported angle, in degrees.
    pub rear_deg: f64,
    /// The offset of the forearm from its reported angle, in degrees.
    pub fore_deg: f64,
    /// The outward offset of the tool from the drawing, in mm.
    pub reach_mm: f64,
    /// How far to the left of the forearm's direction the tool is, in mm.
    pub left_mm: f64,
    /// Where the base's axis stands in the true frame, in mm.
    pub axis_mm: [f64; 2],
    /// How slack base, rear arm and forearm are, in degrees.
    pub backlash_deg: [f64; 3],
    /// The plane on which the paper lies, as Z of the wrist where the pen touches, where that is known: no part of the
    /// paper is lower.
    pub table: Option<Plane>,
}

impl Calibration {
    /// No deviation: the arm is where it reports.
    pub const NONE: Self = Self {
        base_deg: 0.0,
        rear_deg: 0.0,
        fore_deg: 0.0,
        reach_mm: 0.0,
        left_mm: 0.0,
        axis_mm: [0.0; 2],
        backlash_deg: [0.0; 3],
        table: None,
    };

    /// Whether nothing is wrong with the arm, wherever its table is.
    #[must_use]
    pub fn is_none(&self) -> bool {
        let table = self.table;
        *self
            == Self {
                table,
                ..Self::NONE
            }
    }

    /// How high a true place of the wrist is above where the pen touches the table, in mm; `None` where nobody knows
    /// where that is.
    #[must_use]
    pub fn above_table_mm(&self, place: Position) -> Option<f64> {
        let table = self.table?;
        Some(place.z.0 - table.z_at([place.x.0, place.y.0]))
    }

    /// What is wrong with the arm as numbers, to be kept: the zeros of base, rear arm and forearm, how far the tool is out and to
    /// the left, where the axis stands, and the backlash of the three joints.
    #[must_use]
    pub const fn to_numbers(&self) -> [f64; 10] {
        let [axis_x, axis_y] = self.axis_mm;
        let [slack_base, slack_rear, slack_fore] = self.backlash_deg;
        [
            self.base_deg,
            self.rear_deg,
            self.fore_deg,
            self.reach_mm,
            self.left_mm,
            axis_x,
            axis_y,
            slack_base,
            slack_rear,
            slack_fore,
        ]
    }

    /// Restores the numbers of [`to_numbers`](Self::to_numbers).
    #[must_use]
    pub const fn from_numbers(numbers: [f64; 10]) -> Self {
        let [
            base_deg,
            rear_deg,
            fore_deg,
            reach_mm,
            left_mm,
            axis_x,
            axis_y,
            slack_base,
            slack_rear,
            slack_fore,
        ] = numbers;
        Self {
            base_deg,
            rear_deg,
            fore_deg,
            reach_mm,
            left_mm,
            axis_mm: [axis_x, axis_y],
            backlash_deg: [slack_base, slack_rear, slack_fore],
            table: None,
        }
    }

    /// Whether another one means the same arm, wherever the table is: written as text and read again, a number may differ in its last digit.
    #[must_use]
    pub fn is_same(&self, other: &Self) -> bool {
        let numbers = self.to_numbers().into_iter().zip(other.to_numbers());
        numbers.into_iter().all(|(a, b)| (a - b).abs() < SAME)
    }

    /// The calibration after the arm was sent its true joint angles.
    #[must_use]
    pub const fn without_zeros(self) -> Self {
        Self {
            base_deg: 0.0,
            rear_deg: 0.0,
            fore_deg: 0.0,
            ..self
        }
    }

    /// The calibrated joint angles for raw ones.
    #[must_use]
    pub fn true_joints(&self, raw: &Joints) -> Joints {
        Joints {
            base: raw.base + Degrees(self.base_deg),
            rear: raw.rear + Degrees(self.rear_deg),
            fore: raw.fore + Degrees(self.fore_deg),
            servo: raw.servo,
        }
    }

    /// The raw joint angles for calibrated ones.
    #[must_use]
    pub fn raw_joints_of(&self, joints: &Joints) -> Joints {
        Joints {
            base: joints.base - Degrees(self.base_deg),
            rear: joints.rear - Degrees(self.rear_deg),
            fore: joints.fore - Degrees(self.fore_deg),
            servo: joints.servo,
        }
    }

    /// What the motors say where the joints stand so, after each turned so far: one that was turned back stands
    /// further than its motor says, by its backlash.
    #[must_use]
    pub fn motors_at(&self, joints: &Joints, turned_deg: [f64; 3]) -> Joints {
        self.slackened(joints, turned_deg, -1.0)
    }

    /// How the joints stand where the motors say so, after each turned so far.
    #[must_use]
    pub fn joints_at(&self, motors: &Joints, turned_deg: [f64; 3]) -> Joints {
        self.slackened(motors, turned_deg, 1.0)
    }

    fn slackened(&self, joints: &Joints, turned_deg: [f64; 3], sign: f64) -> Joints {
        let more = |index: usize| {
            let is_back = turned_deg[index] < -STILL_DEG;
            Degrees(if is_back {
                sign * self.backlash_deg[index]
            } else {
                0.0
            })
        };
        Joints {
            base: joints.base + more(0),
            rear: joints.rear + more(1),
            fore: joints.fore + more(2),
            servo: joints.servo,
        }
    }

    /// The calibrated position for a raw one.
    ///
    /// # Errors
    ///
    /// Returns [`Unreachable`] if no joint angles reach the raw position.
    pub fn true_place(&self, raw: Position, tool: Tool) -> Result<Position, Unreachable> {
        let raw = inverse(&at(raw), tool)?;
        Ok(self.true_place_of(&raw, tool))
    }

    /// The calibrated position for raw joint angles.
    #[must_use]
    pub fn true_place_of(&self, raw: &Joints, tool: Tool) -> Position {
        let joints = self.true_joints(raw);
        let straight_ahead = Joints {
            base: Degrees(0.0),
            ..joints
        };
        let arm = forward(&straight_ahead, tool).position;
        let out_mm = arm.x.0 + self.reach_mm;
        let (sin, cos) = libm::sincos(joints.base.0.to_radians());
        let [axis_x, axis_y] = self.axis_mm;
        Position::new(
            axis_x + out_mm * cos - self.left_mm * sin,
            axis_y + out_mm * sin + self.left_mm * cos,
            arm.z.0,
        )
    }

    /// The raw position for a calibrated one.
    ///
    /// # Errors
    ///
    /// [`Unreachable`] where the arm cannot bring its tool there.
    pub fn raw_place(&self, true_place: Position, tool: Tool) -> Result<Position, Unreachable> {
        Ok(forward(&self.raw_joints(true_place, tool)?, tool).position)
    }

    /// The raw joint angles for a calibrated position.
    ///
    /// ```text
    ///   tool *----- left -----+          out = sqrt(distance^2 - left^2)
    ///          \              |          base = direction - asin(left / distance)
    ///   distance  \           | out
    ///                 \  base |
    ///                      \  |
    ///                         o axis
    /// ```
    ///
    /// # Errors
    ///
    /// [`Unreachable`] where the arm cannot bring its tool there.
    pub fn raw_joints(&self, true_place: Position, tool: Tool) -> Result<Joints, Unreachable> {
        let [axis_x, axis_y] = self.axis_mm;
        let from_axis = Position::new(
            true_place.x.0 - axis_x,
            true_place.y.0 - axis_y,
            true_place.z.0,
        );
        let distance_mm = from_axis.reach().0;
        let out_mm = libm::sqrt((distance_mm * distance_mm - self.left_mm * self.left_mm).max(0.0));
        let aside_rad = libm::atan2(self.left_mm, out_mm);
        let flat = Position {
            x: Millimeters(out_mm - self.reach_mm),
            y: Millimeters(0.0),
            z: true_place.z,
        };
        let joints = inverse(&at(flat), tool)?;
        let base_deg = from_axis.direction().0 - aside_rad.to_degrees() - self.base_deg;
        Ok(Joints {
            base: Degrees(libm::remainder(base_deg, 360.0)),
            rear: joints.rear - Degrees(self.rear_deg),
            fore: joints.fore - Degrees(self.fore_deg),
            servo: Degrees(0.0),
        })
    }
}

/// Far less than anybody can measure, in degrees and mm.
const SAME: f64 = 1e-6;
/// The smallest rotation that counts as motion.
const STILL_DEG: f64 = 1e-3;

fn at(position: Position) -> Pose {
    Pose {
        position,
        rotation: Degrees(0.0),
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    const ARM: Calibration = Calibration {
        base_deg: 24.0,
        rear_deg: -9.0,
        fore_deg: 7.0,
        reach_mm: 8.0,
        left_mm: -6.0,
        axis_mm: [1.0, -2.0],
        backlash_deg: [0.0; 3],
        table: None,
    };

    #[test]
    fn a_calibrated_target_brings_the_tool_to_the_true_place() {
        for (x, y, z) in [
            (200.0, 30.0, -40.0),
            (180.0, -120.0, 20.0),
            (260.0, 90.0, -60.0),
        ] {
            let wanted = Position::new(x, y, z);
            let raw = ARM.raw_place(wanted, Tool::SuctionCup).unwrap();
            let found = ARM.true_place(raw, Tool::SuctionCup).unwrap();
            let away_mm = (found.x.0 - x).abs() + (found.y.0 - y).abs() + (found.z.0 - z).abs();
            assert!(away_mm < 1e-9, "{wanted:?} became {found:?}");
        }
    }

    #[test]
    fn an_arm_without_errors_is_at_its_reported_place() {
        let place = Position::new(210.0, -70.0, -35.0);
        let found = Calibration::default()
            .raw_place(place, Tool::Laser)
            .unwrap();
        assert!(
            (found.x.0 - 210.0).abs() < 1e-9 && (found.z.0 + 35.0).abs() < 1e-9,
            "{found:?}"
        );
    }

    #[test]
    fn a_place_beyond_the_stretched_arm_is_refused() {
        let far = Position::new(500.0, 0.0, 0.0);
        ARM.raw_place(far, Tool::SuctionCup).unwrap_err();
    }
}
