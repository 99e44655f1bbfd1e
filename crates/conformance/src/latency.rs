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
    /// byte of the first status that shows it.
    pub(crate) fn of(answers: &[Duration]) -> Option<Self> {
        let (least, most) = (answers.iter().min()?, answers.iter().max()?);
        let jitter = (*most - *least).saturating_sub(SPREAD);
        let least = least.saturating_sub(AT_ONCE);
        Some(Self {
            least,
            most: least + jitter,
        })
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
/// The soonest answer without any delay: the command acts in the next tick, the tick after it tells
/// so (note N41), its status has 42 bytes to come; ten more until the tick, for one of the tries.
const AT_ONCE: Duration = Duration::from_millis(74);
/// How much later another one may come: a tick, and the time between two statuses (note N20).
const SPREAD: Duration = Duration::from_millis(100);

#[cfg(test)]
mod tests {
    use super::*;

    fn of(answers: &[u64]) -> Option<String> {
        let answers: Vec<_> = answers.iter().copied().map(Duration::from_millis).collect();
        Latency::of(&answers).map(|it| it.to_string())
    }

    #[test]
    fn what_the_ticks_and_the_statuses_take_is_no_latency() {
        assert_eq!(of(&[64, 164]).as_deref(), Some("0 ms there and back"));
        assert_eq!(of(&[374, 474]).as_deref(), Some("300 ms there and back"));
        assert_eq!(of(&[]), None);
    }

    #[test]
    fn what_varies_by_more_is_told_and_waited_for() {
        let told = of(&[124, 300, 200]);
        assert_eq!(told.as_deref(), Some("50 to 126 ms there and back"));
    }
}
