//! The schedule of reconnection attempts.

use std::time::Duration;

/// The schedule of searches after a link was lost: after a quarter of a second, then after twice as
/// long each time, up to two seconds.
///
/// The [`Finder`](super::Finder) knows the port and tries it first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reconnect {
    due: Duration,
    pause: Duration,
}

impl Reconnect {
    /// Starts when a link is lost; `now` is the time by any clock that never goes back.
    #[must_use]
    pub const fn lost(now: Duration) -> Self {
        Self {
            due: now.saturating_add(SHORTEST),
            pause: SHORTEST,
        }
    }

    /// Handles a search that ended without an arm.
    pub fn handle_failure(&mut self, now: Duration) {
        self.pause = self.pause.saturating_mul(2).min(LONGEST);
        self.due = now.saturating_add(self.pause);
    }

    /// Returns when to search next, by the same clock.
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
