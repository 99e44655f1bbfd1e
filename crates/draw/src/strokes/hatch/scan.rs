//! Which parts of parallel lines lie inside of rings.

use dobot_geometry::{FillRule, Point};

use super::HatchError;

/// Rings cut by lines along x. The lines to draw have even numbers; halfway between them lie odd
/// ones, which tell whether the way from one to the next is inside.
#[derive(Debug)]
pub(super) struct Scan {
    /// The edges of all rings.
    pub(super) edges: Vec<(Point, Point)>,
    /// What counts as inside.
    pub(super) rule: FillRule,
    /// How far apart the lines to draw are.
    pub(super) spacing_mm: f64,
    /// How far they stay away from the edges.
    pub(super) inset_mm: f64,
}

/// The part of a line that lies inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Span {
    /// Even for a line to draw.
    pub(super) line: i64,
    pub(super) y: f64,
    pub(super) from: f64,
    pub(super) to: f64,
}

impl Scan {
    /// The parts that lie inside, by line and from left to right.
    pub(super) fn spans(&self) -> Result<Vec<Span>, HatchError> {
        self.check_count()?;
        let mut events = Vec::new();
        for &edge in &self.edges {
            self.cross(edge, &mut events);
            if self.inset_mm > 0.0 {
                self.block(edge, &mut events);
            }
        }
        events.sort_unstable_by(|a, b| a.line.cmp(&b.line).then(a.x.total_cmp(&b.x)));
        let lines = events.chunk_by(|a, b| a.line == b.line);
        let mut spans = Vec::new();
        for line in lines {
            self.sweep(line, &mut spans);
        }
        Ok(spans)
    }

    fn check_count(&self) -> Result<(), HatchError> {
        let high = |(a, b): &(Point, Point)| (a.y - b.y).abs() + 4.0 * self.inset_mm;
        let crossings = self.edges.iter().map(high).sum::<f64>() / self.spacing_mm;
        if crossings <= f64::from(MOST_CROSSINGS) {
            return Ok(());
        }
        let most = MOST_CROSSINGS;
        Err(HatchError::TooMany { crossings, most })
    }

    /// The first line at or above a height. Edges own the lines from their lower end up to, but
    /// without, their upper one, so that rings are tight at their corners.
    #[expect(clippy::cast_possible_truncation, reason = "few lines, as was checked")]
    fn first_line(&self, y: f64) -> i64 {
        (2.0 * y / self.spacing_mm).ceil() as i64 - 1
    }

    #[expect(clippy::cast_precision_loss, reason = "few lines, as was checked")]
    fn height(&self, line: i64) -> f64 {
        (line + 1) as f64 * self.spacing_mm / 2.0
    }

    /// Where lines cross an edge.
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

    /// Where lines are too near to an edge.
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

    /// The part of the line at height `y` that is nearer to an edge than the inset: what it has in
    /// common with discs around the ends and the rectangle between them.
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

    /// Goes along one line and notes what is inside.
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

/// What happens on a line at one place.
#[derive(Clone, Copy, Debug)]
struct Event {
    line: i64,
    x: f64,
    /// An edge that goes up or down.
    winding: i8,
    /// An edge comes near, or is left behind.
    blocked: i8,
}

/// As many as 100 MB hold.
const MOST_CROSSINGS: u32 = 2_000_000;
