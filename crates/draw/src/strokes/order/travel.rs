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
    /// The reciprocals of the factors.
    per_root: f64,
    per_mm: f64,
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
                per_root: f64::INFINITY,
                per_mm: 1.0,
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
                per_root: 0.5 * a.sqrt(),
                per_mm: v,
            },
        }
    }

    /// Returns the square of a length that no travel cheaper than this cost exceeds, in mm²: for the inner loops,
    /// without roots.
    #[inline]
    pub(super) fn most_mm2(self, cost: f64) -> f64 {
        let by_root = cost * self.per_root;
        let most_mm = if by_root * by_root < self.long_mm {
            by_root * by_root
        } else {
            (cost - self.anyhow) * self.per_mm
        };
        // Costs are rounded to single precision.
        most_mm * most_mm * (1.0 + 1e-5)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_travel_is_cheaper_than_the_longest_of_its_cost() {
        let timed = |least_s| Travel::Time {
            speed_mm_s: 50.0,
            acceleration_mm_s2: 100.0,
            least_s,
        };
        for travel in [Travel::Length, timed(0.0), timed(0.08)] {
            let fare = Fare::of(travel);
            for length_mm in [0.01, 0.5, 1.0, 24.9, 25.1, 300.0] {
                let cost = fare.cost(length_mm);
                let most_mm = fare.most_mm2(cost).sqrt();
                assert!(
                    most_mm >= length_mm,
                    "{travel:?}: {most_mm}, {length_mm} mm"
                );
                let beyond = fare.cost(1.001 * most_mm);
                assert!(
                    beyond > cost,
                    "{travel:?}: {beyond} for {most_mm} mm, {cost}"
                );
            }
        }
    }
}
