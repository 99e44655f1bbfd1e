//! One vector, the corners it joins and the points it has to pass.

use dobot_geometry::{Point, Vec2};

/// A place where one vector ends and the next begins.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) at: Point,
    /// The last point of the stroke that is passed here.
    pub(super) passed: usize,
    /// The corner before it, among those that were gone on from.
    pub(super) before: usize,
}

/// A stroke, and how far from its points a vector may pass.
#[derive(Debug)]
pub(super) struct Corridor<'a> {
    /// The points, in the order in which they are passed.
    pub(super) points: &'a [Point],
    /// Ends where it began.
    pub(super) closed: bool,
    /// The radius of the discs around the points that have to be hit in order.
    pub(super) radius: f64,
    /// For each point the way across the stroke, as long as the radius.
    across: Vec<Vec2>,
}

impl<'a> Corridor<'a> {
    pub(super) fn new(points: &'a [Point], closed: bool, radius: f64) -> Self {
        let closed = closed && points.len() > 2 && points.first() == points.last();
        let last = points.len().saturating_sub(1);
        let across = (0..points.len()).map(|i| {
            let before = if i == 0 && closed {
                last - 1
            } else {
                i.saturating_sub(1)
            };
            let after = (i + 1).min(last);
            across(points[i] - points[before], points[after] - points[i]) * radius
        });
        Self {
            across: across.collect(),
            points,
            closed,
            radius,
        }
    }

    /// The two places beside a point, across the stroke.
    pub(super) fn beside(&self, i: usize) -> [Point; 2] {
        let (here, off) = (self.points[i], self.across[i]);
        [here + off, here - off]
    }

    /// Whether the vector from `a` to `b` hits the discs of the points `first..=last` in order.
    pub(super) fn passes(&self, a: Point, b: Point, first: usize, last: usize) -> bool {
        let length = a.distance(b);
        if length == 0.0 {
            return false;
        }
        let along = (b - a) * (1.0 / length);
        let mut least: f64 = 0.0;
        self.points[first..=last].iter().all(|&p| {
            let Some((enter, leave)) = self.disc_on_ray(a, along, p) else {
                return false;
            };
            least = least.max(enter);
            // A hair's breadth, for a disc that is only touched.
            least <= leave.min(length) + HAIR
        })
    }

    /// Where a ray with a direction of length 1 enters and leaves the disc of a point.
    fn disc_on_ray(&self, from: Point, along: Vec2, p: Point) -> Option<(f64, f64)> {
        let way = p - from;
        let (middle, off) = (way.dot(along), way.cross(along));
        let half2 = self.radius * self.radius - off * off;
        (half2 >= -HAIR * self.radius).then(|| {
            let half = half2.max(0.0).sqrt();
            (middle - half, middle + half)
        })
    }

    /// The farthest point of a ray that lies within the tolerance of the segment that begins with
    /// point `i`, the disc of which it hits.
    pub(super) fn exit(&self, from: Point, along: Vec2, i: usize) -> Option<Point> {
        let (a, b) = (self.points[i], *self.points.get(i + 1)?);
        let along = along * (1.0 / along.length());
        let (_, mut farthest) = self.disc_on_ray(from, along, a)?;
        if let Some((_, leave)) = self.disc_on_ray(from, along, b) {
            farthest = farthest.max(leave);
        }
        if let Some(leave) = self.strip_on_ray(from, along, (a, b)) {
            farthest = farthest.max(leave);
        }
        (farthest > 0.0).then(|| from + along * farthest)
    }

    /// Where a ray leaves the rectangle around a segment, its sides the tolerance away.
    fn strip_on_ray(&self, from: Point, along: Vec2, (a, b): (Point, Point)) -> Option<f64> {
        let length = a.distance(b);
        let unit = (b - a) * (1.0 / length);
        let across = unit.turn_90();
        let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
        let sides = [(unit, 0.0, length), (across, -self.radius, self.radius)];
        for (axis, low, high) in sides {
            let (here, speed) = ((from - a).dot(axis), along.dot(axis));
            let (t, u) = ((low - here) / speed, (high - here) / speed);
            if speed.abs() > HAIR {
                enter = enter.max(t.min(u));
                leave = leave.min(t.max(u));
            } else if here < low || here > high {
                return None;
            }
        }
        (enter <= leave && leave.is_finite()).then_some(leave)
    }
}

/// The direction of length 1 to the left of a way that comes and goes on; zero where it turns right
/// back.
fn across(came: Vec2, goes: Vec2) -> Vec2 {
    let unit = |way: Vec2| way * (1.0 / way.length().max(f64::MIN_POSITIVE));
    let along = unit(came) + unit(goes);
    let length = along.length();
    if length > 1e-6 {
        along.turn_90() * (1.0 / length)
    } else {
        Vec2::ZERO
    }
}

const HAIR: f64 = 1e-9;
