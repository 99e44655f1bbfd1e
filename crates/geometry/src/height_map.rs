//! Interpolated heights of a surface.

use crate::{Point, Rect, bounds, solve};

/// A thin-plate spline through known heights: the smoothest such surface. Outside the bounding
/// rectangle of the known points, the height on the edge applies.
///
/// ```
/// use dobot_geometry::{HeightMap, Point};
///
/// let corners = [[0.0, 0.0, 0.0], [100.0, 0.0, 1.0], [0.0, 100.0, 0.0], [100.0, 100.0, 1.0]];
/// let map = HeightMap::through(&corners).ok_or("no surface")?;
/// assert!((map.z_at(Point::new(50.0, 20.0)) - 0.5).abs() < 1e-9);
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct HeightMap {
    places: Vec<Point>,
    /// The weight of each known point.
    weights: Vec<f64>,
    /// The base plane: its height at the origin and its slopes.
    plane: [f64; 3],
    around: Rect,
}

impl HeightMap {
    /// Builds the surface through points with heights: x, y, z. `None` if there are fewer than
    /// three, they lie on one line, two coincide, or a number is not finite.
    #[must_use]
    pub fn through(known: &[[f64; 3]]) -> Option<Self> {
        let count = known.len();
        if count < 3 || !known.as_flattened().iter().all(|x| x.is_finite()) {
            return None;
        }
        let places: Vec<Point> = known.iter().map(|[x, y, _]| Point::new(*x, *y)).collect();
        let (matrix, heights) = system(known, &places);
        let mut found = solve(&matrix, &heights)?;
        let plane = [found[count], found[count + 1], found[count + 2]];
        found.truncate(count);
        let map = Self {
            around: bounds(places.iter().copied()),
            weights: found,
            places,
            plane,
        };
        // A nearly singular matrix also yields a solution, but a wrong one.
        let is_met =
            |known: &[f64; 3]| (map.z_at(Point::new(known[0], known[1])) - known[2]).abs() < MET;
        known.iter().all(is_met).then_some(map)
    }

    /// Its height at a place.
    #[must_use]
    pub fn z_at(&self, place: Point) -> f64 {
        let Rect { x0, y0, x1, y1 } = self.around;
        let place = Point::new(place.x.clamp(x0, x1), place.y.clamp(y0, y1));
        let [z0, slope_x, slope_y] = self.plane;
        let bent = self.places.iter().zip(&self.weights);
        let bent: f64 = bent
            .map(|(known, weight)| weight * bend(known.distance(place)))
            .sum();
        z0 + slope_x * place.x + slope_y * place.y + bent
    }
}

/// Returns the equations for the weights of the points and for the plane: matrix and right-hand side.
fn system(known: &[[f64; 3]], places: &[Point]) -> (Vec<Vec<f64>>, Vec<f64>) {
    let count = known.len();
    let mut matrix = vec![vec![0.0; count + 3]; count + 3];
    let mut heights = vec![0.0; count + 3];
    for (row, place) in places.iter().enumerate() {
        for (column, other) in places.iter().enumerate() {
            matrix[row][column] = bend(place.distance(*other));
        }
        for (column, share) in [1.0, place.x, place.y].into_iter().enumerate() {
            matrix[row][count + column] = share;
            matrix[count + column][row] = share;
        }
        heights[row] = known[row][2];
    }
    (matrix, heights)
}

/// How much a place bends the surface in a distance.
fn bend(distance: f64) -> f64 {
    if distance == 0.0 {
        0.0
    } else {
        distance * distance * distance.ln()
    }
}

const MET: f64 = 1e-6;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn the_heights_of_a_bent_board_are_interpolated_between_the_touched_places() {
        let board = |x: f64, y: f64| 2.0 * (x / 200.0).powi(2) - 1.5 * (y / 120.0).powi(2) + 0.3;
        let grid =
            (0..5).flat_map(|i| (0..4).map(move |j| [f64::from(i) * 50.0, f64::from(j) * 40.0]));
        let known: Vec<_> = grid.map(|[x, y]| [x, y, board(x, y)]).collect();
        let map = HeightMap::through(&known).unwrap();
        for (x, y) in [(25.0, 20.0), (110.0, 75.0), (190.0, 10.0)] {
            let off = map.z_at(Point::new(x, y)) - board(x, y);
            assert!(off.abs() < 0.05, "{off} at {x}, {y}");
        }
    }

    #[test]
    fn outside_the_touched_places_it_is_as_high_as_at_their_edge() {
        let known = [
            [0.0, 0.0, 0.0],
            [10.0, 0.0, 1.0],
            [0.0, 10.0, 0.0],
            [10.0, 10.0, 1.0],
        ];
        let map = HeightMap::through(&known).unwrap();
        let edge = map.z_at(Point::new(10.0, 5.0));
        assert_eq!(map.z_at(Point::new(500.0, 5.0)).to_bits(), edge.to_bits());
    }

    #[test]
    fn places_that_span_no_surface_give_none() {
        assert_eq!(HeightMap::through(&[[0.0; 3], [1.0, 0.0, 0.0]]), None);
        let line = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 2.0, 1.0]];
        assert_eq!(HeightMap::through(&line), None);
        let twice = [
            [0.0, 0.0, 0.0],
            [0.0, 0.0, 1.0],
            [2.0, 0.0, 1.0],
            [0.0, 2.0, 1.0],
        ];
        assert_eq!(HeightMap::through(&twice), None);
        assert_eq!(HeightMap::through(&[[f64::NAN; 3]; 4]), None);
    }

    proptest! {
        #[test]
        fn it_passes_through_the_known_places_and_is_always_finite(
            heights in proptest::collection::vec(-3.0..3.0, 12),
            x in -400.0..400.0,
            y in -400.0..400.0,
        ) {
            let place = |index: u32| [50.0 * f64::from(index % 4), 60.0 * f64::from(index / 4)];
            let known: Vec<_> = (0..).zip(&heights).map(|(index, z)| {
                let [x, y] = place(index);
                [x, y, *z]
            }).collect();
            let map = HeightMap::through(&known).unwrap();
            for [x, y, z] in known {
                prop_assert!((map.z_at(Point::new(x, y)) - z).abs() < 1e-6);
            }
            prop_assert!(map.z_at(Point::new(x, y)).abs() < 20.0);
        }
    }
}
