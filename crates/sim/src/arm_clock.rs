//! What time it is for a served arm.

use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use tokio::time::Instant;

use crate::Speed;

/// What time it is for a served arm, or, without one, for everybody: for those who live with it and
/// wait by its time. Clones show the same time.
#[derive(Clone, Debug)]
pub struct ArmClock {
    speed: Speed,
    set: Arc<Mutex<Set>>,
}

/// When a clock was set, and to what.
#[derive(Clone, Copy, Debug)]
struct Set {
    at: Instant,
    to: Duration,
}

impl ArmClock {
    /// A clock that begins now, as fast as all others.
    #[must_use]
    pub fn real() -> Self {
        Self::at_speed(Speed::REAL)
    }

    pub(crate) fn at_speed(speed: Speed) -> Self {
        let set = Set {
            at: Instant::now(),
            to: Duration::ZERO,
        };
        Self {
            speed,
            set: Arc::new(Mutex::new(set)),
        }
    }

    /// What time it is.
    #[must_use]
    pub fn now(&self) -> Duration {
        let set = self.set();
        if self.speed.is_max() {
            return set.to;
        }
        set.to + self.speed.of_clock(set.at.elapsed())
    }

    /// When it will be that time; at the greatest speed nobody knows, and it is worth a look soon.
    #[must_use]
    pub fn instant(&self, time: Duration) -> Option<Instant> {
        let set = self.set();
        let later = time.saturating_sub(set.to);
        if self.speed.is_max() {
            let look = if later.is_zero() { later } else { SOON };
            return Instant::now().checked_add(look);
        }
        // Further ahead than any clock goes.
        let later = (later < FAR).then(|| self.speed.of_arm(later))?;
        set.at.checked_add(later)
    }

    /// It is that time now.
    pub(crate) fn set_to(&self, to: Duration) {
        let at = Instant::now();
        *self.set.lock().unwrap_or_else(PoisonError::into_inner) = Set { at, to };
    }

    pub(crate) const fn is_max(&self) -> bool {
        self.speed.is_max()
    }

    fn set(&self) -> Set {
        *self.set.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Nobody plans further ahead: a century.
const FAR: Duration = Duration::from_hours(24 * 365 * 100);
/// At the greatest speed a client has so long to answer, before time goes on.
pub(crate) const SOON: Duration = Duration::from_millis(1);

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test(start_paused = true)]
    async fn a_thousand_times_as_fast_a_second_is_a_thousand() {
        let clock = ArmClock::at_speed("1000".parse().expect("a speed"));
        clock.set_to(Duration::from_secs(5));
        tokio::time::advance(Duration::from_secs(1)).await;
        assert_eq!(clock.now(), Duration::from_secs(1005));
        let wanted = Instant::now() + Duration::from_millis(60);
        assert_eq!(clock.instant(Duration::from_secs(1065)), Some(wanted));
        assert_eq!(clock.instant(Duration::MAX), None);
    }

    #[tokio::test(start_paused = true)]
    async fn at_the_greatest_speed_the_arm_alone_lets_time_pass() {
        let clock = ArmClock::at_speed(Speed::MAX);
        tokio::time::advance(Duration::from_secs(1)).await;
        assert_eq!(clock.now(), Duration::ZERO);
        clock.set_to(Duration::from_secs(7));
        assert_eq!(clock.now(), Duration::from_secs(7));
        assert_eq!(clock.instant(clock.now()), Some(Instant::now()));
        let soon = Instant::now() + SOON;
        assert_eq!(clock.instant(Duration::from_secs(8)), Some(soon));
    }
}
