//! Joining of hatch lines to back-and-forth strokes.

use dobot_geometry::{CancelToken, Cancelled, Point, Rect, SegmentIndex, Stroke};

use super::scan::Span;

/// Returns the visible parts of the lines as separate strokes.
pub(super) fn each(spans: &[Span]) -> Vec<Stroke> {
    let drawn = spans.iter().filter(|span| span.line % 2 == 0);
    drawn
        .map(|span| Stroke::open(ends(*span, false).to_vec()))
        .collect()
}

/// Builds strokes line by line.
#[derive(Debug)]
pub(super) struct Joined<'a> {
    spans: &'a [Span],
    edges: SegmentIndex,
    longest_mm: f64,
    strokes: Vec<Stroke>,
    /// The strokes that end on the last line.
    open: Vec<OpenEnd>,
}

/// The end of a stroke that may continue.
#[derive(Clone, Copy, Debug)]
struct OpenEnd {
    stroke: usize,
    /// Whether it is the right end of its line.
    right: bool,
}

impl<'a> Joined<'a> {
    pub(super) fn new(spans: &'a [Span], edges: Vec<(Point, Point)>, spacing_mm: f64) -> Self {
        Self {
            spans,
            edges: SegmentIndex::new(edges),
            longest_mm: JOIN_SPACINGS * spacing_mm,
            strokes: Vec::new(),
            open: Vec::new(),
        }
    }

    pub(super) fn strokes(mut self, cancel: &CancelToken) -> Result<Vec<Stroke>, Cancelled> {
        let (mut before, mut between): (i64, &[Span]) = (0, &[]);
        for line in self.spans.chunk_by(|a, b| a.line == b.line) {
            cancel.check()?;
            if line[0].line % 2 != 0 {
                between = line;
                continue;
            }
            if before + 2 != line[0].line {
                self.open.clear();
            }
            let halfway = between.first().is_some_and(|span| span.line == before + 1);
            self.draw(line, if halfway { between } else { &[] });
            before = line[0].line;
        }
        Ok(self.strokes)
    }

    /// Adds a line: continues strokes that end near its parts, and begins others.
    fn draw(&mut self, line: &[Span], between: &[Span]) {
        let mut drawn = vec![false; line.len()];
        let mut open = Vec::with_capacity(line.len());
        for end in std::mem::take(&mut self.open) {
            let Some(next) = self.next(end, line, between, &drawn) else {
                continue;
            };
            drawn[next] = true;
            let points = &mut self.strokes[end.stroke].points;
            points.extend(ends(line[next], end.right));
            open.push(OpenEnd {
                right: !end.right,
                ..end
            });
        }
        for (span, _) in line.iter().zip(drawn).filter(|(_, drawn)| !drawn) {
            open.push(OpenEnd {
                stroke: self.strokes.len(),
                right: true,
            });
            self.strokes.push(Stroke::open(ends(*span, false).to_vec()));
        }
        self.open = open;
    }

    /// Returns the part of the line with which a stroke can continue: the one whose end on the same
    /// side is closest, if the connection is short and inside.
    fn next(&self, end: OpenEnd, line: &[Span], between: &[Span], drawn: &[bool]) -> Option<usize> {
        let here = self.strokes[end.stroke].last()?;
        let side = |span: &Span| if end.right { span.to } else { span.from };
        let first = line.partition_point(|span| side(span) < here.x - self.longest_mm);
        let near = (first..line.len()).take_while(|&i| side(&line[i]) <= here.x + self.longest_mm);
        let next = near.min_by(|&i, &j| {
            let off = |i: usize| (side(&line[i]) - here.x).abs();
            off(i).total_cmp(&off(j))
        })?;
        let there = ends(line[next], end.right)[0];
        (!drawn[next] && self.inside(here, there, between)).then_some(next)
    }

    fn inside(&self, from: Point, to: Point, between: &[Span]) -> bool {
        let middle = from.lerp(to, 0.5).x;
        let span = between.partition_point(|span| span.to < middle - TOUCH_MM);
        let fine = between
            .get(span)
            .is_some_and(|span| span.from <= middle + TOUCH_MM)
            && from.distance(to) <= self.longest_mm;
        let mut met = false;
        if fine {
            self.edges
                .touching(Rect::from_points(from, to), &mut |edge| {
                    met |= meets((from, to), self.edges.segment(edge));
                });
        }
        fine && !met
    }
}

/// Returns the ends of a part of a line, in drawing order.
const fn ends(span: Span, from_right: bool) -> [Point; 2] {
    let (left, right) = (Point::new(span.from, span.y), Point::new(span.to, span.y));
    if from_right {
        [right, left]
    } else {
        [left, right]
    }
}

/// Whether a path meets an edge between its ends, including the edge's own ends.
fn meets(way: (Point, Point), edge: (Point, Point)) -> bool {
    let [from, to] = sides(edge, way);
    let [one, other] = sides(way, edge);
    from * to < 0 && one != other
}

/// Returns the sides of a segment's line on which the ends of another lie; 0 if on the line.
fn sides((a, b): (Point, Point), (p, q): (Point, Point)) -> [i8; 2] {
    let along = b - a;
    let touch = TOUCH_MM * along.length();
    [p, q].map(|p| match along.cross(p - a) {
        off if off > touch => 1,
        off if off < -touch => -1,
        _ => 0,
    })
}

/// The maximum length of a connection to the next line, in spacings.
const JOIN_SPACINGS: f64 = 3.0;
const TOUCH_MM: f64 = 1e-9;
