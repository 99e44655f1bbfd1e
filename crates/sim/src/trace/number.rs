//! Numbers as text, as C's `%d` and `%.9g` write them.

use std::io::Write as _;

/// Appends a whole number.
pub(super) fn push_int(text: &mut Vec<u8>, value: i64) {
    write!(text, "{value}").expect("a vector takes all");
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
        push_decimal(text, value.abs());
    }
}

/// Appends a positive float by its nine digits; zeros at the end are left out, and where the first
/// digit counts a power of ten below -4 or above 8, an exponent is added.
fn push_decimal(text: &mut Vec<u8>, value: f32) {
    let scientific = format!("{value:.8e}");
    let parts = scientific.split_once('e');
    let (digits, exponent) = parts.expect("an exponent was asked for");
    let exponent: i32 = exponent.parse().expect("an exponent is a whole number");
    let digits = digits.replace('.', "");
    let len = digits.trim_end_matches('0').len();
    let digits = digits.as_bytes();
    let size = exponent.unsigned_abs() as usize;
    match exponent {
        -4..=-1 => {
            text.extend_from_slice(&b"0.000"[..=size]);
            text.extend_from_slice(&digits[..len]);
        }
        0..=8 => push_parts(text, digits, size + 1, len),
        _ => {
            push_parts(text, digits, 1, len);
            let sign = if exponent < 0 { '-' } else { '+' };
            write!(text, "e{sign}{size:02}").expect("a vector takes all");
        }
    }
}

/// Appends digits with a decimal point after a number of them.
fn push_parts(text: &mut Vec<u8>, digits: &[u8], point: usize, len: usize) {
    text.extend_from_slice(&digits[..point]);
    if len > point {
        text.push(b'.');
        text.extend_from_slice(&digits[point..len]);
    }
}

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
