//! The numbers of the packets.

/// A number as a packet holds it.
#[expect(
    clippy::cast_possible_truncation,
    reason = "packets hold single precision"
)]
#[inline]
#[must_use]
pub const fn single(number: f64) -> f32 {
    number as f32
}
