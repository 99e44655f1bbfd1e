//! The functions of the stock controller's processor, digit by digit.
//!
//! Its compiler's library keeps 32 binary digits between the steps of a function where single
//! precision has 24, and cuts off what is beyond. Factors are cut to 24 digits first. The series are
//! those of Abramowitz and Stegun. Doubles hold each exact result, so that only the cutting has to
//! be done here; addition, multiplication, division and root of single precision are as everywhere.

/// Sine and cosine, by formula 4.3.97.
pub(super) fn sin_cos(x: f32) -> (f32, f32) {
    let (rest, quadrant) = divided(x);
    let turned = if x.is_sign_negative() { 2 } else { 0 };
    (sine(rest, quadrant + turned), sine(rest, quadrant + 1))
}

/// By formula 4.4.46; not a number outside of -1 to 1.
pub(super) fn acos(x: f32) -> f32 {
    let size = x.abs();
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
    let is_steep = x.abs() > 1.0;
    let slope = if is_steep { 1.0 / x } else { x };
    let angle = f64::from(slope) * nearest_24(odd_series(&ARC_TANGENT, slope));
    rounded(if is_steep {
        QUARTER.copysign(x.into()) - cut_32(angle)
    } else {
        angle
    })
}

/// The angle of a point, from -pi to pi; 0 for the origin, whatever the signs.
pub(super) fn atan2(y: f32, x: f32) -> f32 {
    if y.abs() > x.abs() {
        FRAC_PI_2.copysign(y) + atan(-(x / y))
    } else if x == 0.0 && y == 0.0 {
        0.0
    } else if x.is_sign_negative() {
        PI.copysign(y) + atan(y / x)
    } else {
        atan(y / x)
    }
}

/// What is left of an angle's size once all quarters of a turn are taken away, and their number or
/// one that is as good.
fn divided(x: f32) -> (f64, u32) {
    let size = f64::from(x.abs());
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
    rounded(cut_24(odd_series(&SINE, angle))) * angle
}

/// One and the powers of a square, not cut yet: by what an angle and its sine, or a slope and its
/// angle, differ.
fn odd_series<const N: usize>(coefficients: &[f64; N], x: f32) -> f64 {
    let square = x * x;
    let rest = term(series(coefficients, square), square.into());
    // What is entirely beyond the digits of the one is lost; otherwise it changes the rounding.
    if rest.abs() < BEYOND { 1.0 } else { 1.0 + rest }
}

/// The sum of a series, not cut yet. The coefficient of the highest power comes first.
fn series<const N: usize>(coefficients: &[f64; N], x: f32) -> f64 {
    let x = f64::from(x);
    let first = coefficients[0];
    coefficients[1..]
        .iter()
        .fold(first, |sum, coefficient| coefficient + term(sum, x))
}

/// What the sum of the higher powers adds to a coefficient.
fn term(sum: f64, x: f64) -> f64 {
    cut_32(cut_24(sum) * x)
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

const SINE: [f64; 5] = kept([
    -0.000_000_023_9,
    0.000_002_752_6,
    -0.000_198_409_0,
    0.008_333_331_5,
    -0.166_666_666_4,
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
const ARC_TANGENT: [f64; 8] = kept([
    0.002_866_225_7,
    -0.016_165_736_7,
    0.042_909_613_8,
    -0.075_289_640_0,
    0.106_562_639_3,
    -0.142_088_994_4,
    0.199_935_508_5,
    -0.333_331_452_8,
]);

#[cfg(test)]
mod tests {
    use core::ops::Range;

    use proptest::prelude::*;

    use super::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        #[test]
        fn double_precision_matches_the_integer_arithmetic_of_the_processor(
            angle in numbers(-40..8),
            slope in numbers(-40..20),
            cosine in -1.0_f32..=1.0,
        ) {
            let (sin, cos) = sin_cos(angle);
            prop_assert_eq!(sin, exact::sin(angle), "sin {}", angle);
            prop_assert_eq!(cos, exact::cos(angle), "cos {}", angle);
            prop_assert_eq!(atan(slope), exact::atan(slope), "atan {}", slope);
            prop_assert_eq!(acos(cosine), exact::acos(cosine), "acos {}", cosine);
        }

        #[test]
        fn angles_are_off_by_two_digits_at_most(
            angle in -7.0_f32..7.0,
            cosine in -1.0_f32..=1.0,
            y in numbers(-20..20),
            x in numbers(-20..20),
        ) {
            let (sin, cos) = sin_cos(angle);
            let near = |got: f32, expected: f64, off: f64| (f64::from(got) - expected).abs() <= off;
            prop_assert!(near(sin, libm::sin(angle.into()), LAST_TWO), "sin {}: {}", angle, sin);
            prop_assert!(near(cos, libm::cos(angle.into()), LAST_TWO), "cos {}: {}", angle, cos);
            // Half of the last digit of an angle above 2, and the error of the series.
            let off = 1.2e-7 + 2e-7;
            prop_assert!(near(acos(cosine), libm::acos(cosine.into()), off), "acos {}", cosine);
            let expected = libm::atan2(y.into(), x.into());
            prop_assert!(near(atan2(y, x), expected, off), "atan2 {} {}", y, x);
        }

        #[test]
        fn only_nan_and_overflow_give_nan(bits: u32, more: u32) {
            let (a, b) = (f32::from_bits(bits), f32::from_bits(more));
            let (sin, cos) = sin_cos(a);
            prop_assert_eq!(sin.is_nan(), !a.is_finite(), "sin {}", a);
            prop_assert_eq!(cos.is_nan(), !a.is_finite(), "cos {}", a);
            prop_assert_eq!(acos(a).is_nan(), !(-1.0..=1.0).contains(&a), "acos {}", a);
            prop_assert_eq!(atan(a).is_nan(), a.is_nan(), "atan {}", a);
            if a.is_finite() || b.is_finite() {
                prop_assert_eq!(atan2(a, b).is_nan(), a.is_nan() || b.is_nan(), "atan2 {} {}", a, b);
            }
        }
    }

    #[test]
    fn the_quarters_of_a_turn_are_exact() {
        for (y, x, expected) in [
            (0.0, 1.0, 0.0),
            (-0.0, 1.0, -0.0),
            (1.0, 0.0, FRAC_PI_2),
            (-1.0, -0.0, -FRAC_PI_2),
            (0.0, -1.0, PI),
            (-0.0, -1.0, -PI),
            (0.0, 0.0, 0.0),
            (-0.0, -0.0, 0.0),
        ] {
            assert_eq!(atan2(y, x).to_bits(), f32::to_bits(expected), "{y} {x}");
        }
        assert!(atan2(f32::NAN, 0.0).is_nan());
    }

    /// Two in the last place of one.
    const LAST_TWO: f64 = 2.4e-7;

    /// Numbers of all sizes between two powers of two, of either sign.
    fn numbers(powers: Range<i32>) -> impl Strategy<Value = f32> {
        let parts = (powers, 1.0_f32..2.0, any::<bool>());
        parts.prop_map(|(power, part, is_negative)| {
            libm::scalbnf(if is_negative { -part } else { part }, power)
        })
    }

    /// A second implementation in integers, digit by digit.
    mod exact {
        use super::super::{ARC_COSINE, ARC_TANGENT, QUARTER, SINE};

        /// A mantissa of 32 digits, the first of them 1, or nothing; and whether there is more.
        #[derive(Clone, Copy)]
        struct Wide {
            is_negative: bool,
            power: i32,
            mantissa: u64,
            has_more: bool,
        }

        pub(super) fn sin(x: f32) -> f32 {
            sine(x, if x < 0.0 { 2 } else { 0 })
        }

        pub(super) fn cos(x: f32) -> f32 {
            sine(x, 1)
        }

        pub(super) fn atan(x: f32) -> f32 {
            let slope = if x.abs() > 1.0 { 1.0 / x } else { x };
            let factor = half_up(series(&ARC_TANGENT, true, slope * slope));
            let angle = product(factor, wide(slope.into()));
            if x.abs() > 1.0 {
                round(sum(wide(QUARTER.copysign(x.into())), negative(angle)))
            } else {
                round(angle)
            }
        }

        pub(super) fn acos(x: f32) -> f32 {
            let factor = half_up(series(&ARC_COSINE, false, x.abs()));
            let angle = product(wide(libm::sqrtf(1.0 - x.abs()).into()), factor);
            if x.is_sign_negative() {
                round(sum(wide(2.0 * QUARTER), negative(angle)))
            } else {
                round(angle)
            }
        }

        fn sine(x: f32, quarters: u64) -> f32 {
            // In units of 2^-80 every angle down to 2^-40 is a whole number.
            let quarter = u128::from(wide(QUARTER).mantissa) << (80 - 31);
            let size = {
                let size = wide(x.abs().into());
                u128::from(size.mantissa) << (80 + size.power)
            };
            let quadrant = u64::try_from(size / quarter).expect("at most 2^8") + quarters;
            let rest = size % quarter;
            let rest = Wide {
                is_negative: false,
                power: 16 - rest.leading_zeros().cast_signed(),
                mantissa: u64::try_from((rest << rest.leading_zeros()) >> 96).expect("32 digits"),
                has_more: false,
            };
            let angle = round(if quadrant % 2 == 1 {
                sum(rest, wide(-QUARTER))
            } else {
                rest
            });
            let angle = if quadrant % 4 == 1 || quadrant % 4 == 2 {
                -angle
            } else {
                angle
            };
            let factor = series(&SINE, true, angle * angle);
            round(product(factor, wide(angle.into())))
        }

        fn series(coefficients: &[f64], ends_with_one: bool, x: f32) -> Wide {
            let x = wide(x.into());
            let one = ends_with_one.then_some(1.0);
            let mut coefficients = coefficients.iter().copied().chain(one).map(wide);
            let first = coefficients.next().expect("a series");
            coefficients.fold(first, |so_far, coefficient| {
                sum(product(so_far, x), coefficient)
            })
        }

        /// Of the first 24 digits of each. Digits after the 32nd are lost, except in the last step.
        fn product(a: Wide, b: Wide) -> Wide {
            let digits = (a.mantissa >> 8) * (b.mantissa >> 8);
            let shift = i32::from(digits != 0 && digits >> 47 == 0);
            let digits = digits << shift;
            Wide {
                is_negative: a.is_negative != b.is_negative,
                power: a.power + b.power + 32 - shift,
                mantissa: digits >> 16,
                has_more: digits & 0xFFFF != 0,
            }
        }

        fn sum(a: Wide, b: Wide) -> Wide {
            let key = |number: &Wide| (number.mantissa != 0, number.power, number.mantissa);
            let (large, small) = if key(&a) < key(&b) { (b, a) } else { (a, b) };
            let distance = large.power - small.power;
            if small.mantissa == 0 || distance > 32 {
                return Wide {
                    has_more: false,
                    ..large
                };
            }
            let shifted = small.mantissa >> distance;
            let is_cut = shifted << distance != small.mantissa;
            let mut digits = large.mantissa << 8;
            let mut power = large.power;
            if large.is_negative == small.is_negative {
                digits += (shifted << 8) | u64::from(is_cut);
            } else {
                // Any remainder is worth almost a digit.
                digits -= (shifted << 8) + u64::from(is_cut);
            }
            while digits >> 40 != 0 {
                digits = (digits >> 1) | (digits & 1);
                power += 1;
            }
            while digits != 0 && digits >> 39 == 0 {
                digits <<= 1;
                power -= 1;
            }
            Wide {
                is_negative: large.is_negative,
                power,
                mantissa: digits >> 8,
                has_more: digits & 0xFF != 0,
            }
        }

        /// To the nearest 24 digits; where there is no nearest, to the even one.
        fn round(number: Wide) -> f32 {
            let (kept, rest) = (number.mantissa >> 8, number.mantissa & 0xFF);
            let is_up = rest > 0x80 || rest == 0x80 && (number.has_more || kept % 2 == 1);
            narrow(number, kept + u64::from(is_up))
        }

        fn half_up(number: Wide) -> Wide {
            wide(narrow(number, (number.mantissa + 0x80) >> 8).into())
        }

        fn negative(number: Wide) -> Wide {
            Wide {
                is_negative: !number.is_negative,
                ..number
            }
        }

        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_precision_loss,
            reason = "there are 25 digits, and the 25th is 0"
        )]
        fn narrow(number: Wide, digits: u64) -> f32 {
            let size = libm::scalbn(digits as f64, number.power + 8) as f32;
            if number.is_negative { -size } else { size }
        }

        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "whole numbers of 32 digits"
        )]
        fn wide(value: f64) -> Wide {
            let (part, power) = libm::frexp(value.abs());
            Wide {
                is_negative: value.is_sign_negative(),
                power: power - 32,
                mantissa: libm::scalbn(part, 32) as u64,
                has_more: false,
            }
        }
    }
}
