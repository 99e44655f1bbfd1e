//! SPLINE by control points: rational B-splines, by de Boor's algorithm.

use dobot_geometry::{Line, ParamCurveNearest, Point, Vec2};

/// A curve by control points and knots.
#[derive(Debug)]
pub(super) struct Spline {
    degree: usize,
    knots: Vec<f64>,
    /// Control points times their weights, and the weights.
    controls: Vec<(Vec2, f64)>,
}

impl Spline {
    /// Creates a curve; an error describes what is wrong.
    pub(super) fn new(
        degree: usize,
        knots: Vec<f64>,
        points: &[Point],
        weights: &[f64],
    ) -> Result<Self, String> {
        if !(1..=MAX_DEGREE).contains(&degree) {
            return Err(format!("a spline of degree {degree}"));
        }
        if points.len() <= degree || knots.len() != points.len() + degree + 1 {
            let (points, knots) = (points.len(), knots.len());
            return Err(format!(
                "a spline of degree {degree} with {points} control points and {knots} knots"
            ));
        }
        if knots.windows(2).any(|pair| pair[0] > pair[1]) {
            return Err("knots in descending order".to_owned());
        }
        let all_count = weights.is_empty() || weights.len() == points.len();
        if !all_count || weights.iter().any(|&weight| weight <= 0.0) {
            return Err(
                "a number of weights other than that of control points, or a weight of 0 or less"
                    .to_owned(),
            );
        }
        let weights = weights.iter().copied().chain(std::iter::repeat(1.0));
        let controls = points
            .iter()
            .zip(weights)
            .map(|(&p, weight)| (p.to_vec2() * weight, weight));
        Ok(Self {
            degree,
            controls: controls.collect(),
            knots,
        })
    }

    /// Its corners within a tolerance; `None` for more than `most`.
    pub(super) fn points(&self, tolerance: f64, most: usize) -> Option<Vec<Point>> {
        let spans = self.degree..self.controls.len();
        let mut points = Vec::new();
        for span in spans.filter(|&i| self.knots[i] < self.knots[i + 1]) {
            let (begin, end) = (self.knots[span], self.knots[span + 1]);
            if points.is_empty() {
                points.push(self.at(span, begin));
            }
            for i in 0..PIECES {
                let at = |i: u32| begin + (end - begin) * (f64::from(i) / f64::from(PIECES));
                let from = *points.last()?;
                let piece = [(at(i), from), (at(i + 1), self.at(span, at(i + 1)))];
                self.piece(span, piece, tolerance, DEPTH, &mut points);
                if points.len() > most {
                    return None;
                }
            }
        }
        Some(points)
    }

    /// Halves a piece until the curve stays near its chord, tested at a quarter and at its middle.
    fn piece(
        &self,
        span: usize,
        [(begin, from), (end, to)]: [(f64, Point); 2],
        tolerance: f64,
        depth: u32,
        points: &mut Vec<Point>,
    ) {
        let at = |share: f64| begin + (end - begin) * share;
        let middle = self.at(span, at(0.5));
        let probes = [self.at(span, at(0.25)), middle, self.at(span, at(0.75))];
        let chord = Line::new(from, to);
        let is_near = |p: &Point| chord.nearest(*p, 0.0).distance_sq.sqrt() <= tolerance / 2.0;
        if depth == 0 || probes.iter().all(is_near) {
            points.push(to);
            return;
        }
        let half = (at(0.5), middle);
        self.piece(span, [(begin, from), half], tolerance, depth - 1, points);
        self.piece(span, [half, (end, to)], tolerance, depth - 1, points);
    }

    fn at(&self, span: usize, t: f64) -> Point {
        let degree = self.degree;
        let mut row = [(Vec2::ZERO, 0.0); MAX_DEGREE + 1];
        row[..=degree].copy_from_slice(&self.controls[span - degree..=span]);
        for level in 1..=degree {
            for i in (level..=degree).rev() {
                let low = self.knots[i + span - degree];
                let high = self.knots[i + 1 + span - level];
                let share = (t - low) / (high - low);
                let (before, here) = (row[i - 1], row[i]);
                let weight = before.1 + (here.1 - before.1) * share;
                row[i] = (before.0.lerp(here.0, share), weight);
            }
        }
        let (point, weight) = row[degree];
        (point * (1.0 / weight)).to_point()
    }
}

/// The initial number of pieces per span, so that no wave lies between the test points.
const PIECES: u32 = 6;
const MAX_DEGREE: usize = 15;
/// The largest number of halvings of a piece.
const DEPTH: u32 = 12;
