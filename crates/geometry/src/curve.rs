//! Flattening of curves within a guaranteed tolerance.

use kurbo::{CubicBez, ParamCurve, Point};

/// Returns the number of chords with equal parameter steps that stay within `tolerance` of a curve:
/// a whole number of at least 1, or NaN.
///
/// A chord deviates from its curve by at most an eighth of the step squared times the largest
/// second derivative, which is bounded by the control points:
///
/// ```text
///   |B''| <= 6 max(|p0 - 2 p1 + p2|, |p1 - 2 p2 + p3|)     n = ceil(sqrt(|B''| / (8 tolerance)))
/// ```
///
/// kurbo flattens with fewer chords, but its tolerance is an estimate and it has no upper limit.
#[must_use]
pub fn chords(curve: CubicBez, tolerance: f64) -> f64 {
    let CubicBez { p0, p1, p2, p3 } = curve;
    let bend = |a: Point, b: Point, c: Point| ((a - b) + (c - b)).hypot();
    let second = 6.0 * bend(p0, p1, p2).max(bend(p1, p2, p3));
    (second / (8.0 * tolerance)).sqrt().ceil().max(1.0)
}

/// Returns the corners of a curve in `count` chords, without its start; the last one is its end.
pub fn corners(curve: CubicBez, count: u32) -> impl Iterator<Item = Point> {
    let step = 1.0 / f64::from(count);
    let inner = (1..count).map(move |i| curve.eval(f64::from(i) * step));
    inner.chain([curve.p3])
}
