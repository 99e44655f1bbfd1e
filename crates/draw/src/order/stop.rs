//! A stroke in an order.

use crate::point::{Point, Stroke};

/// A stroke and the point of it where it is begun: one of the ends, or any corner where it is closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Stop {
    pub(super) stroke: u32,
    pub(super) point: u32,
}

impl Stop {
    /// Where the pen comes down.
    pub(super) fn begin(self, stroke: &Stroke) -> Point {
        stroke.points[self.point as usize]
    }

    /// Where it leaves the paper.
    pub(super) fn end(self, stroke: &Stroke) -> Point {
        self.other_end(stroke).begin(stroke)
    }

    /// The same stroke, begun from its other end; a closed one has none.
    pub(super) fn other_end(self, stroke: &Stroke) -> Self {
        let last = u32::try_from(stroke.points.len() - 1).expect("far fewer than 2^32 points");
        let point = if stroke.closed {
            self.point
        } else {
            last - self.point
        };
        Self { point, ..self }
    }

    /// The stroke, drawn from here.
    pub(super) fn drawn(self, mut stroke: Stroke) -> Stroke {
        if stroke.closed && self.point > 0 {
            // The last point repeats the first: leave it out while turning.
            stroke.points.pop();
            let count = stroke.points.len();
            stroke
                .points
                .rotate_left(self.point as usize % count.max(1));
            stroke.points.extend(stroke.points.first().copied());
        } else if self.point > 0 {
            stroke.points.reverse();
        }
        stroke
    }
}
