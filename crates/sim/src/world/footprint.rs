//! The outline of an object, seen from above.

use dobot_geometry::{Point, Vec2, direction};

/// What of the table an object covers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Footprint {
    /// A rectangle: its middle, half its sides, and how it is turned.
    Rectangle {
        middle: Point,
        half_mm: [f64; 2],
        turn_deg: f64,
    },
    /// A disc.
    Disc { middle: Point, radius_mm: f64 },
}

impl Footprint {
    /// How far inside a point lies, to the nearest edge; outside it is negative, and a corner may
    /// be farther away than it says.
    pub(crate) fn margin_mm(&self, point: Point) -> f64 {
        match *self {
            Self::Rectangle {
                middle,
                half_mm: [along, across],
                turn_deg,
            } => {
                let point = (point - middle).rotate_scale(direction(-turn_deg));
                (along - point.x.abs()).min(across - point.y.abs())
            }
            Self::Disc { middle, radius_mm } => radius_mm - point.distance(middle),
        }
    }

    /// Whether two outlines cover the same place; side by side they do not.
    pub(crate) fn overlaps(&self, other: &Self) -> bool {
        match (self, other) {
            (
                Self::Disc { middle, radius_mm },
                Self::Disc {
                    middle: other_middle,
                    radius_mm: other_radius_mm,
                },
            ) => middle.distance(*other_middle) < radius_mm + other_radius_mm - SIDE_BY_SIDE_MM,
            (Self::Disc { middle, radius_mm }, rectangle)
            | (rectangle, Self::Disc { middle, radius_mm }) => {
                rectangle.nearest(*middle).distance(*middle) < radius_mm - SIDE_BY_SIDE_MM
            }
            _ => self
                .axes()
                .into_iter()
                .chain(other.axes())
                .all(|axis| meet(self.extent(axis), other.extent(axis))),
        }
    }

    /// From where to where it reaches along a direction of length 1.
    pub(crate) fn extent(&self, along: Vec2) -> [f64; 2] {
        let (middle, half) = match *self {
            Self::Rectangle {
                middle,
                half_mm: [x, y],
                turn_deg,
            } => {
                let along = along.rotate_scale(direction(-turn_deg));
                (middle, x * along.x.abs() + y * along.y.abs())
            }
            Self::Disc { middle, radius_mm } => (middle, radius_mm),
        };
        let at = middle.to_vec2().dot(along);
        [at - half, at + half]
    }

    /// The two directions of the sides.
    fn axes(&self) -> [Vec2; 2] {
        let turn_deg = match *self {
            Self::Rectangle { turn_deg, .. } => turn_deg,
            Self::Disc { .. } => 0.0,
        };
        [0.0, 90.0].map(|angle| direction(turn_deg + angle))
    }

    /// The point of a rectangle that is nearest to `point`.
    fn nearest(&self, point: Point) -> Point {
        match *self {
            Self::Rectangle {
                middle,
                half_mm: [along, across],
                turn_deg,
            } => {
                let point = (point - middle).rotate_scale(direction(-turn_deg));
                let inside =
                    Vec2::new(point.x.clamp(-along, along), point.y.clamp(-across, across));
                middle + inside.rotate_scale(direction(turn_deg))
            }
            Self::Disc { middle, .. } => middle,
        }
    }
}

fn meet(one: [f64; 2], other: [f64; 2]) -> bool {
    one[1].min(other[1]) - one[0].max(other[0]) > SIDE_BY_SIDE_MM
}

/// What rounding may let two objects that touch overlap.
const SIDE_BY_SIDE_MM: f64 = 0.01;

#[cfg(test)]
mod tests {
    use super::*;

    fn square(x: f64, y: f64, side: f64, turn_deg: f64) -> Footprint {
        Footprint::Rectangle {
            middle: Point::new(x, y),
            half_mm: [side / 2.0; 2],
            turn_deg,
        }
    }

    fn disc(x: f64, y: f64, diameter: f64) -> Footprint {
        Footprint::Disc {
            middle: Point::new(x, y),
            radius_mm: diameter / 2.0,
        }
    }

    #[test]
    fn a_turned_square_reaches_farther_and_is_met_only_where_it_is() {
        let turned = square(0.0, 0.0, 20.0, 45.0);
        let [from, to] = turned.extent(Vec2::new(1.0, 0.0));
        assert!((to - 200.0_f64.sqrt()).abs() < 1e-12 && from == -to);
        // Its corner points at +X: a square there is met, one beside the slope is not.
        assert!(turned.overlaps(&square(18.0, 0.0, 10.0, 0.0)));
        assert!(!turned.overlaps(&square(13.0, 13.0, 10.0, 0.0)));
        assert!(turned.overlaps(&square(11.0, 11.0, 10.0, 0.0)));
    }

    #[test]
    fn side_by_side_is_not_in_the_same_place() {
        let cube = square(0.0, 0.0, 20.0, 0.0);
        assert!(!cube.overlaps(&square(20.0, 0.0, 20.0, 0.0)));
        assert!(cube.overlaps(&square(19.9, 0.0, 20.0, 0.0)));
        assert!(!cube.overlaps(&disc(20.0, 0.0, 20.0)));
        assert!(cube.overlaps(&disc(19.9, 0.0, 20.0)));
        // At the corner a disc comes nearer.
        assert!(!cube.overlaps(&disc(18.0, 18.0, 20.0)));
        assert!(!disc(0.0, 0.0, 20.0).overlaps(&disc(20.0, 0.0, 20.0)));
        assert!(disc(0.0, 0.0, 20.0).overlaps(&disc(0.0, 19.9, 20.0)));
    }

    #[test]
    fn the_margin_is_the_way_to_the_nearest_edge() {
        assert_eq!(
            square(5.0, 0.0, 20.0, 0.0).margin_mm(Point::new(12.0, 1.0)),
            3.0
        );
        assert_eq!(disc(0.0, 0.0, 20.0).margin_mm(Point::new(0.0, 12.0)), -2.0);
    }
}
