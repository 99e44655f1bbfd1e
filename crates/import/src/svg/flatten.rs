//! Paths to lines.

use dobot_geometry::{CubicBez, Point, QuadBez, Stroke, chords, corners};
use usvg::tiny_skia_path::{Path, PathSegment};

use crate::error::SvgError;
use crate::limits::Budget;

/// The subpaths of a path as lines within `tolerance` of it, in the path's units.
pub(crate) fn flatten(
    path: &Path,
    tolerance: f64,
    budget: &mut Budget,
) -> Result<Vec<Stroke>, SvgError> {
    let mut flattener = PathFlattener {
        strokes: Vec::new(),
        tolerance,
        budget,
    };
    for segment in path.segments() {
        match segment {
            PathSegment::MoveTo(p) => flattener.strokes.push(Stroke::open(vec![point(p)])),
            PathSegment::LineTo(p) => flattener.line(point(p))?,
            PathSegment::QuadTo(b, c) => {
                let curve = QuadBez::new(flattener.here(), point(b), point(c));
                flattener.curve(curve.raise())?;
            }
            PathSegment::CubicTo(b, c, d) => {
                let here = flattener.here();
                flattener.curve(CubicBez::new(here, point(b), point(c), point(d)))?;
            }
            PathSegment::Close => flattener.close()?,
        }
    }
    flattener.strokes.retain(|stroke| stroke.points.len() > 1);
    Ok(flattener.strokes)
}

struct PathFlattener<'a> {
    strokes: Vec<Stroke>,
    tolerance: f64,
    budget: &'a mut Budget,
}

impl PathFlattener<'_> {
    fn line(&mut self, to: Point) -> Result<(), SvgError> {
        self.budget.spend(1)?;
        self.current().points.push(to);
        Ok(())
    }

    fn curve(&mut self, curve: CubicBez) -> Result<(), SvgError> {
        // The cast saturates, and the budget refuses too many.
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let count = chords(curve, self.tolerance) as u32;
        self.budget.note_curve(count as usize);
        self.budget.spend(count as usize)?;
        self.current().points.extend(corners(curve, count));
        Ok(())
    }

    fn close(&mut self) -> Result<(), SvgError> {
        let (start, is_place) = (self.current().points[0], self.current().points.len() == 1);
        // A closed point is a line of length 0.
        if is_place || self.here() != start {
            self.line(start)?;
        }
        self.current().closed = true;
        Ok(())
    }

    fn here(&mut self) -> Point {
        self.current().last().expect("every subpath has a point")
    }

    fn current(&mut self) -> &mut Stroke {
        // A path that continues after closing starts again at that point.
        if let Some(closed) = self.strokes.last().filter(|stroke| stroke.closed) {
            let start = closed.points[0];
            self.strokes.push(Stroke::open(vec![start]));
        }
        self.strokes.last_mut().expect("a path begins with a move")
    }
}

fn point(p: usvg::tiny_skia_path::Point) -> Point {
    Point::new(f64::from(p.x), f64::from(p.y))
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use proptest::prelude::*;
    use usvg::tiny_skia_path::PathBuilder;

    use super::*;
    use dobot_geometry::SegmentIndex;

    fn cubic(c: [f32; 8]) -> Path {
        let mut path = PathBuilder::new();
        path.move_to(c[0], c[1]);
        path.cubic_to(c[2], c[3], c[4], c[5], c[6], c[7]);
        path.finish().unwrap()
    }

    #[test]
    fn a_straight_cubic_becomes_one_line() {
        let line = cubic([0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0]);
        let strokes = flatten(&line, 0.01, &mut Budget::new(100)).unwrap();
        assert_eq!(strokes[0].points.len(), 2);
    }

    #[test]
    fn closing_returns_to_the_start_and_continuing_begins_there() {
        let mut path = PathBuilder::new();
        path.move_to(1.0, 1.0);
        path.line_to(2.0, 1.0);
        path.line_to(2.0, 2.0);
        path.close();
        path.line_to(5.0, 5.0);
        let strokes = flatten(&path.finish().unwrap(), 0.01, &mut Budget::new(100)).unwrap();
        assert!(strokes[0].closed && !strokes[1].closed);
        assert_eq!(strokes[0].last(), Some(Point::new(1.0, 1.0)));
        assert_eq!(strokes[1].points[0], Point::new(1.0, 1.0));
    }

    #[test]
    fn a_curve_that_costs_more_than_the_budget_is_refused() {
        let wide = cubic([0.0, 0.0, 1e6, 0.0, 0.0, 1e6, 1e6, 1e6]);
        let error = flatten(&wide, 1e-6, &mut Budget::new(1000)).unwrap_err();
        assert!(matches!(error, SvgError::TooManySegments { .. }));
    }

    proptest! {
        #[test]
        fn the_true_curve_stays_within_the_tolerance(
            c in proptest::array::uniform8(-100.0_f32..100.0),
            tolerance in 0.001..1.0_f64,
        ) {
            let strokes = flatten(&cubic(c), tolerance, &mut Budget::new(1_000_000)).unwrap();
            let index = SegmentIndex::new(strokes[0].segments().collect());
            let c = c.map(f64::from);
            for i in 0..=1000 {
                let t = f64::from(i) / 1000.0;
                let s = 1.0 - t;
                let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
                let x = (0..4).map(|k| weights[k] * c[2 * k]).sum();
                let y = (0..4).map(|k| weights[k] * c[2 * k + 1]).sum();
                let (_, distance2) = index.nearest(Point::new(x, y)).unwrap();
                prop_assert!(distance2.sqrt() <= tolerance + 1e-9, "{} > {tolerance}", distance2.sqrt());
            }
        }
    }
}
