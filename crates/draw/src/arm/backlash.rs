//! Backlash compensation: where a joint reverses, its motor first turns through the gap.
//!
//! ```text
//!   calibrated    a -------- b -------- c        at b a joint reverses
//!   raw           a -------- b, b' ----- c'      b' takes up the backlash: the tool stays in place
//! ```
//!
//! The height is not changed: the pen's spring absorbs more.

use dobot_arm::{Calibration, Joints, Pose, Position, Tool, forward, inverse};
use dobot_geometry::{Point, Stroke};
use dobot_plan::{DrawingTool, Paper, Pass};

/// Compensates the backlash in passes, which must be in drawing order.
pub(crate) fn compensated(passes: Vec<Pass>, paper: &Paper, arm: &Calibration) -> Vec<Pass> {
    if arm.backlash_deg == [0.0; 3] {
        return passes;
    }
    let mut walk = Walk {
        paper,
        arm,
        tool: Tool::SuctionCup,
        lift_mm: 0.0,
        turned_deg: [0.0; 3],
        at: None,
    };
    let pass = |pass: Pass| {
        walk.tool = pass.tool.end_effector();
        walk.lift_mm = match &pass.tool {
            DrawingTool::Pen(pen) => pen.lift_mm,
            DrawingTool::Laser(_) => 0.0,
        };
        let strokes = pass
            .strokes
            .into_iter()
            .map(|stroke| walk.stroke(stroke))
            .collect();
        Pass { strokes, ..pass }
    };
    passes.into_iter().map(pass).collect()
}

/// Returns the maximum distance between commanded and actual position, in mm.
pub(crate) fn most_mm(arm: &Calibration) -> f64 {
    let slack_deg: f64 = arm.backlash_deg.iter().sum();
    slack_deg.to_radians() * FARTHEST_MM
}

/// Walks along all strokes and tracks the direction in which each joint turned last.
struct Walk<'a> {
    paper: &'a Paper,
    arm: &'a Calibration,
    tool: Tool,
    lift_mm: f64,
    turned_deg: [f64; 3],
    /// The end of the last stroke.
    at: Option<Point>,
}

impl Walk<'_> {
    fn stroke(&mut self, stroke: Stroke) -> Stroke {
        let Some(&first) = stroke.points.first() else {
            return stroke;
        };
        self.arrive(first);
        let mut points = vec![self.raw(first)];
        for pair in stroke.points.windows(2) {
            for (from, to) in even(pair[0], pair[1], |at| self.joints(at, 0.0)) {
                let before = self.turned_deg;
                self.turn(self.joints(from, 0.0), self.joints(to, 0.0));
                if before.map(f64::is_sign_negative) != self.turned_deg.map(f64::is_sign_negative) {
                    points.push(self.raw(from));
                }
                points.push(self.raw(to));
            }
        }
        points.dedup_by(|a, b| a.distance(*b) < SAME_MM);
        self.at = stroke.points.last().copied();
        Stroke { points, ..stroke }
    }

    /// Moves to a stroke: across, then down.
    fn arrive(&mut self, first: Point) {
        if let Some(at) = self.at {
            let near = at.lerp(first, NEARLY_THERE);
            self.turn(
                self.joints(near, self.lift_mm),
                self.joints(first, self.lift_mm),
            );
        }
        if self.lift_mm > 0.0 {
            let [above, below] = [self.lift_mm, 0.0].map(|above_mm| self.joints(first, above_mm));
            let base = self.turned_deg[0];
            self.turn(above, below);
            self.turned_deg[0] = base;
        }
    }

    fn turn(&mut self, from: Option<Joints>, to: Option<Joints>) {
        let Some((from, to)) = from.zip(to) else {
            return;
        };
        let turned = [
            to.base - from.base,
            to.rear - from.rear,
            to.fore - from.fore,
        ];
        for (last, turned) in self.turned_deg.iter_mut().zip(turned) {
            if turned.0.abs() > STILL_DEG {
                *last = turned.0;
            }
        }
    }

    fn joints(&self, at: Point, above_mm: f64) -> Option<Joints> {
        let pose = Pose {
            position: Position::new(at.x, at.y, self.paper.z_at(at) + above_mm),
            ..Pose::default()
        };
        inverse(&pose, self.tool).ok()
    }

    /// Returns the commanded place on the paper for the tool to be over the wanted one.
    fn raw(&self, wanted: Point) -> Point {
        let mut raw = wanted;
        for _ in 0..ROUNDS {
            let Some(motors) = self.joints(raw, 0.0) else {
                return wanted;
            };
            let joints = self.arm.joints_at(&motors, self.turned_deg);
            let there = forward(&joints, self.tool).position;
            raw += wanted - Point::new(there.x.0, there.y.0);
        }
        raw
    }
}

/// Splits a line where a joint reverses.
fn even(from: Point, to: Point, joints: impl Fn(Point) -> Option<Joints>) -> Vec<(Point, Point)> {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a line is not that long"
    )]
    let parts = (from.distance(to) / LOOK_MM).ceil().clamp(1.0, 1000.0) as u32;
    let at = |part: u32| from.lerp(to, f64::from(part) / f64::from(parts));
    let signs = |part: u32| {
        let (a, b) = joints(at(part)).zip(joints(at(part + 1)))?;
        Some([b.base - a.base, b.rear - a.rear, b.fore - a.fore].map(|angle| angle.0 > 0.0))
    };
    let mut ends = vec![from];
    ends.extend(
        (1..parts)
            .filter(|&part| signs(part - 1) != signs(part))
            .map(at),
    );
    ends.push(to);
    ends.windows(2).map(|pair| (pair[0], pair[1])).collect()
}

/// The maximum distance of a tool from a joint, in mm.
const FARTHEST_MM: f64 = 350.0;
/// The number of iterations: each one reduces the error to a hundredth.
const ROUNDS: usize = 4;
/// The angle below which a joint does not turn.
const STILL_DEG: f64 = 1e-4;
/// The length of the pieces in which a line is examined.
const LOOK_MM: f64 = 1.0;
/// The end of a path shows the direction of the joints there.
const NEARLY_THERE: f64 = 0.99;
/// The distance below which two points are equal.
const SAME_MM: f64 = 1e-6;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_plan::Pen;

    use super::*;

    const SLACK: Calibration = Calibration {
        backlash_deg: [0.3, 0.25, 0.4],
        table: None,
        ..Calibration::NONE
    };

    /// Returns the path of the tool: each joint follows its motor through its gap.
    fn drawn(raw: &[Point], paper: &Paper, mut joints: Joints) -> Vec<Point> {
        let walk = Walk {
            paper,
            arm: &SLACK,
            tool: Tool::SuctionCup,
            lift_mm: 0.0,
            turned_deg: [0.0; 3],
            at: None,
        };
        let follow = |joint: f64, motor: f64, slack: f64| joint.max(motor).min(motor + slack);
        let mut drawn = Vec::new();
        for pair in raw.windows(2) {
            for part in 0..=20 {
                let at = pair[0].lerp(pair[1], f64::from(part) / 20.0);
                let motors = walk.joints(at, 0.0).unwrap();
                let [base, rear, fore] = SLACK.backlash_deg;
                joints = Joints::new(
                    follow(joints.base.0, motors.base.0, base),
                    follow(joints.rear.0, motors.rear.0, rear),
                    follow(joints.fore.0, motors.fore.0, fore),
                    0.0,
                );
                let there = forward(&joints, Tool::SuctionCup).position;
                drawn.push(Point::new(there.x.0, there.y.0));
            }
        }
        drawn
    }

    #[test]
    fn a_circle_drawn_by_an_arm_with_backlash_is_round() {
        let paper = Paper::default();
        let middle = Point::new(210.0, 0.0);
        let circle: Vec<Point> = (0..=120)
            .map(|n| f64::from(n) * std::f64::consts::TAU / 120.0)
            .map(|a| Point::new(middle.x + 30.0 * a.cos(), middle.y + 30.0 * a.sin()))
            .collect();
        let pass = |points: &[Point]| Pass {
            strokes: vec![Stroke {
                points: points.to_vec(),
                ..Stroke::default()
            }],
            ..Pass::new(DrawingTool::Pen(Pen::default()), Vec::new())
        };
        let off_mm = |raw: &[Point]| {
            // The pen came down on to the paper, which turned rear arm and forearm.
            let walk = Walk {
                paper: &paper,
                arm: &SLACK,
                tool: Tool::SuctionCup,
                lift_mm: 5.0,
                turned_deg: [0.0; 3],
                at: None,
            };
            let above = walk.joints(raw[0], 5.0).unwrap();
            let ink = drawn(raw, &paper, above);
            let off = ink
                .iter()
                .skip(30)
                .map(|p| (p.distance(middle) - 30.0).abs());
            off.fold(0.0, f64::max)
        };
        let raw = compensated(vec![pass(&circle)], &paper, &SLACK);
        let (before, after) = (off_mm(&circle), off_mm(&raw[0].strokes[0].points));
        assert!(before > 0.8, "{before} mm without");
        // While the backlash of one joint is taken up, the others turn slightly too.
        assert!(after < 0.3, "{after} mm with it, {before} without");
    }

    #[test]
    fn a_line_on_which_no_joint_turns_back_is_unchanged() {
        let walk = |at: Point| {
            inverse(
                &Pose {
                    position: Position::new(at.x, at.y, -40.0),
                    ..Pose::default()
                },
                Tool::SuctionCup,
            )
            .ok()
        };
        let (from, to) = (Point::new(200.0, 20.0), Point::new(200.0, 60.0));
        assert_eq!(even(from, to, walk), [(from, to)]);
        let across = even(Point::new(200.0, -40.0), to, walk);
        assert_eq!(
            across.len(),
            2,
            "the reach is least in the middle: {across:?}"
        );
    }
}
