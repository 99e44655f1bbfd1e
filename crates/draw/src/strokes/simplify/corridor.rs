//! The corridor of a stroke: the discs around its points that vectors must pass.

use std::f64::consts::TAU;

use dobot_geometry::{Point, Vec2};

use super::MIN_VECTOR_MM;

/// A corner at which one vector ends and the next begins.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) at: Point,
    /// The last point of the stroke that is passed here.
    pub(super) passed: usize,
    /// The corner before, as an index into the expanded corners.
    pub(super) before: usize,
}

/// A stroke and the maximum distance of vectors from its points.
#[derive(Debug)]
pub(super) struct Corridor<'a> {
    /// The points, in passing order.
    pub(super) points: &'a [Point],
    /// Whether the path ends at its start.
    pub(super) closed: bool,
    /// The radii of the discs around the points, which must be hit in order.
    pub(super) radii: Vec<f64>,
    /// The minimum length of a vector, in mm.
    pub(super) least_mm: f64,
    /// The direction across the stroke at each point, of length 1 or 0.
    across: Vec<Vec2>,
}

impl<'a> Corridor<'a> {
    /// Creates a corridor of constant width.
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
            across(points[i] - points[before], points[after] - points[i])
        });
        Self {
            across: across.collect(),
            radii: vec![radius; points.len()],
            least_mm: MIN_VECTOR_MM,
            points,
            closed,
        }
    }

    /// Sets the minimum length of vectors.
    pub(super) fn of_vectors(self, least_mm: f64) -> Self {
        Self { least_mm, ..self }
    }

    /// Returns the two places beside a point, across the stroke.
    pub(super) fn beside(&self, i: usize) -> [Point; 2] {
        let (here, off) = (self.points[i], self.across[i] * self.radii[i]);
        [here + off, here - off]
    }

    /// Returns eight places around a point at the maximum distance of a vector.
    pub(super) fn around(&self, i: usize) -> impl Iterator<Item = Point> + use<'_> {
        let eighths = (0..8).map(|n| Vec2::from_angle(f64::from(n) * TAU / 8.0));
        eighths.map(move |direction| self.points[i] + direction * self.radii[i])
    }

    /// Whether the vector from `a` to `b` hits the discs of the points `first..=last` in order.
    pub(super) fn passes(&self, a: Point, b: Point, first: usize, last: usize) -> bool {
        let length = a.distance(b);
        if length == 0.0 {
            return false;
        }
        let along = (b - a) * (1.0 / length);
        let mut least: f64 = 0.0;
        (first..=last).all(|i| {
            let Some((enter, leave)) = self.disc_on_ray(a, along, i) else {
                return false;
            };
            least = least.max(enter);
            // Allow a tiny margin for a disc that is only touched.
            least <= leave.min(length) + HAIR
        })
    }

    /// Returns where a ray with a unit direction enters and leaves the disc of point `i`.
    fn disc_on_ray(&self, from: Point, along: Vec2, i: usize) -> Option<(f64, f64)> {
        let (way, radius) = (self.points[i] - from, self.radii[i]);
        let (middle, off) = (way.dot(along), way.cross(along));
        let half2 = radius * radius - off * off;
        (half2 >= -HAIR * radius).then(|| {
            let half = half2.max(0.0).sqrt();
            (middle - half, middle + half)
        })
    }

    /// Returns the farthest point of a ray within the tolerance of the segment that begins with
    /// point `i`, whose disc it hits.
    pub(super) fn exit(&self, from: Point, along: Vec2, i: usize) -> Option<Point> {
        if i + 1 == self.points.len() {
            return None;
        }
        let along = along * (1.0 / along.length());
        let (_, mut farthest) = self.disc_on_ray(from, along, i)?;
        if let Some((_, leave)) = self.disc_on_ray(from, along, i + 1) {
            farthest = farthest.max(leave);
        }
        if let Some(leave) = self.strip_on_ray(from, along, i) {
            farthest = farthest.max(leave);
        }
        (farthest > 0.0).then(|| from + along * farthest)
    }

    /// Returns where a ray leaves the rectangle around the segment that begins with point `i`, with
    /// the radius of the smaller disc as half width.
    fn strip_on_ray(&self, from: Point, along: Vec2, i: usize) -> Option<f64> {
        let (a, b) = (self.points[i], self.points[i + 1]);
        let radius = self.radii[i].min(self.radii[i + 1]);
        let length = a.distance(b);
        let unit = (b - a) * (1.0 / length);
        let across = unit.turn_90();
        let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
        let sides = [(unit, 0.0, length), (across, -radius, radius)];
        for (axis, low, high) in sides {
            let (here, speed) = ((from - a).dot(axis), along.dot(axis));
            let (one, other) = ((low - here) / speed, (high - here) / speed);
            if speed.abs() > HAIR {
                enter = enter.max(one.min(other));
                leave = leave.min(one.max(other));
            } else if here < low || here > high {
                return None;
            }
        }
        (enter <= leave && leave.is_finite()).then_some(leave)
    }
}

/// Returns the unit vector to the left of a path that turns at a point; zero at a reversal.
fn across(incoming: Vec2, outgoing: Vec2) -> Vec2 {
    let unit = |way: Vec2| way * (1.0 / way.length().max(f64::MIN_POSITIVE));
    let along = unit(incoming) + unit(outgoing);
    let length = along.length();
    if length > 1e-6 {
        along.turn_90() * (1.0 / length)
    } else {
        Vec2::ZERO
    }
}

const HAIR: f64 = 1e-9;
