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
    #[inline]
    #[must_use]
    pub fn cost(self, length_mm: f64) -> f64 {
        match self {
            Self::Length => length_mm,
            Self::Time { .. } if length_mm == 0.0 => 0.0,
            Self::Time {
                speed_mm_s: v,
                acceleration_mm_s2: a,
                least_s,
            } => {
                let time = if length_mm * a < v * v {
                    2.0 * (length_mm / a).sqrt()
                } else {
                    length_mm / v + v / a
                };
                time.max(least_s)
            }
        }
    }
}
