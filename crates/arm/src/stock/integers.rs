//! The integers of the stock controller's processor.

/// The integer part of a number; 0 for NaN and for a number that does not fit in 32 bits.
#[expect(clippy::cast_possible_truncation, reason = "that is the point")]
#[must_use]
pub const fn whole(value: f32) -> i32 {
    if value.abs() < 2_147_483_648.0 {
        value as i32
    } else {
        0
    }
}

/// The integer part of a number in sixteen bits: the lower half of [`whole`].
#[expect(
    clippy::cast_possible_truncation,
    reason = "its integers are that short"
)]
#[must_use]
pub const fn short(value: f32) -> i16 {
    whole(value) as i16
}

/// The integer part of a number in sixteen bits without a sign, by way of 32 bits without a sign.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "its integers are that short"
)]
#[must_use]
pub const fn short_unsigned(value: f32) -> u16 {
    if 0.0 <= value && value < 4_294_967_296.0 {
        value as u32 as u16
    } else {
        short(value) as u16
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_truncated_towards_zero() {
        assert_eq!([whole(2.9), whole(-2.9)], [2, -2]);
        assert_eq!([short(2.9), short(-2.9)], [2, -2]);
    }

    #[test]
    fn sixteen_bits_keep_the_lower_half_of_larger_numbers() {
        assert_eq!(short(32_768.0), i16::MIN);
        assert_eq!(short(65_536.0 + 5.0), 5);
    }

    #[test]
    fn unsigned_the_same_bits_are_another_number() {
        assert_eq!(short_unsigned(33_833.3), 33_833);
        assert_eq!(short_unsigned(-166.6), u16::MAX - 165);
        assert_eq!(short_unsigned(2_147_483_648.0 + 512.0), 512);
        assert_eq!(short_unsigned(f32::NAN), 0);
        assert_eq!(short_unsigned(5e9), 0);
    }

    #[test]
    fn nan_and_overflow_become_0() {
        for value in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 3e9, -3e9] {
            assert_eq!((whole(value), short(value)), (0, 0), "of {value}");
        }
    }
}
