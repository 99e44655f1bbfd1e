//! Clipping: strokes cut at the edges of visible areas.

use std::cell::{Cell, OnceCell};
use std::rc::Rc;

use dobot_geometry::{
    FillRule, Line, ParamCurveNearest, Point, Polygons, Rect, SegmentIndex, Stroke, bounds,
};

use crate::limits::{Budget, OverBudget};

/// The visible part of a clip path: the union of areas.
#[derive(Debug, Default)]
pub(crate) struct Region {
    areas: Vec<ClipArea>,
    /// The union as polygons, computed on demand; `None` if too complex.
    polygons: OnceCell<Option<Polygons>>,
}

impl Region {
    pub(crate) fn new(areas: Vec<ClipArea>) -> Self {
        Self {
            areas,
            polygons: OnceCell::new(),
        }
    }

    /// The visible part as polygons; `None` if too complex.
    pub(crate) fn polygons(&self) -> Option<&Polygons> {
        let all = || {
            let areas = self.areas.iter().map(ClipArea::polygons);
            Polygons::union(areas.collect::<Option<Vec<_>>>()?)
        };
        self.polygons.get_or_init(all).as_ref()
    }

    /// The visible parts of a stroke. A line along an edge is visible, as half of its ink is in a
    /// browser.
    pub(crate) fn cut(
        &self,
        stroke: Stroke,
        budget: &mut Budget,
    ) -> Result<Vec<Stroke>, OverBudget> {
        let bounds = bounds(stroke.points.iter().copied()).inflate(ON_EDGE_MM, ON_EDGE_MM);
        if stroke.points.len() == 1 || !self.has_edge_in(bounds) {
            let shows = self.shows(stroke.points[0]);
            self.charge(budget)?;
            return Ok(if shows { vec![stroke] } else { Vec::new() });
        }
        let cuts = |a: Point, b: Point, cuts: &mut Vec<f64>| {
            self.each_area(&mut |area| area.cuts(a, b, cuts));
        };
        let spend = |cuts| {
            budget.spend(cuts)?;
            self.charge(budget)
        };
        parts(&stroke, cuts, |p| self.shows(p), spend)
    }

    /// Charges the edge tests since the last call to the budget.
    pub(crate) fn charge(&self, budget: &mut Budget) -> Result<(), OverBudget> {
        let mut looks = 0;
        self.each_area(&mut |area| looks += LOOKS_FOR_ANY + area.looks.take());
        budget.look(looks)
    }

    pub(crate) fn shows(&self, p: Point) -> bool {
        self.areas.iter().any(|area| area.shows(p))
    }

    /// Whether an edge lies in these bounds.
    pub(crate) fn has_edge_in(&self, bounds: Rect) -> bool {
        let mut found = false;
        self.each_area(&mut |area| found |= area.has_edge_in(bounds));
        found
    }

    fn each_area(&self, visit: &mut dyn FnMut(&ClipArea)) {
        for area in &self.areas {
            area.each(visit);
        }
    }
}

/// A filled outline, which may itself be clipped.
#[derive(Debug)]
pub(crate) struct ClipArea {
    rings: Vec<Vec<Point>>,
    /// The number of corners.
    corners: usize,
    /// A spatial index of its edges, built on demand; a few edges are tested one by one.
    edges: OnceCell<SegmentIndex>,
    rule: FillRule,
    within: Vec<Rc<Region>>,
    /// The number of edges tested since the last charge.
    looks: Cell<usize>,
}

impl ClipArea {
    /// Creates the inside of these outlines; open ones are closed, as filling does.
    pub(crate) fn new(outlines: &[Stroke], rule: FillRule, within: Vec<Rc<Region>>) -> Self {
        Self {
            rings: outlines
                .iter()
                .map(|outline| outline.points.clone())
                .collect(),
            corners: outlines.iter().map(|outline| outline.points.len()).sum(),
            edges: OnceCell::new(),
            rule,
            within,
            looks: Cell::new(0),
        }
    }

    /// Restricts the area to a region.
    pub(crate) fn clip(&mut self, region: Rc<Region>) {
        self.within.push(region);
    }

    /// The parts of a stroke outside this area; `None` if the budget of edge tests is exhausted. A
    /// line along the edge is outside, because half of its ink is visible.
    pub(crate) fn uncovered(
        &self,
        stroke: &Stroke,
        budget: &mut Budget,
    ) -> Result<Option<Vec<Stroke>>, OverBudget> {
        let bounds = bounds(stroke.points.iter().copied()).inflate(ON_EDGE_MM, ON_EDGE_MM);
        // Its points were tested just now.
        self.looks.set(self.looks.get() + stroke.points.len());
        if stroke.points.len() == 1 || !self.may_cut(bounds) {
            let covered = self.covers(stroke.points[0]);
            let seen = (!covered).then(|| stroke.clone());
            let is_known = self.charge(budget);
            return Ok(is_known.then(|| seen.into_iter().collect()));
        }
        parts_on(stroke, &[self], |p| !self.covers(p), budget)
    }

    /// Charges the edge tests since the last call to the budget; `false` if it is exhausted.
    pub(crate) fn charge(&self, budget: &mut Budget) -> bool {
        let mut looks = LOOKS_FOR_ANY;
        self.each(&mut |area| looks += area.looks.take());
        budget.take_looks(looks)
    }

    /// The number of corners of its outlines.
    pub(crate) const fn corners(&self) -> usize {
        self.corners
    }

    /// The bounding box of its outlines.
    pub(crate) fn bounds(&self) -> Rect {
        bounds(self.rings.iter().flatten().copied())
    }

    fn has_edge_in(&self, bounds: Rect) -> bool {
        let mut found = false;
        self.edges_touching(bounds, &mut |_| found = true);
        found
    }

    /// Whether an edge of the area, or of a clip of it, lies in these bounds.
    pub(crate) fn may_cut(&self, bounds: Rect) -> bool {
        let mut found = false;
        self.each(&mut |area| found |= area.has_edge_in(bounds));
        found
    }

    /// Whether a point is covered.
    pub(crate) fn covers(&self, p: Point) -> bool {
        self.is_inside(p) && !self.is_on_edge(p) && self.within.iter().all(|r| r.shows(p))
    }

    /// The area and all areas that clip it.
    fn each(&self, visit: &mut dyn FnMut(&Self)) {
        visit(self);
        for region in &self.within {
            region.each_area(visit);
        }
    }

    /// The area as polygons; `None` if too complex.
    pub(crate) fn polygons(&self) -> Option<Polygons> {
        let whole = Polygons::new(&self.rings, self.rule);
        let mut within = self.within.iter();
        within.try_fold(whole?, |shown, region| {
            shown.intersection(region.polygons()?)
        })
    }

    fn shows(&self, p: Point) -> bool {
        (self.is_inside(p) || self.is_on_edge(p)) && self.within.iter().all(|r| r.shows(p))
    }

    fn is_inside(&self, p: Point) -> bool {
        let ray = Rect::new(p.x, p.y, f64::INFINITY, p.y);
        let mut winding = 0;
        self.edges_touching(ray, &mut |edge| winding += crossing(edge, p));
        match self.rule {
            FillRule::NonZero => winding != 0,
            FillRule::EvenOdd => winding % 2 != 0,
        }
    }

    /// Whether a point is on an edge of the area.
    pub(crate) fn is_on_edge(&self, p: Point) -> bool {
        let mut on_edge = false;
        let around = Rect::from_points(p, p).inflate(ON_EDGE_MM, ON_EDGE_MM);
        self.edges_touching(around, &mut |(a, b)| {
            on_edge |= Line::new(a, b).nearest(p, 0.0).distance_sq.sqrt() <= ON_EDGE_MM;
        });
        on_edge
    }

    fn cuts(&self, a: Point, b: Point, cuts: &mut Vec<f64>) {
        let around = Rect::from_points(a, b).inflate(ON_EDGE_MM, ON_EDGE_MM);
        self.edges_touching(around, &mut |edge| cuts.extend(meeting(a, b, edge)));
    }

    /// Calls `visit` for each edge whose bounding box touches `around`.
    fn edges_touching(&self, around: Rect, visit: &mut impl FnMut((Point, Point))) {
        let mut looks = 0;
        if self.corners <= FEW_CORNERS {
            for (a, b) in self.edges() {
                looks += 1;
                if Rect::from_points(a, b).overlaps(around) {
                    visit((a, b));
                }
            }
        } else {
            let edges = self
                .edges
                .get_or_init(|| SegmentIndex::new(self.edges().collect()));
            looks += edges.touching(around, &mut |edge| visit(edges.segment(edge)));
        }
        self.looks.set(self.looks.get() + looks);
    }

    fn edges(&self) -> impl Iterator<Item = (Point, Point)> {
        let edges = self.rings.iter().flat_map(|ring| {
            let closing = ring.last().map(|&last| (last, ring[0]));
            ring.windows(2)
                .map(|pair| (pair[0], pair[1]))
                .chain(closing)
        });
        edges.filter(|(a, b)| a != b)
    }
}

/// The parts of a stroke that are kept, where the decision changes only at the edges of areas;
/// `None` if the budget of edge tests is exhausted.
pub(crate) fn parts_on(
    stroke: &Stroke,
    areas: &[&ClipArea],
    keeps: impl Fn(Point) -> bool,
    budget: &mut Budget,
) -> Result<Option<Vec<Stroke>>, OverBudget> {
    let cuts = |a: Point, b: Point, cuts: &mut Vec<f64>| {
        for area in areas {
            area.each(&mut |area| area.cuts(a, b, cuts));
        }
    };
    let spend = |cuts| {
        budget.spend(cuts).map_err(Some)?;
        let is_known = areas.iter().all(|area| area.charge(budget));
        is_known.then_some(()).ok_or(None)
    };
    match parts(stroke, cuts, keeps, spend) {
        Ok(parts) => Ok(Some(parts)),
        Err(Some(over_budget)) => Err(over_budget),
        Err(None) => Ok(None),
    }
}

/// The kept parts of a stroke; the decision changes only at its cuts, given as fractions of its
/// length. `spend` gets the number of further pieces for each cut, and its error ends the
/// computation.
fn parts<E>(
    stroke: &Stroke,
    find_cuts: impl Fn(Point, Point, &mut Vec<f64>),
    keeps: impl Fn(Point) -> bool,
    mut spend: impl FnMut(usize) -> Result<(), E>,
) -> Result<Vec<Stroke>, E> {
    let mut pieces: Vec<Stroke> = Vec::new();
    let mut open = false;
    let mut cuts = Vec::new();
    for (a, b) in stroke.segments() {
        cuts.clear();
        cuts.extend([0.0, 1.0]);
        find_cuts(a, b, &mut cuts);
        cuts.sort_unstable_by(f64::total_cmp);
        cuts.dedup();
        spend(cuts.len() - 2)?;
        for t in cuts.windows(2) {
            spend(0)?;
            let kept = keeps(a.lerp(b, f64::midpoint(t[0], t[1])));
            if kept && !open {
                pieces.push(Stroke::open(vec![place(a, b, t[0])]));
            }
            if let Some(piece) = pieces.last_mut().filter(|_| kept) {
                piece.points.push(place(a, b, t[1]));
            }
            open = kept;
        }
    }
    // A mere touch of an edge shows at most a speck.
    pieces.retain(|piece| piece.length_mm() > 2.0 * ON_EDGE_MM);
    match &mut pieces[..] {
        [only] => only.closed = stroke.closed && ends(only) == ends(stroke),
        [_, .., _] if stroke.closed => join_at_seam(&mut pieces, stroke.points[0]),
        _ => {}
    }
    Ok(pieces)
}

/// +1 or -1 if the edge crosses the ray from `p` in the x direction, else 0.
fn crossing((a, b): (Point, Point), p: Point) -> i32 {
    if (a.y <= p.y) == (b.y <= p.y) {
        return 0;
    }
    let side = (b - a).cross(p - a);
    if a.y <= p.y {
        i32::from(side > 0.0)
    } else {
        -i32::from(side < 0.0)
    }
}

/// The fraction of the segment at which it meets an edge, if it does.
fn meeting(from: Point, to: Point, edge: (Point, Point)) -> Option<f64> {
    let (way, side) = (to - from, edge.1 - edge.0);
    let turn = way.cross(side);
    if turn == 0.0 {
        return None;
    }
    let gap = edge.0 - from;
    let (on_way, on_side) = (gap.cross(side) / turn, gap.cross(way) / turn);
    let slack = ON_EDGE_MM / side.length();
    let meets = on_way > 0.0 && on_way < 1.0 && on_side >= -slack && on_side <= 1.0 + slack;
    meets.then_some(on_way)
}

fn place(a: Point, b: Point, t: f64) -> Point {
    if t == 1.0 { b } else { a.lerp(b, t) }
}

fn ends(stroke: &Stroke) -> (Point, Option<Point>) {
    (stroke.points[0], stroke.last())
}

/// Joins the last and the first piece of a closed stroke whose start is visible.
fn join_at_seam(pieces: &mut Vec<Stroke>, seam: Point) {
    if (pieces[0].points[0], pieces[pieces.len() - 1].last()) == (seam, Some(seam)) {
        let mut last = pieces.pop().expect("there are two pieces or more");
        last.points.extend_from_slice(&pieces[0].points[1..]);
        pieces[0] = last;
    }
}

/// Up to this number of corners, edges are tested one by one.
const FEW_CORNERS: usize = 16;
/// The base cost of an operation, in edge tests.
const LOOKS_FOR_ANY: usize = 4;
/// The distance at which a point counts as on an edge; single precision allows no smaller one at
/// this size.
const ON_EDGE_MM: f64 = 1e-3;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn outline(points: &[(f64, f64)]) -> Stroke {
        Stroke::open(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
    }

    fn square(min: f64, max: f64) -> Stroke {
        outline(&[(min, min), (max, min), (max, max), (min, max)])
    }

    fn region(outlines: &[Stroke], rule: FillRule) -> Region {
        Region::new(vec![ClipArea::new(outlines, rule, Vec::new())])
    }

    fn cut(region: &Region, stroke: Stroke) -> Vec<Stroke> {
        region.cut(stroke, &mut Budget::new(100_000)).unwrap()
    }

    fn spans(pieces: &[Stroke]) -> Vec<(f64, f64)> {
        pieces
            .iter()
            .map(|s| (s.points[0].x, s.last().unwrap().x))
            .map(|(from, to)| ((from * 1e9).round() / 1e9, (to * 1e9).round() / 1e9))
            .collect()
    }

    #[test]
    fn a_line_through_a_square_keeps_its_middle() {
        let pieces = cut(
            &region(&[square(2.0, 4.0)], FillRule::NonZero),
            outline(&[(0.0, 3.0), (9.0, 3.0)]),
        );
        assert_eq!(spans(&pieces), [(2.0, 4.0)]);
    }

    #[test]
    fn a_square_in_a_square_is_a_hole_for_even_odd_only() {
        let squares = [square(0.0, 9.0), square(3.0, 6.0)];
        let line = outline(&[(-5.0, 4.0), (20.0, 4.0)]);
        let holed = cut(&region(&squares, FillRule::EvenOdd), line.clone());
        assert_eq!(spans(&holed), [(0.0, 3.0), (6.0, 9.0)]);
        let full = cut(&region(&squares, FillRule::NonZero), line);
        assert_eq!(spans(&full), [(0.0, 9.0)]);
    }

    #[test]
    fn a_line_along_an_edge_shows() {
        let pieces = cut(
            &region(&[square(2.0, 4.0)], FillRule::NonZero),
            outline(&[(0.0, 2.0), (9.0, 2.0)]),
        );
        assert_eq!(spans(&pieces), [(2.0, 4.0)]);
    }

    #[test]
    fn an_outline_clipped_by_itself_stays_whole_and_closed() {
        let mut stroke = square(2.0, 4.0);
        stroke.points.push(stroke.points[0]);
        stroke.closed = true;
        let pieces = cut(
            &region(&[square(2.0, 4.0)], FillRule::NonZero),
            stroke.clone(),
        );
        assert_eq!(pieces, [stroke]);
    }

    #[test]
    fn a_closed_stroke_that_shows_at_its_start_is_not_cut_there() {
        let mut stroke = square(0.0, 4.0);
        stroke.points.push(stroke.points[0]);
        stroke.closed = true;
        let pieces = cut(&region(&[square(-2.0, 2.0)], FillRule::NonZero), stroke);
        assert_eq!(pieces.len(), 1);
        assert_eq!(
            pieces[0].points,
            outline(&[(0.0, 2.0), (0.0, 0.0), (2.0, 0.0)]).points
        );
        assert!(!pieces[0].closed);
    }

    #[test]
    fn distant_strokes_are_removed_and_inner_ones_stay() {
        let wide = region(&[square(-100.0, 100.0)], FillRule::NonZero);
        assert_eq!(cut(&wide, square(1.0, 2.0)), [square(1.0, 2.0)]);
        assert_eq!(cut(&wide, square(300.0, 400.0)), []);
    }

    /// A piece counts as on the edge by its middle: its ends may be twice as far away.
    fn edge_distance_mm(area: &ClipArea, p: Point) -> f64 {
        let distances = area
            .edges()
            .map(|(a, b)| Line::new(a, b).nearest(p, 0.0).distance_sq);
        distances.min_by(f64::total_cmp).unwrap().sqrt()
    }

    proptest! {
        #[test]
        fn pieces_lie_inside_and_nothing_inside_is_lost(
            // Some have few enough edges for testing one by one.
            corners in proptest::collection::vec((0.0..50.0_f64, 0.0..50.0_f64), 3..2 * FEW_CORNERS),
            line in proptest::collection::vec((-10.0..60.0_f64, -10.0..60.0_f64), 2..12),
            even_odd in any::<bool>(),
        ) {
            let rule = if even_odd { FillRule::EvenOdd } else { FillRule::NonZero };
            let region = region(&[outline(&corners)], rule);
            let stroke = outline(&line);
            let pieces = cut(&region, stroke.clone());
            let area = &region.areas[0];
            let mut kept = 0.0;
            for (a, b) in pieces.iter().flat_map(Stroke::segments) {
                kept += a.distance(b);
                for i in 1..8 {
                    let p = a.lerp(b, f64::from(i) / 8.0);
                    prop_assert!(area.is_inside(p) || edge_distance_mm(area, p) < 2.1 * ON_EDGE_MM, "{p:?} is outside");
                }
            }
            let mut wanted = 0.0;
            let steps = 2000;
            for (a, b) in stroke.segments() {
                let inside = (0..steps)
                    .filter(|i| area.is_inside(a.lerp(b, (f64::from(*i) + 0.5) / f64::from(steps))))
                    .count();
                #[expect(clippy::cast_precision_loss, reason = "a small count")]
                let share = inside as f64 / f64::from(steps);
                wanted += share * a.distance(b);
            }
            prop_assert!((kept - wanted).abs() < 0.01 * stroke.length_mm() + 0.1, "{kept} of {wanted} mm");
        }
    }
}
