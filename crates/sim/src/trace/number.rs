//! Numbers as text, as C's `%d` and `%.9g` write them: exact, and fast enough for millions.

/// Appends a whole number.
pub(super) fn push_int(text: &mut Vec<u8>, value: i64) {
    if value < 0 {
        text.push(b'-');
    }
    let mut rest = value.unsigned_abs();
    let mut digits = [0; 20];
    let mut first = digits.len();
    loop {
        first -= 1;
        digits[first] = digit(rest);
        rest /= 10;
        if rest == 0 {
            break;
        }
    }
    text.extend_from_slice(&digits[first..]);
}

/// Appends a float with up to nine significant digits: from them every `f32` comes back as it was.
pub(super) fn push_float(text: &mut Vec<u8>, value: f32) {
    if value.is_nan() {
        text.extend_from_slice(b"nan");
        return;
    }
    if value.is_sign_negative() {
        text.push(b'-');
    }
    if value.is_infinite() {
        text.extend_from_slice(b"inf");
    } else if value == 0.0 {
        text.push(b'0');
    } else {
        let (digits, exponent) = nine_digits(value.abs());
        push_decimal(text, digits, exponent);
    }
}

/// Appends nine digits, the first of which counts so many powers of ten; zeros at the end are left
/// out, and below the power of -4 and above that of 8 the power is told.
fn push_decimal(text: &mut Vec<u8>, mut rest: u64, exponent: i32) {
    let mut digits = [0; 9];
    for place in digits.iter_mut().rev() {
        *place = digit(rest);
        rest /= 10;
    }
    let len = 1 + digits.iter().rposition(|&it| it != b'0').unwrap_or(0);
    let size = exponent.unsigned_abs() as usize;
    match exponent {
        -4..=-1 => {
            text.extend_from_slice(&b"0.000"[..=size]);
            text.extend_from_slice(&digits[..len]);
        }
        0..=8 => push_parts(text, &digits, size + 1, len),
        _ => {
            push_parts(text, &digits, 1, len);
            text.extend_from_slice(if exponent < 0 { b"e-" } else { b"e+" });
            if size < 10 {
                text.push(b'0');
            }
            push_int(text, i64::from(exponent.abs()));
        }
    }
}

/// Appends digits with a point behind so many of them.
fn push_parts(text: &mut Vec<u8>, digits: &[u8; 9], point: usize, len: usize) {
    text.extend_from_slice(&digits[..point]);
    if len > point {
        text.push(b'.');
        text.extend_from_slice(&digits[point..len]);
    }
}

/// The nine significant digits of a positive float, and the power of ten of the first.
fn nine_digits(value: f32) -> (u64, i32) {
    // 1233 / 4096 is log10(2), a little less: the guess is right or one too low.
    let power_of_two = (value.to_bits() >> 23).cast_signed() - 127;
    let guess = (power_of_two * 1233) >> 12;
    [guess, guess + 1]
        .into_iter()
        .find_map(|exponent| Some((scaled(value, exponent)?, exponent)))
        .map_or_else(|| by_the_library(value), rounded_up)
}

/// A value whose digits begin at this power of ten, multiplied so that nine of them are whole, and
/// rounded; `None` where they begin elsewhere, or where the number is too great or too small.
fn scaled(value: f32, exponent: i32) -> Option<u64> {
    let bits = value.to_bits();
    // The value is mantissa / 2^shift.
    let mantissa = u128::from(bits & 0x007F_FFFF | 0x0080_0000);
    let shift = 150_u32.checked_sub(bits >> 23).filter(|&it| it < 128)?;
    let power = usize::try_from(8 - exponent).ok()?;
    let whole = half_to_even(mantissa * POWERS.get(power)?, shift);
    let digits = u64::try_from(whole).ok()?;
    (LEAST..=10 * LEAST).contains(&digits).then_some(digits)
}

/// Divides by a power of two; what lies in the middle goes to the even side.
const fn half_to_even(value: u128, shift: u32) -> u128 {
    let whole = value >> shift;
    let rest = value - (whole << shift);
    let half = (1 << shift) >> 1;
    let up = shift > 0 && (rest > half || (rest == half && whole & 1 == 1));
    if up { whole + 1 } else { whole }
}

/// What was rounded up to ten digits has nine of the next power.
const fn rounded_up((digits, exponent): (u64, i32)) -> (u64, i32) {
    if digits == 10 * LEAST {
        (LEAST, exponent + 1)
    } else {
        (digits, exponent)
    }
}

/// For the very great and the very small.
fn by_the_library(value: f32) -> (u64, i32) {
    let text = format!("{value:.8e}");
    let (digits, exponent) = text.split_once('e').expect("an exponent was asked for");
    let digits = digits
        .bytes()
        .filter(u8::is_ascii_digit)
        .fold(0, |sum, digit| sum * 10 + u64::from(digit - b'0'));
    let exponent = exponent.parse().expect("an exponent is a whole number");
    (digits, exponent)
}

const fn digit(number: u64) -> u8 {
    b'0' + (number % 10) as u8
}

/// The least number of nine digits.
const LEAST: u64 = 100_000_000;

/// As many powers of ten as leave room for a mantissa.
const POWERS: [u128; 32] = {
    let mut powers = [1; 32];
    let mut n = 1;
    while n < powers.len() {
        powers[n] = powers[n - 1] * 10;
        n += 1;
    }
    powers
};

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test fails by it")]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn text(value: f32) -> String {
        let mut text = Vec::new();
        push_float(&mut text, value);
        String::from_utf8(text).unwrap()
    }

    /// By the exact decimals of the library, in the way that C's standard describes `%.9g`.
    fn slowly(value: f32) -> String {
        if value == 0.0 || !value.is_finite() {
            return text(value);
        }
        let scientific = format!("{value:.8e}");
        let (digits, exponent) = scientific.split_once('e').unwrap();
        let exponent: i32 = exponent.parse().unwrap();
        let short = |it: &str| it.trim_end_matches('0').trim_end_matches('.').to_owned();
        if (-4..9).contains(&exponent) {
            let places = usize::try_from(8 - exponent).unwrap();
            let fixed = format!("{value:.places$}");
            if places > 0 { short(&fixed) } else { fixed }
        } else {
            let sign = if exponent < 0 { '-' } else { '+' };
            format!("{}e{sign}{:02}", short(digits), exponent.abs())
        }
    }

    #[test]
    fn floats_read_as_in_the_recordings() {
        for (value, expected) in [
            (263.666_47, "263.666473"),
            (-17.677_673, "-17.6776733"),
            (1263.6665, "1263.6665"),
            (0.06, "0.0599999987"),
            (0.060_000_002, "0.0600000024"),
            (45.06, "45.0600014"),
            (-7.526_844e-5, "-7.52684427e-05"),
            (8.533_688e-10, "8.5336882e-10"),
            (1.525_878_9e-5, "1.52587891e-05"),
            (0.0, "0"),
            (-0.0, "-0"),
            (45.0, "45"),
            (1000.0, "1000"),
            (f32::NAN, "nan"),
            (-f32::NAN, "nan"),
            (f32::INFINITY, "inf"),
            (f32::NEG_INFINITY, "-inf"),
        ] {
            assert_eq!(text(value), expected);
        }
    }

    #[test]
    fn the_ends_of_the_range_are_written_as_c_does() {
        for (value, expected) in [
            (f32::MAX, "3.40282347e+38"),
            (f32::MIN_POSITIVE, "1.17549435e-38"),
            (f32::from_bits(1), "1.40129846e-45"),
            (999_999_999.0, "1e+09"),
            (123_456_792.0, "123456792"),
            (1e-4, "9.99999975e-05"),
            (0.000_1_f32.next_up(), "0.000100000005"),
            (9_999_998_976.0, "9.99999898e+09"),
            (16_777_216.0, "16777216"),
        ] {
            assert_eq!(text(value), expected);
        }
    }

    #[test]
    fn whole_numbers_have_all_their_digits() {
        for (value, expected) in [
            (0, "0"),
            (-7, "-7"),
            (500, "500"),
            (i64::MAX, "9223372036854775807"),
            (i64::MIN, "-9223372036854775808"),
        ] {
            let mut text = Vec::new();
            push_int(&mut text, value);
            assert_eq!(text, expected.as_bytes());
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        #[test]
        fn every_float_is_written_exactly_and_comes_back(bits in any::<u32>()) {
            let value = f32::from_bits(bits);
            let found = text(value);
            prop_assert_eq!(&found, &slowly(value));
            let back: f32 = found.parse().unwrap();
            prop_assert!(back == value || value.is_nan() && back.is_nan());
        }

        #[test]
        fn everyday_floats_are_written_exactly(value in -2000.0_f32..2000.0) {
            prop_assert_eq!(text(value), slowly(value));
        }
    }
}
