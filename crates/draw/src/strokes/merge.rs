//! Joining of strokes that meet, so that the pen need not be lifted between them.

use dobot_geometry::{Point, Stroke, Vec2};

/// Joins strokes whose ends lie within `tolerance_mm` of each other, reversed if necessary; a
/// stroke that returns to its start becomes closed. If several ends meet, the straightest
/// continuation is chosen, because the pen keeps its speed there. All corners are kept; a gap is
/// bridged by a straight line. Dots and closed strokes are unchanged.
#[must_use]
pub fn merge(strokes: Vec<Stroke>, tolerance_mm: f64) -> Vec<Stroke> {
    let partners = partners(&strokes, tolerance_mm);
    if partners.iter().all(Option::is_none) {
        return strokes;
    }
    let mut chains = Chains {
        used: vec![false; strokes.len()],
        strokes,
        partners,
    };
    (0..chains.strokes.len())
        .filter_map(|stroke| chains.take(stroke))
        .collect()
}

/// One end of a stroke: twice its number for the start, plus one for the end.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct StrokeEnd(usize);

impl StrokeEnd {
    const fn stroke(self) -> usize {
        self.0 / 2
    }

    const fn opposite(self) -> Self {
        Self(self.0 ^ 1)
    }

    const fn is_begin(self) -> bool {
        self.0.is_multiple_of(2)
    }
}

/// Strokes and the pairing of their ends.
#[derive(Debug)]
struct Chains {
    strokes: Vec<Stroke>,
    partners: Vec<Option<StrokeEnd>>,
    used: Vec<bool>,
}

impl Chains {
    /// Returns the chain of a stroke, in the direction of this stroke; `None` if it was taken.
    fn take(&mut self, stroke: usize) -> Option<Stroke> {
        if self.used[stroke] {
            return None;
        }
        let first = self.first(StrokeEnd(2 * stroke));
        let closes = self.partners[first.0];
        let mut chain = std::mem::take(&mut self.strokes[first.stroke()]);
        chain.points = directed(chain.points, first);
        self.used[first.stroke()] = true;
        let mut last = first.opposite();
        while let Some(next) = self.partners[last.0].filter(|_| Some(last) != closes) {
            let points = std::mem::take(&mut self.strokes[next.stroke()].points);
            self.used[next.stroke()] = true;
            append(&mut chain.points, directed(points, next));
            last = next.opposite();
        }
        if closes.is_some() {
            let begin = chain.points[0];
            append(&mut chain.points, vec![begin]);
            chain.closed = true;
        }
        Some(chain)
    }

    /// Returns the start of the chain that contains this start of a stroke; in a ring that is the
    /// same start.
    fn first(&self, begin: StrokeEnd) -> StrokeEnd {
        let mut first = begin;
        while let Some(before) = self.partners[first.0] {
            first = before.opposite();
            if first == begin {
                break;
            }
        }
        first
    }
}

fn directed(mut points: Vec<Point>, begin: StrokeEnd) -> Vec<Point> {
    if !begin.is_begin() {
        points.reverse();
    }
    points
}

/// Appends points, without the first if it is at the same place.
fn append(points: &mut Vec<Point>, next: Vec<Point>) {
    let same = points.last() == next.first();
    points.extend(next.into_iter().skip(usize::from(same)));
}

/// Returns the partner of each end.
fn partners(strokes: &[Stroke], tolerance_mm: f64) -> Vec<Option<StrokeEnd>> {
    let mut partners = vec![None; 2 * strokes.len()];
    let mut open = Tip::of_all(strokes, tolerance_mm);
    for _ in 0..ROUNDS {
        let mut pairs = pairs(&open, tolerance_mm);
        pairs.sort_unstable_by(Pair::compare);
        let before = open.len();
        for pair in pairs {
            let (a, b) = (pair.a, pair.b);
            if partners[a.0].is_none() && partners[b.0].is_none() {
                partners[a.0] = Some(b);
                partners[b.0] = Some(a);
            }
        }
        open.retain(|tip| partners[tip.end.0].is_none());
        if open.len() == before {
            break;
        }
    }
    partners
}

/// An end of a stroke, with its position and direction.
#[derive(Clone, Copy, Debug)]
struct Tip {
    end: StrokeEnd,
    at: Point,
    /// The unit vector out of the stroke.
    way: Vec2,
    cell: (i64, i64),
    /// Whether the stroke is long enough to be closed with itself.
    closes: bool,
}

impl Tip {
    /// Returns the ends of the open strokes, sorted by cells of the tolerance's size.
    fn of_all(strokes: &[Stroke], tolerance_mm: f64) -> Vec<Self> {
        let open = |(_, stroke): &(usize, &Stroke)| !stroke.closed && stroke.points.len() > 1;
        let mut tips = Vec::with_capacity(2 * strokes.len());
        for (number, stroke) in strokes.iter().enumerate().filter(open) {
            let closes = is_longer(stroke, 2.0 * tolerance_mm);
            let (forth, back) = (stroke.points.iter(), stroke.points.iter().rev());
            let begin = Self::new(StrokeEnd(2 * number), forth, tolerance_mm);
            let end = Self::new(StrokeEnd(2 * number + 1), back, tolerance_mm);
            tips.extend([begin, end].map(|tip| Self { closes, ..tip }));
        }
        tips.sort_unstable_by_key(|tip| (tip.cell, tip.end));
        tips
    }

    fn new<'a>(
        end: StrokeEnd,
        points: impl Iterator<Item = &'a Point> + Clone,
        tolerance_mm: f64,
    ) -> Self {
        let at = *points.clone().next().expect("open strokes have two points");
        // Points closer than the tolerance say little about the direction.
        let far = |p: &&Point| p.distance(at) > tolerance_mm;
        let from = *points.clone().find(far).or(points.last()).unwrap_or(&at);
        let length = from.distance(at).max(f64::MIN_POSITIVE);
        Self {
            end,
            at,
            way: (at - from) * (1.0 / length),
            cell: cell(at, tolerance_mm),
            closes: false,
        }
    }

    fn pair(&self, other: &Self, tolerance_mm: f64) -> Option<Pair> {
        let distance_mm = self.at.distance(other.at);
        let fits = distance_mm <= tolerance_mm && (self.closes || self.end.opposite() != other.end);
        fits.then(|| Pair {
            a: self.end.min(other.end),
            b: self.end.max(other.end),
            turn: 1.0 + self.way.dot(other.way),
            distance_mm,
        })
    }
}

fn is_longer(stroke: &Stroke, length_mm: f64) -> bool {
    let mut length = 0.0;
    stroke.segments().any(|(a, b)| {
        length += a.distance(b);
        length > length_mm
    })
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "what is out of range shares a cell"
)]
fn cell(p: Point, tolerance_mm: f64) -> (i64, i64) {
    let size = tolerance_mm.max(1e-6);
    ((p.x / size).floor() as i64, (p.y / size).floor() as i64)
}

/// Two ends that could be joined.
#[derive(Clone, Copy, Debug)]
struct Pair {
    a: StrokeEnd,
    b: StrokeEnd,
    /// From 0 for straight to 2 for a reversal.
    turn: f64,
    distance_mm: f64,
}

impl Pair {
    /// Compares by straightness, the straightest first.
    fn compare(&self, other: &Self) -> std::cmp::Ordering {
        let by_turn = self.turn.total_cmp(&other.turn);
        let by_distance = self.distance_mm.total_cmp(&other.distance_mm);
        by_turn
            .then(by_distance)
            .then((self.a, self.b).cmp(&(other.a, other.b)))
    }
}

/// Returns the pairs of sorted ends; within a cluster only a limited number, to avoid quadratic
/// growth.
fn pairs(tips: &[Tip], tolerance_mm: f64) -> Vec<Pair> {
    let mut pairs = Vec::with_capacity(tips.len());
    let mut right = 0;
    for (i, tip) in tips.iter().enumerate() {
        let (x, y) = tip.cell;
        let first = (x.saturating_add(1), y.saturating_sub(1));
        while right < tips.len() && tips[right].cell < first {
            right += 1;
        }
        let above = tips[i + 1..]
            .iter()
            .take_while(|other| other.cell <= (x, y.saturating_add(1)));
        let beside = tips[right.max(i + 1)..]
            .iter()
            .take_while(|other| other.cell <= (first.0, y.saturating_add(1)));
        let near = above.take(HEAP).chain(beside.take(HEAP));
        pairs.extend(near.filter_map(|other| tip.pair(other, tolerance_mm)));
    }
    pairs
}

/// The number of others examined per end in each of two columns of cells.
const HEAP: usize = 32;
/// The number of rounds for ends left over in a cluster.
const ROUNDS: usize = 16;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn line(points: &[(f64, f64)]) -> Stroke {
        Stroke::open(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
    }

    #[test]
    fn strokes_are_reversed_if_they_meet_that_way() {
        let pieces = vec![
            line(&[(1.0, 0.0), (2.0, 0.0)]),
            line(&[(1.0, 0.0), (0.0, 0.0)]),
            line(&[(3.0, 1.0), (2.0, 0.0)]),
        ];
        let joined = line(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (3.0, 1.0)]);
        assert_eq!(merge(pieces, 0.0), [joined]);
    }

    #[test]
    fn a_gap_is_bridged_up_to_the_tolerance_and_no_farther() {
        let pieces = vec![
            line(&[(0.0, 0.0), (1.0, 0.0)]),
            line(&[(1.04, 0.0), (2.0, 0.0)]),
        ];
        let bridged = line(&[(0.0, 0.0), (1.0, 0.0), (1.04, 0.0), (2.0, 0.0)]);
        assert_eq!(merge(pieces.clone(), 0.05), [bridged]);
        assert_eq!(merge(pieces.clone(), 0.03), pieces);
    }

    #[test]
    fn a_line_that_returns_to_its_start_is_closed() {
        let pieces = vec![
            line(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)]),
            line(&[(0.0, 0.0), (0.0, 1.0), (1.0, 1.0)]),
        ];
        let ring = merge(pieces, 0.05);
        assert_eq!(ring.len(), 1);
        assert!(ring[0].closed);
        assert_eq!(ring[0].points.len(), 5);
        assert_eq!(ring[0].points[0], ring[0].points[4]);
        let alone = vec![line(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 0.01)])];
        let closed = merge(alone, 0.05);
        assert!(closed[0].closed && closed[0].points.len() == 5);
    }

    #[test]
    fn at_a_crossing_lines_continue_straight_on() {
        let pieces = vec![
            line(&[(0.0, 0.0), (5.0, 0.0)]),
            line(&[(0.0, 0.0), (0.0, 5.0)]),
            line(&[(0.0, 0.0), (-5.0, 0.1)]),
            line(&[(0.0, 0.0), (0.1, -5.0)]),
        ];
        let crossed = merge(pieces, 0.05);
        assert_eq!(
            crossed,
            [
                line(&[(-5.0, 0.1), (0.0, 0.0), (5.0, 0.0)]),
                line(&[(0.1, -5.0), (0.0, 0.0), (0.0, 5.0)]),
            ]
        );
    }

    #[test]
    fn dots_and_closed_strokes_are_unchanged() {
        let mut ring = line(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 0.0)]);
        ring.closed = true;
        let strokes = vec![line(&[(0.0, 0.0)]), ring, line(&[(0.0, 0.0), (0.0, 9.0)])];
        assert_eq!(merge(strokes.clone(), 0.05), strokes);
    }

    #[test]
    fn a_star_of_ten_thousand_rays_becomes_half_as_many_lines() {
        let ray = |i: u32| {
            let (sin, cos) = (f64::from(i) * 0.618).sin_cos();
            line(&[(0.0, 0.0), (9.0 * cos, 9.0 * sin)])
        };
        assert!(merge((0..10_000).map(ray).collect(), 0.05).len() <= 5100);
    }

    #[test]
    fn the_steps_of_a_staircase_in_any_order_become_one_stroke() {
        let step = |i: u32| {
            let corner = |i: u32| (f64::from(i / 2 + i % 2), f64::from(i / 2));
            let ends = [corner(i), corner(i + 1)];
            line(&if i.is_multiple_of(3) {
                [ends[1], ends[0]]
            } else {
                ends
            })
        };
        // 7919 is coprime to the number of steps, so each comes once.
        let shuffled = (0..20_000).map(|i| step(i * 7919 % 20_000));
        let joined = merge(shuffled.collect(), 0.05);
        assert_eq!(joined.len(), 1);
        assert_eq!(joined[0].points.len(), 20_001);
    }

    proptest! {
        #[test]
        fn no_ink_is_lost_and_no_bridge_is_longer_than_the_tolerance(
            corners in proptest::collection::vec(
                proptest::collection::vec((0..12_i32, 0..12_i32), 1..4), 0..60),
            tolerance_mm in prop_oneof![Just(0.0), Just(0.06), Just(0.11), 0.0..1.0_f64],
        ) {
            let at = |&(x, y): &(i32, i32)| Point::new(f64::from(x) * 0.1, f64::from(y) * 0.1);
            let strokes: Vec<Stroke> =
                corners.iter().map(|line| Stroke::open(line.iter().map(at).collect())).collect();
            let merged = merge(strokes.clone(), tolerance_mm);
            prop_assert!(merged.len() <= strokes.len());
            prop_assert_eq!(&merge(strokes.clone(), tolerance_mm), &merged);
            let key = |(a, b): (Point, Point)| {
                let (a, b) = ((a.x.to_bits(), a.y.to_bits()), (b.x.to_bits(), b.y.to_bits()));
                (a.min(b), a.max(b))
            };
            let mut left: Vec<_> = merged.iter().flat_map(Stroke::segments).collect();
            for wanted in strokes.iter().flat_map(Stroke::segments) {
                let found = left.iter().position(|stroke| key(*stroke) == key(wanted));
                prop_assert!(found.is_some() || wanted.0 == wanted.1);
                found.map(|index| left.swap_remove(index));
            }
            for (a, b) in left {
                prop_assert!(a.distance(b) <= tolerance_mm, "{a:?} {b:?}");
            }
            for stroke in merged.iter().filter(|stroke| stroke.closed) {
                prop_assert_eq!(stroke.points.first(), stroke.points.last());
            }
        }
    }
}
