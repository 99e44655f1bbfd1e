//! The latency of the line.

use std::fmt;
use std::time::Duration;

/// The round-trip time of the line, without the transmission time of the bytes at 9600 baud and the
/// response time of the controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Latency {
    /// The minimum.
    pub least: Duration,
    /// The maximum, which the checks wait.
    pub most: Duration,
}

impl Latency {
    /// Computes the latency from the response times, from the last byte of a command, at 9600 baud, to the last
    /// byte of the first status that shows it. Statuses alone vary by `jitter`; commands may as much.
    pub(crate) fn of(answers: &[Duration], jitter: Duration) -> Option<Self> {
        let (least, most) = (answers.iter().min()?, answers.iter().max()?);
        let spread = most.saturating_sub(*least + SPREAD);
        let jitter = if jitter < STEADY {
            Duration::ZERO
        } else {
            jitter
        };
        let least = least.saturating_sub(AT_ONCE);
        Some(Self {
            least,
            most: least + spread.max(2 * jitter),
        })
    }

    /// The one-way jitter of the line.
    pub(crate) fn jitter(&self) -> Duration {
        self.most.saturating_sub(self.least) / 2
    }
}

impl fmt::Display for Latency {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (least, most) = (self.least.as_millis(), self.most.as_millis());
        if least == most {
            write!(f, "{least} ms round trip")
        } else {
            write!(f, "{least} to {most} ms round trip")
        }
    }
}

/// The longest supported latency. It delays the detection of a lost release, and the arm must not
/// leave its space of 30 mm by then.
pub(crate) const MAX_LATENCY: Duration = Duration::from_millis(600);
/// The earliest response without delay: the command acts in the next tick, which is ten milliseconds
/// later or so, that tick or the next one reports it (note N41), and its status has 42 bytes to come.
const AT_ONCE: Duration = Duration::from_millis(64);
/// The variation of the response: a tick and a status period (note N20).
const SPREAD: Duration = Duration::from_millis(100);

/// A line with less jitter is steady.
const STEADY: Duration = Duration::from_millis(15);

#[cfg(test)]
mod tests {
    use super::*;

    fn of(answers: &[u64], jitter: u64) -> Option<String> {
        let answers: Vec<_> = answers.iter().copied().map(Duration::from_millis).collect();
        Latency::of(&answers, Duration::from_millis(jitter)).map(|latency| latency.to_string())
    }

    #[test]
    fn what_the_ticks_and_the_statuses_take_is_no_latency() {
        let formatted = |answers| of(answers, 4);
        assert_eq!(
            formatted(&[44, 164]).as_deref(),
            Some("0 to 20 ms round trip")
        );
        assert_eq!(formatted(&[364, 464]).as_deref(), Some("300 ms round trip"));
        assert_eq!(formatted(&[]), None);
    }

    #[test]
    fn a_larger_jitter_is_included_in_the_latency() {
        let formatted = of(&[114, 290, 200], 0);
        assert_eq!(formatted.as_deref(), Some("50 to 126 ms round trip"));
        let formatted = of(&[114, 190], 60);
        assert_eq!(formatted.as_deref(), Some("50 to 170 ms round trip"));
    }
}
