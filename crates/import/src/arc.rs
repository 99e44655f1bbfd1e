//! Arcs of circles and ellipses.

use dobot_geometry::{Point, Vec2};

/// An elliptic arc, `center + across cos t + along sin t`; its size may change along the arc, so
/// that it ends where the file specifies.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arc {
    center: Point,
    across: Vec2,
    along: Vec2,
    from_rad: f64,
    sweep_rad: f64,
    /// The ratio of its size at the end to that at the start.
    growth: f64,
    pub(crate) start: Point,
    pub(crate) end: Point,
}

impl Arc {
    /// The sweep; above 0 is counterclockwise if y points up.
    pub(crate) fn circle(center: Point, radius: f64, from_rad: f64, sweep_rad: f64) -> Self {
        let across = Vec2::new(radius, 0.0);
        Self::ellipse(center, across, Vec2::new(0.0, radius), from_rad, sweep_rad)
    }

    pub(crate) fn ellipse(
        center: Point,
        across: Vec2,
        along: Vec2,
        from_rad: f64,
        sweep_rad: f64,
    ) -> Self {
        let at = |t: f64| center + across * t.cos() + along * t.sin();
        let is_whole = sweep_rad.abs() >= std::f64::consts::TAU;
        let start = at(from_rad);
        Self {
            center,
            across,
            along,
            from_rad,
            sweep_rad,
            growth: 1.0,
            start,
            end: if is_whole {
                start
            } else {
                at(from_rad + sweep_rad)
            },
        }
    }

    /// An arc about a center from a point by an angle to another point, whose distance may differ a
    /// little.
    pub(crate) fn between(center: Point, start: Point, sweep_rad: f64, end: Point) -> Self {
        let out = start - center;
        let radius = out.length();
        Self {
            growth: end.distance(center) / radius,
            start,
            end,
            ..Self::circle(center, radius, out.atan2(), sweep_rad)
        }
    }

    pub(crate) fn at(&self, share: f64) -> Point {
        let (sin, cos) = (self.from_rad + self.sweep_rad * share).sin_cos();
        let size = 1.0 + (self.growth - 1.0) * share;
        self.center + (self.across * cos + self.along * sin) * size
    }

    /// The number of chords that stay within the tolerance, 1 or more.
    ///
    /// A chord over the angle `a` deviates from its circle by `r (1 - cos(a / 2))`; an ellipse is a
    /// flattened circle of its larger radius.
    pub(crate) fn chords(&self, tolerance: f64) -> f64 {
        let radius = self.across.length().max(self.along.length()) * self.growth.max(1.0);
        let share = (tolerance / (2.0 * radius)).sqrt().min(1.0);
        let most_rad = (4.0 * share.asin()).min(std::f64::consts::FRAC_PI_2);
        (self.sweep_rad.abs() / most_rad).ceil().max(1.0)
    }
}

/// Points nearer than this are equal: sums of rounded numbers differ by less.
pub(crate) const SAME_MM: f64 = 1e-6;
