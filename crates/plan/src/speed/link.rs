//! The vectors queued in the arm.

use crate::LinkRate;

/// The queue of the arm, as time credit: the link delivers a vector per period, and vectors not
/// begun yet wait in the queue. A vector may be shorter than a period if enough others wait.
///
/// ```text
///   waiting
///     2 |----.        ,-.---           the queue takes no more than that
///       |     `.    ,'   `
///     0 |_______`--'________ time      none may be over before the next is there
///         short      long
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(clippy::struct_field_names, reason = "units")]
pub(crate) struct Credit {
    period_s: f64,
    /// The link time of the waiting vectors, in s.
    waiting_s: f64,
    most_s: f64,
    /// The duration above which a vector is divided, in s.
    piece_s: f64,
}

impl Credit {
    pub(crate) fn new(link: LinkRate) -> Self {
        Self {
            period_s: link.period_s,
            waiting_s: 0.0,
            most_s: link.period_s * MAX_WAITING,
            piece_s: f64::INFINITY,
        }
    }

    /// Takes into account that vectors of longer duration are divided.
    pub(crate) const fn with_pieces(self, piece_s: f64) -> Self {
        Self { piece_s, ..self }
    }

    /// Returns the minimum duration of the next vector.
    pub(crate) fn least_s(&self) -> f64 {
        (self.period_s - self.waiting_s).max(0.0)
    }

    /// Adds the next vector with its duration.
    pub(crate) fn take(&mut self, duration_s: f64) {
        let packets = (duration_s / self.piece_s).ceil().max(1.0);
        let waiting_s = self.waiting_s + duration_s - packets * self.period_s;
        self.waiting_s = waiting_s.clamp(0.0, self.most_s);
    }
}

/// A stock arm reports its state while fewer than four vectors wait; one is reserved because
/// statuses and vectors begin at different times.
const MAX_WAITING: f64 = 2.0;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_vectors_may_follow_a_long_one_until_none_is_queued() {
        let mut credit = Credit::new(LinkRate { period_s: 0.08 });
        assert_eq!(credit.least_s(), 0.08);
        credit.take(1.0);
        // Two wait, and a third arrives while they are executed.
        assert_eq!(credit.least_s(), 0.0);
        credit.take(0.04);
        credit.take(0.04);
        assert!((credit.least_s() - 0.0).abs() < 1e-12);
        credit.take(0.04);
        assert!((credit.least_s() - 0.04).abs() < 1e-12);
    }

    #[test]
    fn a_vector_in_pieces_leaves_less_time_for_others_to_arrive() {
        let mut credit = Credit::new(LinkRate { period_s: 0.08 }).with_pieces(0.2);
        // Two packets; a quarter of the next one has arrived.
        credit.take(0.22);
        assert!((credit.least_s() - 0.02).abs() < 1e-12);
    }
}
