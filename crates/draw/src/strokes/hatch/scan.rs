//! Intersection of parallel lines with the inside of rings.

use dobot_geometry::{CancelToken, FillRule, Point};

use super::HatchError;

/// Rings intersected with lines along x. The lines to draw have even numbers; the odd ones halfway
/// between decide whether a connection is inside.
#[derive(Debug)]
pub(super) struct Scan {
    /// The edges of all rings.
    pub(super) edges: Vec<(Point, Point)>,
    /// The rule for the inside.
    pub(super) rule: FillRule,
    /// The spacing of the lines to draw.
    pub(super) spacing_mm: f64,
    /// The distance of the lines from the edges.
    pub(super) inset_mm: f64,
}

/// A part of a line that lies inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Span {
    /// Even for a line to draw.
    pub(super) line: i64,
    pub(super) y: f64,
    pub(super) from: f64,
    pub(super) to: f64,
}

impl Scan {
    /// Returns the parts inside, by line and from left to right.
    pub(super) fn spans(&self, cancel: &CancelToken) -> Result<Vec<Span>, HatchError> {
        self.check_count()?;
        let mut events = Vec::new();
        for &edge in &self.edges {
            cancel.check()?;
            self.cross(edge, &mut events);
            if self.inset_mm > 0.0 {
                self.block(edge, &mut events);
            }
        }
        events.sort_unstable_by(|a, b| a.line.cmp(&b.line).then(a.x.total_cmp(&b.x)));
        let lines = events.chunk_by(|a, b| a.line == b.line);
        let mut spans = Vec::new();
        for line in lines {
            cancel.check()?;
            self.sweep(line, &mut spans);
        }
        Ok(spans)
    }

    fn check_count(&self) -> Result<(), HatchError> {
        let high = |(a, b): &(Point, Point)| (a.y - b.y).abs() + 4.0 * self.inset_mm;
        let crossings = self.edges.iter().map(high).sum::<f64>() / self.spacing_mm;
        if crossings <= f64::from(MAX_CROSSINGS) {
            return Ok(());
        }
        let most = MAX_CROSSINGS;
        Err(HatchError::TooMany { crossings, most })
    }

    /// Returns the first line at or above a height. Edges own the lines from their lower end up to,
    /// but excluding, their upper one, so that rings are tight at their corners.
    #[expect(clippy::cast_possible_truncation, reason = "few lines, as was checked")]
    fn first_line(&self, y: f64) -> i64 {
        (2.0 * y / self.spacing_mm).ceil() as i64 - 1
    }

    #[expect(clippy::cast_precision_loss, reason = "few lines, as was checked")]
    fn height(&self, line: i64) -> f64 {
        (line + 1) as f64 * self.spacing_mm / 2.0
    }

    /// Adds the crossings of lines with an edge.
    fn cross(&self, (a, b): (Point, Point), events: &mut Vec<Event>) {
        let (low, high, winding) = if a.y < b.y { (a, b, 1) } else { (b, a, -1) };
        for line in self.first_line(low.y)..self.first_line(high.y) {
            let share = (self.height(line) - low.y) / (high.y - low.y);
            events.push(Event {
                line,
                x: low.lerp(high, share.clamp(0.0, 1.0)).x,
                winding,
                blocked: 0,
            });
        }
    }

    /// Adds the parts of lines that are too close to an edge.
    fn block(&self, (a, b): (Point, Point), events: &mut Vec<Event>) {
        let (low, high) = (a.y.min(b.y) - self.inset_mm, a.y.max(b.y) + self.inset_mm);
        for line in self.first_line(low)..self.first_line(high) {
            if let Some((from, to)) = self.near((a, b), self.height(line)) {
                for (x, blocked) in [(from, 1), (to, -1)] {
                    events.push(Event {
                        line,
                        x,
                        winding: 0,
                        blocked,
                    });
                }
            }
        }
    }

    /// Returns the part of the line at height `y` that is closer to an edge than the inset: its
    /// intersection with discs around the ends and the rectangle between them.
    fn near(&self, (a, b): (Point, Point), y: f64) -> Option<(f64, f64)> {
        let discs = [a, b].into_iter().filter_map(|p| {
            let half2 = self.inset_mm * self.inset_mm - (y - p.y) * (y - p.y);
            (half2 > 0.0).then(|| [p.x - half2.sqrt(), p.x + half2.sqrt()])
        });
        let along = b - a;
        let length = along.length();
        let off = along.turn_90() * (self.inset_mm / length);
        let corners = [a + off, b + off, b - off, a - off];
        let sides = (0..4).map(|i| (corners[i], corners[(i + 1) % 4]));
        let crossed = sides
            .filter(|(p, q)| length > 0.0 && (p.y < y) != (q.y < y))
            .map(|(p, q)| p.lerp(q, (y - p.y) / (q.y - p.y)).x);
        discs.flatten().chain(crossed).fold(None, |found, x| {
            let (from, to) = found.unwrap_or((x, x));
            Some((x.min(from), x.max(to)))
        })
    }

    /// Sweeps along a line and records the parts inside.
    fn sweep(&self, events: &[Event], spans: &mut Vec<Span>) {
        let (mut winding, mut blocked) = (0_i32, 0_i32);
        let first = spans.len();
        for pair in events.windows(2) {
            winding += i32::from(pair[0].winding);
            blocked += i32::from(pair[0].blocked);
            let filled = match self.rule {
                FillRule::NonZero => winding != 0,
                FillRule::EvenOdd => winding % 2 != 0,
            };
            let (from, to) = (pair[0].x, pair[1].x);
            if !filled || blocked > 0 || from >= to {
                continue;
            }
            match spans[first..].last_mut() {
                Some(last) if last.to == from => last.to = to,
                _ => spans.push(Span {
                    line: pair[0].line,
                    y: self.height(pair[0].line),
                    from,
                    to,
                }),
            }
        }
    }
}

/// An event at a place on a line.
#[derive(Clone, Copy, Debug)]
struct Event {
    line: i64,
    x: f64,
    /// The winding change at an edge.
    winding: i8,
    /// The start or end of a blocked part close to an edge.
    blocked: i8,
}

/// As many as fit in 100 MB.
const MAX_CROSSINGS: u32 = 2_000_000;
