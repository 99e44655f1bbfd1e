//! From the units of a plot to millimetres: IP, SC, RO.
//!
//! ```text
//!   the user's units   SC says which of them    P1 and P2, in plotter units (IP),
//!                      stand at P1 and P2       40 to the millimetre; RO turns all
//! ```

use dobot_geometry::Point;

/// How points come onto the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    /// P1 and P2, in plotter units.
    pub(super) corners: [Point; 2],
    pub(super) scale: Option<Scale>,
    /// In quarter turns counterclockwise.
    pub(super) quarters: u8,
}

/// What SC says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scale {
    /// The user's coordinates of P1.
    pub(super) from: Point,
    /// And of P2, or how many plotter units one of the user's is.
    pub(super) to: Point,
    pub(super) kind: ScaleKind,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum ScaleKind {
    /// X and Y fill the corners, each for itself.
    Stretched,
    /// X and Y are scaled alike; what is left over is shared in these parts, from 0 to 1.
    Even { left: f64, bottom: f64 },
    /// By a factor.
    Factor,
}

impl Frame {
    /// That of an HP 7475A with a sheet of A4.
    pub(super) const DEFAULT: Self = Self {
        corners: [Point::new(603.0, 521.0), Point::new(10_603.0, 7721.0)],
        scale: None,
        quarters: 0,
    };

    /// A point, in millimetres.
    pub(super) fn point(&self, p: Point) -> Point {
        let (factor, shift) = self.factor_and_shift();
        let units = Point::new(p.x * factor.x, p.y * factor.y) + shift;
        self.turned(units) * UNIT_MM
    }

    /// The way from one point to another.
    pub(super) fn way(&self, way: Point) -> Point {
        let (factor, _) = self.factor_and_shift();
        self.turned(Point::new(way.x * factor.x, way.y * factor.y)) * UNIT_MM
    }

    /// The point that is there on the paper.
    pub(super) fn point_at(&self, place_mm: Point) -> Point {
        let back = Self {
            quarters: (4 - self.quarters) % 4,
            ..*self
        };
        let (factor, shift) = self.factor_and_shift();
        let units = back.turned(place_mm * (1.0 / UNIT_MM)) - shift;
        Point::new(units.x / factor.x, units.y / factor.y)
    }

    fn factor_and_shift(&self) -> (Point, Point) {
        let [p1, p2] = self.corners;
        let Some(Scale { from, to, kind }) = self.scale else {
            return (Point::new(1.0, 1.0), Point::default());
        };
        let room = p2 - p1;
        let full = Point::new(room.x / (to.x - from.x), room.y / (to.y - from.y));
        let (factor, gap) = match kind {
            ScaleKind::Stretched => (full, Point::default()),
            ScaleKind::Factor => (to, Point::default()),
            ScaleKind::Even { left, bottom } => {
                let least = full.x.abs().min(full.y.abs());
                let even = Point::new(least.copysign(full.x), least.copysign(full.y));
                let used = Point::new(even.x * (to.x - from.x), even.y * (to.y - from.y));
                let rest = room - used;
                (even, Point::new(rest.x * left, rest.y * bottom))
            }
        };
        let from = Point::new(from.x * factor.x, from.y * factor.y);
        (factor, p1 + gap - from)
    }

    /// As RO turns everything.
    pub(super) const fn turned(&self, p: Point) -> Point {
        match self.quarters {
            0 => p,
            1 => Point::new(-p.y, p.x),
            2 => Point::new(-p.x, -p.y),
            _ => Point::new(p.y, -p.x),
        }
    }
}

/// A plotter unit.
pub(super) const UNIT_MM: f64 = 0.025;
