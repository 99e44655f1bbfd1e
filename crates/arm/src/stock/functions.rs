//! The functions of the stock controller's processor, as near as they are known.
//!
//! It calculates sine and cosine a little too small: what does not fit into single precision is cut
//! off. The others are the approximations of Abramowitz and Stegun, with errors that add up where a
//! pose is calculated from the last one again and again, as in a linear jog.

use core::f64::consts::{FRAC_PI_2, PI};

pub(super) fn sin(x: f32) -> f32 {
    cut(libm::sin(x.into()))
}

pub(super) fn cos(x: f32) -> f32 {
    cut(libm::cos(x.into()))
}

/// By formula 4.4.46; not a number outside of -1 to 1.
pub(super) fn acos(x: f32) -> f32 {
    let x = f64::from(x);
    let size = x.abs();
    let angle = libm::sqrt(1.0 - size) * polynomial(&ARC_SINE, size);
    rounded(if x < 0.0 { PI - angle } else { angle })
}

/// By formula 4.4.49.
pub(super) fn atan(x: f32) -> f32 {
    let x = f64::from(x);
    rounded(if x.abs() > 1.0 {
        FRAC_PI_2.copysign(x) - arc_tangent(1.0 / x)
    } else {
        arc_tangent(x)
    })
}

/// The angle of a point, from -pi to pi.
pub(super) fn atan2(y: f32, x: f32) -> f32 {
    let (y, x) = (f64::from(y), f64::from(x));
    rounded(if y.abs() > x.abs() {
        FRAC_PI_2.copysign(y) - arc_tangent(x / y)
    } else if x < 0.0 {
        PI.copysign(y) + arc_tangent(y / x)
    } else if y == 0.0 {
        y
    } else {
        arc_tangent(y / x)
    })
}

/// For -1 to 1.
fn arc_tangent(x: f64) -> f64 {
    x * polynomial(&ARC_TANGENT, x * x)
}

/// The coefficient of the highest power comes first.
fn polynomial(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().fold(0.0, |sum, it| sum * x + it)
}

/// Drops the digits that single precision does not have.
#[expect(
    clippy::cast_possible_truncation,
    reason = "nothing is left to be lost"
)]
const fn cut(value: f64) -> f32 {
    f64::from_bits(value.to_bits() & !0x1FFF_FFFF) as f32
}

#[expect(clippy::cast_possible_truncation, reason = "that is the precision")]
const fn rounded(value: f64) -> f32 {
    value as f32
}

const ARC_SINE: [f64; 8] = [
    -0.001_262_491_1,
    0.006_670_090_1,
    -0.017_088_125_6,
    0.030_891_881_0,
    -0.050_174_304_6,
    0.088_978_987_4,
    -0.214_598_801_6,
    1.570_796_305_0,
];
const ARC_TANGENT: [f64; 9] = [
    0.002_866_225_7,
    -0.016_165_736_7,
    0.042_909_613_8,
    -0.075_289_640_0,
    0.106_562_639_3,
    -0.142_088_994_4,
    0.199_935_508_5,
    -0.333_331_452_8,
    1.0,
];
