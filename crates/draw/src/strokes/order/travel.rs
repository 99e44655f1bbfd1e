//! The cost of pen-up travel.

/// The cost to minimise when strokes are ordered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Travel {
    /// The length, in mm.
    Length,
    /// The arm's time from rest to rest, in seconds.
    Time {
        /// The speed reached on a long way, in mm/s; above 0.
        speed_mm_s: f64,
        /// The acceleration, in mm/s²; above 0.
        acceleration_mm_s2: f64,
        /// The minimum time of any travel, because the link delivers no more packets.
        least_s: f64,
    },
}

impl Travel {
    /// Returns the cost of a straight travel of `length_mm`, in millimetres or seconds; 0 for no
    /// travel.
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

/// The cost of a travel as the sum of a term per mm, a term for the square root of its length, and
/// a constant: without divisions, for the inner loops of the search.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fare {
    /// The length in mm below which only the square root counts, and above which it does not.
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

    /// Returns the cost of a straight travel of `length_mm`; 0 for no travel.
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
