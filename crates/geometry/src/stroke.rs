//! Pen strokes in the plane.

use kurbo::Point;

/// A line that the pen draws without lifting; a single point is a dot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stroke {
    /// The corners of the line, at least one.
    pub points: Vec<Point>,
    /// Whether the line ends where it began (the last point repeats the first), so that drawing may
    /// start at any of its points.
    pub closed: bool,
}

impl Stroke {
    /// Creates a line that is not closed.
    #[must_use]
    pub const fn open(points: Vec<Point>) -> Self {
        Self {
            points,
            closed: false,
        }
    }

    /// Creates a closed line from a ring whose last point connects to the first.
    #[must_use]
    pub fn ring(mut points: Vec<Point>) -> Self {
        points.extend(points.first().copied());
        Self {
            points,
            closed: true,
        }
    }

    /// Returns the length of the line, in millimetres.
    #[must_use]
    pub fn length_mm(&self) -> f64 {
        let lengths = self.segments().map(|(a, b)| a.distance(b));
        // An empty sum is -0.0.
        lengths.sum::<f64>() + 0.0
    }

    /// Returns the segments of the line; a dot has none.
    pub fn segments(&self) -> impl Iterator<Item = (Point, Point)> {
        self.points.windows(2).map(|pair| (pair[0], pair[1]))
    }

    /// Returns the end of the line.
    #[must_use]
    pub fn last(&self) -> Option<Point> {
        self.points.last().copied()
    }
}

/// Returns points on the segment from `a` to `b`, both ends included, at most `step_mm` apart.
pub fn steps(a: Point, b: Point, step_mm: f64) -> impl Iterator<Item = Point> {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a count, saturating"
    )]
    let count = (a.distance(b) / step_mm).ceil().max(1.0) as u32;
    (0..=count).map(move |i| a.lerp(b, f64::from(i) / f64::from(count)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dot_has_no_segments_and_no_length() {
        let dot = Stroke::open(vec![Point::new(1.0, 2.0)]);
        assert_eq!((dot.segments().count(), dot.length_mm()), (0, 0.0));
    }
}
