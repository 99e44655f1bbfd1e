//! The ink on the paper.

use dobot_arm::Position;
use dobot_geometry::{PathDistance, Point, Stroke};
use dobot_plan::{Paper, Plan};

/// A line on the paper and its deviation from the wanted path.
#[derive(Clone, Debug, PartialEq)]
pub struct InkLine {
    /// The line, or a dot.
    pub stroke: Stroke,
    /// The distance of each point from the wanted path, in mm.
    pub errors_mm: Vec<f64>,
    /// The pass that drew it, from 0.
    pub pass: u32,
}

impl InkLine {
    /// Compares observed ink with the wanted path. Everything is assigned to pass 0, because passes
    /// are not observable.
    #[must_use]
    pub fn measured(seen: Vec<Stroke>, wanted: &[Stroke]) -> Vec<Self> {
        let mut near = PathDistance::new(wanted);
        let mut measure = |stroke: Stroke| Self {
            errors_mm: stroke.points.iter().map(|&p| near.distance_mm(p)).collect(),
            stroke,
            pass: 0,
        };
        seen.into_iter().map(&mut measure).collect()
    }
}

/// Returns the positions at which a pen was observed writing, from statuses; between two statuses
/// its path is unknown.
///
/// Writing counts from the first position with the pen up, at half its lift: an arm that stands on
/// the paper before it draws has drawn nothing. A laser is not visible in a status, so it has no
/// ink.
#[must_use]
pub fn ink_seen(
    path: impl IntoIterator<Item = Position>,
    plan: &Plan,
    paper: &Paper,
) -> Vec<Stroke> {
    if plan.burns() {
        return Vec::new();
    }
    let up_mm = plan.lift_mm() / 2.0;
    path.into_iter()
        .skip_while(|&at| paper.height_mm(at) < up_mm)
        .filter(|&at| writes(at, paper))
        .map(|at| Stroke::open(vec![point(at)]))
        .collect()
}

/// Whether a pen writes: at most 0.05 mm above the paper.
pub(crate) fn writes(at: Position, paper: &Paper) -> bool {
    paper.height_mm(at) <= TOUCHING_MM
}

pub(crate) const fn point(at: Position) -> Point {
    Point::new(at.x.0, at.y.0)
}

const TOUCHING_MM: f64 = 0.05;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use dobot_plan::{ArmLimits, DrawingTool, Laser, Pass};

    fn plan(tool: DrawingTool) -> Plan {
        let line = Stroke::open(vec![Point::new(200.0, 0.0), Point::new(210.0, 0.0)]);
        let pass = Pass::new(tool, vec![line]);
        Plan::new(&[pass], &Paper::level(-40.0), &ArmLimits::default()).unwrap()
    }

    fn seen(path: &[(f64, f64)], tool: DrawingTool) -> Vec<f64> {
        let path = path.iter().map(|&(x, z)| Position::new(x, 0.0, z));
        let dots = ink_seen(path, &plan(tool), &Paper::level(-40.0));
        assert!(dots.iter().all(|dot| dot.points.len() == 1));
        dots.iter().map(|dot| dot.points[0].x).collect()
    }

    #[test]
    fn statuses_give_dots_and_no_lines_between_them() {
        let path = [
            (200.0, -30.0),
            (200.0, -40.0),
            (205.0, -40.0),
            (210.0, -38.0),
            (209.0, -40.0),
        ];
        assert_eq!(seen(&path, DrawingTool::default()), [200.0, 205.0, 209.0]);
    }

    #[test]
    fn the_place_of_the_arm_on_the_paper_before_drawing_is_not_ink() {
        let path = [
            (150.0, -40.0),
            (150.0, -40.0),
            (150.0, -20.0),
            (200.0, -30.0),
            (200.0, -40.0),
        ];
        assert_eq!(seen(&path, DrawingTool::default()), [200.0]);
    }

    #[test]
    fn the_statuses_of_a_laser_show_no_ink() {
        let path = [(200.0, -40.0), (210.0, -40.0)];
        assert_eq!(seen(&path, DrawingTool::Laser(Laser::default())), [0.0; 0]);
    }

    #[test]
    fn the_drawn_ink_is_compared_with_the_wanted_one() {
        let wanted = [Stroke::open(vec![
            Point::new(0.0, 0.0),
            Point::new(9.0, 0.0),
        ])];
        let seen = vec![Stroke::open(vec![
            Point::new(3.0, 0.25),
            Point::new(3.0, -0.5),
        ])];
        let measured = InkLine::measured(seen.clone(), &wanted);
        assert_eq!(measured[0].stroke, seen[0]);
        assert_eq!(measured[0].errors_mm, [0.25, 0.5]);
    }
}
