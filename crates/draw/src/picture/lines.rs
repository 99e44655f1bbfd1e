//! The lines of a picture: sorted by what they are, and grouped, so that large drawings stay small.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use dobot_geometry::{Line, ParamCurveNearest, Point, Rect, Stroke};

use crate::ink::InkLine;

/// X up, Y to the left.
pub(super) fn on_picture(p: Point) -> Point {
    Point::new(-p.y, -p.x)
}

pub(super) fn area_on_picture(area: Rect) -> Rect {
    Rect::new(-area.y1, -area.x1, -area.y0, -area.x0)
}

/// A group of lines in one style.
pub(super) fn group<'a>(style: &str, lines: impl IntoIterator<Item = &'a [Point]>) -> String {
    let mut paths = Paths::default();
    lines.into_iter().for_each(|line| paths.add(line));
    format!("<g {style}>\n{}</g>\n", paths.finish())
}

/// The ink in pieces of one class each: where the class changes, one piece ends and another begins.
pub(super) fn by_class(
    ink: &[InkLine],
    class: impl Fn(&InkLine, usize) -> usize,
) -> BTreeMap<usize, Vec<Vec<Point>>> {
    let mut pieces: BTreeMap<usize, Vec<Vec<Point>>> = BTreeMap::new();
    for line in ink {
        let points = &line.stroke.points;
        // A piece between two places is as bad as the worse of them.
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

pub(super) fn points(strokes: &[Stroke]) -> impl Iterator<Item = &[Point]> {
    strokes.iter().map(|it| it.points.as_slice())
}

/// The line without the points that are hardly off the straight way.
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

/// Path elements, each with so many points that they are drawn fast.
#[derive(Default)]
struct Paths {
    text: String,
    points: usize,
}

impl Paths {
    fn add(&mut self, line: &[Point]) {
        if self.points == 0 {
            self.text += "<path d=\"";
        }
        for (i, p) in line.iter().map(|p| on_picture(*p)).enumerate() {
            let letter = if i == 0 { 'M' } else { 'L' };
            write!(self.text, "{letter}{} {}", Short(p.x), Short(p.y))
                .expect("writing to a string works");
        }
        if line.len() == 1 {
            // A dot is a line of no length with round ends.
            self.text += "h.001";
        }
        self.points += line.len();
        if self.points >= POINTS_A_PATH {
            self.close();
        }
    }

    fn close(&mut self) {
        if self.points > 0 {
            self.text += "\"/>\n";
        }
        self.points = 0;
    }

    fn finish(mut self) -> String {
        self.close();
        self.text
    }
}

/// A number to a hundredth, without the zeros at its end.
struct Short(f64);

impl std::fmt::Display for Short {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}", (self.0 * 100.0).round() / 100.0 + 0.0)
    }
}

const LOOK_AHEAD: usize = 64;
const STRAIGHT_MM: f64 = 0.015;
const POINTS_A_PATH: usize = 1000;

#[cfg(test)]
mod tests {
    use super::*;

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
            .flat_map(|(class, pieces)| pieces.into_iter().map(move |it| (class, it)))
            .map(|(class, piece)| (class, piece.iter().map(|p| p.x).collect()))
            .collect()
    }

    #[test]
    fn a_line_is_cut_where_its_class_changes_and_nothing_of_it_is_lost() {
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
        let dot = [Point::new(1.0, 2.0)];
        let text = group("", [&dot[..]]);
        assert_eq!(text, "<g >\n<path d=\"M-2 -1h.001\"/>\n</g>\n");
    }

    #[test]
    fn many_short_lines_share_a_path() {
        let line = [Point::new(1.0, 2.0), Point::new(3.0, 4.0)];
        let text = group("", (0..1500).map(|_| &line[..]));
        assert_eq!(text.matches("<path").count(), 3);
        assert_eq!(text.matches('M').count(), 1500);
    }
}
