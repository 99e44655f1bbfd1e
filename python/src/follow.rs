//! Paths through points in space, without a stop in between.

use std::iter;

use dobot_api::problem_kinds::{BAD_JOB, OUT_OF_RANGE};
use dobot_api::{JobKind, JobProgram, NewJob, Problem};
use dobot_arm::Position;
use dobot_host::PlannedFor;
use dobot_plan::{ArmLimits, LONGEST_DRAW_S, RespeedStart, respeed};
use dobot_wire::{Command, MoveTo, MovingMode, WriteVector, single};

/// A path through points.
pub(crate) struct Follow {
    /// The points: x, y and z, in mm.
    pub(crate) points_mm: Vec<[f64; 3]>,
    /// The maximum speed, in mm/s.
    pub(crate) speed_mm_s: f64,
    pub(crate) title: String,
}

impl Follow {
    /// Returns the job for an arm: straight to the first point, then along the path.
    pub(crate) fn job(&self, arm: &PlannedFor) -> Result<NewJob, Problem> {
        self.check()?;
        let model = arm.model();
        let calibration = arm.arm();
        let tool = model.tool;
        let raw = |[x, y, z]: [f64; 3]| {
            let place = calibration.raw_place(Position::new(x, y, z), tool);
            let place = place.map_err(|error| {
                OUT_OF_RANGE.problem(format!("the point ({x}, {y}, {z}) mm: {error}"))
            })?;
            Ok([place.x.0, place.y.0, place.z.0])
        };
        let points: Vec<[f64; 3]> = self.pieces().map(raw).collect::<Result<_, Problem>>()?;
        let limits = ArmLimits::of(arm.dialect());
        let begin = RespeedStart {
            speed_mm_s: 0.0,
            position: Position::new(points[0][0], points[0][1], points[0][2]),
            tool,
        };
        let status = arm.status();
        let here = [status.x_mm, status.y_mm, status.z_mm].map(f64::from);
        let first = MoveTo {
            rotation_deg: status.rotation_deg,
            suction: model.suction,
            // Where the arm is already, a stock arm would lose its pose on a straight line (note N34).
            mode: if distance_mm(points[0], here) < HERE_MM {
                MovingMode::MovJ
            } else {
                MovingMode::MovL
            },
            gripper_deg: status.gripper_deg,
            ..MoveTo::to(
                single(points[0][0]),
                single(points[0][1]),
                single(points[0][2]),
            )
        };
        // Faster by a factor of two, all speeds are planned again.
        let vectors = respeed(&self.half_speed(&points), &begin, 2.0, &limits);
        Ok(NewJob {
            title: self.title.clone(),
            kind: JobKind::Drawing,
            commands: iter::once(first.into())
                .chain(vectors.into_iter().map(Command::from))
                .collect(),
            lift_mm: 0.0,
            pauses: Vec::new(),
            program: JobProgram::default(),
        })
    }

    fn check(&self) -> Result<(), Problem> {
        if self.points_mm.is_empty() {
            return Err(BAD_JOB.problem("points is empty; allowed are one or more points"));
        }
        let is_number = |point: &[f64; 3]| point.iter().all(|mm| mm.abs() <= FARTHEST_MM);
        if let Some(at) = self.points_mm.iter().position(|point| !is_number(point)) {
            let [x, y, z] = self.points_mm[at];
            return Err(OUT_OF_RANGE.problem(format!(
                "points[{at}] is ({x}, {y}, {z}); allowed are {FARTHEST_MM} mm or less in each direction"
            )));
        }
        if !(SLOWEST_MM_S..=FASTEST_MM_S).contains(&self.speed_mm_s) {
            return Err(OUT_OF_RANGE.problem(format!(
                "speed is {}; allowed are {SLOWEST_MM_S} to {FASTEST_MM_S} mm/s",
                self.speed_mm_s
            )));
        }
        Ok(())
    }

    /// Returns the points with further ones between them: the protocol has no stop, so no vector
    /// should take long.
    fn pieces(&self) -> impl Iterator<Item = [f64; 3]> + '_ {
        let longest_mm = self.speed_mm_s * LONGEST_DRAW_S;
        let first = self.points_mm.first().copied();
        let lines = self.points_mm.windows(2).flat_map(move |line| {
            let (from, to) = (line[0], line[1]);
            let count = (distance_mm(from, to) / longest_mm).ceil().max(1.0);
            let share = iter::successors(Some(1.0), |part| Some(part + 1.0))
                .take_while(move |part| *part <= count)
                .map(move |part| part / count);
            share.map(move |share| [0, 1, 2].map(|i| from[i] + share * (to[i] - from[i])))
        });
        first.into_iter().chain(lines)
    }

    /// Returns the vectors at half the speed, with the only rest at their end.
    fn half_speed(&self, points: &[[f64; 3]]) -> Vec<WriteVector> {
        let half_mm_s = single(self.speed_mm_s / 2.0);
        let vector = |line: &[[f64; 3]]| {
            let [x, y, z] = [0, 1, 2].map(|i| single(line[1][i] - line[0][i]));
            WriteVector {
                start_speed_mm_s: half_mm_s,
                end_speed_mm_s: half_mm_s,
                ..WriteVector::by(x, y, z, half_mm_s)
            }
        };
        let moves = |line: &&[[f64; 3]]| distance_mm(line[0], line[1]) > SHORTEST_MM;
        let lines = points.windows(2).filter(moves);
        let mut vectors: Vec<WriteVector> = lines.map(vector).collect();
        if let Some(last) = vectors.last_mut() {
            last.end_speed_mm_s = 0.0;
        }
        vectors
    }
}

fn distance_mm(from: [f64; 3], to: [f64; 3]) -> f64 {
    let [x, y, z] = [0, 1, 2].map(|i| to[i] - from[i]);
    x.hypot(y).hypot(z)
}

/// Farther points are not within reach of any arm.
const FARTHEST_MM: f64 = 1000.0;
/// Shorter vectors are left out.
const SHORTEST_MM: f64 = 1e-6;
/// A shorter way to the first point is no motion.
const HERE_MM: f64 = 0.01;
const SLOWEST_MM_S: f64 = 1.0;
const FASTEST_MM_S: f64 = 500.0;
