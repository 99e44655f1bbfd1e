//! Lines of equal tone (marching squares).

use dobot_geometry::{Point, Stroke};

use crate::tone::Tone;

/// Returns the lines along which the tone is `threshold`, with the darker side always on the same
/// hand.
///
/// The centers of four neighbouring cells form a square. If its corners are on different sides of
/// the threshold, the line crosses the square from edge to edge, at the interpolated places of the
/// threshold.
///
/// ```text
///   dark ----x---- light      each crossed edge is the exit of one square
///     |       \      |        and the entry of the next
///   dark ------x-- light
/// ```
pub(crate) fn contours(tone: &Tone, threshold: f64) -> Vec<Stroke> {
    if tone.width < 2 || tone.height < 2 {
        return Vec::new();
    }
    let mut map = EdgeMap {
        tone,
        threshold,
        next: vec![NONE; 2 * tone.ink.len()],
        entered: vec![false; 2 * tone.ink.len()],
    };
    map.cross_all();
    map.strokes()
}

/// The successor of each edge. Edge `2 * i` leads from the center of cell `i` to the right,
/// edge `2 * i + 1` down.
struct EdgeMap<'a> {
    tone: &'a Tone,
    threshold: f64,
    next: Vec<usize>,
    /// Whether an edge has a predecessor.
    entered: Vec<bool>,
}

impl EdgeMap<'_> {
    fn cross_all(&mut self) {
        let width = self.tone.width;
        for y in 0..self.tone.height - 1 {
            for x in 0..width - 1 {
                self.cross(y * width + x);
            }
        }
    }

    /// Joins the crossed edges of the square to the right of and below a cell.
    fn cross(&mut self, cell: usize) {
        let width = self.tone.width;
        let corners = [cell, cell + 1, cell + width + 1, cell + width];
        // Clockwise: top, right, bottom, left; each edge starts at the corner with its number.
        let edges = [2 * cell, 2 * cell + 3, 2 * (cell + width), 2 * cell + 1];
        let dark = corners.map(|corner| self.is_dark(corner));
        let exits = |i: usize| dark[i] && !dark[(i + 1) % 4];
        let enters = |i: usize| !dark[i] && dark[(i + 1) % 4];
        let saddle = dark[0] == dark[2] && dark[1] == dark[3] && dark[0] != dark[1];
        // In a saddle the center decides which corners are connected.
        let turn = if saddle && !self.middle_is_dark(corners) {
            3
        } else {
            1
        };
        for from in (0..4).filter(|&i| exits(i)) {
            let mut to = (from + turn) % 4;
            while !enters(to) {
                to = (to + turn) % 4;
            }
            self.next[edges[from]] = edges[to];
            self.entered[edges[to]] = true;
        }
    }

    fn is_dark(&self, cell: usize) -> bool {
        f64::from(self.tone.ink[cell]) >= self.threshold
    }

    fn middle_is_dark(&self, corners: [usize; 4]) -> bool {
        let sum: f64 = corners
            .map(|corner| f64::from(self.tone.ink[corner]))
            .iter()
            .sum();
        sum / 4.0 >= self.threshold
    }

    fn strokes(mut self) -> Vec<Stroke> {
        let mut strokes = Vec::new();
        // First those that start at the page's border: only rings remain.
        for ends in [true, false] {
            for edge in 0..self.next.len() {
                if self.next[edge] != NONE && !(ends && self.entered[edge]) {
                    strokes.push(self.follow(edge));
                }
            }
        }
        strokes
    }

    fn follow(&mut self, first: usize) -> Stroke {
        let mut points = vec![self.place(first)];
        let mut edge = std::mem::replace(&mut self.next[first], NONE);
        while edge != NONE {
            points.push(self.place(edge));
            edge = std::mem::replace(&mut self.next[edge], NONE);
        }
        let closed = points.len() > 3 && points.first() == points.last();
        Stroke { points, closed }
    }

    /// The place of the threshold on an edge.
    fn place(&self, edge: usize) -> Point {
        let width = self.tone.width;
        let from = edge / 2;
        let to = if edge.is_multiple_of(2) {
            from + 1
        } else {
            from + width
        };
        let [a, b] = [from, to].map(|value| f64::from(self.tone.ink[value]));
        let middle = |cell: usize| self.tone.middle(cell % width, cell / width);
        middle(from).lerp(middle(to), ((self.threshold - a) / (b - a)).clamp(0.0, 1.0))
    }
}

const NONE: usize = usize::MAX;

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use proptest::prelude::*;

    use dobot_geometry::Vec2;

    use super::*;

    fn tone(width: usize, ink: Vec<f32>) -> Tone {
        let height = ink.len() / width;
        let cell = Point::new(1.0, 1.0);
        Tone {
            width,
            height,
            cell,
            ink,
        }
    }

    #[test]
    fn a_cone_has_round_level_lines() {
        let middle = Point::new(20.3, 19.8);
        let radius = |x: usize, y: usize| {
            let at = Point::new(crate::tone::count(x), crate::tone::count(y));
            (at + Vec2::new(0.5, 0.5)).distance(middle)
        };
        let ink = (0..1600).map(|i| crate::tone::as_ink(1.0 - radius(i % 40, i / 40) / 20.0));
        let lines = contours(&tone(40, ink.collect()), 0.5);
        assert_eq!(lines.len(), 1);
        assert!(lines[0].closed);
        for p in &lines[0].points {
            assert!((p.distance(middle) - 10.0).abs() < 0.02, "{p:?}");
        }
        assert!((lines[0].length_mm() - TAU * 10.0).abs() < 0.2);
    }

    #[test]
    fn a_border_across_the_page_is_one_open_line() {
        let ink = (0..50)
            .map(|i| if i % 10 < 5 { 1.0 } else { 0.0 })
            .collect();
        let lines = contours(&tone(10, ink), 0.5);
        assert_eq!(lines.len(), 1);
        assert!(!lines[0].closed);
        assert!(lines[0].points.iter().all(|p| p.x == 5.0));
        assert_eq!(lines[0].length_mm(), 4.0);
    }

    proptest! {
        #[test]
        fn every_line_ends_at_the_border_or_in_itself(
            ink in prop::collection::vec(0..4_u8, 64), threshold in 0.05..0.95,
        ) {
            let ink: Vec<f32> = ink.into_iter().map(|item| f32::from(item) / 3.0).collect();
            let tone = tone(8, ink);
            let at_border = |p: Point| p.x == 0.5 || p.y == 0.5 || p.x == 7.5 || p.y == 7.5;
            let mut crossings = 0;
            for line in contours(&tone, threshold) {
                crossings += line.points.len() - usize::from(line.closed);
                let (first, last) = (line.points[0], line.last().unwrap_or_default());
                prop_assert!(first == last || at_border(first) && at_border(last), "{:?}", line);
            }
            // Each edge between a darker and a lighter cell is crossed exactly once.
            let dark: Vec<bool> = tone.ink.iter().map(|&item| f64::from(item) >= threshold).collect();
            let right = (0..64).filter(|i| i % 8 < 7 && dark[*i] != dark[i + 1]).count();
            let down = (0..56).filter(|i| dark[*i] != dark[i + 8]).count();
            prop_assert!(crossings >= right + down, "{} of {}", crossings, right + down);
        }
    }
}
