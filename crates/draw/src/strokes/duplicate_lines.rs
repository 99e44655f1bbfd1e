//! Removal of duplicate lines.

use std::collections::HashSet;

use dobot_geometry::{Point, Rect, SegmentIndex, Stroke};

use crate::strokes::cutting::along;

/// Strokes without duplicate lines, and statistics of the removal.
#[derive(Debug, PartialEq)]
pub(crate) struct Deduplicated {
    pub strokes: Vec<Stroke>,
    /// The number of removed lines or parts of lines.
    pub duplicates: usize,
    /// The number of lines that were not compared, because there are too many.
    pub unknown: usize,
}

/// Removes lines that lie on another stroke, in either direction; the longer one remains. If shapes
/// must stay whole, only strokes that are duplicates from end to end are removed.
pub(crate) fn without_duplicates(strokes: Vec<Stroke>, stay_whole: bool) -> Deduplicated {
    let before = strokes.len();
    let mut seen = HashSet::new();
    let mut strokes = strokes;
    strokes.retain(|stroke| seen.insert(edges(&stroke.points)));
    let (mut duplicates, mut unknown) = (before - strokes.len(), 0);
    let mut drawn = Drawn::new(&strokes);
    let mut by_length: Vec<usize> = (0..strokes.len()).collect();
    by_length.sort_by(|&a, &b| drawn.length_mm[a].total_cmp(&drawn.length_mm[b]));
    let mut left: Vec<Option<Vec<Stroke>>> = vec![None; strokes.len()];
    for stroke in by_length {
        let Some(spans) = drawn.duplicates(stroke, stay_whole) else {
            unknown += 1;
            continue;
        };
        if !spans.is_empty() {
            duplicates += spans.len();
            drawn.remove(stroke, &spans);
            left[stroke] = Some(beside(&strokes[stroke], &spans, drawn.length_mm[stroke]));
        }
    }
    let all = strokes
        .into_iter()
        .zip(left)
        .flat_map(|(stroke, left)| left.unwrap_or_else(|| vec![stroke]));
    Deduplicated {
        strokes: all.collect(),
        duplicates,
        unknown,
    }
}

/// Returns the edges in a canonical order, which is equal for a line in both directions and for a
/// ring with any start.
fn edges(points: &[Point]) -> Vec<[[i64; 2]; 2]> {
    #[expect(clippy::cast_possible_truncation, reason = "on a table")]
    let rounded = |mm: f64| (mm / SAME_MM).round() as i64;
    let corner = |p: &Point| [rounded(p.x), rounded(p.y)];
    let pairs = points
        .windows(2)
        .map(|pair| [corner(&pair[0]), corner(&pair[1])]);
    let mut edges: Vec<_> = if let [dot] = points {
        vec![[corner(dot); 2]]
    } else {
        pairs.collect()
    };
    for edge in &mut edges {
        edge.sort_unstable();
    }
    edges.sort_unstable();
    edges
}

/// Returns the parts of a stroke outside these spans of its length.
fn beside(stroke: &Stroke, spans: &[(f64, f64)], length_mm: f64) -> Vec<Stroke> {
    let ends = spans.iter().map(|span| span.1);
    let begins = spans.iter().map(|span| span.0);
    let gaps = [0.0].into_iter().chain(ends);
    let gaps = gaps.zip(begins.chain([length_mm]));
    let gaps: Vec<(f64, f64)> = gaps.filter(|(from, to)| to > from).collect();
    let part = |&(from, to): &(f64, f64)| along(&stroke.points, from, to);
    let mut parts: Vec<Vec<Point>> = gaps.iter().map(part).collect();
    let goes_around = stroke.points.first() == stroke.points.last()
        && gaps.len() > 1
        && gaps[0].0 == 0.0
        && gaps[gaps.len() - 1].1 == length_mm;
    if goes_around && let Some(mut last) = parts.pop() {
        last.extend(parts[0].drain(..).skip(1));
        parts[0] = last;
    }
    parts.into_iter().map(Stroke::open).collect()
}

/// A spatial index of the strokes in short pieces.
#[derive(Debug)]
struct Drawn {
    index: SegmentIndex,
    /// The stroke of each piece, and the distance along it at which the piece begins, in mm.
    pieces: Vec<(usize, f64)>,
    /// The first piece of each stroke, followed by the total number of pieces.
    first: Vec<u32>,
    length_mm: Vec<f64>,
    /// The remaining budget of comparisons.
    looks_left: usize,
}

impl Drawn {
    fn new(strokes: &[Stroke]) -> Self {
        let (mut pieces, mut segments) = (Vec::new(), Vec::new());
        let (mut first, mut length_mm) = (vec![0], Vec::new());
        for (number, stroke) in strokes.iter().enumerate() {
            let mut here_mm = 0.0;
            for (a, b) in stroke.segments() {
                let whole_mm = a.distance(b);
                let count = (whole_mm / PIECE_MM).ceil().max(1.0);
                let mut from = 0.0;
                while from < count && whole_mm > 0.0 {
                    let [begin, end] = [from, from + 1.0].map(|share| a.lerp(b, share / count));
                    pieces.push((number, here_mm + whole_mm * from / count));
                    segments.push((begin, end));
                    from += 1.0;
                }
                here_mm += whole_mm;
            }
            length_mm.push(here_mm);
            first.push(u32::try_from(segments.len()).expect("no more than an index holds"));
        }
        Self {
            index: SegmentIndex::new(segments),
            pieces,
            first,
            length_mm,
            looks_left: MAX_LOOKS,
        }
    }

    /// Returns the spans of a stroke's length that need not be drawn; `None` if the budget is used
    /// up.
    fn duplicates(&mut self, stroke: usize, stay_whole: bool) -> Option<Vec<(f64, f64)>> {
        let mut spans = self.covered(stroke)?;
        let length_mm = self.length_mm[stroke];
        let is_whole = matches!(spans[..], [(from, to)] if from == 0.0 && to == length_mm);
        if !is_whole {
            spans.retain(|&(from, to)| !stay_whole && to - from >= MIN_MM);
        }
        Some(spans)
    }

    /// Returns the spans of a stroke's length that lie on others; `None` if the budget is used up.
    fn covered(&mut self, stroke: usize) -> Option<Vec<(f64, f64)>> {
        let mut spans = Vec::new();
        for piece in self.first[stroke]..self.first[stroke + 1] {
            let (a, b) = self.index.segment(piece);
            let from_mm = self.pieces[piece as usize].1;
            let around = Rect::from_points(a, b).inflate(SAME_MM, SAME_MM);
            let mut here = Vec::new();
            let looks = self.index.touching(around, &mut |other| {
                if self.pieces[other as usize].0 != stroke {
                    here.extend(on((a, b), self.index.segment(other)));
                }
            });
            self.looks_left = self.looks_left.checked_sub(looks)?;
            let here = joined(here, a.distance(b));
            spans.extend(here.iter().map(|span| (from_mm + span.0, from_mm + span.1)));
        }
        Some(joined(spans, self.length_mm[stroke]))
    }

    /// Removes spans of a stroke from later comparisons, including pieces of which only a part is
    /// inside.
    fn remove(&mut self, stroke: usize, spans: &[(f64, f64)]) {
        for piece in self.first[stroke]..self.first[stroke + 1] {
            let (a, b) = self.index.segment(piece);
            let from_mm = self.pieces[piece as usize].1;
            let to_mm = from_mm + a.distance(b);
            if spans.iter().any(|span| span.0 < to_mm && from_mm < span.1) {
                self.index.remove(piece);
            }
        }
    }
}

/// Returns the span of a line along which another one lies, in mm, if it stays on the line
/// throughout.
fn on((a, b): (Point, Point), (c, d): (Point, Point)) -> Option<(f64, f64)> {
    let length_mm = a.distance(b);
    let along = (b - a) / length_mm;
    let [c, d] = [c, d].map(|p| ((p - a).dot(along), (p - a).cross(along)));
    let (near, far) = if c.0 < d.0 { (c, d) } else { (d, c) };
    let (from, to) = (near.0.max(0.0), far.0.min(length_mm));
    if from >= to {
        return None;
    }
    let slope = (far.1 - near.1) / (far.0 - near.0);
    let is_near = |mm: f64| (near.1 + (mm - near.0) * slope).abs() <= SAME_MM;
    (slope.abs() <= MAX_SLOPE && is_near(from) && is_near(to)).then_some((from, to))
}

/// Sorts spans and joins those with negligible gaps, including the gaps to both ends.
fn joined(mut spans: Vec<(f64, f64)>, length_mm: f64) -> Vec<(f64, f64)> {
    spans.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut joined: Vec<(f64, f64)> = Vec::new();
    for (from, to) in spans {
        let from = if from < NO_GAP_MM { 0.0 } else { from };
        let to = if to > length_mm - NO_GAP_MM {
            length_mm
        } else {
            to
        };
        match joined.last_mut() {
            Some(last) if from < last.1 + NO_GAP_MM => last.1 = last.1.max(to),
            _ => joined.push((from, to)),
        }
    }
    joined
}

/// The distance below which lines look like one; narrower than any pen or beam.
const SAME_MM: f64 = 0.05;
/// The gap between two spans in which no line remains.
const NO_GAP_MM: f64 = 2.0 * SAME_MM;
/// The slope up to which pieces may belong to the same curve with different points.
const MAX_SLOPE: f64 = 1.0;
/// Shorter spans, as at a crossing, remain.
const MIN_MM: f64 = 1.0;
/// The budget of comparisons: a second or two. Unit tests, which are not optimised, have less.
const MAX_LOOKS: usize = if cfg!(test) { 2_000_000 } else { 50_000_000 };
/// The length of the pieces into which long lines are divided, because they may cross many others.
const PIECE_MM: f64 = 4.0;

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the remaining strokes and the number of removed lines.
    fn without_duplicates(strokes: Vec<Stroke>, stay_whole: bool) -> (Vec<Stroke>, usize) {
        let found = super::without_duplicates(strokes, stay_whole);
        assert_eq!(found.unknown, 0);
        (found.strokes, found.duplicates)
    }

    fn line(points: &[(f64, f64)]) -> Stroke {
        Stroke::open(points.iter().map(|&p| Point::from(p)).collect())
    }

    fn square(x: f64, side: f64) -> Stroke {
        let corners = [(x, 0.0), (x + side, 0.0), (x + side, side), (x, side)];
        Stroke {
            closed: true,
            ..line(&[&corners[..], &corners[..1]].concat())
        }
    }

    fn length_mm(strokes: &[Stroke]) -> f64 {
        strokes.iter().map(Stroke::length_mm).sum()
    }

    #[test]
    fn a_line_on_top_of_another_is_dropped_in_either_direction() {
        let square = [(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0), (0.0, 0.0)];
        let from_elsewhere = [(9.0, 9.0), (9.0, 0.0), (0.0, 0.0), (0.0, 9.0), (9.0, 9.0)];
        let strokes = vec![
            line(&[(0.0, 0.0), (5.0, 5.0)]),
            line(&[(5.001, 5.0), (0.0, 0.001)]),
            line(&square),
            line(&from_elsewhere),
            line(&[(0.0, 0.0), (5.0, 5.2)]),
            line(&[(3.0, 1.0)]),
            line(&[(3.0, 1.0)]),
        ];
        for stay_whole in [false, true] {
            let (kept, count) = without_duplicates(strokes.clone(), stay_whole);
            assert_eq!(count, 3);
            let left = [0, 2, 4, 5].map(|i: usize| strokes[i].clone());
            assert!((length_mm(&kept) - length_mm(&left)).abs() < 0.02);
            assert_eq!(kept.len(), 4);
        }
    }

    #[test]
    fn lines_with_the_same_corners_but_other_paths_are_not_duplicates() {
        let bow_tie = line(&[
            (0.0, 0.0),
            (20.0, 20.0),
            (20.0, 0.0),
            (0.0, 20.0),
            (0.0, 0.0),
        ]);
        let open = line(&[(0.0, 0.0), (0.0, 20.0), (20.0, 20.0), (20.0, 0.0)]);
        // The open stroke lies completely on the square, in either order.
        for strokes in [
            vec![open.clone(), square(0.0, 20.0)],
            vec![square(0.0, 20.0), open],
        ] {
            assert_eq!(
                without_duplicates(strokes, true),
                (vec![square(0.0, 20.0)], 1)
            );
        }
        let both = vec![square(0.0, 20.0), bow_tie];
        assert_eq!(without_duplicates(both.clone(), true), (both.clone(), 0));
        // Both of its sides lie on the square, its diagonals do not.
        let (kept, count) = without_duplicates(both, false);
        let diagonals_mm = 2.0 * 20.0 * 2.0_f64.sqrt();
        assert_eq!(count, 2);
        assert!(
            (length_mm(&kept) - 80.0 - diagonals_mm).abs() < 0.5,
            "{kept:?}"
        );
    }

    #[test]
    fn a_part_of_a_line_and_a_shared_edge_of_two_shapes_are_dropped() {
        let long = line(&[(0.0, 0.0), (40.0, 0.0)]);
        let short = line(&[(20.0, 0.01), (10.0, 0.0)]);
        assert_eq!(
            without_duplicates(vec![short, long.clone()], true),
            (vec![long.clone()], 1)
        );
        let overlapping = line(&[(30.0, 0.0), (60.0, 0.0)]);
        let (kept, count) = without_duplicates(vec![long, overlapping], false);
        assert_eq!(count, 1);
        assert!((length_mm(&kept) - 60.0).abs() < 0.01, "{kept:?}");
        let (kept, count) = without_duplicates(vec![square(0.0, 20.0), square(20.0, 20.0)], false);
        assert_eq!((kept.len(), count), (2, 1));
        assert!((length_mm(&kept) - 140.0).abs() < 0.5, "{kept:?}");
    }

    #[test]
    fn a_circle_of_other_points_is_a_duplicate_and_crossing_lines_are_not() {
        let circle = |count: u32| {
            let at = |i: u32| f64::from(i % count) * std::f64::consts::TAU / f64::from(count);
            let points = (0..=count).map(|i| (9.0 * at(i).cos(), 9.0 * at(i).sin()));
            line(&points.collect::<Vec<_>>())
        };
        let (kept, count) = without_duplicates(vec![circle(100), circle(173)], true);
        assert_eq!((kept.len(), count), (1, 1));
        let star: Vec<Stroke> = (0..18)
            .map(|i| {
                let (sin, cos) = (f64::from(i) * std::f64::consts::PI / 18.0).sin_cos();
                line(&[(-30.0 * cos, -30.0 * sin), (30.0 * cos, 30.0 * sin)])
            })
            .collect();
        assert_eq!(without_duplicates(star.clone(), false), (star, 0));
    }

    #[test]
    fn the_common_part_of_two_arcs_is_drawn_once_and_in_one_piece() {
        for (radius, points) in [(5.0, 60), (50.0, 200)] {
            let arc = |from: f64, count: u32| {
                let at = |i: u32| from + 1.5 * f64::from(i) / f64::from(count);
                let points = (0..=count).map(|i| (radius * at(i).cos(), radius * at(i).sin()));
                line(&points.collect::<Vec<_>>())
            };
            let (kept, _) = without_duplicates(vec![arc(0.0, points), arc(0.7, points + 7)], false);
            let wanted_mm = 2.2 * radius;
            assert!(
                (length_mm(&kept) - wanted_mm).abs() < 0.3,
                "{}",
                length_mm(&kept)
            );
            assert_eq!(kept.len(), 2);
        }
    }

    #[test]
    fn lines_skipped_by_the_comparison_of_very_many_overlapping_ones_are_reported() {
        let mut random = dobot_geometry::Random::new(1);
        let strokes: Vec<Stroke> = (0..600)
            .map(|_| {
                line(&[
                    (9.0 * random.share(), 0.0),
                    (90.0 + 9.0 * random.share(), 0.0),
                ])
            })
            .collect();
        let found = super::without_duplicates(strokes, false);
        assert!(found.unknown > 0 && found.duplicates > 0);
        assert_eq!(found.strokes.len(), 600 - found.duplicates);
    }
}
