//! Detection of strokes burned too slowly, and so too dark.

use crate::{DrawingTool, MoveKind, Plan, PlannedPass, PlannedVector};

/// The part of a pass burned below the requested speed because of corners, short vectors or the
/// link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlowBurning {
    /// The length burned slowly, in mm.
    pub slow_mm: f64,
    /// The total burned length, in mm.
    pub burned_mm: f64,
    /// The speed that all but 5 % of the length reaches, in mm/s: at this speed the pass burns
    /// evenly.
    pub even_mm_s: f64,
}

impl Plan {
    /// Returns the part of a pass burned below the laser's speed; `None` if it is negligible, and
    /// for a pen.
    #[must_use]
    pub fn slow_burning(&self, pass: &PlannedPass) -> Option<SlowBurning> {
        let DrawingTool::Laser(laser) = pass.tool else {
            return None;
        };
        let moves = self.moves[pass.moves.clone()].iter();
        let burned = moves.filter(|vector| vector.kind == MoveKind::Burn);
        let mut burned: Vec<[f64; 2]> = burned.map(speed_and_length).collect();
        burned.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let sum_mm = |burned: &[[f64; 2]]| burned.iter().map(|row| row[1]).sum::<f64>();
        let is_slow = |row: &[f64; 2]| row[0] * SLOW < laser.burn_speed_mm_s;
        let burned_mm = sum_mm(&burned);
        let slow_mm = sum_mm(&burned[..burned.partition_point(is_slow)]);
        let negligible_mm = SEEN_SHARE * burned_mm;
        let mut passed_mm = 0.0;
        let even = burned.iter().find(|row| {
            passed_mm += row[1];
            passed_mm > negligible_mm
        })?;
        (slow_mm > negligible_mm).then_some(SlowBurning {
            slow_mm,
            burned_mm,
            even_mm_s: even[0],
        })
    }
}

fn speed_and_length(vector: &PlannedVector) -> [f64; 2] {
    let length_mm = vector.length_mm();
    [length_mm / f64::from(vector.duration_s), length_mm]
}

/// A burning time this many times as long is visibly darker.
const SLOW: f64 = 1.25;
/// The largest share of the length that is negligible.
const SEEN_SHARE: f64 = 0.05;

#[cfg(test)]
mod tests {
    use dobot_geometry::{Point, Stroke};

    use crate::{ArmLimits, DrawingTool, Laser, Paper, Pass, Plan, SlowBurning};

    fn slow_burning(strokes: Vec<Stroke>, burn_speed_mm_s: f64) -> Option<SlowBurning> {
        let laser = Laser {
            burn_speed_mm_s,
            ..Laser::default()
        };
        let pass = Pass::new(DrawingTool::Laser(laser), strokes);
        let plan = Plan::new(&[pass], &Paper::level(-40.0), &ArmLimits::default()).expect("a plan");
        plan.slow_burning(&plan.passes[0])
    }

    fn line(points: &[(f64, f64)]) -> Stroke {
        Stroke::open(points.iter().map(|p| Point::new(p.0, p.1)).collect())
    }

    #[test]
    fn a_line_is_burned_at_the_requested_speed() {
        let lines = vec![line(&[(200.0, 0.0), (230.0, 0.0)])];
        assert_eq!(slow_burning(lines, 30.0), None);
    }

    #[test]
    fn a_line_slowed_down_by_the_link_is_reported_and_even_at_the_reported_speed() {
        // Its packets take 80 ms each: 20 vectors of 0.8 mm allow 10 mm/s.
        let row: Vec<(f64, f64)> = (0..=20)
            .map(|i| (200.0 + 0.8 * f64::from(i), 0.0))
            .collect();
        let strokes = vec![line(&row), line(&[(200.0, 10.0), (232.0, 10.0)])];
        let found = slow_burning(strokes.clone(), 30.0).expect("16 of 48 mm are slow");
        assert!((found.burned_mm - 48.0).abs() < 0.1, "{found:?}");
        assert!(found.slow_mm > 8.0 && found.slow_mm < 16.1, "{found:?}");
        assert!(found.even_mm_s > 9.0 && found.even_mm_s < 24.0, "{found:?}");
        assert_eq!(slow_burning(strokes, found.even_mm_s), None);
    }
}
