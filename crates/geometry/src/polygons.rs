//! Boolean operations on areas, and offsets of them.

use i_overlay::core::fill_rule::FillRule as Rule;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::simplify::SimplifyShape;
use i_overlay::float::single::SingleFloatOverlay;
use i_overlay::mesh::float::outline::offset::OutlineOffset;
use i_overlay::mesh::float::style::{LineJoin, OutlineStyle};
use kurbo::{Point, Rect};

use crate::{Area, FillRule, SegmentIndex, bounds, edges};

/// Polygons with holes that neither overlap nor cross each other.
#[derive(Clone, Debug, Default)]
pub struct Polygons(Vec<Vec<Vec<[f64; 2]>>>);

impl Polygons {
    /// Creates polygons from closed rings, whose last point connects to the first; `None` if they
    /// cross too often: it would take too much time and memory.
    #[must_use]
    pub fn new(rings: &[Vec<Point>], rule: FillRule) -> Option<Self> {
        if is_entangled(rings) {
            return None;
        }
        let plain = |ring: &Vec<Point>| ring.iter().map(|p| [p.x, p.y]).collect();
        let rings: Vec<Vec<[f64; 2]>> = rings.iter().map(plain).collect();
        let rule = match rule {
            FillRule::NonZero => Rule::NonZero,
            FillRule::EvenOdd => Rule::EvenOdd,
        };
        Some(Self(rings.simplify_shape_as::<i64>(rule)))
    }

    /// Returns the part inside both; `None` if they cross too often.
    #[must_use]
    pub fn intersection(self, other: &Self) -> Option<Self> {
        self.joined(other, OverlayRule::Intersect)
    }

    /// Returns the part inside any; `None` if they cross too often.
    #[must_use]
    pub fn union(all: Vec<Self>) -> Option<Self> {
        // The rings of each go around their inside once, so that together they cover all of it.
        let all = Self(all.into_iter().flat_map(|item| item.0).collect());
        all.joined(&Self::default(), OverlayRule::Union)
    }

    /// Returns the part outside all others; `None` if they cross too often.
    #[must_use]
    pub fn difference<'p>(self, others: impl IntoIterator<Item = &'p Self>) -> Option<Self> {
        // The rings of each go around their inside once, so that together they cover all of it.
        let others = others.into_iter().flat_map(|other| other.0.iter().cloned());
        self.joined(&Self(others.collect()), OverlayRule::Difference)
    }

    /// Returns the rings enlarged by a distance, or reduced if it is negative, with round corners
    /// within `round_mm`; the result may have several parts or none.
    #[must_use]
    pub fn offset(&self, by_mm: f64, round_mm: f64) -> Vec<Vec<Point>> {
        if by_mm == 0.0 {
            return self.rings().collect();
        }
        let share = (2.0 * round_mm / by_mm.abs()).sqrt().clamp(0.02, 1.0);
        let style = OutlineStyle::new(by_mm).line_join(LineJoin::Round(share));
        Self(self.0.outline_as::<i64>(&style)).rings().collect()
    }

    /// Whether nothing is inside.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns the rings as an area.
    #[must_use]
    pub fn into_area(self) -> Area {
        Area {
            rings: self.rings().collect(),
            rule: FillRule::EvenOdd,
        }
    }

    fn joined(self, other: &Self, how: OverlayRule) -> Option<Self> {
        if self.corners() + other.corners() > FEW_CORNERS {
            let both: Vec<Vec<Point>> = [&self, other].into_iter().flat_map(Self::rings).collect();
            if is_entangled(&both) {
                return None;
            }
        }
        Some(Self(self.0.overlay_as::<i64>(&other.0, how, Rule::NonZero)))
    }

    /// Returns the number of corners.
    #[must_use]
    pub fn corners(&self) -> usize {
        self.0.iter().flatten().map(Vec::len).sum()
    }

    fn rings(&self) -> impl Iterator<Item = Vec<Point>> {
        let point = |&[x, y]: &[f64; 2]| Point::new(x, y);
        let rings = self.0.iter().flatten();
        rings.map(move |ring| ring.iter().map(point).collect())
    }
}

/// Whether too many edges overlap: clipping would take too much time and memory.
fn is_entangled(rings: &[Vec<Point>]) -> bool {
    if rings.iter().map(Vec::len).sum::<usize>() <= FEW_CORNERS {
        return false;
    }
    let edges: Vec<(Point, Point)> = rings.iter().flat_map(|ring| edges(ring)).collect();
    if fragments(&edges) > MAX_FRAGMENTS {
        return true;
    }
    let index = SegmentIndex::new(edges);
    let most_pairs = MAX_PAIRS + PAIRS_OF_EDGE * index.segments().len();
    let (mut pairs, mut crossings) = (0_usize, 0_usize);
    for &edge in index.segments() {
        index.touching(Rect::from_points(edge.0, edge.1), &mut |other| {
            pairs += 1;
            crossings += usize::from(is_crossed(edge, index.segment(other)));
        });
        if pairs > most_pairs || crossings > MAX_CROSSINGS {
            return true;
        }
    }
    false
}

/// Whether each edge has its ends on both sides of the other.
fn is_crossed(one: (Point, Point), other: (Point, Point)) -> bool {
    let parts = |(a, b): (Point, Point), (p, q): (Point, Point)| {
        let way = b - a;
        way.cross(p - a) * way.cross(q - a) < 0.0
    };
    parts(one, other) && parts(other, one)
}

/// An estimate of the number of pieces of edges in the library, which cuts at columns of equal
/// width, up to twice as many as the root of the edge count.
fn fragments(edges: &[(Point, Point)]) -> f64 {
    let around = bounds(edges.iter().flat_map(|&(a, b)| [a, b]));
    let across: f64 = edges.iter().map(|(a, b)| (b.x - a.x).abs()).sum();
    #[expect(clippy::cast_precision_loss, reason = "a few millions")]
    let columns = 2.0 * (edges.len() as f64).sqrt();
    across / around.width() * columns
}

/// The largest number of edge pairs with touching boxes, besides neighbours: a twentieth of a
/// second.
const MAX_PAIRS: usize = 2_000_000;
/// Pairs per edge that do not count: itself, its neighbours, and a few others where corners are
/// close.
const PAIRS_OF_EDGE: usize = 8;
/// The largest number of crossing edges, counted per edge: twice the number of crossings, of which
/// each takes 350 bytes.
const MAX_CROSSINGS: usize = 600_000;
/// The largest number of pieces of edges, of which each takes 72 bytes.
const MAX_FRAGMENTS: f64 = 1_000_000.0;
/// Up to this number of corners the edges are few enough, even if each crosses all.
const FEW_CORNERS: usize = 750;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use proptest::prelude::*;

    use kurbo::{Line, ParamCurveNearest};

    use super::*;

    fn ring(points: &[(f64, f64)]) -> Vec<Point> {
        points.iter().map(|&(x, y)| Point::new(x, y)).collect()
    }

    fn inside(area: &Area, p: Point) -> bool {
        let winding: i32 = area.rings.iter().map(|ring| winding(ring, p)).sum();
        match area.rule {
            FillRule::NonZero => winding != 0,
            FillRule::EvenOdd => winding % 2 != 0,
        }
    }

    fn winding(ring: &[Point], p: Point) -> i32 {
        let crossing = |(a, b): (Point, Point)| {
            let up = a.y <= p.y && b.y > p.y;
            let down = b.y <= p.y && a.y > p.y;
            let left = (b - a).cross(p - a) > 0.0;
            i32::from(up && left) - i32::from(down && !left)
        };
        edges(ring).map(crossing).sum()
    }

    fn distance(area: &Area, p: Point) -> f64 {
        let to_edge = |(a, b)| Line::new(a, b).nearest(p, 0.0).distance_sq.sqrt();
        let edges = area.rings.iter().flat_map(|ring| edges(ring));
        edges.map(to_edge).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn a_ring_of_few_corners_cannot_be_entangled() {
        const { assert!(FEW_CORNERS * FEW_CORNERS <= MAX_CROSSINGS) };
    }

    #[test]
    fn a_ring_that_crosses_itself_millions_of_times_is_not_changed() {
        let across = |i| match (i % 2, f64::from(i) * 0.01) {
            (0, y) => Point::new(0.0, y),
            (_, y) => Point::new(90.0, 80.0 - y),
        };
        assert!(Polygons::new(&[(0..8000).map(across).collect()], FillRule::NonZero).is_none());
    }

    /// Adjacent teeth, `turned` below each other.
    fn comb(teeth: i32, turned: bool) -> Vec<Point> {
        let corner = |i: i32| {
            let (along, up) = (f64::from(i) * 100.0 / f64::from(2 * teeth), i % 2 == 1);
            let across = if up { 100.0 } else { 0.0 };
            if turned {
                Point::new(across, along)
            } else {
                Point::new(along, across)
            }
        };
        (0..2 * teeth).map(corner).collect()
    }

    #[test]
    fn combs_that_cross_too_often_are_not_changed_and_smaller_ones_are_cut() {
        let cut = |teeth| {
            let [one, other] = [false, true]
                .map(|turned| Polygons::new(&[comb(teeth, turned)], FillRule::NonZero).unwrap());
            one.intersection(&other)
        };
        assert!(cut(30).is_some_and(|cut| cut.corners() > 3000));
        assert!(cut(300).is_none());
    }

    #[test]
    fn edges_that_would_be_cut_into_too_many_pieces_are_not_changed() {
        assert!(Polygons::new(&[comb(20_000, true)], FillRule::NonZero).is_none());
        assert!(Polygons::new(&[comb(20_000, false)], FillRule::NonZero).is_some());
    }

    proptest! {
        #[test]
        fn a_point_is_in_the_cut_area_if_it_is_in_both(
            one in proptest::collection::vec((0.0..50.0_f64, 0.0..50.0_f64), 3..12),
            other in proptest::collection::vec((0.0..50.0_f64, 0.0..50.0_f64), 3..12),
            even_odd in any::<bool>(),
            points in proptest::collection::vec((0.0..50.0_f64, 0.0..50.0_f64), 100),
        ) {
            let rule = if even_odd { FillRule::EvenOdd } else { FillRule::NonZero };
            let areas = [one, other].map(|value| Area { rings: vec![ring(&value)], rule });
            let [a, b] = [&areas[0], &areas[1]].map(|value| Polygons::new(&value.rings, rule).unwrap());
            let both = a.clone().intersection(&b).unwrap().into_area();
            let any = Polygons::union(vec![a, b]).unwrap().into_area();
            for p in ring(&points) {
                if areas.iter().any(|area| distance(area, p) < 1e-4) {
                    continue;
                }
                let [in_a, in_b] = [inside(&areas[0], p), inside(&areas[1], p)];
                prop_assert_eq!(inside(&both, p), in_a && in_b);
                prop_assert_eq!(inside(&any, p), in_a || in_b);
            }
        }
    }
}
