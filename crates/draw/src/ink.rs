//! What the pen left on the paper.

use dobot_arm::Position;

use crate::point::{Point, Stroke};

/// The lines that a pen leaves along a path that is known everywhere: it writes where it is no
/// higher than 0.05 mm above `down_z_mm`.
#[must_use]
pub fn ink(path: impl IntoIterator<Item = Position>, down_z_mm: f64) -> Vec<Stroke> {
    let mut strokes: Vec<Stroke> = Vec::new();
    let mut writing = false;
    for at in path {
        let writes = writes(at, down_z_mm);
        if writes && !writing {
            strokes.push(Stroke::open(Vec::new()));
        }
        if writes && let Some(stroke) = strokes.last_mut() {
            stroke.points.push(point(at));
        }
        writing = writes;
    }
    strokes
}

/// The places where a pen was seen writing, of a path that is known there only: between two
/// statuses nobody knows where the pen went.
#[must_use]
pub fn ink_seen(path: impl IntoIterator<Item = Position>, down_z_mm: f64) -> Vec<Stroke> {
    path.into_iter()
        .filter(|&at| writes(at, down_z_mm))
        .map(|at| Stroke::open(vec![point(at)]))
        .collect()
}

fn writes(at: Position, down_z_mm: f64) -> bool {
    at.z.0 <= down_z_mm + TOUCHING_MM
}

const fn point(at: Position) -> Point {
    Point::new(at.x.0, at.y.0)
}

const TOUCHING_MM: f64 = 0.05;

#[cfg(test)]
mod tests {
    use super::*;

    fn path() -> Vec<Position> {
        [
            (0.0, -30.0),
            (0.0, -40.0),
            (5.0, -40.0),
            (5.0, -30.0),
            (9.0, -30.0),
            (9.0, -40.0),
        ]
        .map(|(x, z)| Position::new(x, 0.0, z))
        .to_vec()
    }

    #[test]
    fn a_pen_writes_only_while_it_is_down() {
        let strokes = ink(path(), -40.0);
        let xs: Vec<Vec<f64>> = strokes
            .iter()
            .map(|stroke| stroke.points.iter().map(|point| point.x).collect())
            .collect();
        assert_eq!(xs, [vec![0.0, 5.0], vec![9.0]]);
    }

    #[test]
    fn statuses_give_dots_and_no_lines_between_them() {
        let dots = ink_seen(path(), -40.0);
        assert_eq!(dots.len(), 3);
        assert!(dots.iter().all(|dot| dot.points.len() == 1));
    }
}
