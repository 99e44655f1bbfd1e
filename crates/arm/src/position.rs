//! Points in the base frame.

use core::ops::{Add, Mul, Sub};

use crate::kinematics::{DEG_PER_RAD, RAD_PER_DEG};
use crate::{Degrees, Millimeters};

/// A point in the base frame, or the way from one point to another.
///
/// The origin is the pivot of the rear arm, about 103 mm above the table; X points forward, Y to
/// the left, Z up (Figure 3.1).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Position {
    /// Forward.
    pub x: Millimeters,
    /// To the left.
    pub y: Millimeters,
    /// Up.
    pub z: Millimeters,
}

impl Position {
    /// The point `x`, `y`, `z`, in millimetres.
    ///
    /// ```
    /// # use dobot_arm::Position;
    /// assert_eq!(Position::new(3.0, 4.0, 0.0).reach().0, 5.0);
    /// ```
    #[must_use]
    pub const fn new(x_mm: f64, y_mm: f64, z_mm: f64) -> Self {
        Self {
            x: Millimeters(x_mm),
            y: Millimeters(y_mm),
            z: Millimeters(z_mm),
        }
    }

    /// The point at a distance from the base axis, in the direction of a base angle.
    ///
    /// ```
    /// # use dobot_arm::{Degrees, Millimeters, Position};
    /// let left = Position::polar(Millimeters(200.0), Degrees(90.0), Millimeters(10.0));
    /// assert!(left.distance(Position::new(0.0, 200.0, 10.0)).0 < 1e-12);
    /// ```
    #[must_use]
    pub fn polar(reach: Millimeters, base: Degrees, z: Millimeters) -> Self {
        let (sin, cos) = libm::sincos(base.0 * RAD_PER_DEG);
        Self {
            x: reach * cos,
            y: reach * sin,
            z,
        }
    }

    /// The base angle that points here, in -180..=180 degrees; 0 on the base axis itself.
    #[must_use]
    pub fn direction(self) -> Degrees {
        Degrees(libm::atan2(self.y.0, self.x.0) * DEG_PER_RAD)
    }

    /// The horizontal distance from the base axis, never negative.
    #[must_use]
    pub fn reach(self) -> Millimeters {
        Millimeters(libm::sqrt(self.x.0 * self.x.0 + self.y.0 * self.y.0))
    }

    /// The straight distance to another point, never negative.
    #[must_use]
    pub fn distance(self, other: Self) -> Millimeters {
        (other - self).length()
    }

    /// The distance from the origin, never negative.
    #[must_use]
    pub fn length(self) -> Millimeters {
        let [x, y, z] = [self.x.0, self.y.0, self.z.0];
        Millimeters(libm::sqrt(x * x + y * y + z * z))
    }

    /// Whether all three coordinates are finite.
    #[must_use]
    pub const fn is_finite(self) -> bool {
        self.x.0.is_finite() && self.y.0.is_finite() && self.z.0.is_finite()
    }
}

impl Add for Position {
    type Output = Self;
    fn add(self, by: Self) -> Self {
        Self {
            x: self.x + by.x,
            y: self.y + by.y,
            z: self.z + by.z,
        }
    }
}

impl Sub for Position {
    type Output = Self;
    fn sub(self, from: Self) -> Self {
        Self {
            x: self.x - from.x,
            y: self.y - from.y,
            z: self.z - from.z,
        }
    }
}

impl Mul<f64> for Position {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self {
            x: self.x * factor,
            y: self.y * factor,
            z: self.z * factor,
        }
    }
}
