//! Clipping of lines to the arm's reach.

use dobot_geometry::{Point, Rect, Stroke};

/// The result of clipping.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Clipped {
    /// The parts inside; a stroke that leaves and returns becomes several.
    pub strokes: Vec<Stroke>,
    /// The length of the lines outside, in mm.
    pub cut_mm: f64,
    /// The number of dots outside.
    pub cut_dots: usize,
}

impl Clipped {
    /// Whether nothing was outside.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.cut_mm == 0.0 && self.cut_dots == 0
    }
}

/// Clips strokes to the places for which `inside` returns true. It is evaluated at least every
/// millimetre in the area `within`, which contains all other places, and the border is located to a
/// hundredth of a millimetre. No part outside is kept; one shorter than a millimetre may be missed.
#[must_use]
pub fn clip_to_reach(strokes: &[Stroke], within: Rect, inside: impl Fn(Point) -> bool) -> Clipped {
    let mut clipped = Clipped::default();
    for stroke in strokes {
        if let [dot] = stroke.points[..] {
            if inside(dot) {
                clipped.strokes.push(stroke.clone());
            } else {
                clipped.cut_dots += 1;
            }
            continue;
        }
        let mut pieces = StrokePieces::default();
        for (a, b) in stroke.segments() {
            pieces.add((a, b), &reached(a, b, within, &inside));
        }
        if pieces.whole {
            clipped.strokes.push(stroke.clone());
        } else {
            clipped.cut_mm += pieces.cut_mm;
            clipped.strokes.extend(pieces.strokes(stroke.closed));
        }
    }
    clipped
}

/// The remaining pieces of a stroke.
#[derive(Debug)]
struct StrokePieces {
    done: Vec<Vec<Point>>,
    /// The points of the piece that continues in the next segment.
    current: Vec<Point>,
    /// Whether the stroke begins inside.
    begins: bool,
    whole: bool,
    cut_mm: f64,
}

impl Default for StrokePieces {
    fn default() -> Self {
        Self {
            done: Vec::new(),
            current: Vec::new(),
            begins: false,
            whole: true,
            cut_mm: 0.0,
        }
    }
}

impl StrokePieces {
    fn add(&mut self, (a, b): (Point, Point), shares: &[(f64, f64)]) {
        let mut inside = 0.0;
        let first = self.done.is_empty() && self.current.is_empty() && self.cut_mm == 0.0;
        for &(from, to) in shares {
            if from > 0.0 {
                self.end_current();
            }
            if self.current.is_empty() {
                self.current
                    .push(if from > 0.0 { a.lerp(b, from) } else { a });
                self.begins |= first && from == 0.0;
            }
            self.current.push(if to < 1.0 { a.lerp(b, to) } else { b });
            inside += to - from;
        }
        if shares.last().is_none_or(|&(_, to)| to < 1.0) {
            self.end_current();
        }
        if shares != [(0.0, 1.0)] {
            self.whole = false;
            self.cut_mm += a.distance(b) * (1.0 - inside);
        }
    }

    fn end_current(&mut self) {
        if !self.current.is_empty() {
            self.done.push(std::mem::take(&mut self.current));
        }
    }

    /// Returns the pieces. In a closed stroke, the last one continues with the first if both are
    /// inside at its start.
    fn strokes(mut self, closed: bool) -> impl Iterator<Item = Stroke> {
        if closed && self.begins && !self.current.is_empty() && !self.done.is_empty() {
            let first = std::mem::take(&mut self.done[0]);
            self.current.extend(first.into_iter().skip(1));
        }
        self.end_current();
        let lines = self.done.into_iter().filter(|piece| piece.len() > 1);
        lines.map(Stroke::open)
    }
}

/// Returns the reachable shares of a segment, from 0 at its start to 1 at its end.
fn reached(a: Point, b: Point, within: Rect, inside: &impl Fn(Point) -> bool) -> Vec<(f64, f64)> {
    let mut shares = Vec::new();
    let Some((first, last)) = overlap(a, b, within) else {
        return shares;
    };
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a count, saturating"
    )]
    let count = (a.distance(b) * (last - first) / STEP_MM).ceil().max(1.0) as u32;
    let reaches = |share: f64| inside(a.lerp(b, share));
    let mut begin = reaches(first).then_some(first);
    let share = |i: u32| {
        let of_all = f64::from(i) / f64::from(count);
        first * (1.0 - of_all) + last * of_all
    };
    for i in 1..=count {
        let (before, here) = (share(i - 1), share(i));
        let halvings = |out, inn| border(out, inn, a.distance(b), &reaches);
        match (begin, reaches(here)) {
            (Some(from), false) => {
                shares.push((from, halvings(here, before)));
                begin = None;
            }
            (None, true) => begin = Some(halvings(before, here)),
            _ => {}
        }
    }
    shares.extend(begin.map(|from| (from, last)));
    shares.retain(|&(from, to)| from < to);
    shares
}

/// Returns the share of a segment inside a rectangle.
fn overlap(a: Point, b: Point, within: Rect) -> Option<(f64, f64)> {
    let way = b - a;
    if !(a.is_finite() && way.is_finite()) {
        return None;
    }
    let (mut first, mut last) = (0.0_f64, 1.0_f64);
    for (at, way, low, high) in [
        (a.x, way.x, within.x0, within.x1),
        (a.y, way.y, within.y0, within.y1),
    ] {
        if way == 0.0 {
            if at < low || at > high {
                return None;
            }
            continue;
        }
        let (one, other) = ((low - at) / way, (high - at) / way);
        first = first.max(one.min(other));
        last = last.min(one.max(other));
    }
    (first < last).then_some((first, last))
}

/// Returns the last share inside before the border.
fn border(mut out: f64, mut inn: f64, length_mm: f64, reaches: &impl Fn(f64) -> bool) -> f64 {
    while (out - inn).abs() * length_mm > BORDER_MM {
        let middle = f64::midpoint(out, inn);
        if reaches(middle) {
            inn = middle;
        } else {
            out = middle;
        }
    }
    inn
}

const STEP_MM: f64 = 1.0;
const BORDER_MM: f64 = 0.01;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use dobot_geometry::bounds;

    use super::*;

    fn line(points: &[(f64, f64)]) -> Stroke {
        Stroke::open(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
    }

    const AROUND: Rect = Rect::new(-40.0, -40.0, 40.0, 40.0);

    fn in_area(p: Point) -> bool {
        (0.0..=10.0).contains(&p.x) && (0.0..=10.0).contains(&p.y)
    }

    /// Whether the points agree to the hundredth of a millimetre to which borders are located.
    fn is_near(found: &[Stroke], wanted: &[Stroke]) -> bool {
        let is_same = |(a, b): (&Stroke, &Stroke)| {
            let points = a.points.iter().zip(&b.points);
            a.points.len() == b.points.len()
                && points.into_iter().all(|(p, q)| p.distance(*q) <= 0.01)
        };
        found.len() == wanted.len() && found.iter().zip(wanted).all(is_same)
    }

    /// A ring around the origin, like the arm's reach.
    fn in_ring(p: Point) -> bool {
        (5.0..=20.0).contains(&p.to_vec2().length())
    }

    #[test]
    fn strokes_inside_are_unchanged() {
        let mut ring = line(&[(1.0, 1.0), (9.0, 1.0), (9.0, 10.0), (1.0, 1.0)]);
        ring.closed = true;
        let strokes = [ring, line(&[(0.0, 0.0)]), line(&[(2.0, 2.0), (3.0, 3.0)])];
        let clipped = clip_to_reach(&strokes, AROUND, in_area);
        assert_eq!(clipped.strokes, strokes);
        assert!(clipped.is_whole());
        assert_eq!(clip_to_reach(&strokes, AROUND, |_| true), clipped);
    }

    #[test]
    fn a_stroke_that_leaves_and_returns_becomes_two() {
        let stroke = line(&[(1.0, 5.0), (12.0, 5.0), (12.0, 6.0), (1.0, 6.0)]);
        let clipped = clip_to_reach(&[stroke], AROUND, in_area);
        let parts = [
            line(&[(1.0, 5.0), (10.0, 5.0)]),
            line(&[(10.0, 6.0), (1.0, 6.0)]),
        ];
        assert!(is_near(&clipped.strokes, &parts), "{clipped:?}");
        assert!((clipped.cut_mm - 5.0).abs() <= 0.02);
    }

    #[test]
    fn a_closed_stroke_continues_over_its_start() {
        let mut ring = line(&[(5.0, 5.0), (5.0, 8.0), (15.0, 8.0), (15.0, 5.0), (5.0, 5.0)]);
        ring.closed = true;
        let clipped = clip_to_reach(&[ring], AROUND, in_area);
        let rest = line(&[(10.0, 5.0), (5.0, 5.0), (5.0, 8.0), (10.0, 8.0)]);
        assert!(is_near(&clipped.strokes, &[rest]), "{clipped:?}");
    }

    #[test]
    fn strokes_outside_are_counted() {
        let strokes = [
            line(&[(20.0, 0.0)]),
            line(&[(20.0, 0.0), (20.0, 7.0)]),
            line(&[(10.0, 12.0), (12.0, 10.0)]),
        ];
        let clipped = clip_to_reach(&strokes, AROUND, in_area);
        assert_eq!(clipped.strokes, []);
        assert_eq!(clipped.cut_dots, 1);
        assert!((clipped.cut_mm - 7.0 - 8.0_f64.sqrt()).abs() < 1e-9);
    }

    #[test]
    fn the_reach_cuts_within_a_hundredth_of_a_millimetre() {
        let through = line(&[(-30.0, 0.0), (30.0, 0.0)]);
        let clipped = clip_to_reach(&[through], AROUND, in_ring);
        assert_eq!(clipped.strokes.len(), 2);
        let wanted = [-20.0, -5.0, 5.0, 20.0];
        let found = clipped.strokes.iter().flat_map(|stroke| &stroke.points);
        for (p, wanted) in found.zip(wanted) {
            assert!((p.x - wanted).abs() <= 0.01 && in_ring(*p), "{p:?}");
        }
        assert!((clipped.cut_mm - 30.0).abs() <= 0.04);
    }

    #[test]
    fn distant_strokes_are_cut_without_checking_each_millimetre() {
        let far = 1e12;
        let through = line(&[(-far, 5.0), (far, 5.0), (far, far), (-far, -far)]);
        let asked = std::cell::Cell::new(0);
        let clipped = clip_to_reach(&[through], AROUND, |p| {
            asked.set(asked.get() + 1);
            in_area(p)
        });
        let parts = clipped.strokes.iter().map(Stroke::length_mm);
        let wanted = [10.0, 10.0 * 2.0_f64.sqrt()];
        assert!(
            parts
                .zip(wanted)
                .all(|(mm, wanted)| (mm - wanted).abs() < 0.05),
            "{clipped:?}"
        );
        assert_eq!(clipped.strokes.len(), 2);
        assert!(asked.get() < 1000, "{}", asked.get());
    }

    #[test]
    fn places_that_are_not_finite_are_cut() {
        let nowhere = [
            line(&[(1.0, 1.0), (f64::NAN, 2.0)]),
            line(&[(f64::NAN, 2.0)]),
        ];
        assert_eq!(clip_to_reach(&nowhere, AROUND, in_area).cut_dots, 1);
        assert_eq!(clip_to_reach(&nowhere, AROUND, in_ring).strokes, []);
    }

    fn strokes() -> impl Strategy<Value = Vec<Stroke>> {
        let corner = (-30..30_i32, -30..30_i32, -0.5..0.5_f64);
        let corners = proptest::collection::vec(corner, 1..8);
        let stroke = (corners, any::<bool>()).prop_map(|(corners, closed)| {
            let at = |&(x, y, off): &(i32, i32, f64)| Point::new(f64::from(x), f64::from(y) + off);
            let mut points: Vec<Point> = corners.iter().map(at).collect();
            let closed = closed && points.len() > 2;
            points.extend(closed.then_some(points[0]));
            Stroke { points, closed }
        });
        proptest::collection::vec(stroke, 0..6)
    }

    fn length_mm(strokes: &[Stroke]) -> f64 {
        strokes.iter().map(Stroke::length_mm).sum()
    }

    proptest! {
        #[test]
        fn no_line_is_lost_and_none_is_outside(strokes in strokes()) {
            let clips = [
                (clip_to_reach(&strokes, AROUND, in_area), Rect::new(0.0, 0.0, 10.0, 10.0)),
                (clip_to_reach(&strokes, AROUND, in_ring), bounds([Point::new(-20.0, -20.0), Point::new(20.0, 20.0)])),
            ];
            for (clipped, bounds) in clips {
                let length = length_mm(&clipped.strokes) + clipped.cut_mm;
                prop_assert!((length - length_mm(&strokes)).abs() < 1e-6);
                for p in clipped.strokes.iter().flat_map(|stroke| &stroke.points) {
                    prop_assert!(bounds.overlaps(Rect::from_points(*p, *p)), "{p:?}");
                }
            }
        }

        #[test]
        fn everything_kept_is_reachable(strokes in strokes()) {
            for stroke in clip_to_reach(&strokes, AROUND, in_ring).strokes {
                for &p in &stroke.points {
                    prop_assert!(in_ring(p), "{p:?}");
                }
            }
        }
    }
}
