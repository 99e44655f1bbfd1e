//! The four joint angles.

use crate::Degrees;

/// The angles of the four joints.
///
/// Rear arm and forearm are both absolute: the parallelogram keeps the forearm's angle independent
/// of the rear arm's.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Joints {
    /// Joint 1, from straight ahead, counter-clockwise positive seen from above.
    pub base: Degrees,
    /// Joint 2, the rear arm, from the vertical, forward positive.
    pub rear: Degrees,
    /// Joint 3, the forearm, below the horizontal: down is positive.
    pub fore: Degrees,
    /// Joint 4, the servo of the tool, from its middle, counter-clockwise positive.
    pub servo: Degrees,
}

impl Joints {
    /// The four angles, in degrees.
    #[must_use]
    pub const fn new(base_deg: f64, rear_deg: f64, fore_deg: f64, servo_deg: f64) -> Self {
        Self {
            base: Degrees(base_deg),
            rear: Degrees(rear_deg),
            fore: Degrees(fore_deg),
            servo: Degrees(servo_deg),
        }
    }

    /// The four angles in degrees: base, rear arm, forearm and servo.
    #[must_use]
    pub const fn angles_deg(&self) -> [f64; 4] {
        [self.base.0, self.rear.0, self.fore.0, self.servo.0]
    }

    /// The angles after this share of the way to others, on which all turn evenly.
    #[must_use]
    pub fn towards(&self, to: &Self, share: f64) -> Self {
        let between = |from: Degrees, to: Degrees| from + (to - from) * share;
        Self {
            base: between(self.base, to.base),
            rear: between(self.rear, to.rear),
            fore: between(self.fore, to.fore),
            servo: between(self.servo, to.servo),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_have_the_order_of_the_joints() {
        assert_eq!(
            Joints::new(1.0, 2.0, 3.0, 4.0).angles_deg(),
            [1.0, 2.0, 3.0, 4.0]
        );
    }
}
