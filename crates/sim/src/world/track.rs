//! Long ways in few points.

use dobot_geometry::{Point, Vec2};

/// A way that grows at its end and keeps few points: those that it needs to stay within
/// [`KEPT_MM`] of where it really went.
///
/// From the last corner it looks ahead: each point passed by opens a wedge of the directions that
/// lead past it closely enough. As long as the next point lies in all wedges and no nearer than what
/// was passed by, the last point moves there; otherwise it becomes the next corner.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Track {
    /// The corners, and the end.
    points: Vec<Point>,
    /// The directions from the last corner that pass all points since: clockwise and
    /// counter-clockwise edge. `None` while every direction is fine.
    wedge: Option<(Vec2, Vec2)>,
    /// How far from the last corner the farthest point since is.
    reach_mm: f64,
}

impl Track {
    /// A way that begins here.
    pub(crate) fn new(at: Point) -> Self {
        Self {
            points: vec![at],
            wedge: None,
            reach_mm: 0.0,
        }
    }

    /// Goes on to a point.
    pub(crate) fn push(&mut self, to: Point) {
        let end = self.end();
        if to == end {
            return;
        }
        if self.points.len() == 1 {
            self.points.push(to);
        } else if self.allows(to) {
            let last = self.points.len() - 1;
            self.points[last] = to;
        } else {
            self.points.push(to);
            (self.wedge, self.reach_mm) = (None, 0.0);
        }
        self.pass(to);
    }

    pub(crate) fn points(&self) -> &[Point] {
        &self.points
    }

    pub(crate) fn end(&self) -> Point {
        self.points[self.points.len() - 1]
    }

    /// The last corner: the end is never one.
    fn corner(&self) -> Point {
        self.points[self.points.len().saturating_sub(2)]
    }

    fn allows(&self, to: Point) -> bool {
        let way = to - self.corner();
        let inside =
            |(right, left): (Vec2, Vec2)| right.cross(way) >= 0.0 && way.cross(left) >= 0.0;
        self.wedge.is_none_or(inside) && way.length() >= self.reach_mm - KEPT_MM
    }

    /// Narrows the wedge to the directions that pass `by`.
    fn pass(&mut self, by: Point) {
        let way = by - self.corner();
        let distance = way.length();
        self.reach_mm = self.reach_mm.max(distance);
        if distance <= KEPT_MM {
            return;
        }
        let sin = KEPT_MM / distance;
        let cos = (1.0 - sin * sin).sqrt();
        let turned = |sin| way.rotate_scale(Vec2::new(cos, sin));
        let (mut right, mut left) = (turned(-sin), turned(sin));
        if let Some((old_right, old_left)) = self.wedge {
            if old_right.cross(right) <= 0.0 {
                right = old_right;
            }
            if left.cross(old_left) <= 0.0 {
                left = old_left;
            }
        }
        self.wedge = Some((right, left));
    }
}

/// The length of a way.
pub(crate) fn length_mm(points: &[Point]) -> f64 {
    points
        .windows(2)
        .map(|pair| pair[0].distance(pair[1]))
        .sum()
}

/// Less than a motor step moves the wrist: no line shows it.
pub(crate) const KEPT_MM: f64 = 0.02;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use dobot_geometry::{Line, ParamCurveNearest};

    use super::*;

    fn track(points: impl IntoIterator<Item = (f64, f64)>) -> Track {
        let mut points = points.into_iter().map(|(x, y)| Point::new(x, y));
        let mut track = Track::new(points.next().expect("it begins somewhere"));
        points.for_each(|point| track.push(point));
        track
    }

    fn distance_mm(point: Point, points: &[Point]) -> f64 {
        let to_segment = |pair: &[Point]| {
            let segment = Line::new(pair[0], pair[1]);
            segment.nearest(point, 0.0).distance_sq.sqrt()
        };
        let alone = point.distance(points[0]);
        points.windows(2).map(to_segment).fold(alone, f64::min)
    }

    #[test]
    fn an_hour_of_straight_lines_takes_a_point_for_each_corner() {
        let square = [
            (0.0, 0.0),
            (50.0, 0.0),
            (50.0, 50.0),
            (0.0, 50.0),
            (0.0, 0.0),
        ];
        let steps = square.windows(2).flat_map(|pair| {
            let [(x, y), (to_x, to_y)] = [pair[0], pair[1]];
            (0..1000)
                .map(move |i| f64::from(i) / 1000.0)
                .map(move |s| (x + (to_x - x) * s, y + (to_y - y) * s))
        });
        let found = track(steps.chain([(0.0, 0.0)]));
        assert_eq!(found.points(), square.map(|(x, y)| Point::new(x, y)));
    }

    #[test]
    fn a_way_back_over_itself_keeps_its_farthest_point() {
        let found = track([(0.0, 0.0), (5.0, 0.0), (9.0, 0.0), (6.0, 0.0), (2.0, 0.0)]);
        assert_eq!(found.points(), [0.0, 9.0, 2.0].map(|x| Point::new(x, 0.0)));
    }

    proptest! {
        #[test]
        fn no_point_is_farther_from_the_track_than_twice_what_is_kept(
            steps in proptest::collection::vec((-0.02..0.05_f64, -0.02..0.02_f64), 1..200),
        ) {
            let mut at = (0.0, 0.0);
            let points: Vec<_> = steps.iter().map(|(x, y)| { at = (at.0 + x, at.1 + y); at }).collect();
            let found = track(points.iter().copied());
            for (x, y) in points {
                let off = distance_mm(Point::new(x, y), found.points());
                prop_assert!(off <= 2.0 * KEPT_MM, "{off} mm off");
            }
        }
    }
}
