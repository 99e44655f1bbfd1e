//! The transform from plot units to millimetres: IP, SC, RO.
//!
//! ```text
//!   the user's units   SC says which of them    P1 and P2, in plotter units (IP),
//!                      stand at P1 and P2       40 to the millimetre; RO turns all
//! ```

use dobot_geometry::{Point, Vec2};

/// The transform of points to the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PlotTransform {
    /// P1 and P2, in plotter units.
    pub(super) corners: [Point; 2],
    pub(super) scale: Option<Scale>,
    /// The rotation in quarter turns counterclockwise.
    pub(super) quarters: u8,
}

/// The scale of SC.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scale {
    /// The user coordinates of P1.
    pub(super) from: Point,
    /// The user coordinates of P2, or the number of plotter units per user unit.
    pub(super) to: Point,
    pub(super) kind: ScaleKind,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum ScaleKind {
    /// X and Y fill the corners separately.
    Stretched,
    /// X and Y have the same scale; the remaining space is divided in these fractions, from 0 to 1.
    Even { left: f64, bottom: f64 },
    /// By a factor.
    Factor,
}

impl PlotTransform {
    /// The default of an HP 7475A with a sheet of A4.
    pub(super) const DEFAULT: Self = Self {
        corners: [Point::new(603.0, 521.0), Point::new(10_603.0, 7721.0)],
        scale: None,
        quarters: 0,
    };

    /// A point, in millimetres.
    pub(super) fn point(&self, p: Point) -> Point {
        (self.turned(self.plotter_units(p)) * UNIT_MM).to_point()
    }

    /// A point in plotter units, before the rotation of RO.
    pub(super) fn plotter_units(&self, p: Point) -> Vec2 {
        let (factor, shift) = self.factor_and_shift();
        Vec2::new(p.x * factor.x, p.y * factor.y) + shift
    }

    /// The vector from one point to another.
    pub(super) fn way(&self, way: Vec2) -> Vec2 {
        let (factor, _) = self.factor_and_shift();
        self.turned(Vec2::new(way.x * factor.x, way.y * factor.y)) * UNIT_MM
    }

    /// The user coordinates of a point on the paper.
    pub(super) fn point_at(&self, place_mm: Point) -> Point {
        let back = Self {
            quarters: (4 - self.quarters) % 4,
            ..*self
        };
        let (factor, shift) = self.factor_and_shift();
        let units = back.turned(place_mm.to_vec2() * (1.0 / UNIT_MM)) - shift;
        Point::new(units.x / factor.x, units.y / factor.y)
    }

    fn factor_and_shift(&self) -> (Vec2, Vec2) {
        let [p1, p2] = self.corners;
        let Some(Scale { from, to, kind }) = self.scale else {
            return (Vec2::new(1.0, 1.0), Vec2::ZERO);
        };
        let room = p2 - p1;
        let full = Vec2::new(room.x / (to.x - from.x), room.y / (to.y - from.y));
        let (factor, gap) = match kind {
            ScaleKind::Stretched => (full, Vec2::ZERO),
            ScaleKind::Factor => (to.to_vec2(), Vec2::ZERO),
            ScaleKind::Even { left, bottom } => {
                let least = full.x.abs().min(full.y.abs());
                let even = Vec2::new(least.copysign(full.x), least.copysign(full.y));
                let used = Vec2::new(even.x * (to.x - from.x), even.y * (to.y - from.y));
                let rest = room - used;
                (even, Vec2::new(rest.x * left, rest.y * bottom))
            }
        };
        let from = Vec2::new(from.x * factor.x, from.y * factor.y);
        (factor, p1.to_vec2() + gap - from)
    }

    /// Applies the rotation of RO.
    pub(super) const fn turned(&self, way: Vec2) -> Vec2 {
        match self.quarters {
            0 => way,
            1 => Vec2::new(-way.y, way.x),
            2 => Vec2::new(-way.x, -way.y),
            _ => Vec2::new(way.y, -way.x),
        }
    }
}

/// A plotter unit.
pub(super) const UNIT_MM: f64 = 0.025;
