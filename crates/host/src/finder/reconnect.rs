//! When to look for an arm again.

use std::time::Duration;

/// When to look for an arm again after its link was lost: after a quarter of a second, then after
/// twice as long each time, up to two seconds.
///
/// The [`Finder`](super::Finder) knows which port it was and tries that one first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reconnect {
    due: Duration,
    pause: Duration,
}

impl Reconnect {
    /// The link was lost now; `now` is the time by any clock that never goes back.
    #[must_use]
    pub const fn lost(now: Duration) -> Self {
        Self {
            due: now.saturating_add(SHORTEST),
            pause: SHORTEST,
        }
    }

    /// Nothing was found; the search ended now.
    pub fn handle_failure(&mut self, now: Duration) {
        self.pause = self.pause.saturating_mul(2).min(LONGEST);
        self.due = now.saturating_add(self.pause);
    }

    /// When to look next, by the same clock.
    #[must_use]
    pub const fn poll_wakeup(&self) -> Duration {
        self.due
    }
}

const SHORTEST: Duration = Duration::from_millis(250);
const LONGEST: Duration = Duration::from_secs(2);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pauses_grow_from_a_quarter_of_a_second_to_two_seconds() {
        let lost = Duration::from_secs(100);
        let mut reconnect = Reconnect::lost(lost);
        let mut now = lost;
        let mut pauses_ms = Vec::new();
        for _ in 0..6 {
            let next = reconnect.poll_wakeup();
            pauses_ms.push(next.abs_diff(now).as_millis());
            now = next + Duration::from_secs(5);
            reconnect.handle_failure(now);
        }
        assert_eq!(pauses_ms, [250, 500, 1000, 2000, 2000, 2000]);
    }
}
