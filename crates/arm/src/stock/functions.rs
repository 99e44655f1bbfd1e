//! The functions of the stock controller's processor, digit by digit.
//!
//! Its compiler's library keeps 32 binary digits between the steps of a function where single
//! precision has 24, and cuts off what is beyond. Factors are cut to 24 digits first. The series are
//! those of Abramowitz and Stegun. Doubles hold each exact result, so that only the cutting has to
//! be done here; addition, multiplication, division and root of single precision are as everywhere.

/// By formula 4.3.97.
pub(super) fn sin(x: f32) -> f32 {
    let (rest, quadrant) = divided(x);
    let turned = if x.is_sign_negative() { 2 } else { 0 };
    sine(rest, quadrant + turned)
}

pub(super) fn cos(x: f32) -> f32 {
    let (rest, quadrant) = divided(x);
    sine(rest, quadrant + 1)
}

/// By formula 4.4.46; not a number outside of -1 to 1.
pub(super) fn acos(x: f32) -> f32 {
    let size = libm::fabsf(x);
    let factor = nearest_24(series(&ARC_COSINE, size));
    let angle = f64::from(libm::sqrtf(1.0 - size)) * factor;
    rounded(if x.is_sign_negative() {
        2.0 * QUARTER - cut_32(angle)
    } else {
        angle
    })
}

/// By formula 4.4.49.
pub(super) fn atan(x: f32) -> f32 {
    let is_steep = libm::fabsf(x) > 1.0;
    let slope = if is_steep { 1.0 / x } else { x };
    let angle = f64::from(slope) * nearest_24(series(&ARC_TANGENT, slope * slope));
    rounded(if is_steep {
        libm::copysign(QUARTER, x.into()) - cut_32(angle)
    } else {
        angle
    })
}

/// The angle of a point, from -pi to pi; 0 for the origin, whatever the signs.
pub(super) fn atan2(y: f32, x: f32) -> f32 {
    if libm::fabsf(y) > libm::fabsf(x) {
        libm::copysignf(FRAC_PI_2, y) + atan(-(x / y))
    } else if x.is_sign_negative() && x != 0.0 {
        libm::copysignf(PI, y) + atan(y / x)
    } else if x == 0.0 {
        0.0
    } else {
        atan(y / x)
    }
}

/// What is left of an angle's size once all quarters of a turn are taken away, and their number or
/// one that is as good.
fn divided(x: f32) -> (f64, u32) {
    let size = f64::from(libm::fabsf(x));
    let size = if size < MANY {
        size
    } else {
        libm::fmod(size, 4.0 * QUARTER)
    };
    let quadrant = whole(size * (1.0 / QUARTER));
    (size - f64::from(quadrant) * QUARTER, quadrant)
}

/// The sine of an angle in a quadrant, counted from 0.
fn sine(rest: f64, quadrant: u32) -> f32 {
    let angle = rounded(if quadrant % 2 == 1 {
        rest - QUARTER
    } else {
        rest
    });
    let angle = if (quadrant + 1) & 2 == 2 {
        -angle
    } else {
        angle
    };
    rounded(cut_24(series(&SINE, angle * angle))) * angle
}

/// The sum of a series, not cut yet. The coefficient of the highest power comes first.
fn series<const N: usize>(coefficients: &[f64; N], x: f32) -> f64 {
    let x = f64::from(x);
    coefficients[1..].iter().fold(coefficients[0], |sum, &it| {
        let product = cut_32(cut_24(sum) * x);
        // What is entirely beyond the digits is not noticed; otherwise it would tell in the cut.
        if product.abs() < it.abs() * BEYOND {
            it
        } else {
            it + product
        }
    })
}

/// Cuts off what is beyond 24 digits.
const fn cut_24(value: f64) -> f64 {
    f64::from_bits(value.to_bits() & !0x1FFF_FFFF)
}

/// Cuts off what is beyond 32 digits.
const fn cut_32(value: f64) -> f64 {
    f64::from_bits(value.to_bits() & !0x1F_FFFF)
}

/// Rounds to 24 digits, a half upwards.
const fn nearest_24(value: f64) -> f64 {
    cut_24(f64::from_bits(value.to_bits() + 0x1000_0000))
}

/// Rounds to 32 digits, a half upwards.
const fn nearest_32(value: f64) -> f64 {
    cut_32(f64::from_bits(value.to_bits() + 0x10_0000))
}

#[expect(clippy::cast_possible_truncation, reason = "that is the precision")]
const fn rounded(value: f64) -> f32 {
    value as f32
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "it is small and positive, or not a number"
)]
const fn whole(value: f64) -> u32 {
    value as u32
}

/// Coefficients as they are kept: the first one in 24 digits, the others in 32.
const fn kept<const N: usize>(mut coefficients: [f64; N]) -> [f64; N] {
    coefficients[0] = nearest_24(coefficients[0]);
    let mut index = 1;
    while index < N {
        coefficients[index] = nearest_32(coefficients[index]);
        index += 1;
    }
    coefficients
}

const PI: f32 = core::f32::consts::PI;
const FRAC_PI_2: f32 = core::f32::consts::FRAC_PI_2;
/// A quarter of a turn.
const QUARTER: f64 = nearest_32(core::f64::consts::FRAC_PI_2);
/// From there on quarters are not counted one by one.
const MANY: f64 = 1000.0;
/// The 33rd digit.
const BEYOND: f64 = 1.0 / 4_294_967_296.0;

const SINE: [f64; 6] = kept([
    -0.000_000_023_9,
    0.000_002_752_6,
    -0.000_198_409_0,
    0.008_333_331_5,
    -0.166_666_666_4,
    1.0,
]);
const ARC_COSINE: [f64; 8] = kept([
    -0.001_262_491_1,
    0.006_670_090_1,
    -0.017_088_125_6,
    0.030_891_881_0,
    -0.050_174_304_6,
    0.088_978_987_4,
    -0.214_598_801_6,
    1.570_796_305_0,
]);
const ARC_TANGENT: [f64; 9] = kept([
    0.002_866_225_7,
    -0.016_165_736_7,
    0.042_909_613_8,
    -0.075_289_640_0,
    0.106_562_639_3,
    -0.142_088_994_4,
    0.199_935_508_5,
    -0.333_331_452_8,
    1.0,
]);
