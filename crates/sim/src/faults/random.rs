//! Chance that a seed decides.

/// The same numbers for the same seed (`SplitMix64`).
#[derive(Clone, Debug)]
pub(crate) struct Random(u64);

impl Random {
    /// One of many sequences that a seed has.
    pub(crate) fn new(seed: u64, sequence: u64) -> Self {
        let mut random = Self(seed);
        let start = random.next();
        Self(start ^ sequence.wrapping_mul(STEP))
    }

    /// Whether something comes to pass that does so in so many of a hundred cases.
    pub(crate) fn chance(&mut self, percent: f64) -> bool {
        self.share() * 100.0 < percent
    }

    /// From 0 to just below 1.
    #[expect(
        clippy::cast_precision_loss,
        reason = "53 bits are as many as a float holds"
    )]
    pub(crate) fn share(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// One of the eight bits of a byte.
    pub(crate) fn bit(&mut self) -> u8 {
        1 << (self.next() >> 61)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(STEP);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
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
        let mut random = Random(1_234_567);
        assert_eq!(random.next(), 6_457_827_717_110_365_317);
        assert_eq!(random.next(), 3_203_168_211_198_807_973);
        assert_eq!(random.next(), 9_817_491_932_198_370_423);
    }

    #[test]
    fn a_chance_of_one_percent_comes_once_in_a_hundred_times() {
        let mut random = Random::new(7, 0);
        let hits = (0..1_000_000).filter(|_| random.chance(1.0)).count();
        assert!((9_500..10_500).contains(&hits), "{hits}");
    }

    #[test]
    fn a_hundred_percent_is_always_and_every_bit_comes() {
        let mut random = Random::new(1, 2);
        assert!((0..10_000).all(|_| random.chance(100.0)));
        assert_eq!((0..1000).fold(0, |bits, _| bits | random.bit()), 0xFF);
    }

    #[test]
    fn other_sequences_of_a_seed_are_others() {
        assert_ne!(Random::new(1, 0).next(), Random::new(1, 1).next());
        assert_ne!(Random::new(1, 0).next(), Random::new(2, 0).next());
    }
}
