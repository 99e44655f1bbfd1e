//! New speeds for planned vectors, faster or slower while the arm draws.

use dobot_arm::Position;
use dobot_wire::WriteVector;

use crate::ArmLimits;
use crate::path::planner::round_down;
use crate::path::vector::length;
use crate::speed::chain::ChainSpeeds;
use crate::speed::joints::JointSpeeds;
use crate::speed::lookahead::ChainVector;
use crate::speed::objective::Objective;
use crate::ticks::ticker::Ticker;

/// The state of the arm at the start of some vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RespeedStart {
    /// The current or kept speed, in mm/s.
    pub speed_mm_s: f32,
    /// The tool position.
    pub position: Position,
    /// The tool.
    pub tool: dobot_arm::Tool,
}

/// Scales the speeds of vectors by `share`, starting with the end speed of the vector before.
///
/// 1. Slower (a share below 1): all speeds are that share of those planned. Faster: the maximum
///    speeds are multiplied, and the rest is planned again, within joint speeds, acceleration,
///    corners and link; maximum speeds set by a person do not apply.
/// 2. If the current speed does not match, the arm brakes or accelerates within its limits until it
///    does. A vector that was planned to end at rest does so, if the distance is long enough for
///    braking.
/// 3. The endpoints of vectors, their laser switches and stops are unchanged.
///
/// A share of 1 from the planned start speed changes nothing, unless the vectors were changed in
/// length since and a stock arm would miss their ends.
#[must_use]
pub fn respeed(
    vectors: &[WriteVector],
    begin: &RespeedStart,
    share: f64,
    arm_limits: &ArmLimits,
) -> Vec<WriteVector> {
    let position = begin.position;
    let mut respeeding = Respeeding {
        arm_limits,
        share,
        speed_mm_s: begin.speed_mm_s,
        here: [position.x.0, position.y.0, position.z.0],
        joints: JointSpeeds::new(arm_limits.joint_speed_deg_s, begin.tool.reach().0),
        ticker: Ticker::of(arm_limits, begin.speed_mm_s),
    };
    vectors
        .split_inclusive(|vector| vector.end_speed_mm_s == 0.0)
        .flat_map(|chain| respeeding.chain(chain))
        .collect()
}

/// Returns the speed of an arm after a vector, in mm/s, given the speed before: a stock arm ends a
/// vector at another speed than in the packet, and begins the next one with it (note N48).
#[must_use]
pub fn end_speed_mm_s(vector: &WriteVector, begin_speed_mm_s: f32, arm_limits: &ArmLimits) -> f32 {
    let ticker = Ticker::of(arm_limits, begin_speed_mm_s);
    ticker.map_or(vector.end_speed_mm_s, |mut ticker| {
        ticker.run(vector).end_mm_s
    })
}

struct Respeeding<'a> {
    arm_limits: &'a ArmLimits,
    share: f64,
    /// The end speed of the vector before.
    speed_mm_s: f32,
    /// Its end, in mm.
    here: [f64; 3],
    joints: JointSpeeds,
    ticker: Option<Ticker>,
}

impl Respeeding<'_> {
    /// Replans the speeds up to the next rest.
    fn chain(&mut self, chain: &[WriteVector]) -> Vec<WriteVector> {
        if self.share == 1.0 && self.runs_as_planned(chain) {
            for vector in chain {
                self.follow(vector);
            }
            return chain.to_vec();
        }
        let targets = if self.share > 1.0 {
            self.faster(chain)
        } else {
            slower(chain, self.share)
        };
        let most = targets.iter().map(|target| target[1]).fold(0.0, f64::max);
        // The arm may already be faster than the new maximum and needs distance to brake.
        let most_mm_s = round_down(most).max(self.speed_mm_s);
        let pairs = chain.iter().zip(targets);
        pairs
            .map(|(vector, targets)| self.vector(vector, targets, most_mm_s))
            .collect()
    }

    /// Whether the vectors end where planned from this speed, without a jerk.
    fn runs_as_planned(&self, chain: &[WriteVector]) -> bool {
        let Some(ticker) = &self.ticker else {
            return (chain[0].start_speed_mm_s - self.speed_mm_s).abs() < SAME_MM_S;
        };
        let begin_mm_s = self.speed_mm_s.min(chain[0].max_speed_mm_s);
        let is_near = (chain[0].start_speed_mm_s - begin_mm_s).abs() < ticker.step_mm_s();
        is_near && ticker.runs_exactly(chain)
    }

    fn vector(&mut self, vector: &WriteVector, targets: [f64; 2], most_mm_s: f32) -> WriteVector {
        let acceleration_mm_s2 = self.arm_limits.acceleration_mm_s2;
        let mut next = from_speed(vector, self.speed_mm_s.into(), targets, acceleration_mm_s2);
        if let Some(ticker) = &mut self.ticker {
            let rests = vector.end_speed_mm_s == 0.0;
            // A stock arm executes whole ticks only; find the closest speeds that it can execute.
            ticker.respeed(&mut next, rests, acceleration_mm_s2, most_mm_s);
        }
        self.follow(&next);
        next
    }

    /// Returns the end speed and the maximum speed of each vector.
    fn faster(&self, chain: &[WriteVector]) -> Vec<[f64; 2]> {
        let mut here = self.here;
        let mut runs: Vec<ChainVector> = Vec::with_capacity(chain.len());
        for vector in chain {
            let way = way(vector);
            let wanted_mm_s = self.share * f64::from(vector.max_speed_mm_s);
            runs.push(ChainVector::of(
                way,
                self.joints.cap(here, way, wanted_mm_s),
            ));
            here = [0, 1, 2].map(|i| here[i] + way[i]);
        }
        let mut chain_speeds = ChainSpeeds::new(self.arm_limits);
        let speeds = chain_speeds.plan_from(self.speed_mm_s.into(), &mut runs, Objective::Even);
        speeds
            .map(|speeds| [speeds.end_mm_s, speeds.max_mm_s])
            .collect()
    }

    /// Records the execution of a vector.
    fn follow(&mut self, vector: &WriteVector) {
        let way = way(vector);
        self.here = [0, 1, 2].map(|i| self.here[i] + way[i]);
        self.speed_mm_s = match &mut self.ticker {
            Some(ticker) => ticker.run(vector).end_mm_s,
            None => vector.end_speed_mm_s,
        };
    }
}

/// Returns the end speed and the maximum speed of each vector at a lower share.
fn slower(chain: &[WriteVector], share: f64) -> Vec<[f64; 2]> {
    let scaled = |vector: &WriteVector| {
        [vector.end_speed_mm_s, vector.max_speed_mm_s].map(|mm_s| share * f64::from(mm_s))
    };
    chain.iter().map(scaled).collect()
}

fn way(vector: &WriteVector) -> [f64; 3] {
    [vector.x_mm, vector.y_mm, vector.z_mm].map(f64::from)
}

/// Returns the vector with the speeds closest to the targets that are reachable from this initial
/// speed.
fn from_speed(
    vector: &WriteVector,
    begin_mm_s: f64,
    [end, max]: [f64; 2],
    acceleration_mm_s2: f64,
) -> WriteVector {
    let change_v2 = 2.0 * acceleration_mm_s2 * length(way(vector));
    let begin_v2 = begin_mm_s * begin_mm_s;
    let least = (begin_v2 - change_v2).max(0.0).sqrt();
    let most = (begin_v2 + change_v2).sqrt();
    let end_speed_mm_s = round_down(end.clamp(least, most));
    WriteVector {
        start_speed_mm_s: round_down(begin_mm_s),
        end_speed_mm_s,
        max_speed_mm_s: round_down(max.max(begin_mm_s).max(end_speed_mm_s.into())),
        ..*vector
    }
}

/// Speeds that differ by less are equal.
const SAME_MM_S: f32 = 1e-3;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_wire::Command;
    use proptest::prelude::*;

    use super::*;
    use crate::{DrawingTool, Paper, Pass, Plan};
    use dobot_geometry::{Point, Stroke};

    fn planned(points: &[(f64, f64)]) -> Vec<WriteVector> {
        let points = points.iter().map(|&(x, y)| Point::new(x, y)).collect();
        let pass = Pass::new(DrawingTool::default(), vec![Stroke::open(points)]);
        let plan = Plan::new(&[pass], &Paper::default(), &ArmLimits::default()).unwrap();
        let vectors = plan.commands().filter_map(|command| match command {
            Command::WriteVector(vector) => Some(vector),
            _ => None,
        });
        vectors.collect()
    }

    /// A start in the middle of the reach, where no joint approaches its limit.
    fn begin(speed_mm_s: f32) -> RespeedStart {
        RespeedStart {
            speed_mm_s,
            position: Position::new(200.0, 0.0, 0.0),
            tool: dobot_arm::Tool::SuctionCup,
        }
    }

    #[test]
    fn no_joint_is_overdriven_at_any_requested_speed() {
        // Past the axis of the base at 70 mm, where 100 degrees per second are 122 mm/s.
        let sideways = WriteVector {
            y_mm: 200.0,
            ..planned(&[(200.0, 0.0), (210.0, 0.0)])[1]
        };
        let sideways = WriteVector {
            x_mm: 0.0,
            max_speed_mm_s: 80.0,
            ..sideways
        };
        let near = RespeedStart {
            position: Position::new(70.0, -100.0, 0.0),
            ..begin(0.0)
        };
        let arm_limits = ArmLimits {
            link: crate::LinkRate { period_s: 0.0 },
            acceleration_mm_s2: 500.0,
            ..ArmLimits::default()
        };
        let far = RespeedStart {
            position: Position::new(230.0, -100.0, 0.0),
            ..begin(0.0)
        };
        let fastest =
            |begin: &RespeedStart| respeed(&[sideways], begin, 2.0, &arm_limits)[0].max_speed_mm_s;
        assert_eq!(fastest(&far), 160.0);
        let allowed_mm_s = 70.0 * 100.0_f32.to_radians();
        assert!(fastest(&near) <= allowed_mm_s, "{}", fastest(&near));
    }

    #[test]
    fn half_the_speed_halves_every_speed() {
        let planned = planned(&[(200.0, 0.0), (240.0, 0.0), (250.0, 5.0), (250.0, 6.0)]);
        for (half, whole) in respeed(&planned, &begin(0.0), 0.5, &ArmLimits::default())
            .iter()
            .zip(&planned)
        {
            assert_eq!(half.end_speed_mm_s, 0.5 * whole.end_speed_mm_s);
            assert_eq!(half.max_speed_mm_s, 0.5 * whole.max_speed_mm_s);
        }
    }

    #[test]
    fn a_long_line_at_twice_the_speed_gets_twice_as_fast() {
        let planned = planned(&[(150.0, 0.0), (250.0, 0.0)]);
        assert_eq!(planned[1].max_speed_mm_s, 40.0);
        let faster = respeed(&planned, &begin(0.0), 2.0, &ArmLimits::default());
        let fastest = faster.iter().map(|vector| vector.max_speed_mm_s);
        assert_eq!(fastest.fold(0.0, f32::max), 80.0);
        let drawn = &faster[1..faster.len() - 1];
        assert_eq!(drawn[0].start_speed_mm_s, 0.0);
        assert_eq!(drawn[drawn.len() - 1].end_speed_mm_s, 0.0);
    }

    #[test]
    fn a_stock_arm_gets_half_the_speed_in_whole_ticks() {
        let arm_limits = ArmLimits {
            has_ticks: true,
            ..ArmLimits::default()
        };
        let points = [(200.0, 0.0), (203.0, 0.0), (206.0, 0.5), (209.0, 1.5)];
        let stroke = Stroke::open(points.map(|(x, y)| Point::new(x, y)).to_vec());
        let pass = Pass::new(DrawingTool::default(), vec![stroke]);
        let plan = Plan::new(&[pass], &Paper::default(), &arm_limits).unwrap();
        let planned: Vec<WriteVector> = plan
            .moves
            .iter()
            .map(crate::path::commands::write)
            .collect();
        assert_eq!(respeed(&planned, &begin(0.0), 1.0, &arm_limits), planned);
        let slower = respeed(&planned, &begin(0.0), 0.5, &arm_limits);
        let mut ticker = Ticker::new(&arm_limits, 0.0);
        for (vector, was) in slower.iter().zip(&planned) {
            assert!(vector.max_speed_mm_s <= 0.5 * was.max_speed_mm_s + 2.0);
            assert_eq!(vector.end_speed_mm_s == 0.0, was.end_speed_mm_s == 0.0);
            let stored = ticker.run(vector).end_mm_s;
            assert!(
                (0.0..=0.5 * was.max_speed_mm_s + 2.0).contains(&stored),
                "{stored}"
            );
        }
    }

    fn strokes() -> impl Strategy<Value = Vec<(f64, f64)>> {
        proptest::collection::vec((150.0..250.0_f64, -50.0..50.0_f64), 2..20)
    }

    proptest! {
        #[test]
        fn a_factor_of_one_from_rest_changes_nothing(points in strokes()) {
            let planned = planned(&points);
            prop_assert_eq!(respeed(&planned, &begin(0.0), 1.0, &ArmLimits::default()), planned);
        }

        #[test]
        fn vectors_of_changed_length_end_correctly_on_a_stock_arm(
            points in strokes(), slope in -0.05..0.05_f32, at_mm_s in 0.0..1.5_f32,
        ) {
            let arm_limits = ArmLimits { has_ticks: true, ..ArmLimits::default() };
            let points = points.iter().map(|&(x, y)| Point::new(x, y)).collect();
            let pass = Pass::new(DrawingTool::default(), vec![Stroke::open(points)]);
            let plan = Plan::new(&[pass], &Paper::default(), &arm_limits).unwrap();
            let planned: Vec<WriteVector> = plan.moves.iter().map(crate::path::commands::write).collect();
            let steeper = |vector: &WriteVector| {
                let z_mm = vector.z_mm + slope * vector.x_mm.hypot(vector.y_mm);
                WriteVector { z_mm, ..*vector }
            };
            let steeper: Vec<WriteVector> = planned.iter().map(steeper).collect();
            let next = respeed(&steeper, &begin(at_mm_s), 1.0, &arm_limits);
            prop_assert!(Ticker::new(&arm_limits, at_mm_s).runs_exactly(&next));
            let same = next.iter().zip(&steeper);
            prop_assert!(same.clone().all(|(vector, was)| vector.z_mm == was.z_mm));
            let ends = |vector: &WriteVector| vector.end_speed_mm_s == 0.0;
            prop_assert!(same.clone().all(|(vector, was)| ends(vector) == ends(was)));
        }

        #[test]
        fn speeds_match_and_are_reachable_and_the_end_is_at_rest(
            points in strokes(), share in 0.1..2.0_f64, at in 0.0..1.0_f64, before in 0.1..2.0_f64,
        ) {
            let arm_limits = ArmLimits::default();
            let planned = planned(&points);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss, reason = "an index")]
            let at = (at * planned.len() as f64) as usize;
            let running = respeed(&planned, &begin(0.0), before, &arm_limits);
            let mut speed = running[at].start_speed_mm_s;
            let next = respeed(&planned[at..], &begin(speed), share, &arm_limits);
            prop_assert_eq!(next.len(), planned.len() - at);
            for (vector, was) in next.iter().zip(&planned[at..]) {
                prop_assert_eq!(vector.start_speed_mm_s, speed);
                speed = vector.end_speed_mm_s;
                prop_assert_eq!([vector.x_mm, vector.y_mm, vector.z_mm], [was.x_mm, was.y_mm, was.z_mm]);
                prop_assert!(vector.start_speed_mm_s.max(speed) <= vector.max_speed_mm_s);
                let v2 = |v: f32| f64::from(v) * f64::from(v);
                let change = (v2(speed) - v2(vector.start_speed_mm_s)).abs();
                let needed = change / (2.0 * length(way(vector)));
                prop_assert!(needed <= arm_limits.acceleration_mm_s2 * 1.001, "{needed}");
            }
            prop_assert!(speed < 0.01, "{speed}");
        }
    }
}
