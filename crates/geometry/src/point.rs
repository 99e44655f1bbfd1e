//! Points and pen strokes in the plane.

use std::ops::{Add, Mul, Sub};

/// A point in the plane, or the way from one point to another, in millimetres.
///
/// On the sheet x points right and y down, as in an SVG file; in the base frame x points forward
/// and y to the left (Figure 3.1).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// To the right on the sheet, forward in the base frame.
    pub x: f64,
    /// Down on the sheet, to the left in the base frame.
    pub y: f64,
}

impl Point {
    /// The point `x_mm`, `y_mm`.
    #[must_use]
    pub const fn new(x_mm: f64, y_mm: f64) -> Self {
        Self { x: x_mm, y: y_mm }
    }

    /// The point a share `t` of the way to another: here at 0, there at 1.
    #[must_use]
    pub fn lerp(self, other: Self, t: f64) -> Self {
        self + (other - self) * t
    }

    /// Points on the straight way to another, both ends included, at most `step_mm` apart.
    pub fn steps_to(self, other: Self, step_mm: f64) -> impl Iterator<Item = Self> {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a count, saturating"
        )]
        let count = (self.distance(other) / step_mm).ceil().max(1.0) as u32;
        (0..=count).map(move |i| self.lerp(other, f64::from(i) / f64::from(count)))
    }

    /// The distance from the origin.
    #[must_use]
    pub fn length(self) -> f64 {
        self.length2().sqrt()
    }

    /// The distance from the origin, squared.
    #[must_use]
    pub fn length2(self) -> f64 {
        self.dot(self)
    }

    /// The straight distance to another point.
    #[must_use]
    pub fn distance(self, other: Self) -> f64 {
        (other - self).length()
    }

    /// The scalar product.
    #[must_use]
    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y
    }

    /// The vector product: positive where `other` lies from x towards y.
    #[must_use]
    pub fn cross(self, other: Self) -> f64 {
        self.x * other.y - self.y * other.x
    }

    /// The point of the segment from `a` to `b` that is nearest to this one.
    #[must_use]
    pub fn nearest_on(self, a: Self, b: Self) -> Self {
        let along = b - a;
        let length2 = along.length2();
        if length2 == 0.0 {
            return a;
        }
        a.lerp(b, ((self - a).dot(along) / length2).clamp(0.0, 1.0))
    }
}

impl FromIterator<Point> for Bounds {
    fn from_iter<I: IntoIterator<Item = Point>>(points: I) -> Self {
        Self::of(points)
    }
}

impl Add for Point {
    type Output = Self;
    fn add(self, by: Self) -> Self {
        Self::new(self.x + by.x, self.y + by.y)
    }
}

impl Sub for Point {
    type Output = Self;
    fn sub(self, from: Self) -> Self {
        Self::new(self.x - from.x, self.y - from.y)
    }
}

impl Mul<f64> for Point {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self::new(self.x * factor, self.y * factor)
    }
}

/// What the pen draws between touching the paper and leaving it: one point is a dot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stroke {
    /// The corners of the line, at least one.
    pub points: Vec<Point>,
    /// The line ends where it began (the last point repeats the first), so that it may be drawn
    /// from any of its points.
    pub closed: bool,
}

impl Stroke {
    /// A line that is not closed.
    #[must_use]
    pub const fn open(points: Vec<Point>) -> Self {
        Self {
            points,
            closed: false,
        }
    }

    /// How long the line is, in millimetres.
    #[must_use]
    pub fn length_mm(&self) -> f64 {
        self.segments().map(|(a, b)| a.distance(b)).sum()
    }

    /// The straight pieces of the line; a dot has none.
    pub fn segments(&self) -> impl Iterator<Item = (Point, Point)> {
        self.points.windows(2).map(|pair| (pair[0], pair[1]))
    }

    /// Where the line ends.
    #[must_use]
    pub fn last(&self) -> Option<Point> {
        self.points.last().copied()
    }
}

/// An upright rectangle in millimetres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The corner with the smaller coordinates.
    pub min: Point,
    /// The corner with the larger coordinates.
    pub max: Point,
}

impl Bounds {
    /// What holds no point yet.
    pub const EMPTY: Self = Self {
        min: Point::new(f64::INFINITY, f64::INFINITY),
        max: Point::new(f64::NEG_INFINITY, f64::NEG_INFINITY),
    };

    /// The smallest rectangle that holds these points.
    pub fn of(points: impl IntoIterator<Item = Point>) -> Self {
        points.into_iter().fold(Self::EMPTY, Self::with)
    }

    /// The smallest rectangle that holds these strokes.
    #[must_use]
    pub fn of_strokes(strokes: &[Stroke]) -> Self {
        Self::of(strokes.iter().flat_map(|s| s.points.iter().copied()))
    }

    /// This rectangle, grown to hold a point.
    #[must_use]
    pub fn with(self, p: Point) -> Self {
        Self {
            min: Point::new(self.min.x.min(p.x), self.min.y.min(p.y)),
            max: Point::new(self.max.x.max(p.x), self.max.y.max(p.y)),
        }
    }

    /// This rectangle, grown by a margin on every side.
    #[must_use]
    pub fn grown(self, margin_mm: f64) -> Self {
        let margin = Point::new(margin_mm, margin_mm);
        Self {
            min: self.min - margin,
            max: self.max + margin,
        }
    }

    /// Extent along x.
    #[must_use]
    pub fn width(self) -> f64 {
        self.max.x - self.min.x
    }

    /// Extent along y.
    #[must_use]
    pub fn height(self) -> f64 {
        self.max.y - self.min.y
    }

    /// The middle.
    #[must_use]
    pub fn center(self) -> Point {
        self.min.lerp(self.max, 0.5)
    }

    /// Whether the rectangles share a point.
    #[must_use]
    pub fn touches(self, other: Self) -> bool {
        self.min.x <= other.max.x
            && other.min.x <= self.max.x
            && self.min.y <= other.max.y
            && other.min.y <= self.max.y
    }

    /// The squared distance to a point; 0 inside.
    #[must_use]
    pub fn distance2(self, p: Point) -> f64 {
        let dx = (self.min.x - p.x).max(p.x - self.max.x).max(0.0);
        let dy = (self.min.y - p.y).max(p.y - self.max.y).max(0.0);
        dx * dx + dy * dy
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_point_of_a_segment_may_be_inside_or_an_end() {
        let (a, b) = (Point::new(0.0, 0.0), Point::new(10.0, 0.0));
        assert_eq!(Point::new(3.0, 4.0).nearest_on(a, b), Point::new(3.0, 0.0));
        assert_eq!(Point::new(13.0, 4.0).nearest_on(a, b), b);
        assert_eq!(Point::new(-1.0, 4.0).nearest_on(a, a), a);
    }

    #[test]
    fn a_dot_has_no_segments_and_no_length() {
        let dot = Stroke::open(vec![Point::new(1.0, 2.0)]);
        assert_eq!((dot.segments().count(), dot.length_mm()), (0, 0.0));
    }
}
