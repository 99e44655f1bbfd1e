//! Chance that can be repeated.

use std::time::Duration;

use dobot_geometry::Random;

/// The random choices of a case; the same seed gives the same choices.
#[derive(Clone, Debug)]
pub(crate) struct Chance(Random);

impl Chance {
    /// Begins with a seed.
    pub(crate) const fn new(seed: u64) -> Self {
        Self(Random::new(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15)))
    }

    /// Any number.
    pub(crate) const fn number(&mut self) -> u64 {
        self.0.number()
    }

    /// A number below `end`.
    pub(crate) const fn below(&mut self, end: u64) -> u64 {
        self.number() % end
    }

    /// A length or an angle from `from` to `to`, in steps of a hundredth of that.
    #[expect(clippy::cast_precision_loss, reason = "a hundred is exact")]
    pub(crate) fn between(&mut self, from: f32, to: f32) -> f32 {
        let share = self.below(101) as f32 / 100.0;
        from + (to - from) * share
    }

    /// A time below `end`, to the microsecond.
    pub(crate) fn time(&mut self, end: Duration) -> Duration {
        let most = u64::try_from(end.as_micros()).unwrap_or(u64::MAX);
        Duration::from_micros(self.below(most.max(1)))
    }

    /// One of some.
    pub(crate) fn one<T: Copy>(&mut self, of: &[T]) -> T {
        let at = self.below(of.len() as u64);
        of[usize::try_from(at).unwrap_or_default()]
    }
}
