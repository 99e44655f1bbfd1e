//! Cutting with a laser: inner shapes first, kerf compensation, and tabs that hold parts.

use std::collections::HashSet;

use dobot_geometry::{
    FillRule, Line, ParamCurveNearest, Point, Polygons, Rect, SegmentIndex, Stroke, Vec2,
};

/// The settings for cutting shapes out.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cutting {
    /// The kerf, the width of the beam, in mm: parts are cut larger by half of it all around, and
    /// holes smaller; a negative width does the opposite.
    pub kerf_mm: f64,
    /// The length of the lead-in in the waste, in mm.
    pub lead_in_mm: f64,
    /// The distance that each cut continues past its start, in mm.
    pub overcut_mm: f64,
    /// The number of tabs that hold each shape.
    pub tabs: u32,
    /// The width of a tab, in mm.
    pub tab_mm: f64,
}

impl Cutting {
    /// Whether any setting changes closed shapes.
    pub(crate) fn is_asked_for(&self) -> bool {
        self.kerf_mm != 0.0 || self.lead_in_mm > 0.0 || self.overcut_mm > 0.0 || self.tabs > 0
    }

    /// Offsets closed shapes by the kerf: parts and holes alternate, the outermost shape is a part,
    /// and shapes cut in other layers count.
    pub(crate) fn offset(
        &self,
        strokes: Vec<Stroke>,
        others: &[&Stroke],
        tolerance_mm: f64,
    ) -> OffsetShapes {
        let mut shapes = OffsetShapes::default();
        if self.kerf_mm == 0.0 {
            shapes.strokes = strokes;
            return shapes;
        }
        let depths = depths(&strokes, others);
        for (stroke, depth) in strokes.into_iter().zip(depths) {
            if !is_loop(&stroke) {
                shapes.strokes.push(stroke);
                continue;
            }
            let side = if depth % 2 == 0 { 0.5 } else { -0.5 };
            if let Some(parts) = offset(&stroke, side * self.kerf_mm, tolerance_mm) {
                shapes.vanished += usize::from(parts.is_empty());
                shapes.strokes.extend(parts);
            } else {
                shapes.entangled += 1;
                shapes.strokes.push(stroke);
            }
        }
        shapes
    }

    /// Returns the strokes in order; closed ones with lead-in, overcut or tabs.
    pub(crate) fn finished(&self, strokes: Vec<Stroke>, others: &[&Stroke]) -> Cut {
        let leads_in = self.lead_in_mm > 0.0;
        let mut waste = leads_in.then(|| Waste::between(&strokes, others, self.lead_in_mm));
        let depths = if leads_in {
            depths(&strokes, others)
        } else {
            vec![0; strokes.len()]
        };
        let (mut all, mut too_small) = (Vec::new(), 0);
        for (number, (stroke, depth)) in strokes.into_iter().zip(depths).enumerate() {
            if !is_loop(&stroke) {
                all.push(stroke);
                continue;
            }
            let is_part = depth % 2 == 0;
            let has_room = stroke.length_mm() > 3.0 * self.gap_mm() * f64::from(self.tabs);
            let has_tabs = self.tabs > 0 && has_room;
            let stroke = match &waste {
                Some(waste) if !has_tabs => waste.begun_well(stroke, is_part, number),
                _ => stroke,
            };
            let (cuts, before) = if has_tabs {
                (self.between_tabs(&stroke), Vec2::ZERO)
            } else {
                too_small += usize::from(self.tabs > 0);
                (vec![self.overcut(&stroke)], end_direction(&stroke))
            };
            for mut cut in cuts {
                if let Some(waste) = &mut waste {
                    let side = waste_side(&stroke, before, &cut, is_part);
                    waste.lead_in(&mut cut, side, number);
                }
                all.push(cut);
            }
        }
        Cut {
            strokes: all,
            too_small,
            short_of_room: waste.map_or(0, |waste| waste.short_of_room),
        }
    }

    /// Returns one turn around the shape that continues past its start.
    fn overcut(&self, stroke: &Stroke) -> Stroke {
        if self.overcut_mm <= 0.0 {
            return stroke.clone();
        }
        let over = along(&stroke.points, 0.0, self.overcut_mm);
        Stroke::open(
            stroke
                .points
                .iter()
                .copied()
                .chain(over.into_iter().skip(1))
                .collect(),
        )
    }

    /// Returns the length of a tab between the beam centres.
    fn gap_mm(&self) -> f64 {
        self.tab_mm + self.kerf_mm.abs()
    }

    /// Returns the parts between the tabs, which are evenly distributed.
    fn between_tabs(&self, stroke: &Stroke) -> Vec<Stroke> {
        let each_mm = stroke.length_mm() / f64::from(self.tabs);
        let twice = [&stroke.points[..], &stroke.points[1..]].concat();
        let piece = |i: u32| {
            let tab_mm = each_mm * (f64::from(i) + 0.5);
            let half_mm = 0.5 * self.gap_mm();
            Stroke::open(along(&twice, tab_mm + half_mm, tab_mm + each_mm - half_mm))
        };
        (0..self.tabs).map(piece).collect()
    }
}

/// Shapes offset by the kerf.
#[derive(Debug, Default)]
pub(crate) struct OffsetShapes {
    pub strokes: Vec<Stroke>,
    /// The number of shapes that vanished, because the beam is wider.
    pub vanished: usize,
    /// The number of shapes that are not offset, because their edge crosses itself too often.
    pub entangled: usize,
}

/// The cuts of shapes.
#[derive(Debug)]
pub(crate) struct Cut {
    pub strokes: Vec<Stroke>,
    /// The number of shapes too small for tabs.
    pub too_small: usize,
    /// The number of cuts with a shortened lead-in, because the waste is too narrow.
    pub short_of_room: usize,
}

/// The waste between the strokes.
///
/// ```text
///        .---->----.
///        |         |          lead-in from the waste, once around, and on over the beginning
///   ---> *=>-------'
/// ```
#[derive(Debug)]
struct Waste {
    lines: SegmentIndex,
    /// The stroke of each line.
    owners: Vec<usize>,
    lead_in_mm: f64,
    short_of_room: usize,
}

impl Waste {
    fn between(strokes: &[Stroke], others: &[&Stroke], lead_in_mm: f64) -> Self {
        let all = strokes.iter().chain(others.iter().copied()).enumerate();
        let lines =
            all.flat_map(|(number, stroke)| stroke.segments().map(move |line| (number, line)));
        let (owners, lines) = lines.unzip();
        Self {
            lines: SegmentIndex::new(lines),
            owners,
            lead_in_mm,
            short_of_room: 0,
        }
    }

    /// Returns a shape with a start that has room for its lead-in: the given one, or the middle of
    /// a side.
    fn begun_well(&self, shape: Stroke, is_part: bool, stroke: usize) -> Stroke {
        let room_mm = |shape: &Stroke| {
            let side = waste_side(shape, end_direction(shape), shape, is_part);
            let room_mm = self.room_mm(shape.points[0], unit(side), stroke);
            room_mm.min(2.0 * self.lead_in_mm)
        };
        let mut most_mm = room_mm(&shape);
        let mut best = None;
        let sides = shape.points.len() - 1;
        for side in (0..sides).step_by(sides.div_ceil(MAX_BEGINNINGS)) {
            if most_mm >= 2.0 * self.lead_in_mm {
                break;
            }
            let begun = begun_in_side(&shape, side);
            let mm = room_mm(&begun);
            if mm > most_mm {
                (most_mm, best) = (mm, Some(begun));
            }
        }
        best.unwrap_or(shape)
    }

    /// Adds a lead-in to a cut from this side, at most half the distance to the next cut.
    fn lead_in(&mut self, cut: &mut Stroke, side: Vec2, stroke: usize) {
        let (first, way) = (cut.points[0], unit(side));
        let room_mm = 0.5 * self.room_mm(first, way, stroke);
        self.short_of_room += usize::from(room_mm < self.lead_in_mm);
        let lead_in_mm = self.lead_in_mm.min(room_mm);
        if lead_in_mm > MIN_LEAD_IN_MM {
            cut.points.insert(0, first + way * lead_in_mm);
            cut.closed = false;
        }
    }

    /// Returns the distance from the start of a stroke to the next cut, in mm.
    fn room_mm(&self, from: Point, way: Vec2, stroke: usize) -> f64 {
        let ahead = from + way * (2.0 * self.lead_in_mm);
        let mut room_mm = f64::INFINITY;
        self.lines
            .touching(Rect::from_points(from, ahead), &mut |line| {
                let (a, b) = self.lines.segment(line);
                let across = way.cross(b - a);
                let mm = (a - from).cross(b - a) / across;
                let share = (a - from).cross(way) / across;
                let is_own = self.owners[line as usize] == stroke && mm.abs() < SAME_MM;
                if (0.0..=1.0).contains(&share) && mm > -MIN_LEAD_IN_MM && !is_own {
                    room_mm = room_mm.min(mm.max(0.0));
                }
            });
        room_mm
    }
}

/// Returns the direction in which a closed shape returns to its start.
fn end_direction(shape: &Stroke) -> Vec2 {
    let last = shape.points.len() - 1;
    unit(shape.points[last] - shape.points[last - 1])
}

/// Returns the side of a cut's start on which the waste lies, given the direction `before` of
/// arrival: in a corner halfway between both sides, because straight behind one side would be on
/// the other.
fn waste_side(shape: &Stroke, before: Vec2, cut: &Stroke, is_part: bool) -> Vec2 {
    let left = unit(before + unit(cut.points[1] - cut.points[0])).turn_90();
    let is_inside = is_in(&shape.points, cut.points[0] + left * MEETS_MM);
    if is_inside == is_part { -left } else { left }
}

/// Returns the closed shape with its start in the middle of a side.
fn begun_in_side(shape: &Stroke, side: usize) -> Stroke {
    let points = &shape.points;
    let middle = points[side].midpoint(points[side + 1]);
    let on = points[side + 1..points.len() - 1].iter();
    let back = points[..=side].iter();
    let around = on.chain(back).chain([&middle]).copied();
    Stroke {
        points: [middle].into_iter().chain(around).collect(),
        ..*shape
    }
}

/// Groups strokes, the most deeply nested first: content is cut before what encloses it, or
/// enclosed it when its edges were `whole`.
pub(crate) fn inner_first(strokes: Vec<Stroke>, whole: &[Stroke]) -> Vec<Vec<Stroke>> {
    let whole: Vec<&Stroke> = whole.iter().collect();
    let depths = depths(&strokes, &whole);
    let deepest = depths.iter().copied().max().unwrap_or(0);
    let mut groups = vec![Vec::new(); deepest + 1];
    for (stroke, depth) in strokes.into_iter().zip(depths) {
        groups[deepest - depth].push(stroke);
    }
    groups.retain(|group: &Vec<Stroke>| !group.is_empty());
    groups
}

/// Orders layers, with those inside the shapes of earlier layers before them, and returns the
/// number that cannot be ordered. Each layer is given by its cut strokes.
pub(crate) fn layers_inner_first(layers: &[Vec<&Stroke>]) -> (Vec<usize>, usize) {
    let layer_of = |layer: usize| vec![layer; layers[layer].len()];
    let layer_of: Vec<usize> = (0..layers.len()).flat_map(layer_of).collect();
    let strokes: Vec<&Stroke> = layers.iter().flatten().copied().collect();
    let mut inside_of = vec![HashSet::new(); layers.len()];
    if layers.len() > 1 {
        for (inner, enclosing) in enclosing(&strokes, strokes.len()).into_iter().enumerate() {
            let outer = enclosing.into_iter().map(|stroke| layer_of[stroke]);
            inside_of[layer_of[inner]].extend(outer.filter(|&layer| layer != layer_of[inner]));
        }
    }
    let mut left: Vec<usize> = (0..layers.len()).collect();
    let (mut sorted, mut too_late) = (Vec::new(), 0);
    while !left.is_empty() {
        let encloses = |outer: usize| left.iter().any(|&layer| inside_of[layer].contains(&outer));
        let next = left.iter().position(|&layer| !encloses(layer));
        too_late += usize::from(next.is_none());
        sorted.push(left.remove(next.unwrap_or(0)));
    }
    (sorted, too_late)
}

/// Returns the number of closed strokes or others around each stroke.
fn depths(strokes: &[Stroke], others: &[&Stroke]) -> Vec<usize> {
    let all: Vec<&Stroke> = strokes.iter().chain(others.iter().copied()).collect();
    let enclosing = enclosing(&all, strokes.len());
    enclosing.iter().map(HashSet::len).collect()
}

/// Returns the closed strokes that completely enclose each of the first strokes; strokes that only
/// touch or partially enclose it do not count.
fn enclosing(strokes: &[&Stroke], first: usize) -> Vec<HashSet<usize>> {
    let loops = strokes
        .iter()
        .enumerate()
        .filter(|stroke| is_loop(stroke.1));
    let edges = loops.flat_map(|(number, ring)| {
        let points = ring.points.windows(2);
        points.map(move |pair| (number, (pair[0], pair[1])))
    });
    let (owners, edges): (Vec<usize>, Vec<(Point, Point)>) = edges.unzip();
    let index = SegmentIndex::new(edges);
    let owner = |edge: u32| owners[edge as usize];
    let around = |number: usize, at: Point| {
        let (mut crossed, mut met) = (Vec::new(), HashSet::new());
        index.touching(Rect::new(at.x, at.y, f64::INFINITY, at.y), &mut |edge| {
            if owner(edge) != number && is_ahead(index.segment(edge), at) {
                crossed.push(owner(edge));
            }
        });
        let near = Rect::new(at.x, at.y, at.x, at.y).inflate(MEETS_MM, MEETS_MM);
        index.touching(near, &mut |edge| {
            let (a, b) = index.segment(edge);
            let is_met = || Line::new(a, b).nearest(at, 0.0).distance_sq < MEETS_MM * MEETS_MM;
            if owner(edge) != number && is_met() {
                met.insert(owner(edge));
            }
        });
        crossed.sort_unstable();
        let odd = crossed
            .chunk_by(|a, b| a == b)
            .filter(|run| run.len() % 2 == 1);
        let inside: HashSet<usize> = odd.map(|run| run[0]).collect();
        (inside, met)
    };
    let around_whole = |(number, stroke): (usize, &&Stroke)| {
        let mut enclosing: Option<HashSet<usize>> = None;
        let mut only_met = HashSet::new();
        for at in samples(&stroke.points) {
            let (inside, met) = around(number, at);
            // A stroke that meets it here may still enclose it.
            enclosing = Some(match enclosing {
                None => {
                    only_met.clone_from(&met);
                    &inside | &met
                }
                Some(before) => &before & &(&inside | &met),
            });
            only_met.retain(|number| met.contains(number));
            if enclosing.as_ref().is_some_and(HashSet::is_empty) {
                break;
            }
        }
        let enclosing = enclosing.unwrap_or_default();
        enclosing.difference(&only_met).copied().collect()
    };
    let asked = strokes.iter().take(first).enumerate();
    asked.map(around_whole).collect()
}

/// Returns sample points of a path that decide what it lies in: some of its corners, and the
/// middles between them.
fn samples(points: &[Point]) -> impl Iterator<Item = Point> {
    let step = points.len().div_ceil(SAMPLES).max(1);
    let corners = points.iter().copied().step_by(step);
    let middles = points.windows(2).step_by(step);
    corners.chain(middles.map(|pair| pair[0].midpoint(pair[1])))
}

/// Whether a point lies in a closed path.
fn is_in(ring: &[Point], at: Point) -> bool {
    let edges = ring.windows(2).map(|pair| (pair[0], pair[1]));
    edges.filter(|&edge| is_ahead(edge, at)).count() % 2 == 1
}

/// Whether a ray from a point along x crosses an edge: an odd number of crossings means inside.
fn is_ahead((a, b): (Point, Point), at: Point) -> bool {
    (a.y <= at.y) != (b.y <= at.y) && a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x) > at.x
}

/// Offsets the edge of a closed stroke outwards, or inwards if negative; the result may have
/// several parts or none. `None` if the edge crosses itself too often.
fn offset(stroke: &Stroke, by_mm: f64, tolerance_mm: f64) -> Option<Vec<Stroke>> {
    let shape = Polygons::new(&[stroke.points[1..].to_vec()], FillRule::NonZero)?;
    let rings = shape.offset(by_mm, tolerance_mm).into_iter();
    Some(rings.map(Stroke::ring).collect())
}

/// Returns the part of a path between two distances along it, in mm.
pub(crate) fn along(points: &[Point], from_mm: f64, to_mm: f64) -> Vec<Point> {
    let (mut part, mut here_mm) = (Vec::new(), 0.0);
    for pair in points.windows(2) {
        let length_mm = pair[0].distance(pair[1]);
        let at = |mm: f64| pair[0].lerp(pair[1], ((mm - here_mm) / length_mm).clamp(0.0, 1.0));
        if length_mm > 0.0 && here_mm + length_mm > from_mm && here_mm < to_mm {
            if part.is_empty() {
                part.push(at(from_mm));
            }
            part.push(at(to_mm));
        }
        here_mm += length_mm;
    }
    part
}

fn unit(way: Vec2) -> Vec2 {
    way / way.length().max(f64::MIN_POSITIVE)
}

fn is_loop(stroke: &Stroke) -> bool {
    stroke.points.len() > 3 && stroke.points.first() == stroke.points.last()
}

/// The distance within which a point lies on a line.
const MEETS_MM: f64 = 0.02;
const SAME_MM: f64 = 1e-6;
/// The number of corners, and of points between them, that decide what a path lies in.
const SAMPLES: usize = 6;
/// The number of sides tried as a start if the lead-in has no room.
const MAX_BEGINNINGS: usize = 100;
/// The minimum length of a lead-in.
const MIN_LEAD_IN_MM: f64 = 0.05;

#[cfg(test)]
mod tests {
    use dobot_geometry::bounds;

    use super::*;
    use crate::strokes::shapes::tangle;

    fn square(x: f64, y: f64, side: f64) -> Stroke {
        let corners = [
            (x, y),
            (x + side, y),
            (x + side, y + side),
            (x, y + side),
            (x, y),
        ];
        Stroke {
            points: corners.map(Point::from).to_vec(),
            closed: true,
        }
    }

    /// Returns the signed area, positive for counterclockwise rings with x to the right and y up.
    fn area(ring: &[Point]) -> f64 {
        let ends = ring.windows(2);
        let first = bounds(ring.iter().copied()).origin();
        let part = |pair: &[Point]| Vec2::cross(pair[0] - first, pair[1] - first);
        ends.map(part).sum::<f64>() / 2.0
    }

    fn width(stroke: &Stroke) -> f64 {
        let width = bounds(stroke.points.iter().copied()).width();
        (width * 1e3).round() / 1e3
    }

    /// A part with two holes, an island in one of them, and a part beside it.
    fn nest() -> Vec<Stroke> {
        vec![
            square(0.0, 0.0, 60.0),
            square(5.0, 5.0, 20.0),
            square(35.0, 35.0, 20.0),
            square(10.0, 10.0, 8.0),
            square(70.0, 0.0, 10.0),
        ]
    }

    #[test]
    fn inner_shapes_come_before_outer_ones() {
        let groups = inner_first(nest(), &[]);
        let widths: Vec<Vec<f64>> = groups
            .iter()
            .map(|group| group.iter().map(width).collect())
            .collect();
        assert_eq!(widths, [vec![8.0], vec![20.0, 20.0], vec![60.0, 10.0]]);
        assert_eq!(inner_first(Vec::new(), &[]), Vec::<Vec<Stroke>>::new());
    }

    #[test]
    fn a_layer_inside_a_part_of_another_one_comes_before_it() {
        let part = vec![square(0.0, 0.0, 60.0)];
        let beside = vec![square(80.0, 0.0, 10.0)];
        let slit = vec![Stroke::open(vec![
            Point::new(5.0, 5.0),
            Point::new(9.0, 5.0),
        ])];
        let hole = vec![square(2.0, 2.0, 20.0), square(82.0, 2.0, 3.0)];
        let sorted = |layers: &[&Vec<Stroke>]| {
            let layers: Vec<Vec<&Stroke>> =
                layers.iter().map(|layer| layer.iter().collect()).collect();
            layers_inner_first(&layers)
        };
        assert_eq!(sorted(&[]), (vec![], 0));
        assert_eq!(sorted(&[&part, &beside]), (vec![0, 1], 0));
        assert_eq!(sorted(&[&part, &beside, &slit]), (vec![1, 2, 0], 0));
        assert_eq!(
            sorted(&[&part, &beside, &hole, &slit]),
            (vec![3, 2, 0, 1], 0)
        );
        // Each is inside the other: one of them must be first.
        let both = vec![square(0.0, 100.0, 60.0), square(5.0, 5.0, 3.0)];
        let other = vec![square(0.0, 0.0, 60.0), square(5.0, 105.0, 3.0)];
        assert_eq!(sorted(&[&both, &other]), (vec![0, 1], 1));
    }

    #[test]
    fn parts_grow_and_holes_shrink_by_the_width_of_the_beam() {
        let cutting = Cutting {
            kerf_mm: 0.2,
            ..Cutting::default()
        };
        let mut shapes = nest();
        shapes[1].points.reverse();
        let offset = cutting.offset(shapes, &[], 0.005);
        let widths: Vec<f64> = offset.strokes.iter().map(width).collect();
        assert_eq!(widths, [60.2, 19.8, 19.8, 8.2, 10.2]);
        assert_eq!(offset.vanished, 0);
        // A hole narrower than the beam vanishes.
        let offset = cutting.offset(
            vec![square(0.0, 0.0, 9.0), square(4.0, 4.0, 0.15)],
            &[],
            0.005,
        );
        assert_eq!((offset.strokes.len(), offset.vanished), (1, 1));
    }

    #[test]
    fn a_shape_that_crosses_itself_too_often_is_cut_as_it_is() {
        let cutting = Cutting {
            kerf_mm: 0.2,
            ..Cutting::default()
        };
        let shapes = vec![Stroke::ring(tangle()), square(100.0, 0.0, 20.0)];
        let offset = cutting.offset(shapes.clone(), &[], 0.005);
        assert_eq!((offset.vanished, offset.entangled), (0, 1));
        assert_eq!(offset.strokes[0], shapes[0]);
        assert_eq!(width(&offset.strokes[1]), 20.2);
    }

    /// Two squares of 10 mm, one to the upper right of the other, through their common corner.
    const EIGHT: [(f64, f64); 8] = [
        (0.0, 0.0),
        (10.0, 0.0),
        (10.0, 10.0),
        (0.0, 10.0),
        (0.0, -10.0),
        (-10.0, -10.0),
        (-10.0, 0.0),
        (0.0, 0.0),
    ];

    #[test]
    fn parts_that_touch_or_overlap_are_not_holes_in_each_other() {
        let cutting = Cutting {
            kerf_mm: 0.4,
            ..Cutting::default()
        };
        let grid = (0..12).map(|i| square(20.0 * f64::from(i % 4), 20.0 * f64::from(i / 4), 20.0));
        let overlapping = [square(100.0, 0.0, 20.0), square(110.0, 10.0, 20.0)];
        let above_the_middle = [square(200.0, 0.0, 40.0), square(210.0, 40.0, 20.0)];
        for (shapes, sizes) in [
            (grid.collect(), vec![20.4; 12]),
            (overlapping.to_vec(), vec![20.4; 2]),
            (above_the_middle.to_vec(), vec![40.4, 20.4]),
            // A hole that touches the edge is still a hole.
            (
                vec![square(0.0, 0.0, 40.0), square(0.0, 10.0, 10.0)],
                vec![40.4, 9.6],
            ),
        ] {
            let offset = cutting.offset(shapes, &[], 0.005);
            let widths: Vec<f64> = offset.strokes.iter().map(width).collect();
            assert_eq!(widths, sizes);
        }
    }

    #[test]
    fn all_parts_of_a_self_intersecting_shape_grow() {
        let twice = [&EIGHT[..], &EIGHT[1..]].concat();
        for points in [EIGHT.to_vec(), twice] {
            let shape = Stroke {
                points: points.into_iter().map(Point::from).collect(),
                closed: true,
            };
            let cutting = Cutting {
                kerf_mm: 0.2,
                ..Cutting::default()
            };
            let offset = cutting.offset(vec![shape], &[], 0.005);
            let areas: Vec<f64> = offset
                .strokes
                .iter()
                .map(|stroke| area(&stroke.points).abs())
                .collect();
            // Both meet in a corner and become one.
            assert_eq!((areas.len(), offset.vanished), (1, 0), "{areas:?}");
            assert!((areas[0] - 208.0).abs() < 0.1, "{areas:?}");
        }
    }

    #[test]
    fn a_cut_starts_in_the_waste_and_continues_over_its_start() {
        let cutting = Cutting {
            lead_in_mm: 2.0,
            overcut_mm: 1.0,
            ..Cutting::default()
        };
        let Cut { strokes: cut, .. } = cutting.finished(nest(), &[]);
        let first = |i: usize| (cut[i].points[0].x, cut[i].points[0].y);
        // Outside the part, inside the hole.
        let diagonal = 2.0_f64.sqrt();
        let near = |found: (f64, f64), mm: f64| (found.0 - mm).hypot(found.1 - mm) < 1e-9;
        assert!(near(first(0), -diagonal) && near(first(1), 5.0 + diagonal));
        assert_eq!(cut[0].points.last(), Some(&Point::new(1.0, 0.0)));
        assert!((cut[0].length_mm() - 243.0).abs() < 1e-9);
    }

    #[test]
    fn a_cut_starts_no_farther_away_than_the_waste_allows() {
        let cutting = Cutting {
            lead_in_mm: 4.0,
            ..Cutting::default()
        };
        // A hole of 3 mm, a part in a hole that is 1 mm wider on each side, and a hole that nearly
        // vanishes.
        let shapes = vec![
            square(0.0, 0.0, 60.0),
            square(5.0, 5.0, 3.0),
            square(20.0, 20.0, 12.0),
            square(21.0, 21.0, 10.0),
            square(40.0, 40.0, 0.03),
        ];
        let diagonal = 2.0_f64.sqrt();
        let begins = [
            (0, 4.0),
            (1, 1.5 * diagonal),
            (2, 0.5 * diagonal),
            (3, 0.5 * diagonal),
            (4, 0.0),
        ];
        let cut = cutting.finished(shapes.clone(), &[]);
        assert_eq!(cut.short_of_room, 4);
        for (i, mm) in begins {
            let begin = cut.strokes[i].points[0];
            let found_mm = begin.distance(shapes[i].points[0]);
            assert!((found_mm - mm).abs() < 1e-9, "{i}: {found_mm}");
        }
    }

    #[test]
    fn a_shape_that_touches_another_starts_at_a_side_next_to_waste() {
        let cutting = Cutting {
            lead_in_mm: 2.0,
            ..Cutting::default()
        };
        // Both begin on their common side.
        let shapes = [-10.0, 10.0].map(|x| {
            let begin = (0.0, 5.0);
            let corners = [begin, (0.0, 10.0), (x, 10.0), (x, 0.0), (0.0, 0.0)];
            Stroke::ring(corners.map(Point::from).to_vec())
        });
        let cut = cutting.finished(shapes.to_vec(), &[]);
        assert_eq!(cut.short_of_room, 0);
        for (stroke, whole) in cut.strokes.iter().zip(&shapes) {
            let [from, on] = [stroke.points[0], stroke.points[1]];
            assert!((from.distance(on) - 2.0).abs() < 1e-9, "{stroke:?}");
            assert!((stroke.length_mm() - whole.length_mm() - 2.0).abs() < 1e-9);
            assert!(
                shapes.iter().all(|shape| !is_in(&shape.points, from)),
                "{from:?}"
            );
        }
    }

    #[test]
    fn each_cut_between_tabs_starts_in_the_waste() {
        let cutting = Cutting {
            lead_in_mm: 2.0,
            overcut_mm: 1.0,
            tabs: 2,
            tab_mm: 1.0,
            ..Cutting::default()
        };
        let cut = cutting.finished(vec![square(0.0, 0.0, 60.0), square(20.0, 20.0, 20.0)], &[]);
        let begins: Vec<Point> = cut.strokes.iter().map(|stroke| stroke.points[0]).collect();
        let (part, hole) = ([0.0, 60.0], [20.0, 40.0]);
        let is_within = |p: &Point, [low, high]: [f64; 2]| {
            (low..=high).contains(&p.x) && (low..=high).contains(&p.y)
        };
        assert_eq!(cut.strokes.len(), 4);
        assert!(
            begins[..2].iter().all(|p| !is_within(p, part)),
            "{begins:?}"
        );
        assert!(begins[2..].iter().all(|p| is_within(p, hole)), "{begins:?}");
        for (piece, mm) in cut.strokes.iter().zip([121.0, 121.0, 41.0, 41.0]) {
            assert!((piece.length_mm() - mm).abs() < 1e-9, "{piece:?}");
        }
        // The beam removes half of its width from each side of a tab.
        let kerf = Cutting {
            kerf_mm: 0.4,
            ..cutting
        };
        let cut = kerf.finished(vec![square(0.0, 0.0, 60.0)], &[]);
        assert!((cut.strokes[0].length_mm() - 2.0 - 118.6).abs() < 1e-9);
    }

    #[test]
    fn the_cut_of_a_self_intersecting_shape_starts_outside_of_it() {
        let mut points = EIGHT.map(Point::from).to_vec();
        let cutting = Cutting {
            lead_in_mm: 3.0,
            ..Cutting::default()
        };
        for begin in 0..points.len() - 1 {
            let shape = Stroke {
                points: points.clone(),
                closed: true,
            };
            let cut = cutting.finished(vec![shape], &[]);
            let at = cut.strokes[0].points[0];
            let is_in = |low: f64| (at.x - low).abs() < 4.9 && (at.y - low).abs() < 4.9;
            assert!(!is_in(5.0) && !is_in(-5.0), "{begin}: {at:?}");
            points.remove(0);
            points.push(points[0]);
        }
    }

    #[test]
    fn tabs_stay_uncut_and_are_evenly_spaced() {
        let cutting = Cutting {
            tabs: 4,
            tab_mm: 1.0,
            ..Cutting::default()
        };
        let line = Stroke::open(vec![Point::ORIGIN, Point::new(9.0, 0.0)]);
        let Cut {
            strokes: cut,
            too_small,
            ..
        } = cutting.finished(
            vec![square(0.0, 0.0, 20.0), square(5.0, 5.0, 2.0), line],
            &[],
        );
        assert_eq!((cut.len(), too_small), (6, 1));
        for piece in &cut[..4] {
            assert!((piece.length_mm() - 19.0).abs() < 1e-9, "{piece:?}");
        }
        // The middle of each side is a tab.
        let middle = Point::new(10.0, 0.0);
        let near = cut[..4]
            .iter()
            .flat_map(Stroke::segments)
            .flat_map(|(a, b)| [a, b]);
        let nearest = near.map(|p| p.distance(middle)).fold(f64::MAX, f64::min);
        assert!((nearest - 0.5).abs() < 1e-9, "{nearest}");
    }
}
