//! Arcs of G2 and G3: by center or by radius.
//!
//! ```text
//!          end                       the center lies beside the middle of the chord,
//!         /   \                      h = sqrt(r^2 - (chord / 2)^2) away: to the left for a
//!   chord       \                    short way counterclockwise, to the right for a long
//!       /        center              one or one clockwise
//!    start
//! ```

use std::f64::consts::{PI, TAU};

use dobot_geometry::Point;

use crate::arc::SAME_MM;

/// The center of an arc from its radius; a negative radius selects the longer arc. The error
/// describes what is wrong.
pub(super) fn center_by_radius(
    start: Point,
    end: Point,
    radius: f64,
    clockwise: bool,
) -> Result<Point, String> {
    let way = end - start;
    let half = way.length() / 2.0;
    if half < SAME_MM {
        return Err("an arc given by its radius that ends at its start".to_owned());
    }
    if differ(half.max(radius.abs()), radius.abs()) {
        return Err(format!(
            "an arc of radius {:.3} mm between points {:.3} mm apart",
            radius.abs(),
            2.0 * half
        ));
    }
    let height = (radius * radius - half * half).max(0.0).sqrt();
    let side = if clockwise == (radius > 0.0) {
        -1.0
    } else {
        1.0
    };
    let left = way.turn_90() * (1.0 / way.length());
    Ok(start.midpoint(end) + left * (side * height))
}

/// The sweep of an arc about its center, below 0 for clockwise; a full turn if it ends at its
/// start. The error describes what is wrong.
pub(super) fn sweep_rad(
    center: Point,
    start: Point,
    end: Point,
    clockwise: bool,
) -> Result<f64, String> {
    let (a, b) = (start - center, end - center);
    let (begins, ends) = (a.length(), b.length());
    if begins < SAME_MM {
        return Err("an arc whose center is its start".to_owned());
    }
    if differ(begins, ends) {
        return Err(format!(
            "an arc whose start is {begins:.3} mm and whose end is {ends:.3} mm from its center"
        ));
    }
    let turn = a.cross(b).atan2(a.dot(b));
    let is_whole = start.distance(end) < SAME_MM;
    Ok(match (clockwise, is_whole) {
        (true, true) => -TAU,
        (false, true) => TAU,
        (true, false) if turn > 0.0 => turn - TAU,
        (false, false) if turn < 0.0 => turn + TAU,
        _ => turn,
    })
}

/// The points at which an arc turns back along X, in order.
pub(super) fn far_sides(center: Point, start: Point, sweep_rad: f64) -> [Option<f64>; 2] {
    let from = start - center;
    let (radius, begin) = (from.length(), from.y.atan2(from.x));
    let end = begin + sweep_rad;
    // In half turns from the right.
    let (first, step) = if sweep_rad > 0.0 {
        ((begin / PI).floor() + 1.0, 1.0)
    } else {
        ((begin / PI).ceil() - 1.0, -1.0)
    };
    [first, first + step].map(|half_turns| {
        let is_passed = (half_turns * PI - end) * step < 0.0;
        let side = if half_turns % 2.0 == 0.0 {
            radius
        } else {
            -radius
        };
        is_passed.then_some(center.x + side)
    })
}

/// Whether radii differ by more than rounding explains: more than 0.01 mm and half a percent.
fn differ(a: f64, b: f64) -> bool {
    let by = (a - b).abs();
    by > 0.01 && by > 0.005 * a.max(b)
}
