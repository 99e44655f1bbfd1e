//! The lines of a picture, by kind.

use std::collections::BTreeMap;

use dobot_geometry::{Line, ParamCurveNearest, Point, Rect};

use crate::output::ink::InkLine;

/// Converts a point to the picture: X up, Y to the left.
pub(super) fn on_picture(p: Point) -> Point {
    Point::new(-p.y, -p.x)
}

pub(super) fn area_on_picture(area: Rect) -> Rect {
    Rect::new(-area.y1, -area.x1, -area.y0, -area.x0)
}

/// Returns the points of a line on the picture.
pub(super) fn seen(line: &[Point]) -> impl Iterator<Item = [f64; 2]> {
    line.iter().map(|p| [-p.y, -p.x])
}

/// Splits the ink into pieces of one class each.
pub(super) fn by_class(
    ink: &[InkLine],
    class: impl Fn(&InkLine, usize) -> usize,
) -> BTreeMap<usize, Vec<Vec<Point>>> {
    let mut pieces: BTreeMap<usize, Vec<Vec<Point>>> = BTreeMap::new();
    for line in ink {
        let points = &line.stroke.points;
        // The worse end determines the class of a piece.
        let of = |i: usize| class(line, i).max(class(line, (i + 1).min(points.len() - 1)));
        let mut from = 0;
        while from < points.len() {
            let same = (from..points.len() - 1).take_while(|&i| of(i) == of(from));
            let to = same.last().map_or(from, |last| last + 1);
            let piece = straightened(&points[from..=to]);
            pieces.entry(of(from)).or_default().push(piece);
            from = if to + 1 >= points.len() {
                points.len()
            } else {
                to
            };
        }
    }
    pieces
}

/// Removes points that barely deviate from a straight line.
fn straightened(points: &[Point]) -> Vec<Point> {
    let mut kept: Vec<Point> = points.first().copied().into_iter().collect();
    let mut here = 0;
    while here + 1 < points.len() {
        let most = (here + LOOK_AHEAD).min(points.len() - 1);
        let mut next = here + 1;
        while next < most && is_straight(&points[here..=next + 1]) {
            next += 1;
        }
        kept.push(points[next]);
        here = next;
    }
    kept
}

fn is_straight(way: &[Point]) -> bool {
    let (from, to) = (way[0], way[way.len() - 1]);
    let chord = Line::new(from, to);
    let off = |p: &Point| chord.nearest(*p, 0.0).distance_sq;
    way.iter().all(|p| off(p) <= STRAIGHT_MM * STRAIGHT_MM)
}

const LOOK_AHEAD: usize = 64;
const STRAIGHT_MM: f64 = 0.015;

#[cfg(test)]
mod tests {
    use super::*;
    use dobot_geometry::Stroke;

    fn ink(errors_mm: &[f64]) -> InkLine {
        let x = (0..).map(f64::from);
        let points = x.zip(errors_mm).map(|(x, &error)| Point::new(x, error));
        InkLine {
            stroke: Stroke::open(points.collect()),
            errors_mm: errors_mm.to_vec(),
            pass: 0,
        }
    }

    fn pieces(errors_mm: &[f64]) -> Vec<(usize, Vec<f64>)> {
        let class = |line: &InkLine, i: usize| usize::from(line.errors_mm[i] > 0.5);
        by_class(&[ink(errors_mm)], class)
            .into_iter()
            .flat_map(|(class, pieces)| pieces.into_iter().map(move |piece| (class, piece)))
            .map(|(class, piece)| (class, piece.iter().map(|p| p.x).collect()))
            .collect()
    }

    #[test]
    fn a_line_is_cut_where_its_class_changes_and_no_part_is_lost() {
        let pieces = pieces(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
        assert_eq!(
            pieces,
            [
                (0, vec![0.0, 2.0]),
                (0, vec![4.0, 5.0]),
                (1, vec![2.0, 3.0, 4.0])
            ]
        );
    }

    #[test]
    fn a_dot_stays_a_dot() {
        assert_eq!(pieces(&[1.0]), [(1, vec![0.0])]);
    }
}
