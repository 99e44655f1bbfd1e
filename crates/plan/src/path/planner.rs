//! From strokes to vectors: the paths of the tool, chain by chain.

use dobot_geometry::{CancelToken, Cancelled, Point, Stroke};

use crate::path::detour::detour;
use crate::path::endpoint::Endpoint;
use crate::path::pieces::LONGEST_BURN_S;
use crate::path::travel::TravelVectors;
use crate::path::vector::length;
use crate::speed::chain::ChainSpeeds;
use crate::speed::joints::JointSpeeds;
use crate::speed::lookahead::ChainVector;
use crate::speed::objective::Objective;
use crate::speed::speeds::Speeds;
use crate::ticks::tick_chain::LastPositions;
use crate::ticks::tick_fit::MIN_BURN_MM_S;
use crate::ticks::ticker::Ticker;
use crate::{ArmLimits, DrawingTool, MoveKind, Paper, Pass, Pen, PlannedVector};

/// Plans one chain after another. A chain is a path between two rests.
pub(crate) struct Planner<'a> {
    paper: &'a Paper,
    pub(crate) arm_limits: &'a ArmLimits,
    /// Once it is cancelled, the search for speeds ends with the first that it finds.
    pub(crate) cancel: &'a CancelToken,
    pub(crate) chain_speeds: ChainSpeeds,
    /// Present if the arm has ticks.
    pub(crate) ticker: Option<Ticker>,
    /// The tool positions at the last ticks.
    pub(crate) last_positions: LastPositions,
    pub(crate) travel: TravelVectors,
    /// The end of the planned vectors, including rounding.
    pub(crate) here: [f64; 3],
    pub(crate) settled: Settled,
    /// The objective of the current pass.
    pub(crate) objective: Objective,
    /// The travel speed of the tool, in mm/s.
    pub(crate) travel_mm_s: f64,
    joints: JointSpeeds,
    pub(crate) moves: Vec<PlannedVector>,
    /// The stroke and pass of the next vectors.
    pub(crate) stroke: u32,
    pass: u32,
    /// The vectors since the last rest; the buffer is reused.
    pub(crate) chain: Vec<ChainVector>,
}

impl<'a> Planner<'a> {
    pub(crate) fn new(
        start: [f64; 3],
        tool: &DrawingTool,
        paper: &'a Paper,
        arm_limits: &'a ArmLimits,
        cancel: &'a CancelToken,
    ) -> Self {
        let ticker = Ticker::of(arm_limits, 0.0);
        let chain_speeds = ChainSpeeds::new(arm_limits).until(cancel);
        Self {
            paper,
            arm_limits,
            cancel,
            chain_speeds: if tool.burns() {
                chain_speeds.with_pieces(LONGEST_BURN_S)
            } else {
                chain_speeds
            },
            ticker: if tool.burns() {
                ticker.map(|ticker| ticker.with_unknown_speed().with_pieces(LONGEST_BURN_S))
            } else {
                ticker
            },
            last_positions: LastPositions::default(),
            travel: TravelVectors::default(),
            here: start,
            settled: Settled {
                endpoint: Endpoint::new(arm_limits, tool),
                count: 0,
                here: start,
            },
            objective: Objective::of(tool),
            travel_mm_s: tool.travel_speed_mm_s(),
            joints: JointSpeeds::new(arm_limits.joint_speed_deg_s, tool.reach_mm()),
            moves: Vec::new(),
            stroke: 0,
            pass: 0,
            chain: Vec::new(),
        }
    }

    pub(crate) fn pass(&mut self, number: u32, pass: &Pass) -> Result<(), Cancelled> {
        self.plan_travel(0);
        self.pass = number;
        self.objective = Objective::of(&pass.tool);
        self.travel_mm_s = pass.tool.travel_speed_mm_s();
        for stroke in pass.drawn().filter(|stroke| !stroke.points.is_empty()) {
            match &pass.tool {
                DrawingTool::Pen(pen) => self.draw(stroke, pen),
                DrawingTool::Laser(laser) => self.burn(stroke, laser),
            }
            self.cancel.check()?;
        }
        Ok(())
    }

    /// Plans a pen stroke.
    ///
    /// ```text
    ///   up    ----> Travel ----.                     .---- Travel ---->
    ///                          | Lower          Lift |
    ///   down                   '-- Draw Draw Draw ---'
    /// ```
    fn draw(&mut self, stroke: &Stroke, pen: &Pen) {
        let (first, last) = (stroke.points[0], stroke.points[stroke.points.len() - 1]);
        self.travel(first, pen.lift_mm, pen.travel_speed_mm_s);
        if pen.touch_mm > 0.0 && pen.touch_mm < pen.lift_mm {
            self.go(MoveKind::Lower, first, pen.touch_mm, pen.lift_speed_mm_s);
            let slow_mm_s = pen.touch_speed_mm_s.min(pen.lift_speed_mm_s);
            self.go(MoveKind::Lower, first, 0.0, slow_mm_s);
        } else {
            self.go(MoveKind::Lower, first, 0.0, pen.lift_speed_mm_s);
        }
        self.rest();
        for &p in &stroke.points[1..] {
            self.go(MoveKind::Draw, p, 0.0, pen.draw_speed_mm_s);
        }
        self.rest();
        self.go(MoveKind::Lift, last, pen.lift_mm, pen.lift_speed_mm_s);
        self.rest();
        self.stroke += 1;
    }

    /// Travels from rest to rest, around the arm's own position.
    pub(crate) fn travel(&mut self, to: Point, above_mm: f64, limit_mm_s: f64) {
        let here = Point::new(self.here[0], self.here[1]);
        for corner in detour(here, to, self.arm_limits.nearest_mm) {
            self.go(MoveKind::Travel, corner, above_mm, limit_mm_s);
        }
        self.go(MoveKind::Travel, to, above_mm, limit_mm_s);
        self.rest();
    }

    /// Adds a vector to a place at a height above the paper.
    pub(crate) fn go(&mut self, kind: MoveKind, to: Point, above_mm: f64, limit_mm_s: f64) {
        let to = [to.x, to.y, self.paper.z_at(to) + above_mm];
        let here = self.here;
        #[expect(clippy::cast_possible_truncation, reason = "as the packet holds it")]
        let [x_mm, y_mm, z_mm] = [0, 1, 2].map(|i| (to[i] - here[i]) as f32);
        let way = [x_mm, y_mm, z_mm].map(f64::from);
        // `here` is unchanged, so the next vector includes this distance.
        if length(way) < self.least_vector_mm(kind) {
            return;
        }
        self.here = self.settled.endpoint.estimate(here, [x_mm, y_mm, z_mm]);
        let limit_mm_s = self.joints.cap(here, way, limit_mm_s);
        self.chain.push(ChainVector::of(way, limit_mm_s));
        self.moves.push(PlannedVector {
            x_mm,
            y_mm,
            z_mm,
            start_speed_mm_s: 0.0,
            end_speed_mm_s: 0.0,
            max_speed_mm_s: 0.0,
            duration_s: 0.0,
            kind,
            stroke: self.stroke,
            pass: self.pass,
        });
    }

    /// Returns the length below which a vector is merged into the next one. The laser must be
    /// switched however short the path is, and its vectors do not begin at rest.
    fn least_vector_mm(&self, kind: MoveKind) -> f64 {
        match kind {
            MoveKind::Travel | MoveKind::Lower | MoveKind::Draw | MoveKind::Lift => {
                MIN_VECTOR_MM.max(self.arm_limits.least_from_rest_mm())
            }
            _ => MIN_VECTOR_MM,
        }
    }

    /// Ends the chain and plans its speeds.
    pub(crate) fn rest(&mut self) {
        if self.chain.is_empty() {
            return;
        }
        let begin = self.moves.len() - self.chain.len();
        self.even_burning(begin);
        if self.ticker.is_none() {
            let speeds = self.chain_speeds.plan(&mut self.chain, self.objective);
            for (vector, speeds) in self.moves[begin..].iter_mut().zip(speeds) {
                set(vector, speeds);
            }
            self.raise_burn_speeds(begin);
        // A single vector between two rests is planned later, together with its neighbours.
        } else if self.objective == Objective::Fast && self.chain.len() == 1 {
            self.push_travel();
        } else {
            self.plan_ticks(begin);
        }
        self.chain.clear();
    }

    /// Raises the speeds of a laser to the allowed minimum if rounding and slow corners lowered
    /// them.
    fn raise_burn_speeds(&mut self, begin: usize) {
        let fastest_mm_s = self.chain.iter().map(|run| run.limit_mm_s);
        if fastest_mm_s.fold(0.0, f64::max) < MIN_BURN_MM_S.into() {
            return;
        }
        let burned = self.moves[begin..].iter_mut();
        for vector in burned.filter(|vector| vector.kind == MoveKind::Burn) {
            vector.max_speed_mm_s = vector.max_speed_mm_s.max(MIN_BURN_MM_S);
        }
    }

    /// Computes the exact end of the first `count` vectors, whose speeds are planned, and moves the
    /// following vectors there.
    pub(crate) fn settle(&mut self, count: usize) {
        let settled = &mut self.settled;
        for vector in &self.moves[settled.count..count] {
            settled.here = settled.endpoint.after(settled.here, vector);
        }
        settled.count = count;
        self.here = self.moves[count..]
            .iter()
            .fold(settled.here, |here, vector| {
                settled
                    .endpoint
                    .estimate(here, [vector.x_mm, vector.y_mm, vector.z_mm])
            });
    }

    /// Plans the remaining vectors and returns all of them.
    pub(crate) fn finish(mut self) -> Vec<PlannedVector> {
        self.plan_travel(0);
        self.moves
    }
}

/// The vectors with planned speeds, on an arm with ticks.
#[derive(Clone, Debug)]
pub(crate) struct Settled {
    endpoint: Endpoint,
    count: usize,
    /// Their end.
    here: [f64; 3],
}

#[expect(clippy::cast_possible_truncation, reason = "as the packet holds it")]
fn set(vector: &mut PlannedVector, speeds: Speeds) {
    vector.start_speed_mm_s = round_down(speeds.start_mm_s);
    vector.end_speed_mm_s = round_down(speeds.end_mm_s);
    vector.max_speed_mm_s = round_down(speeds.max_mm_s);
    vector.duration_s = speeds.duration_s as f32;
}

/// Returns the largest single-precision number not above `value`.
pub(crate) fn round_down(value: f64) -> f32 {
    #[expect(clippy::cast_possible_truncation, reason = "corrected below")]
    let nearest = value as f32;
    if f64::from(nearest) > value {
        nearest.next_down()
    } else {
        nearest
    }
}

pub(crate) const MIN_VECTOR_MM: f64 = 0.001;
