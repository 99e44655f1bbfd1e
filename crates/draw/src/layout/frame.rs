//! The outline of a drawing, traced before drawing to check its position.

use dobot_geometry::{Point, Rect, Stroke, bounds};
use dobot_plan::{ArmLimits, DrawingTool, MoveKind, Paper, Pass, Pen, Plan, PlanError, detour};

/// The shape of the outline.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FrameShape {
    /// The bounding rectangle of the ink.
    #[default]
    Rectangle,
    /// The convex hull of the ink.
    Hull,
}

/// Plans a closed path around the ink of the passes at travel speed, with the pen up, or with the
/// laser off at its burning height. For a single dot, the plan only moves there.
///
/// # Errors
///
/// [`PlanError`] if there is no ink or a setting is invalid.
pub fn frame(
    passes: &[Pass],
    paper: &Paper,
    arm_limits: &ArmLimits,
    shape: FrameShape,
) -> Result<Plan, PlanError> {
    let strokes = || passes.iter().flat_map(|pass| &pass.strokes);
    let points: Vec<Point> = strokes()
        .flat_map(|stroke| stroke.points.iter().copied())
        .collect();
    let first = passes.first().filter(|_| !points.is_empty());
    let tool = first.ok_or(PlanError::NoStrokes)?.tool;
    let outline = match shape {
        FrameShape::Rectangle => rectangle(bounds(points)),
        FrameShape::Hull => hull(points),
    };
    let outline = around_arm(&outline, arm_limits.nearest_mm);
    let highest_mm = passes
        .iter()
        .map(|pass| pass.tool.lift_mm())
        .fold(0.0, f64::max);
    // Plan with a pen; the lowering is removed below.
    let pen = Pen {
        lift_mm: LIFT_MM,
        draw_speed_mm_s: tool.travel_speed_mm_s(),
        touch_mm: 0.0,
        ..Pen::default()
    };
    let pass = Pass {
        name: "frame".to_owned(),
        ..Pass::new(DrawingTool::Pen(pen), vec![outline])
    };
    let plan = Plan::new(
        &[pass],
        &paper.clone().raised(highest_mm - LIFT_MM),
        arm_limits,
    )?;
    Ok(without_ink(plan, tool))
}

/// Returns the outline with detours around the arm's own position.
fn around_arm(outline: &Stroke, nearest_mm: f64) -> Stroke {
    let legs = outline.segments();
    let points = legs.flat_map(|(a, b)| [vec![a], detour(a, b, nearest_mm)].concat());
    Stroke {
        points: points.chain(outline.last()).collect(),
        ..*outline
    }
}

/// Removes lowering and lifting from a plan: the rest is travel with the original tool.
fn without_ink(mut plan: Plan, tool: DrawingTool) -> Plan {
    plan.moves.retain(|vector| vector.kind.marks());
    for vector in &mut plan.moves {
        vector.kind = MoveKind::Travel;
    }
    for pass in &mut plan.passes {
        pass.tool = tool;
        pass.moves = 0..plan.moves.len();
    }
    plan
}

fn rectangle(Rect { x0, y0, x1, y1 }: Rect) -> Stroke {
    let corners = [(x1, y1), (x1, y0), (x0, y0), (x0, y1)];
    Stroke::ring(corners.map(|(x, y)| Point::new(x, y)).to_vec())
}

/// Returns the convex hull: lower and upper chain of the points from left to right.
fn hull(mut points: Vec<Point>) -> Stroke {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    if points.len() < 3 {
        return Stroke::ring(points);
    }
    let mut around = chain(points.iter().copied());
    around.pop();
    around.extend(chain(points.iter().rev().copied()));
    around.pop();
    Stroke::ring(around)
}

/// Returns the points of a chain with all others to the left.
fn chain(points: impl Iterator<Item = Point>) -> Vec<Point> {
    let mut chain: Vec<Point> = Vec::new();
    for p in points {
        while let [.., a, b] = chain[..]
            && (b - a).cross(p - a) <= 0.0
        {
            chain.pop();
        }
        chain.push(p);
    }
    chain
}

/// The minimum lift of a pen; removed from the plan again.
const LIFT_MM: f64 = 0.1;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_wire::Command;
    use proptest::prelude::*;

    use super::*;
    use dobot_plan::Laser;

    fn cross() -> Vec<Stroke> {
        let line = |points: [(f64, f64); 2]| {
            Stroke::open(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
        };
        vec![
            line([(200.0, 0.0), (220.0, 0.0)]),
            line([(210.0, -30.0), (210.0, 30.0)]),
        ]
    }

    fn around(tool: DrawingTool, shape: FrameShape) -> Plan {
        let passes = [Pass::new(tool, cross())];
        frame(&passes, &Paper::level(-40.0), &ArmLimits::default(), shape).unwrap()
    }

    /// Returns the number of turns between start and end.
    fn turns(plan: &Plan) -> usize {
        let places: Vec<[f64; 3]> = std::iter::once(plan.start)
            .chain(plan.positions())
            .collect();
        let ways = places.windows(2);
        let angles: Vec<f64> = ways
            .map(|pair| (pair[1][1] - pair[0][1]).atan2(pair[1][0] - pair[0][0]))
            .collect();
        let turns = angles.windows(2);
        turns
            .filter(|pair| (pair[1] - pair[0]).abs() > 0.01)
            .count()
    }

    #[test]
    fn a_pen_goes_around_the_rectangle_without_touching_the_paper() {
        let pen = Pen {
            lift_mm: 7.0,
            ..Pen::default()
        };
        let plan = around(DrawingTool::Pen(pen), FrameShape::Rectangle);
        assert!((plan.start[2] + 33.0).abs() < 1e-9, "{:?}", plan.start);
        let places: Vec<[f64; 3]> = plan.positions().collect();
        assert!(
            places.iter().all(|place| (place[2] + 33.0).abs() < 1e-5),
            "{places:?}"
        );
        let seen = bounds(places.iter().map(|place| Point::new(place[0], place[1])));
        assert_eq!(seen, Rect::new(200.0, -30.0, 220.0, 30.0));
        assert_eq!(turns(&plan), 3);
        assert_eq!(places.last().unwrap()[..2], plan.start[..2]);
        assert_eq!(plan.summary().drawn_mm, 0.0);
        assert_eq!(plan.summary().travelled_mm.round(), 160.0);
    }

    #[test]
    fn a_laser_goes_around_switched_off_at_its_burning_height() {
        let plan = around(DrawingTool::Laser(Laser::default()), FrameShape::Rectangle);
        assert!(plan.burns());
        assert!((plan.start[2] + 40.0).abs() < 1e-9, "{:?}", plan.start);
        for command in plan.commands() {
            if let Command::WriteVector(vector) = command {
                assert!(!vector.laser && vector.z_mm.abs() < 1e-6, "{vector:?}");
            }
        }
    }

    #[test]
    fn the_hull_is_shorter_than_the_rectangle() {
        let plan = around(DrawingTool::default(), FrameShape::Hull);
        // A rhombus with half diagonals of 10 and 30 mm.
        let length = 4.0 * 10.0_f64.hypot(30.0);
        assert!((plan.summary().travelled_mm - length).abs() < 1e-3);
        assert_eq!(turns(&plan), 3);
    }

    #[test]
    fn the_frame_of_a_dot_is_a_point_and_an_empty_drawing_has_none() {
        let around = |strokes, shape| {
            let passes = [Pass::new(DrawingTool::default(), strokes)];
            frame(&passes, &Paper::default(), &ArmLimits::default(), shape)
        };
        for shape in [FrameShape::Rectangle, FrameShape::Hull] {
            let dot = vec![Stroke::open(vec![Point::new(200.0, 3.0)])];
            let plan = around(dot, shape).unwrap();
            assert_eq!((plan.moves.len(), plan.start), (0, [200.0, 3.0, -30.0]));
            assert_eq!(around(vec![], shape), Err(PlanError::NoStrokes));
        }
    }

    proptest! {
        #[test]
        fn the_hull_is_convex_and_holds_every_point(
            points in proptest::collection::vec((-9..9_i32, -9..9_i32), 1..40),
        ) {
            let points: Vec<Point> = points
                .into_iter()
                .map(|(x, y)| Point::new(f64::from(x), f64::from(y)))
                .collect();
            let hull = hull(points.clone());
            for (a, b) in hull.segments() {
                for &p in &points {
                    prop_assert!((b - a).cross(p - a) >= 0.0, "{:?} {:?}", hull, p);
                }
            }
            prop_assert!(hull.points.iter().all(|p| points.contains(p)));
        }
    }
}
