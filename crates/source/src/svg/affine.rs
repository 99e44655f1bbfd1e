//! Affine maps of the plane.

use dobot_geometry::Point;

/// `x' = xx x + xy y + dx`, `y' = yx x + yy y + dy`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Affine {
    xx: f64,
    xy: f64,
    yx: f64,
    yy: f64,
    dx: f64,
    dy: f64,
}

impl Affine {
    pub(crate) const fn scale(factor: f64) -> Self {
        Self {
            xx: factor,
            xy: 0.0,
            yx: 0.0,
            yy: factor,
            dx: 0.0,
            dy: 0.0,
        }
    }

    /// The map that applies `inner` first and `self` second, as nested SVG groups do.
    pub(crate) fn of(self, inner: usvg::Transform) -> Self {
        let [sx, kx, ky, sy, tx, ty] =
            [inner.sx, inner.kx, inner.ky, inner.sy, inner.tx, inner.ty].map(f64::from);
        Self {
            xx: self.xx * sx + self.xy * ky,
            xy: self.xx * kx + self.xy * sy,
            yx: self.yx * sx + self.yy * ky,
            yy: self.yx * kx + self.yy * sy,
            dx: self.xx * tx + self.xy * ty + self.dx,
            dy: self.yx * tx + self.yy * ty + self.dy,
        }
    }

    pub(crate) fn apply(self, p: Point) -> Point {
        Point::new(
            self.xx * p.x + self.xy * p.y + self.dx,
            self.yx * p.x + self.yy * p.y + self.dy,
        )
    }

    /// The largest factor by which any distance grows (the larger singular value).
    pub(crate) fn max_stretch(self) -> f64 {
        let turn = (self.xx + self.yy).hypot(self.yx - self.xy);
        let mirror = (self.xx - self.yy).hypot(self.yx + self.xy);
        f64::midpoint(turn, mirror)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inner_map_comes_first() {
        let moved = usvg::Transform::from_translate(1.0, 2.0);
        let map = Affine::scale(10.0).of(moved);
        assert_eq!(map.apply(Point::new(3.0, 4.0)), Point::new(40.0, 60.0));
    }

    #[test]
    fn the_stretch_is_that_of_the_longest_image_of_a_unit_vector() {
        let map = Affine::scale(1.0).of(usvg::Transform::from_row(2.0, 0.5, -1.0, 3.0, 7.0, 7.0));
        let origin = map.apply(Point::default());
        let longest = (0..36_000)
            .map(|i| (f64::from(i) / 36_000.0 * std::f64::consts::TAU).sin_cos())
            .map(|(sin, cos)| map.apply(Point::new(cos, sin)).distance(origin))
            .fold(0.0, f64::max);
        assert!((map.max_stretch() - longest).abs() < 1e-6);
    }
}
