//! Unit vectors from angles.

use kurbo::Vec2;

/// Returns the unit vector of an angle, from x towards y; quarter turns are exact. Rotate other
/// vectors by it with [`Vec2::rotate_scale`].
#[must_use]
pub fn direction(angle_deg: f64) -> Vec2 {
    let angle_deg = angle_deg.rem_euclid(360.0);
    let quarters = (angle_deg / 90.0).round();
    let Vec2 { x, y } = Vec2::from_angle((angle_deg - 90.0 * quarters).to_radians());
    match quarters.rem_euclid(4.0) {
        0.0 => Vec2::new(x, y),
        1.0 => Vec2::new(-y, x),
        2.0 => Vec2::new(-x, -y),
        _ => Vec2::new(y, -x),
    }
}
