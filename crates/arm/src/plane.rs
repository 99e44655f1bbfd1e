//! A plane, which need not be level.

/// A plane in the base frame: `z = z0 + slope_x x + slope_y y`, X forward, Y to the left (Figure 3.1).
///
/// ```
/// use dobot_arm::Plane;
///
/// // It rises by a hundredth forward.
/// let paper = Plane { z0_mm: -42.0, slope_x: 0.01, slope_y: 0.0 };
/// assert!((paper.z_at([200.0, 50.0]) + 40.0).abs() < 1e-12);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plane {
    /// Its height at the axis of the base, in mm.
    pub z0_mm: f64,
    /// How much it rises for each mm forward.
    pub slope_x: f64,
    /// How much it rises for each mm to the left.
    pub slope_y: f64,
}

impl Plane {
    /// Its height at a place, in mm.
    #[must_use]
    pub const fn z_at(&self, [x_mm, y_mm]: [f64; 2]) -> f64 {
        self.z0_mm + self.slope_x * x_mm + self.slope_y * y_mm
    }
}
