//! A pseudo-random number generator (`SplitMix64`). Any library that guarantees its sequences would
//! also do.

/// A pseudo-random number generator: a seed gives the same numbers on every machine and in every
/// version.
///
/// Path orders, shadings, faults and tests are repeatable because the numbers never change. It is
/// not suitable for cryptography.
///
/// ```
/// use dobot_geometry::Random;
///
/// let [mut one, mut again] = [Random::new(7), Random::new(7)];
/// assert_eq!(one.below(6), again.below(6));
/// assert!(one.share() < 1.0);
/// ```
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// Creates the sequence of a seed.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Creates one of the many sequences of a seed.
    #[must_use]
    pub const fn sequence(seed: u64, sequence: u64) -> Self {
        let start = Self(seed).number();
        Self(start ^ sequence.wrapping_mul(STEP))
    }

    /// Returns the next number.
    pub const fn number(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(STEP);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    }

    /// Returns a number below `count`, which must be at least 1.
    pub fn below(&mut self, count: u32) -> u32 {
        (((self.number() >> 32) * u64::from(count)) >> 32) as u32
    }

    /// Returns a number from 0 to just below 1.
    #[expect(
        clippy::cast_precision_loss,
        reason = "53 bits are as many as a float holds"
    )]
    pub fn share(&mut self) -> f64 {
        (self.number() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Returns `true` with the given probability, in percent.
    pub fn chance(&mut self, percent: f64) -> bool {
        self.share() * 100.0 < percent
    }
}

/// 2^64 divided by the golden ratio.
const STEP: u64 = 0x9E37_79B9_7F4A_7C15;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_numbers_are_those_of_splitmix64() {
        // The reference sequence for the seed 1234567, as published with the algorithm.
        let mut random = Random::new(1_234_567);
        assert_eq!(random.number(), 6_457_827_717_110_365_317);
        assert_eq!(random.number(), 3_203_168_211_198_807_973);
        assert_eq!(random.number(), 9_817_491_932_198_370_423);
    }

    #[test]
    fn a_chance_of_one_percent_occurs_once_in_a_hundred_times() {
        let mut random = Random::sequence(7, 0);
        let hits = (0..1_000_000).filter(|_| random.chance(1.0)).count();
        assert!((9_500..10_500).contains(&hits), "{hits}");
    }

    #[test]
    fn a_chance_of_a_hundred_percent_always_occurs() {
        let mut random = Random::sequence(1, 2);
        assert!((0..10_000).all(|_| random.chance(100.0)));
    }

    #[test]
    fn every_number_below_a_count_occurs_and_no_other() {
        let mut random = Random::new(1);
        let seen = (0..1000).fold(0_u32, |seen, _| seen | 1 << random.below(8));
        assert_eq!(seen, 0xFF);
    }

    #[test]
    fn different_sequences_of_a_seed_differ() {
        let first = |seed, sequence| Random::sequence(seed, sequence).number();
        assert_ne!(first(1, 0), first(1, 1));
        assert_ne!(first(1, 0), first(2, 0));
    }
}
