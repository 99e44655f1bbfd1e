//! The polygon buffer: between PM0 and PM2 moves are stored instead of drawn.

use dobot_geometry::Point;

/// The rings that EP draws and FP fills, in millimetres.
#[derive(Debug, Default)]
pub(super) struct Polygon {
    /// Whether the plotter is between PM0 and PM2.
    pub(super) is_open: bool,
    rings: Vec<Ring>,
    /// Whether the next point starts a ring.
    starts: bool,
}

/// A ring, closed by PM1 and PM2.
#[derive(Clone, Debug, Default)]
struct Ring {
    points: Vec<Point>,
    /// The points that the pen reached while lifted, in order.
    hidden: Vec<usize>,
}

impl Ring {
    fn lines(&self) -> impl Iterator<Item = &[Point]> {
        let ends = self.hidden.iter().copied().chain([self.points.len()]);
        let lines = ends.scan(0, |begin, end| {
            let line = &self.points[*begin..end];
            *begin = end;
            Some(line)
        });
        lines.filter(|line| line.len() > 1)
    }
}

impl Polygon {
    /// The lines that EP draws: those with the pen down, or all if it never was.
    pub(super) fn lines(&self) -> Vec<Vec<Point>> {
        let lines = self.rings.iter().flat_map(Ring::lines);
        let lines: Vec<_> = lines.map(<[Point]>::to_vec).collect();
        if lines.is_empty() {
            self.filled()
        } else {
            lines
        }
    }

    /// The rings that FP fills.
    pub(super) fn filled(&self) -> Vec<Vec<Point>> {
        self.rings.iter().map(|ring| ring.points.clone()).collect()
    }

    /// PM0: clears the buffer.
    pub(super) fn begin(&mut self, at: Point) {
        *self = Self {
            is_open: true,
            ..Self::default()
        };
        self.ring(vec![at]);
        self.starts = false;
    }

    /// PM1: closes the ring, the next point starts another.
    pub(super) fn close_ring(&mut self, is_down: bool) {
        if let Some(ring) = self.rings.last()
            && ring.points.first() != ring.points.last()
        {
            let first = ring.points[0];
            self.point(first, is_down);
        }
        self.starts = true;
    }

    /// PM2: ends the polygon.
    pub(super) fn end(&mut self, is_down: bool) {
        self.close_ring(is_down);
        self.is_open = false;
    }

    /// Moves the pen there, on the paper or lifted.
    pub(super) fn point(&mut self, p: Point, is_down: bool) {
        match self.rings.last_mut().filter(|_| !self.starts) {
            Some(ring) => {
                if !is_down {
                    ring.hidden.push(ring.points.len());
                }
                ring.points.push(p);
            }
            None => self.ring(vec![p]),
        }
        self.starts = false;
    }

    /// Adds a separate ring (CI).
    pub(super) fn ring(&mut self, points: Vec<Point>) {
        self.rings.push(Ring {
            points,
            hidden: Vec::new(),
        });
        self.starts = true;
    }
}
