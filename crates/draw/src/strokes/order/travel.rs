//! What a way with the pen up costs.

/// What counts when strokes are put in order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Travel {
    /// The length of the way, in mm.
    Length,
    /// The time that the arm takes, in seconds, from rest to rest.
    Time {
        /// The speed it reaches on a long way, in mm/s; above 0.
        speed_mm_s: f64,
        /// How fast it gets there and stops again, in mm/s²; above 0.
        acceleration_mm_s2: f64,
        /// What a way takes however short it is, because the link carries no more packets.
        least_s: f64,
    },
}

impl Travel {
    /// What a straight way of `length_mm` costs, in millimetres or seconds. No way costs nothing.
    ///
    /// ```text
    ///   speed ^    ______               speed ^
    ///         |   /      \                    |   /\
    ///         |  /        \                   |  /  \
    ///         +----------------> t            +--------> t
    ///           d/v + v/a                       2 sqrt(d/a), where d < v²/a
    /// ```
    #[must_use]
    pub fn cost(self, length_mm: f64) -> f64 {
        Fare::of(self).cost(length_mm)
    }
}

/// The cost of a way as the sum of so much for each mm, so much for the root of its length, and so much anyhow:
/// without the divisions, for a search that asks all the time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fare {
    /// Below this length only the root counts, from there on it does not; in mm.
    long_mm: f64,
    for_root: f64,
    for_mm: f64,
    anyhow: f64,
    least: f64,
}

impl Fare {
    pub(super) fn of(travel: Travel) -> Self {
        match travel {
            Travel::Length => Self {
                long_mm: 0.0,
                for_root: 0.0,
                for_mm: 1.0,
                anyhow: 0.0,
                least: 0.0,
            },
            Travel::Time {
                speed_mm_s: v,
                acceleration_mm_s2: a,
                least_s,
            } => Self {
                long_mm: v * v / a,
                for_root: 2.0 / a.sqrt(),
                for_mm: 1.0 / v,
                anyhow: v / a,
                least: least_s,
            },
        }
    }

    /// What a straight way of `length_mm` costs. No way costs nothing.
    #[inline]
    pub(super) fn cost(self, length_mm: f64) -> f64 {
        if length_mm == 0.0 {
            return 0.0;
        }
        let cost = if length_mm < self.long_mm {
            self.for_root * length_mm.sqrt()
        } else {
            self.for_mm * length_mm + self.anyhow
        };
        cost.max(self.least)
    }
}
