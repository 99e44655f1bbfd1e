//! How long the line takes.

use std::fmt;
use std::time::Duration;

/// How long the line takes there and back, on top of what the bytes need at 9600 baud and of what
/// the controller needs to answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Latency {
    /// When it is fast.
    pub least: Duration,
    /// When it is slow: what the checks wait.
    pub most: Duration,
}

impl Latency {
    /// What the answers say: the times from the last byte of a command, at 9600 baud, to the last
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

    /// By how much the line varies one way.
    pub(crate) fn jitter(&self) -> Duration {
        self.most.saturating_sub(self.least) / 2
    }
}

impl fmt::Display for Latency {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (least, most) = (self.least.as_millis(), self.most.as_millis());
        if least == most {
            write!(f, "{least} ms there and back")
        } else {
            write!(f, "{least} to {most} ms there and back")
        }
    }
}

/// The longest that the checks can work with. A button whose release got lost is noticed that much
/// later, and the arm must not have left its room of 30 mm by then.
pub(crate) const MOST: Duration = Duration::from_millis(600);
/// The soonest answer without any delay: the command acts in the next tick, which is ten milliseconds
/// later or so, that tick or the one after it tells so (note N41), and its status has 42 bytes to come.
const AT_ONCE: Duration = Duration::from_millis(64);
/// How much later another one may come: a tick, and the time between two statuses (note N20).
const SPREAD: Duration = Duration::from_millis(100);

/// A line that varies by less is steady.
const STEADY: Duration = Duration::from_millis(15);

#[cfg(test)]
mod tests {
    use super::*;

    fn of(answers: &[u64], jitter: u64) -> Option<String> {
        let answers: Vec<_> = answers.iter().copied().map(Duration::from_millis).collect();
        Latency::of(&answers, Duration::from_millis(jitter)).map(|it| it.to_string())
    }

    #[test]
    fn what_the_ticks_and_the_statuses_take_is_no_latency() {
        let told = |answers| of(answers, 4);
        assert_eq!(
            told(&[44, 164]).as_deref(),
            Some("0 to 20 ms there and back")
        );
        assert_eq!(told(&[364, 464]).as_deref(), Some("300 ms there and back"));
        assert_eq!(told(&[]), None);
    }

    #[test]
    fn what_varies_by_more_is_told_and_waited_for() {
        let told = of(&[114, 290, 200], 0);
        assert_eq!(told.as_deref(), Some("50 to 126 ms there and back"));
        let told = of(&[114, 190], 60);
        assert_eq!(told.as_deref(), Some("50 to 170 ms there and back"));
    }
}
