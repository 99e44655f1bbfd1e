//! Back-off for a program that sends useless bytes.

use std::time::Duration;

/// Back-off for a program that sends useless bytes: refused packets or noise.
///
/// Useless bytes are accepted at the speed of an arm's line. A program that sends one command for
/// each status never waits, even if all of them are refused; nor does one that sends half a second
/// of noise in one burst.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Backoff {
    /// The time at which an arm's line would have carried all useless bytes so far.
    carried_by: Duration,
}

impl Backoff {
    /// Counts useless bytes; `now` never decreases.
    pub(crate) fn handle_bytes(&mut self, now: Duration, count: u64) {
        let begins = self.carried_by.max(now);
        self.carried_by = begins.saturating_add(BYTE_TIME.saturating_mul(saturated(count)));
    }

    /// Returns the time at which the next bytes may be read.
    pub(crate) const fn poll_wakeup(&self) -> Duration {
        self.carried_by.saturating_sub(AT_ONCE)
    }
}

fn saturated(count: u64) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}

/// A byte at 9600 baud, 8N1, rounded up: 22.7 packets a second, of which flow control uses 12.5.
const BYTE_TIME: Duration = Duration::from_micros(1042);
/// The length of a burst that is free.
const AT_ONCE: Duration = Duration::from_millis(500);

#[cfg(test)]
mod tests {
    use super::*;

    const fn ms(ms: u64) -> Duration {
        Duration::from_millis(ms)
    }

    #[test]
    fn one_useless_packet_for_each_status_never_waits() {
        let mut backoff = Backoff::default();
        for status in 0..1000 {
            let now = ms(80) * status;
            assert!(backoff.poll_wakeup() <= now, "at status {status}");
            backoff.handle_bytes(now, 42);
        }
    }

    #[test]
    fn useless_bytes_are_read_no_faster_than_a_line_carries_them() {
        let mut backoff = Backoff::default();
        let mut now = Duration::ZERO;
        let mut taken = 0_u32;
        while now < Duration::from_mins(1) {
            backoff.handle_bytes(now, 4096);
            taken += 4096;
            now = now.max(backoff.poll_wakeup());
        }
        // The bytes of a line of 960 bytes/s in a minute, and two free reads.
        assert!((50_000..60 * 960 + 2 * 4096).contains(&taken), "{taken}");
    }

    #[test]
    fn patience_recovers_while_no_useless_bytes_arrive() {
        let mut backoff = Backoff::default();
        backoff.handle_bytes(Duration::ZERO, 480);
        backoff.handle_bytes(ms(600), 400);
        assert!(backoff.poll_wakeup() <= ms(600), "{backoff:?}");
    }

    #[test]
    fn any_number_of_bytes_is_accepted() {
        let mut backoff = Backoff::default();
        backoff.handle_bytes(Duration::MAX, u64::MAX);
        backoff.handle_bytes(ms(1), u64::MAX);
        assert!(backoff.poll_wakeup() > ms(1));
    }
}
