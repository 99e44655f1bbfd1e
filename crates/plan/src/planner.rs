//! From strokes to vectors: the ways of the tool, chain by chain.

use dobot_arm::TICK_S;
use dobot_geometry::{Point, Stroke};

use crate::chain::{ChainSpeeds, LEAST_SHARE};
use crate::joints::JointSpeeds;
use crate::landing::Landing;
use crate::lookahead::ChainVector;
use crate::seen::TickPositions;
use crate::speeds::Speeds;
use crate::tick_fit::{MOST_FITS, OVER};
use crate::ticker::Ticker;
use crate::vector::length;
use crate::{DrawingTool, Machine, MoveKind, Paper, Pass, Pen, PlannedVector};

/// Plans one way after the other. A chain is a way between two rests.
pub(super) struct Planner<'a> {
    paper: &'a Paper,
    pub(super) machine: &'a Machine,
    pub(super) chain_speeds: ChainSpeeds,
    /// Where the arm has ticks.
    pub(super) ticker: Option<Ticker>,
    /// Where the vectors so far lead, rounding included.
    pub(super) here: [f64; 3],
    landing: Landing,
    joints: JointSpeeds,
    pub(super) moves: Vec<PlannedVector>,
    /// Which stroke and pass the next vectors belong to.
    pub(super) stroke: u32,
    pass: u32,
    /// The runs since the last rest; reused.
    pub(super) chain: Vec<ChainVector>,
}

impl<'a> Planner<'a> {
    pub(super) fn new(
        start: [f64; 3],
        tool: &DrawingTool,
        paper: &'a Paper,
        machine: &'a Machine,
    ) -> Self {
        Self {
            paper,
            machine,
            chain_speeds: ChainSpeeds::new(machine),
            ticker: Ticker::of(machine, 0.0),
            here: start,
            landing: Landing::new(machine, tool),
            joints: JointSpeeds::new(machine.joint_speed_deg_s, tool.reach_mm()),
            moves: Vec::new(),
            stroke: 0,
            pass: 0,
            chain: Vec::new(),
        }
    }

    pub(super) fn pass(&mut self, number: u32, pass: &Pass) {
        self.pass = number;
        let strokes = pass.strokes.iter().filter(|it| !it.points.is_empty());
        match &pass.tool {
            DrawingTool::Pen(pen) => strokes.for_each(|stroke| self.draw(stroke, pen)),
            DrawingTool::Laser(laser) if laser.by_stroke => strokes
                .flat_map(|it| (0..laser.times).map(move |_| it))
                .for_each(|stroke| self.burn(stroke, laser)),
            DrawingTool::Laser(laser) => (0..laser.times)
                .flat_map(|_| strokes.clone())
                .for_each(|stroke| self.burn(stroke, laser)),
        }
    }

    /// ```text
    ///   up    ----> Travel ----.                     .---- Travel ---->
    ///                          | Lower          Lift |
    ///   down                   '-- Draw Draw Draw ---'
    /// ```
    fn draw(&mut self, stroke: &Stroke, pen: &Pen) {
        let (first, last) = (stroke.points[0], stroke.points[stroke.points.len() - 1]);
        self.go(MoveKind::Travel, first, pen.lift_mm, pen.travel_speed_mm_s);
        self.rest();
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

    /// A vector to a place so high above the paper.
    pub(super) fn go(&mut self, kind: MoveKind, to: Point, above_mm: f64, limit_mm_s: f64) {
        let to = [to.x, to.y, self.paper.z_at(to) + above_mm];
        let here = self.here;
        #[expect(clippy::cast_possible_truncation, reason = "as the packet holds it")]
        let [x_mm, y_mm, z_mm] = [0, 1, 2].map(|i| (to[i] - here[i]) as f32);
        let way = [x_mm, y_mm, z_mm].map(f64::from);
        if length(way) < self.least_vector_mm(kind) {
            return;
        }
        self.here = self.landing.of(here, [x_mm, y_mm, z_mm]);
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

    /// What is shorter is left to the next vector. A laser is switched however short the way is; its
    /// ways do not begin at rest.
    fn least_vector_mm(&self, kind: MoveKind) -> f64 {
        match kind {
            MoveKind::Travel | MoveKind::Lower | MoveKind::Draw | MoveKind::Lift => {
                LEAST_VECTOR_MM.max(self.machine.least_from_rest_mm())
            }
            _ => LEAST_VECTOR_MM,
        }
    }

    /// The chain ends: its speeds can be planned.
    pub(super) fn rest(&mut self) {
        let begin = self.moves.len() - self.chain.len();
        self.even_burning(begin);
        if let Some(mut ticker) = self.ticker.take() {
            let limits = self.chain.iter().map(|it| it.limit_mm_s);
            ticker.limit(round_down(limits.fold(0.0, f64::max)));
            self.plan_in_ticks(begin, &ticker);
        } else {
            let speeds = self.chain_speeds.plan(&mut self.chain);
            for (vector, speeds) in self.moves[begin..].iter_mut().zip(speeds) {
                set(vector, speeds);
            }
        }
        self.chain.clear();
    }
}

/// A chain in ticks.
impl Planner<'_> {
    /// Where the ticks come out so that a pen would be seen to accelerate too much, the corners there
    /// are taken slower, and all is planned again. A laser keeps its even speed.
    fn plan_in_ticks(&mut self, begin: usize, ticker: &Ticker) {
        let draws = self.moves[begin..]
            .iter()
            .any(|it| it.kind == MoveKind::Draw);
        let rounds = if draws { MOST_ROUNDS } else { 0 };
        let mut over = vec![OVER; self.chain.len()];
        let mut ways = 1;
        for left in (0..=rounds).rev() {
            let attempt = self.attempt(begin, ticker.clone(), &over, ways);
            let fits = attempt.shares.iter().all(|it| *it >= 1.0);
            if left == 0 || fits && (ways > 1 || attempt.late_share < MOST_LATE_SHARE) {
                self.chain_speeds = attempt.chain_speeds;
                self.ticker = Some(attempt.ticker);
                return;
            }
            if ways > 1 {
                self.take_slower(&attempt, &mut over);
            }
            ways = MOST_FITS;
        }
    }

    fn attempt(&mut self, begin: usize, mut ticker: Ticker, over: &[f64], ways: usize) -> Attempt {
        let mut chain_speeds = self.chain_speeds.clone();
        let speeds: Vec<Speeds> = chain_speeds.plan(&mut self.chain).collect();
        let mut ticks = TickPositions::default();
        let cuts = ticker.set(&mut self.moves[begin..], &self.chain, &speeds, over, ways);
        for (run, cut) in self.chain.iter().zip(&cuts) {
            ticks.push(run, cut);
        }
        let wanted_s: f64 = speeds.iter().map(|it| it.duration_s).sum();
        let took_s: f64 = cuts.iter().map(|it| f64::from(it.ticks()) * TICK_S).sum();
        Attempt {
            chain_speeds,
            ticker,
            speeds,
            late_share: took_s / wanted_s - 1.0,
            shares: ticks.shares(self.machine.acceleration_mm_s2, LEAST_SHARE),
        }
    }

    /// Corners that are too fast, round after round more so; those that are hardly faster than one
    /// tick becomes a stop in the end.
    fn take_slower(&mut self, attempt: &Attempt, over: &mut [f64]) {
        let step_mm_s = f64::from(attempt.ticker.step_mm_s());
        let shares = attempt.shares.iter().enumerate();
        for (i, share) in shares.filter(|it| *it.1 < 1.0) {
            over[i] = (2.0 * over[i]).min(MOST_OVER);
            let slower_mm_s = attempt.speeds[i].end_mm_s * share;
            let stops = over[i] == MOST_OVER && slower_mm_s < step_mm_s;
            self.chain[i].corner_mm_s = if stops { 0.0 } else { slower_mm_s };
        }
    }
}

/// A chain as it comes out in ticks.
struct Attempt {
    chain_speeds: ChainSpeeds,
    ticker: Ticker,
    /// What was wanted of each vector.
    speeds: Vec<Speeds>,
    /// How much longer all of them take than wanted, as a share of that.
    late_share: f64,
    /// What share of the acceleration seen at the corner behind each vector is allowed.
    shares: Vec<f64>,
}

#[expect(clippy::cast_possible_truncation, reason = "as the packet holds it")]
fn set(vector: &mut PlannedVector, speeds: Speeds) {
    vector.start_speed_mm_s = round_down(speeds.start_mm_s);
    vector.end_speed_mm_s = round_down(speeds.end_mm_s);
    vector.max_speed_mm_s = round_down(speeds.max_mm_s);
    vector.duration_s = speeds.duration_s as f32;
}

/// The largest single-precision number that is not above `value`.
pub(super) fn round_down(value: f64) -> f32 {
    #[expect(clippy::cast_possible_truncation, reason = "corrected below")]
    let nearest = value as f32;
    if f64::from(nearest) > value {
        nearest.next_down()
    } else {
        nearest
    }
}

pub(super) const LEAST_VECTOR_MM: f64 = 0.001;
/// What takes no longer than this beyond what is wanted is not worth a search.
const MOST_LATE_SHARE: f64 = 0.01;
/// How often a chain is planned again for the ticks of a stock arm.
const MOST_ROUNDS: u32 = 12;
/// How much an end speed above the one wanted counts at the most.
const MOST_OVER: f64 = 128.0;
