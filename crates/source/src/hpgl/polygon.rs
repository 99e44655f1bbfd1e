//! The polygon buffer: between PM0 and PM2 moves are remembered instead of drawn.

use dobot_geometry::Point;

/// The rings that EP draws and FP fills, in millimetres.
#[derive(Debug, Default)]
pub(super) struct Polygon {
    /// Between PM0 and PM2.
    pub(super) is_open: bool,
    pub(super) rings: Vec<Vec<Point>>,
    /// The next point begins a ring.
    starts: bool,
}

impl Polygon {
    /// PM0: what was there is forgotten.
    pub(super) fn begin(&mut self, at: Point) {
        *self = Self {
            is_open: true,
            rings: vec![vec![at]],
            starts: false,
        };
    }

    /// PM1: the ring is closed, the next point begins another.
    pub(super) fn close_ring(&mut self) {
        if let Some(ring) = self.rings.last_mut()
            && ring.first() != ring.last()
        {
            ring.extend(ring.first().copied());
        }
        self.starts = true;
    }

    /// PM2.
    pub(super) fn end(&mut self) {
        self.close_ring();
        self.is_open = false;
    }

    pub(super) fn point(&mut self, p: Point) {
        match self.rings.last_mut().filter(|_| !self.starts) {
            Some(ring) => ring.push(p),
            None => self.rings.push(vec![p]),
        }
        self.starts = false;
    }

    /// A ring for itself (CI).
    pub(super) fn ring(&mut self, ring: Vec<Point>) {
        self.rings.push(ring);
        self.starts = true;
    }
}
