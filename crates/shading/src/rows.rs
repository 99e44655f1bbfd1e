//! Parallel lines over a page, and the joining of their pieces.

use dobot_geometry::{Point, Stroke, Vec2};

/// Parallel lines over a page, from one border to another.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rows {
    /// The page's width and height.
    pub(crate) page: Point,
    /// The empty margin along the borders.
    pub(crate) margin_mm: f64,
    pub(crate) spacing_mm: f64,
    /// The angle, counterclockwise from the horizontal, as displayed.
    pub(crate) angle_deg: f64,
}

impl Rows {
    /// The direction of the lines.
    pub(crate) fn along(&self) -> Vec2 {
        let (sin, cos) = self.angle_deg.to_radians().sin_cos();
        Vec2::new(cos, -sin)
    }

    /// The direction from one line to the next.
    pub(crate) fn across(&self) -> Vec2 {
        self.along().turn_90()
    }

    /// Both ends of each line; the lines are centered on the page.
    pub(crate) fn lines(&self) -> Vec<[Point; 2]> {
        let middle = self.page.to_vec2() * 0.5;
        let half = middle.length();
        let room = self.page.to_vec2() - Vec2::splat(self.margin_mm) * 2.0;
        if room.x < 0.0 || room.y < 0.0 {
            return Vec::new();
        }
        let across = self.across();
        let extent = across.x.abs() * room.x + across.y.abs() * room.y;
        let lines = (extent / self.spacing_mm).floor();
        let first = middle.to_point() - across * (lines * self.spacing_mm / 2.0);
        let steps = std::iter::successors(Some(0.0), |step| Some(step + 1.0));
        let starts = steps
            .take_while(|&step| step <= lines)
            .map(|step| first + across * (step * self.spacing_mm));
        starts.filter_map(|at| self.clipped(at, half)).collect()
    }

    /// The part of the line through a point that is on the page.
    fn clipped(&self, at: Point, half_mm: f64) -> Option<[Point; 2]> {
        let along = self.along();
        let (mut from, mut to) = (-half_mm, half_mm);
        for (at, along, size) in [(at.x, along.x, self.page.x), (at.y, along.y, self.page.y)] {
            let (low, high) = (self.margin_mm - at, size - self.margin_mm - at);
            if along.abs() < 1e-12 {
                if low > 0.0 || high < 0.0 {
                    return None;
                }
                continue;
            }
            let [a, b] = [low / along, high / along];
            from = from.max(a.min(b));
            to = to.min(a.max(b));
        }
        (to > from).then(|| [at + along * from, at + along * to])
    }
}

/// The pieces of lines as strokes: separate, or joined back and forth.
pub(crate) fn strokes(lines: Vec<Vec<Vec<Point>>>, reach_mm: f64, apart: bool) -> Vec<Stroke> {
    if apart {
        lines.into_iter().flatten().map(Stroke::open).collect()
    } else {
        woven(lines, reach_mm)
    }
}

/// Joins pieces of neighbouring lines to strokes that go back and forth, if the distance from one
/// to the next is at most `reach_mm`. Each piece continues at the end of the previous one.
fn woven(lines: Vec<Vec<Vec<Point>>>, reach_mm: f64) -> Vec<Stroke> {
    let mut done = Vec::new();
    let mut open: Vec<Vec<Point>> = Vec::new();
    for line in lines {
        let mut next = Vec::with_capacity(line.len());
        for piece in line {
            next.push(match nearest(&open, &piece, reach_mm) {
                Some((stroke, reversed)) => joined(open.swap_remove(stroke), piece, reversed),
                None => piece,
            });
        }
        done.append(&mut open);
        open = next;
    }
    done.append(&mut open);
    done.into_iter().map(Stroke::open).collect()
}

/// The stroke that ends nearest to an end of a piece, and whether that is its far end.
fn nearest(open: &[Vec<Point>], piece: &[Point], reach_mm: f64) -> Option<(usize, bool)> {
    let (first, last) = (*piece.first()?, *piece.last()?);
    let mut best = None;
    let mut best_mm = reach_mm;
    for (i, stroke) in open.iter().enumerate() {
        let Some(&end) = stroke.last() else { continue };
        for (to, reversed) in [(first, false), (last, true)] {
            if end.distance(to) <= best_mm {
                best_mm = end.distance(to);
                best = Some((i, reversed));
            }
        }
    }
    best
}

fn joined(mut stroke: Vec<Point>, piece: Vec<Point>, reversed: bool) -> Vec<Point> {
    if reversed {
        stroke.extend(piece.into_iter().rev());
    } else {
        stroke.extend(piece);
    }
    stroke
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn lines_are_evenly_spaced_and_reach_from_border_to_border() {
        let rows = Rows {
            page: Point::new(10.0, 4.0),
            margin_mm: 0.5,
            spacing_mm: 1.0,
            angle_deg: 0.0,
        };
        let lines = rows.lines();
        let wanted = [0.5, 1.5, 2.5, 3.5];
        assert_eq!(lines.len(), wanted.len());
        for ([a, b], y) in lines.iter().zip(wanted) {
            assert!(a.distance(Point::new(0.5, y)) < 1e-9, "{a:?}");
            assert!(b.distance(Point::new(9.5, y)) < 1e-9, "{b:?}");
        }
    }

    #[test]
    fn pieces_are_joined_back_and_forth() {
        let p = Point::new;
        let lines = vec![
            vec![vec![p(0.0, 0.0), p(9.0, 0.0)]],
            vec![
                vec![p(0.0, 1.0), p(4.0, 1.0)],
                vec![p(5.0, 1.0), p(9.0, 1.0)],
            ],
            vec![vec![p(0.0, 2.0), p(4.0, 2.0)]],
        ];
        let strokes = woven(lines, 1.5);
        let points: Vec<usize> = strokes.iter().map(|stroke| stroke.points.len()).collect();
        assert_eq!(points, [4, 4]);
        assert_eq!(strokes[0].last(), Some(p(5.0, 1.0)));
        assert_eq!(strokes[1].last(), Some(p(0.0, 2.0)));
    }

    proptest! {
        #[test]
        fn all_lines_stay_on_the_page(
            width in 0.1..50.0, height in 0.1..50.0, spacing_mm in 0.1..10.0, angle_deg in -400.0..400.0,
        ) {
            let page = Point::new(width, height);
            let rows = Rows { page, margin_mm: 0.0, spacing_mm, angle_deg };
            for p in rows.lines().into_iter().flatten() {
                prop_assert!(p.x >= -1e-9 && p.x <= width + 1e-9, "{:?}", p);
                prop_assert!(p.y >= -1e-9 && p.y <= height + 1e-9, "{:?}", p);
            }
        }
    }
}
