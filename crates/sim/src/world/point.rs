//! Points of the table, seen from above.

use std::ops::{Add, Mul, Sub};

use serde::{Deserialize, Serialize};

/// A place on the table in the base frame, or the way from one place to another: X forward, Y to
/// the left, in mm. In JSON it is `[x, y]`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(from = "[f64; 2]", into = "[f64; 2]")]
pub struct Point {
    /// Forward.
    pub x: f64,
    /// To the left.
    pub y: f64,
}

impl Point {
    /// The place `x`, `y`, in mm.
    #[must_use]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// The way of length 1 in a direction, counter-clockwise from straight ahead.
    pub(crate) fn towards(angle_deg: f64) -> Self {
        let (sin, cos) = angle_deg.to_radians().sin_cos();
        Self::new(cos, sin)
    }

    /// Turned about the origin, counter-clockwise.
    pub(crate) fn turned(self, angle_deg: f64) -> Self {
        let along = Self::towards(angle_deg);
        Self::new(
            self.x * along.x - self.y * along.y,
            self.x * along.y + self.y * along.x,
        )
    }

    pub(crate) fn length(self) -> f64 {
        self.x.hypot(self.y)
    }

    pub(crate) fn distance(self, other: Self) -> f64 {
        (other - self).length()
    }

    pub(crate) fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y
    }

    pub(crate) fn cross(self, other: Self) -> f64 {
        self.x * other.y - self.y * other.x
    }

    /// The place between here and `other` after so much of the way.
    pub(crate) fn between(self, other: Self, share: f64) -> Self {
        self + (other - self) * share
    }

    /// To a thousandth of a millimetre, which is what states tell.
    pub(crate) fn rounded(self) -> Self {
        Self::new(rounded(self.x), rounded(self.y))
    }
}

/// To a thousandth.
pub(crate) fn rounded(value: f64) -> f64 {
    // No `-0`.
    (value * 1000.0).round() / 1000.0 + 0.0
}

impl From<[f64; 2]> for Point {
    fn from([x, y]: [f64; 2]) -> Self {
        Self { x, y }
    }
}

impl From<Point> for [f64; 2] {
    fn from(point: Point) -> Self {
        [point.x, point.y]
    }
}

impl Add for Point {
    type Output = Self;
    fn add(self, by: Self) -> Self {
        Self::new(self.x + by.x, self.y + by.y)
    }
}

impl Sub for Point {
    type Output = Self;
    fn sub(self, from: Self) -> Self {
        Self::new(self.x - from.x, self.y - from.y)
    }
}

impl Mul<f64> for Point {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self::new(self.x * factor, self.y * factor)
    }
}
