//! Offsetting of areas.

use dobot_geometry::{FillRule, Point, Stroke};
use i_overlay::core::fill_rule::FillRule as Rule;
use i_overlay::float::simplify::SimplifyShape;
use i_overlay::mesh::float::outline::offset::OutlineOffset;
use i_overlay::mesh::float::style::{LineJoin, OutlineStyle};

/// An area whose rings neither cross nor touch themselves or each other.
#[derive(Debug)]
pub(crate) struct SimpleArea(Vec<Vec<Vec<[f64; 2]>>>);

impl SimpleArea {
    /// Creates the area inside rings by a rule; the last point of a ring does not repeat the first.
    pub(crate) fn of<'a>(rings: impl IntoIterator<Item = &'a [Point]>, rule: FillRule) -> Self {
        let rule = match rule {
            FillRule::NonZero => Rule::NonZero,
            FillRule::EvenOdd => Rule::EvenOdd,
        };
        let plain = |ring: &[Point]| ring.iter().map(|p| [p.x, p.y]).collect();
        let rings: Vec<Vec<[f64; 2]>> = rings.into_iter().map(plain).collect();
        Self(rings.simplify_shape_as::<i64>(rule))
    }

    /// Returns the rings of the area enlarged by a distance, or reduced if it is negative, with
    /// round corners within `round_mm`; the result may have several parts or none.
    pub(crate) fn offset(&self, by_mm: f64, round_mm: f64) -> Vec<Vec<Point>> {
        let share = (2.0 * round_mm / by_mm.abs()).sqrt().clamp(0.02, 1.0);
        let style = OutlineStyle::new(by_mm).line_join(LineJoin::Round(share));
        let moved = (by_mm != 0.0).then(|| self.0.outline_as::<i64>(&style));
        let shapes = moved.as_ref().unwrap_or(&self.0);
        let point = |&[x, y]: &[f64; 2]| Point::new(x, y);
        let rings = shapes.iter().flatten();
        rings.map(|ring| ring.iter().map(point).collect()).collect()
    }
}

/// Converts a ring to a closed stroke.
pub(crate) fn closed(mut ring: Vec<Point>) -> Stroke {
    ring.extend(ring.first().copied());
    Stroke {
        points: ring,
        closed: true,
    }
}
