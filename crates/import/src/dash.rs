//! Dashed lines.

use dobot_geometry::{Point, Stroke};

use crate::limits::{Budget, OverBudget};

/// Cuts a stroke into dashes: alternating `lengths` of pen down and pen up, starting `offset` into
/// the pattern. A dash of length zero is a dot. A pattern of total length zero leaves the stroke
/// whole.
///
/// kurbo can do this too, but does not terminate within reasonable time for billions of dashes.
pub(crate) fn dash(
    stroke: Stroke,
    lengths: &[f64],
    offset: f64,
    budget: &mut Budget,
) -> Result<Vec<Stroke>, OverBudget> {
    let lengths: Vec<f64> = lengths.iter().map(|length| length.max(0.0)).collect();
    let period: f64 = 2.0 * lengths.iter().sum::<f64>();
    if period <= 0.0 || !period.is_finite() {
        return Ok(vec![stroke]);
    }
    let mut cutter = Cutter::new(&lengths, offset.rem_euclid(period));
    cutter.begin(stroke.points[0]);
    for (a, b) in stroke.segments() {
        cutter.advance(a, b, budget)?;
    }
    cutter.finish();
    Ok(cutter.dashes)
}

/// Cuts a stroke into dashes fitted to each of its lines: between corners there are whole periods,
/// stretched or shrunk, with half of the first dash at both ends. A line whose period would be
/// shorter than `least`, or that would have more than `most` periods, stays whole.
///
/// ```text
///   --  ----  ----  --.      Two lines of three turns and one.
///                     |
///
///                     |
/// ```
pub(crate) fn fitted_dashes(
    stroke: Stroke,
    lengths: &[f64],
    [least, most]: [f64; 2],
    budget: &mut Budget,
) -> Result<Vec<Stroke>, OverBudget> {
    let period: f64 = lengths.iter().sum();
    if stroke.points.len() < 2 || period <= 0.0 || !period.is_finite() {
        return Ok(vec![stroke]);
    }
    let mut dashes: Vec<Stroke> = Vec::new();
    for line in lines_between_corners(&stroke.points) {
        let line = Stroke::open(line.to_vec());
        let length = line.length_mm();
        let turns = (length / period).round().max(1.0);
        let turn = length / turns;
        let pieces = if turn < least || turns > most {
            vec![line]
        } else {
            let fitted: Vec<f64> = lengths
                .iter()
                .map(|length| length * turn / period)
                .collect();
            dash(line, &fitted, 0.5 * fitted[0], budget)?
        };
        // The half dashes at a corner are joined.
        let mut pieces = pieces.into_iter().peekable();
        if let (Some(last), Some(first)) = (dashes.last_mut(), pieces.peek())
            && last.last() == Some(first.points[0])
        {
            last.points.extend_from_slice(&first.points[1..]);
            pieces.next();
        }
        dashes.extend(pieces);
    }
    Ok(dashes)
}

/// The parts of a line between its corners; smaller turns belong to curves.
fn lines_between_corners(points: &[Point]) -> Vec<&[Point]> {
    let mut lines = Vec::new();
    let mut from = 0;
    for i in 1..points.len() - 1 {
        let (before, after) = (points[i] - points[i - 1], points[i + 1] - points[i]);
        let turn_rad = before.cross(after).atan2(before.dot(after)).abs();
        if turn_rad > CORNER_RAD {
            lines.push(&points[from..=i]);
            from = i;
        }
    }
    lines.push(&points[from..]);
    lines
}

struct Cutter<'a> {
    lengths: &'a [f64],
    /// The index of the current length; even ones are drawn.
    turn: usize,
    left: f64,
    dashes: Vec<Stroke>,
    current: Vec<Point>,
}

impl<'a> Cutter<'a> {
    fn new(lengths: &'a [f64], offset: f64) -> Self {
        let mut cutter = Self {
            lengths,
            turn: 0,
            left: lengths[0],
            dashes: Vec::new(),
            current: Vec::new(),
        };
        let mut offset = offset;
        while offset >= cutter.left && offset > 0.0 {
            offset -= cutter.left;
            cutter.next_turn();
        }
        cutter.left -= offset;
        cutter
    }

    fn begin(&mut self, at: Point) {
        if self.turn.is_multiple_of(2) {
            self.current.push(at);
        }
    }

    fn advance(&mut self, a: Point, b: Point, budget: &mut Budget) -> Result<(), OverBudget> {
        let length = a.distance(b);
        let mut done = 0.0;
        while length - done > self.left {
            budget.spend(1)?;
            done += self.left;
            let at = a.lerp(b, done / length);
            self.begin(at);
            self.finish();
            self.next_turn();
            self.begin(at);
        }
        self.left -= length - done;
        self.begin(b);
        Ok(())
    }

    fn finish(&mut self) {
        let mut points = std::mem::take(&mut self.current);
        points.dedup();
        if !points.is_empty() {
            self.dashes.push(Stroke::open(points));
        }
    }

    fn next_turn(&mut self) {
        self.turn += 1;
        self.left = self.lengths[self.turn % self.lengths.len()];
    }
}

/// The largest turn within a curve: plotters turn 5 degrees from chord to chord.
const CORNER_RAD: f64 = 0.2;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    fn dashes(lengths: &[f64], offset: f64) -> Vec<(f64, f64)> {
        let line = Stroke::open(vec![
            Point::new(0.0, 0.0),
            Point::new(4.0, 0.0),
            Point::new(10.0, 0.0),
        ]);
        let strokes = dash(line, lengths, offset, &mut Budget::new(1000)).unwrap();
        strokes
            .iter()
            .map(|s| (s.points[0].x, s.last().unwrap().x))
            .collect()
    }

    #[test]
    fn dashes_and_gaps_take_turns_across_corners() {
        assert_eq!(dashes(&[3.0, 2.0], 0.0), [(0.0, 3.0), (5.0, 8.0)]);
    }

    #[test]
    fn an_offset_starts_further_along_the_pattern() {
        assert_eq!(
            dashes(&[3.0, 2.0], 1.0),
            [(0.0, 2.0), (4.0, 7.0), (9.0, 10.0)]
        );
        assert_eq!(dashes(&[3.0, 2.0], -1.0), [(1.0, 4.0), (6.0, 9.0)]);
    }

    #[test]
    fn an_odd_pattern_swaps_dashes_and_gaps_in_each_round() {
        assert_eq!(dashes(&[4.0], 0.0), [(0.0, 4.0), (8.0, 10.0)]);
    }

    #[test]
    fn dashes_without_length_are_dots() {
        assert_eq!(
            dashes(&[0.0, 4.0], 0.0),
            [(0.0, 0.0), (4.0, 4.0), (8.0, 8.0)]
        );
    }

    #[test]
    fn fitted_dashes_have_whole_periods_between_corners_and_lines_that_are_too_short_stay_whole() {
        let fitted = |points: &[(f64, f64)]| {
            let points = points.iter().map(|&(x, y)| Point::new(x, y)).collect();
            let limits = [0.5, 1000.0];
            let budget = &mut Budget::new(1000);
            fitted_dashes(Stroke::open(points), &[4.0, 2.0], limits, budget).unwrap()
        };
        let ends = |stroke: &Stroke| [stroke.points[0], stroke.last().unwrap()].map(|p| (p.x, p.y));
        let found: Vec<_> = fitted(&[(0.0, 0.0), (6.0, 0.3), (12.0, 0.0), (12.0, 3.0)])
            .iter()
            .map(ends)
            .map(|fitted| fitted.map(|(x, y)| (x.round(), y.round())))
            .collect();
        assert_eq!(
            found,
            [
                [(0.0, 0.0), (2.0, 0.0)],
                [(4.0, 0.0), (8.0, 0.0)],
                [(10.0, 0.0), (12.0, 1.0)],
                [(12.0, 2.0), (12.0, 3.0)],
            ]
        );
        assert_eq!(fitted(&[(0.0, 0.0), (0.4, 0.0)]).len(), 1);
        assert_eq!(fitted(&[(1.0, 1.0)]).len(), 1);
    }

    #[test]
    fn a_billion_dashes_are_refused() {
        let line = Stroke::open(vec![Point::new(0.0, 0.0), Point::new(1e9, 0.0)]);
        dash(line, &[1.0], 0.0, &mut Budget::new(1000)).unwrap_err();
    }
}
