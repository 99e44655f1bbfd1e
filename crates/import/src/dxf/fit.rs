//! SPLINE by fit points: a cubic curve with continuous curvature.

use std::iter::once;

use dobot_geometry::{CubicBez, Point, Vec2, bounds};

/// The directions of a curve at its ends; without a direction the end is not bent.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Ends {
    pub(super) first: Option<Vec2>,
    pub(super) last: Option<Vec2>,
}

/// The pieces of the curve through these points. The parameter grows by the distance of the points,
/// so that end directions have length 1.
pub(super) fn pieces(points: &[Point], ends: Ends) -> Vec<CubicBez> {
    let points = distinct(points);
    let slopes = slopes(&points, ends);
    let both = points.windows(2).zip(slopes.windows(2));
    both.map(|(p, slope)| {
        let third = p[0].distance(p[1]) / 3.0;
        let [from, to] = [p[0] + slope[0] * third, p[1] - slope[1] * third];
        CubicBez::new(p[0], from, to, p[1])
    })
    .collect()
}

/// The pieces of a closed curve.
pub(super) fn closed_pieces(points: &[Point]) -> Vec<CubicBez> {
    // It ends at its start, whether its last point repeats the first or not.
    let begin = points.first();
    let ring: Vec<Point> = points.iter().chain(begin).copied().collect();
    let mut ring = distinct(&ring);
    ring.pop();
    let count = ring.len();
    if count < 2 {
        return Vec::new();
    }
    // Once around, plus enough points before and after that the influence of the ends vanishes: it
    // fades to a quarter with each point.
    let before = ring.iter().rev().cycle().take(FADE);
    let before: Vec<Point> = before.copied().collect();
    let on = ring.iter().cycle().take(count + 1 + FADE);
    let around: Vec<Point> = before.into_iter().rev().chain(on.copied()).collect();
    let mut pieces = pieces(&around, Ends::default());
    pieces.drain(..FADE);
    pieces.truncate(count);
    pieces
}

/// The points without repetitions, within rounding: repeated points have no direction between them.
fn distinct(points: &[Point]) -> Vec<Point> {
    let around = bounds(points.iter().copied());
    let near = (around.width() + around.height()) * 1e-9;
    let mut distinct = points.to_vec();
    distinct.dedup_by(|next, point| next.distance(*point) <= near);
    distinct
}

/// The slope of the curve at each point, for points that differ from their neighbours:
///
/// ```text
///   m[i-1] / h[i-1] + 2 m[i] (1 / h[i-1] + 1 / h[i]) + m[i+1] / h[i] = 3 (v[i-1] / h[i-1] + v[i] / h[i])
/// ```
///
/// with the distance `h[i]` to the next point and the direction `v[i]` there.
fn slopes(points: &[Point], ends: Ends) -> Vec<Vec2> {
    let ways: Vec<Vec2> = points.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let (Some(first), Some(last)) = (ways.first(), ways.last()) else {
        return Vec::new();
    };
    let inner = ways.windows(2).map(|pair| {
        let [a, b] = [pair[0].length().recip(), pair[1].length().recip()];
        Row {
            before: a,
            own: 2.0 * (a + b),
            after: b,
            sum: (pair[0] * (a * a) + pair[1] * (b * b)) * 3.0,
        }
    });
    let begin = end_row(ends.first, *first);
    let end = end_row(ends.last, *last);
    let rows = once(begin).chain(inner).chain(once(Row {
        before: end.after,
        after: 0.0,
        ..end
    }));
    solved(rows.collect())
}

/// The first row: a given slope, or one without curvature.
fn end_row(slope: Option<Vec2>, way: Vec2) -> Row {
    let (own, after, sum) = match slope {
        Some(slope) => (1.0, 0.0, slope),
        None => (2.0, 1.0, way * (3.0 / way.length())),
    };
    Row {
        before: 0.0,
        own,
        after,
        sum,
    }
}

/// An equation for three consecutive unknowns.
#[derive(Clone, Copy, Debug)]
struct Row {
    before: f64,
    own: f64,
    after: f64,
    sum: Vec2,
}

/// Solves a tridiagonal system (Thomas' algorithm).
fn solved(mut rows: Vec<Row>) -> Vec<Vec2> {
    for i in 1..rows.len() {
        let above = rows[i - 1];
        let share = rows[i].before / above.own;
        rows[i].own -= share * above.after;
        rows[i].sum -= above.sum * share;
    }
    let mut found = vec![Vec2::ZERO; rows.len() + 1];
    for (i, row) in rows.iter().enumerate().rev() {
        found[i] = (row.sum - found[i + 1] * row.after) / row.own;
    }
    found.pop();
    found
}

/// The number of points after which an end has no influence: 0.27 to the power of it.
const FADE: usize = 24;

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use dobot_geometry::ParamCurve;

    use super::*;

    fn on_circle(count: u32, turns: f64) -> Vec<Point> {
        let angle = |i: u32| turns * TAU * f64::from(i) / f64::from(count);
        (0..=count)
            .map(|i| Vec2::from_angle(angle(i)).to_point())
            .collect()
    }

    /// The largest deviation of a curve from the unit circle.
    fn off(pieces: &[CubicBez]) -> f64 {
        let points = pieces
            .iter()
            .flat_map(|piece| (0..=8).map(|i| piece.eval(f64::from(i) / 8.0)));
        points
            .map(|p| (p.to_vec2().length() - 1.0).abs())
            .fold(0.0, f64::max)
    }

    #[test]
    fn a_curve_passes_its_points_and_bends_without_a_jump() {
        let points = [
            (0.0, 0.0),
            (10.0, 10.0),
            (20.0, 0.0),
            (20.0, 0.0),
            (60.0, 5.0),
        ];
        let points = points.map(Point::from);
        let found = pieces(&points, Ends::default());
        assert_eq!(found.len(), 3);
        let bend = |piece: &CubicBez, [a, b, c]: [Point; 3]| {
            let way = (a.to_vec2() - b.to_vec2() * 2.0 + c.to_vec2()) * 6.0;
            way / piece.p0.distance(piece.p3).powi(2)
        };
        let begin = |piece: &CubicBez| bend(piece, [piece.p0, piece.p1, piece.p2]);
        let end = |piece: &CubicBez| bend(piece, [piece.p3, piece.p2, piece.p1]);
        for both in found.windows(2) {
            assert_eq!(both[0].p3, both[1].p0);
            let jump = (end(&both[0]) - begin(&both[1])).length();
            assert!(jump < 1e-9, "{jump}");
        }
        // It is straight at its ends.
        let ends = [begin(&found[0]), end(&found[2])].map(Vec2::length);
        assert!(ends.iter().all(|end| *end < 1e-9), "{ends:?}");
    }

    #[test]
    fn points_on_a_circle_become_a_circle_if_its_end_slopes_are_given_or_it_is_closed() {
        let half = on_circle(8, 0.5);
        let ends = Ends {
            first: Some(Vec2::new(0.0, 1.0)),
            last: Some(Vec2::new(0.0, -1.0)),
        };
        assert!(off(&pieces(&half, ends)) < 1e-3);
        assert!(off(&pieces(&half, Ends::default())) > 1e-3);
        let whole = closed_pieces(&on_circle(12, 1.0));
        assert_eq!(whole.len(), 12);
        assert!(off(&whole) < 1e-3, "{}", off(&whole));
        assert!(whole[0].p0.distance(whole[11].p3) < 1e-12);
    }

    #[test]
    fn two_points_are_a_line_and_fewer_are_nothing() {
        let points = [Point::ORIGIN, Point::new(9.0, 3.0)];
        let line = pieces(&points, Ends::default());
        assert!(line[0].eval(0.5).distance(Point::new(4.5, 1.5)) < 1e-12);
        assert_eq!(closed_pieces(&points).len(), 2);
        for few in [&points[..0], &points[..1], &[Point::ORIGIN; 3]] {
            assert_eq!(pieces(few, Ends::default()), []);
            assert_eq!(closed_pieces(few), []);
        }
    }
}
