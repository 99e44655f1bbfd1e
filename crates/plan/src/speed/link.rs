//! How many vectors the arm has in hand.

use crate::LinkRate;

/// The link brings a vector in each period; what the arm has not begun waits in its queue. So a
/// vector may be shorter than a period if enough of them wait.
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
    /// How much time those that wait took on the link, in s.
    waiting_s: f64,
    most_s: f64,
    /// A vector that takes longer comes in pieces, in s.
    piece_s: f64,
}

impl Credit {
    pub(crate) fn new(link: LinkRate) -> Self {
        Self {
            period_s: link.period_s,
            waiting_s: 0.0,
            most_s: link.period_s * MOST_WAITING,
            piece_s: f64::INFINITY,
        }
    }

    /// The same where vectors that take longer come in pieces.
    pub(crate) const fn with_pieces(self, piece_s: f64) -> Self {
        Self { piece_s, ..self }
    }

    /// How long the next vector has to take at the least.
    pub(crate) fn least_s(&self) -> f64 {
        (self.period_s - self.waiting_s).max(0.0)
    }

    /// The next vector takes so long.
    pub(crate) fn take(&mut self, duration_s: f64) {
        let packets = (duration_s / self.piece_s).ceil().max(1.0);
        let waiting_s = self.waiting_s + duration_s - packets * self.period_s;
        self.waiting_s = waiting_s.clamp(0.0, self.most_s);
    }
}

/// A stock arm tells its state while fewer than four wait; one is left for where statuses and
/// vectors begin at different times.
const MOST_WAITING: f64 = 2.0;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_vectors_may_follow_a_long_one_until_none_waits() {
        let mut credit = Credit::new(LinkRate { period_s: 0.08 });
        assert_eq!(credit.least_s(), 0.08);
        credit.take(1.0);
        // Two wait, and a third comes while they are run.
        assert_eq!(credit.least_s(), 0.0);
        credit.take(0.04);
        credit.take(0.04);
        assert!((credit.least_s() - 0.0).abs() < 1e-12);
        credit.take(0.04);
        assert!((credit.least_s() - 0.04).abs() < 1e-12);
    }

    #[test]
    fn a_vector_that_comes_in_pieces_leaves_less_time_for_others_to_come() {
        let mut credit = Credit::new(LinkRate { period_s: 0.08 }).with_pieces(0.2);
        // Two packets; the next one has come for a quarter of its time.
        credit.take(0.22);
        assert!((credit.least_s() - 0.02).abs() < 1e-12);
    }
}
