//! Numbers in texts.

use crate::limits::MAX_NUMBER;

/// The decimal number without an exponent that a text begins with, and its length in bytes.
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
