//! Numbers in texts.

use crate::limits::MAX_NUMBER;

/// The decimal number without an exponent at the start of a text, and its length in bytes.
pub(crate) fn decimal(text: &[u8]) -> Option<(f64, usize)> {
    let is_part = |(i, byte): &(usize, &u8)| match byte {
        b'0'..=b'9' | b'.' => true,
        b'+' | b'-' => *i == 0,
        _ => false,
    };
    let length = text.iter().enumerate().take_while(is_part).count();
    let digits = std::str::from_utf8(&text[..length]).ok()?;
    let number: f64 = digits.parse().ok()?;
    (number.abs() <= MAX_NUMBER).then_some((number, length))
}

/// The number, optionally with an exponent, at the start of a text, and its length in bytes.
pub(crate) fn real(text: &[u8]) -> Option<(f64, usize)> {
    let digits = |from: usize| {
        let rest = text.get(from..).unwrap_or_default();
        from + rest.iter().take_while(|byte| byte.is_ascii_digit()).count()
    };
    let signed = |from: usize| match text.get(from) {
        Some(b'+' | b'-') => from + 1,
        _ => from,
    };
    let mut end = digits(signed(0));
    if text.get(end) == Some(&b'.') {
        end = digits(end + 1);
    }
    if let Some(b'e' | b'E') = text.get(end) {
        let exponent = signed(end + 1);
        let whole = digits(exponent);
        end = if whole > exponent { whole } else { end };
    }
    let number: f64 = std::str::from_utf8(&text[..end]).ok()?.parse().ok()?;
    (number.abs() <= MAX_NUMBER).then_some((number, end))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_ends_before_the_next_letter_that_is_not_part_of_it() {
        for (text, found) in [
            ("1c1", Some((1.0, 1))),
            ("-0.5V2", Some((-0.5, 4))),
            ("+.25 7", Some((0.25, 4))),
            ("2.e", Some((2.0, 2))),
            ("1e-3c", Some((0.001, 4))),
            ("1e9", Some((1e9, 3))),
            ("1e10", None),
            ("1e308", None),
            ("nan", None),
            ("inf", None),
            ("-", None),
            ("", None),
        ] {
            assert_eq!(real(text.as_bytes()), found, "{text:?}");
        }
    }
}
