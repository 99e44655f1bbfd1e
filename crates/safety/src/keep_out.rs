//! Keep-outs: boxes and vertical cylinders, and their contact with parts of the arm.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::Bounds;
use crate::distance::distance;

/// A keep-out, which no part of the arm may touch.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum KeepOut {
    /// A box along the axes.
    Box(Area),
    /// A vertical cylinder.
    Cylinder(Cylinder),
}

/// A box along the axes of the base frame, in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Area {
    /// From back to front.
    pub x_mm: Bounds,
    /// From right to left.
    pub y_mm: Bounds,
    /// From bottom to top.
    pub z_mm: Bounds,
}

/// A vertical cylinder, in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cylinder {
    /// The x coordinate of its axis (forward).
    pub x_mm: f64,
    /// The y coordinate of its axis (left).
    pub y_mm: f64,
    /// Its radius, 0 or more.
    pub radius_mm: f64,
    /// From bottom to top.
    pub z_mm: Bounds,
}

impl KeepOut {
    /// Returns whether a straight line touches it when it is enlarged on all sides.
    ///
    /// An enlarged box stays a box and a cylinder a cylinder, so corners grow slightly more. A
    /// keep-out shrunk to nothing (`grown` below 0) touches nothing.
    pub(crate) fn touches(&self, line: &[[f64; 3]; 2], grown: f64) -> bool {
        match self {
            Self::Box(area) => {
                let spans = area.axes().map(|span| span.grown(grown));
                (0..3)
                    .try_fold(WHOLE, |part, axis| within(part, line, axis, spans[axis]))
                    .is_some()
            }
            Self::Cylinder(cylinder) => {
                let radius = cylinder.radius_mm + grown;
                let part = within(WHOLE, line, 2, cylinder.z_mm.grown(grown));
                radius >= 0.0
                    && part.is_some_and(|part| cylinder.axis_distance(line, part) <= radius)
            }
        }
    }

    /// Returns whether the whole sweep of a part of the arm, from its line at one end to its line
    /// at the other, keeps a distance of `room` on all sides.
    ///
    /// Each point of the part moves between its two end positions and strays from the straight line
    /// by less than `room`. A clear sweep may be rejected, but never the other way round.
    pub(crate) fn is_clear_of(&self, swept: &[[[f64; 3]; 2]; 2], room: f64) -> bool {
        self.has_face_between(swept, room) || {
            let [a, b] = swept;
            let middle = [mean(a[0], b[0]), mean(a[1], b[1])];
            let stray = 0.5 * distance(a[0], b[0]).max(distance(a[1], b[1]));
            !self.touches(&middle, room + stray)
        }
    }

    /// Returns how much it may grow until it touches one of these lines; negative if it already
    /// does.
    pub(crate) fn room(&self, lines: &[[[f64; 3]; 2]], most: f64) -> f64 {
        let touched = |grown| lines.iter().any(|line| self.touches(line, grown));
        let (mut clear, mut touching) = (-THICKEST_MM, most);
        if !touched(most) {
            return most;
        }
        for _ in 0..48 {
            let middle = 0.5 * (clear + touching);
            if touched(middle) {
                touching = middle;
            } else {
                clear = middle;
            }
        }
        clear
    }

    /// Returns whether one flat face has the keep-out on one side and all four corners on the
    /// other.
    fn has_face_between(&self, [a, b]: &[[[f64; 3]; 2]; 2], room: f64) -> bool {
        let corners = [a[0], a[1], b[0], b[1]];
        let beyond = |axis: usize, span: Bounds| {
            let Bounds { min, max } = span.grown(room);
            corners.iter().all(|corner| corner[axis] > max)
                || corners.iter().all(|corner| corner[axis] < min)
        };
        match self {
            Self::Box(area) => {
                let spans = area.axes();
                (0..3).any(|axis| beyond(axis, spans[axis]))
            }
            Self::Cylinder(cylinder) => {
                beyond(2, cylinder.z_mm) || cylinder.tangent_between(&corners, room)
            }
        }
    }
}

impl Area {
    pub(crate) const fn axes(&self) -> [Bounds; 3] {
        [self.x_mm, self.y_mm, self.z_mm]
    }
}

impl Cylinder {
    /// Returns the horizontal distance from the axis to a part of a line, given in shares of it.
    fn axis_distance(&self, [from, to]: &[[f64; 3]; 2], [start, end]: [f64; 2]) -> f64 {
        let [way_x, way_y] = [to[0] - from[0], to[1] - from[1]];
        let [x, y] = [self.x_mm - from[0], self.y_mm - from[1]];
        let length_v2 = way_x * way_x + way_y * way_y;
        let foot = if length_v2 > 0.0 {
            ((way_x * x + way_y * y) / length_v2).clamp(start, end)
        } else {
            start
        };
        (way_x * foot - x).hypot(way_y * foot - y)
    }

    /// Returns whether the vertical plane that faces the centre of the corners separates all of
    /// them from the keep-out.
    fn tangent_between(&self, corners: &[[f64; 3]; 4], room: f64) -> bool {
        let from_axis = |point: &[f64; 3]| [point[0] - self.x_mm, point[1] - self.y_mm];
        let [x, y] = corners
            .iter()
            .map(from_axis)
            .fold([0.0, 0.0], |sum, corner| {
                [sum[0] + corner[0], sum[1] + corner[1]]
            });
        let length = x.hypot(y);
        let off = |point: &[f64; 3]| {
            let [from_x, from_y] = from_axis(point);
            from_x * x + from_y * y > (self.radius_mm + room) * length
        };
        length > 0.0 && corners.iter().all(off)
    }
}

/// Returns the part of a line, in shares of it, that lies within `span` of an axis.
fn within(
    [start, end]: [f64; 2],
    [from, to]: &[[f64; 3]; 2],
    axis: usize,
    span: Bounds,
) -> Option<[f64; 2]> {
    let (at, way) = (from[axis], to[axis] - from[axis]);
    if span.min > span.max {
        return None;
    }
    if way == 0.0 {
        return span.contains(at).then_some([start, end]);
    }
    let (enters, leaves) = ((span.min - at) / way, (span.max - at) / way);
    let part = [start.max(enters.min(leaves)), end.min(enters.max(leaves))];
    (part[0] <= part[1]).then_some(part)
}

fn mean(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| 0.5 * (a[axis] + b[axis]))
}

/// A whole line.
const WHOLE: [f64; 2] = [0.0, 1.0];

/// No keep-out extends farther than this from its centre: a policy has none larger than 2000 mm.
const THICKEST_MM: f64 = 1100.0;
