//! Planning of laser strokes.

use std::ops::Range;

use dobot_geometry::{Point, Stroke};
use dobot_motion::TickStroke;

use crate::laser::laser_path::{
    LaserPath, MIN_BURN_MM, NEAR_MM, Parted, SwitchLead, burn_speed_mm_s, burnable,
};
use crate::path::commands::write;
use crate::path::planner::{Planner, Settled};
use crate::speed::chain::ChainSpeeds;
use crate::speed::objective::Objective;
use crate::ticks::TICK_S;
use crate::ticks::tick_fit::MIN_BURN_MM_S;
use crate::ticks::ticker::Ticker;
use crate::{Laser, MoveKind, PlannedVector};

impl Planner<'_> {
    /// Plans the stroke with a run-up and a run-out.
    ///
    /// ```text
    ///   off  -- Travel --> RunUp .                   . RunOut Brake -- Travel -->
    ///   on                       '- Burn Burn Burn --'
    /// ```
    ///
    /// The length of the last ticks before switching is known only after planning. The switching
    /// points are then moved and the stroke is planned again. If that does not converge, another
    /// run-up or a slightly lower speed is tried.
    pub(crate) fn burn(&mut self, stroke: &Stroke, laser: &Laser) {
        let points = burnable(stroke, self.here);
        let laser = &Laser {
            burn_speed_mm_s: burn_speed_mm_s(&points, laser, self.arm_limits),
            ..*laser
        };
        let before = self.checkpoint();
        let mut best: Option<BurnAttempt> = None;
        let (mut planned, mut is_planned) = (0, false);
        // Variants are ordered by preference: stop at the first that is good enough.
        'ways: for way in BurnVariant::all() {
            let is_over_budget = planned > MAX_PLANNED;
            let goes = |attempt: BurnAttempt| {
                attempt.is_within(way.worth_mm) || is_over_budget && !attempt.fails
            };
            if best.is_some_and(goes) {
                break;
            }
            let mut wanted = SwitchLead::at_speed(laser, self.arm_limits);
            for _ in 0..BURN_ROUNDS {
                if best.is_some() && self.cancel.is_cancelled() {
                    return;
                }
                // Planning changes the state of the arm, so every attempt starts from the
                // checkpoint.
                if is_planned {
                    self.restore(&before);
                }
                let mut tried = BurnAttempt {
                    way,
                    wanted,
                    off_mm: 0.0,
                    fails: false,
                };
                let lead = self.burn_once(&points, laser, &tried);
                let Some(ticker) = &before.ticker else {
                    break 'ways;
                };
                let found = self.lead(before.moves, ticker.clone());
                tried.off_mm = found.distance_mm(lead);
                tried.fails = ticker.fails(&self.moves[before.moves..]);
                if best.is_none_or(|best| tried.is_better(&best)) {
                    best = Some(tried);
                }
                if tried.is_within(NEAR_MM) {
                    break 'ways;
                }
                is_planned = true;
                planned += self.moves.len() - before.moves;
                // Tick counts jump between attempts; half the correction may lie in between.
                wanted = wanted.half_way(found);
            }
        }
        // The last attempt need not be the best one; plan the best one again.
        if let Some(best) = best.filter(|best| !best.is_within(NEAR_MM)) {
            self.restore(&before);
            self.burn_once(&points, laser, &best);
        }
        self.stroke += 1;
    }

    /// Plans the stroke once and returns where the laser is switched.
    fn burn_once(&mut self, points: &[Point], laser: &Laser, tried: &BurnAttempt) -> SwitchLead {
        let asked = laser.burn_speed_mm_s;
        let least = self.arm_limits.least_kept_mm_s().max(MIN_BURN_MM_S.into());
        let speed = (asked * tried.way.speed_share).max(asked.min(least));
        let longer_mm = tried.way.longer_ticks * f64::from(TICK_S) * speed;
        let path = LaserPath::of(
            points,
            speed,
            tried.wanted,
            (longer_mm, tried.way.parted),
            self.arm_limits,
        );
        self.travel(path.run_up, 0.0, laser.travel_speed_mm_s);
        for p in path.off_to {
            self.go(MoveKind::RunUp, p, 0.0, speed);
        }
        for p in path.on_to {
            self.go(MoveKind::Burn, p, 0.0, speed);
        }
        self.go(MoveKind::RunOut, path.run_out, 0.0, speed);
        self.go(MoveKind::Brake, path.brake, 0.0, speed);
        self.rest();
        path.lead
    }

    /// Returns the state before a stroke, for [`restore`](Self::restore).
    fn checkpoint(&self) -> Checkpoint {
        Checkpoint {
            moves: self.moves.len(),
            here: self.here,
            settled: self.settled.clone(),
            chain_speeds: self.chain_speeds.clone(),
            ticker: self.ticker.clone(),
        }
    }

    fn restore(&mut self, before: &Checkpoint) {
        self.moves.truncate(before.moves);
        self.here = before.here;
        self.settled = before.settled.clone();
        self.chain_speeds = before.chain_speeds.clone();
        self.ticker.clone_from(&before.ticker);
    }

    /// Returns the lengths of the ticks in which the laser is switched, in the vectors from `begin`
    /// on.
    fn lead(&self, begin: usize, mut ticker: Ticker) -> SwitchLead {
        let last_mm = |tick_stroke: &TickStroke| {
            tick_stroke
                .speeds_mm_s()
                .last()
                .map_or(0.0, |mm_s| mm_s * TICK_S)
        };
        let mut lead = SwitchLead {
            on_mm: 0.0,
            off_mm: 0.0,
        };
        for vector in &self.moves[begin..] {
            let tick_stroke = ticker.run(&write(vector));
            match vector.kind {
                MoveKind::RunUp => lead.on_mm = last_mm(&tick_stroke).into(),
                MoveKind::Burn => lead.off_mm = last_mm(&tick_stroke).into(),
                _ => {}
            }
        }
        lead
    }

    /// Lowers the speed of the stroke to its slowest part if that is nearly as fast: a laser burns
    /// more where it is slower.
    pub(crate) fn even_burning(&mut self, begin: usize) {
        let burns = |vector: &&PlannedVector| vector.kind == MoveKind::Burn;
        let Some(first) = self.moves[begin..].iter().position(|vector| burns(&vector)) else {
            return;
        };
        let burned = self.moves[begin..].iter().filter(burns).count();
        let limit_mm_s = self.chain[first].limit_mm_s;
        let slowest_mm_s = self.slowest_mm_s(first..first + burned).min(limit_mm_s);
        // Where the slowest part is much slower, even burning would make the whole stroke too slow.
        if slowest_mm_s * MAX_SPREAD >= limit_mm_s {
            let least_mm_s = f64::from(MIN_BURN_MM_S);
            let even_mm_s = if limit_mm_s < least_mm_s {
                slowest_mm_s
            } else {
                slowest_mm_s.max(least_mm_s)
            };
            for run in &mut self.chain {
                run.limit_mm_s = run.limit_mm_s.min(even_mm_s);
            }
        }
    }

    /// Returns the lowest speed in these vectors of the chain.
    fn slowest_mm_s(&self, vectors: Range<usize>) -> f64 {
        let mut chain = self.chain.clone();
        let mut chain_speeds = self.chain_speeds.clone();
        let speeds = chain_speeds
            .plan(&mut chain, Objective::Even)
            .skip(vectors.start)
            .take(vectors.len());
        speeds
            .map(|speeds| speeds.start_mm_s.min(speeds.end_mm_s).min(speeds.max_mm_s))
            .fold(f64::INFINITY, f64::min)
    }
}

/// The state of the planner before a stroke.
struct Checkpoint {
    /// The number of vectors.
    moves: usize,
    here: [f64; 3],
    settled: Settled,
    chain_speeds: ChainSpeeds,
    ticker: Option<Ticker>,
}

/// An attempt at a burned stroke.
#[derive(Clone, Copy)]
struct BurnAttempt {
    way: BurnVariant,
    /// The intended switching points.
    wanted: SwitchLead,
    /// The distance of the burned start or end from the stroke's, in mm.
    off_mm: f64,
    /// Whether the arm may deviate from the plan in it.
    fails: bool,
}

impl BurnAttempt {
    fn is_within(&self, most_mm: f64) -> bool {
        !self.fails && self.off_mm < most_mm
    }

    fn is_better(&self, other: &Self) -> bool {
        (self.fails, self.off_mm) < (other.fails, other.off_mm)
    }
}

/// A variant of burning a stroke, with different ticks.
#[derive(Clone, Copy)]
struct BurnVariant {
    /// The share of the speed.
    speed_share: f64,
    /// The additional length of the run-up, in ticks: at most the length of the run-out.
    longer_ticks: f64,
    /// The end with an additional vector, which may consist of just the tick in which the laser is
    /// switched.
    parted: Parted,
    /// The error above which the variant is tried, in mm.
    worth_mm: f64,
}

impl BurnVariant {
    /// Returns the requested variant followed by the alternatives.
    fn all() -> impl Iterator<Item = Self> {
        WAYS.into_iter().flat_map(|way| {
            LONGER_TICKS.into_iter().map(move |longer_ticks| Self {
                longer_ticks,
                ..way
            })
        })
    }

    const fn new(speed_share: f64, parted: Parted, worth_mm: f64) -> Self {
        Self {
            speed_share,
            longer_ticks: 0.0,
            parted,
            worth_mm,
        }
    }
}

/// The maximum number of attempts per variant.
const BURN_ROUNDS: u32 = 12;
/// After this many planned vectors no more variants are tried.
const MAX_PLANNED: usize = 5_000;
const LONGER_TICKS: [f64; 5] = [0.0, 0.7, 1.4, 2.1, 2.8];
/// Slower variants burn more and divided ones may be slower: they must be worth it. An error of
/// half the shortest burn is unavoidable where the laser is switched at a corner.
const WAYS: [BurnVariant; 7] = [
    BurnVariant::new(1.0, Parted::Nowhere, 0.01),
    BurnVariant::new(1.0, Parted::AtEnd, 0.025),
    BurnVariant::new(1.0, Parted::AtBoth, 0.025),
    BurnVariant::new(0.97, Parted::Nowhere, 0.025),
    BurnVariant::new(0.97, Parted::AtBoth, 0.025),
    BurnVariant::new(0.9, Parted::Nowhere, 0.5 * MIN_BURN_MM),
    // Burns much more; only for strokes in which the arm would deviate from the plan otherwise.
    BurnVariant::new(0.8, Parted::Nowhere, f64::INFINITY),
];
/// The factor by which burning per millimetre may increase to make it even.
const MAX_SPREAD: f64 = 1.2;

#[cfg(test)]
mod tests {
    use dobot_geometry::{Point, Stroke, Vec2, deviation};
    use proptest::prelude::*;

    use super::*;
    use crate::{ArmLimits, DrawingTool, Paper, Pass, Plan, burned_corners};

    /// Returns the burned line of each stroke on a stock arm: from the last tick before the burning
    /// vectors up to their last but one.
    fn lit(plan: &Plan) -> Vec<Stroke> {
        let mut ticker = Ticker::new(plan.arm_limits(), 0.0);
        let mut here = Point::new(plan.start[0], plan.start[1]);
        let mut lit: Vec<Stroke> = Vec::new();
        let mut last_tick = [here; 2];
        let mut was = MoveKind::Travel;
        for (vector, [x, y, _]) in plan.moves.iter().zip(plan.positions()) {
            let there = Point::new(x, y);
            let tick_stroke = ticker.run(&write(vector));
            let last_mm = f64::from(tick_stroke.speeds_mm_s().last().unwrap_or(0.0) * TICK_S);
            let before_last = there.lerp(here, last_mm / there.distance(here));
            if vector.kind == MoveKind::Burn && was != MoveKind::Burn {
                lit.push(Stroke::open(last_tick.to_vec()));
            }
            if let Some(stroke) = lit.last_mut().filter(|_| vector.kind == MoveKind::Burn) {
                stroke.points.push(there);
            }
            if let Some(stroke) = lit.last_mut().filter(|_| vector.kind == MoveKind::RunOut) {
                // The laser switches off before the last tick of the vector before.
                stroke.points.pop();
                stroke.points.push(last_tick[0]);
            }
            (here, was, last_tick) = (there, vector.kind, [before_last, there]);
        }
        lit
    }

    /// A stroke with corners as close together as a laser burns them, and farther apart.
    fn stroke() -> impl Strategy<Value = Stroke> {
        let step = (0.0..360.0_f64, prop_oneof![0.08..0.3_f64, 0.1..3.0_f64]);
        proptest::collection::vec(step, 1..12).prop_map(|steps| {
            let mut points = vec![Point::new(200.0, 0.0)];
            points.extend(steps.iter().scan(points[0], |here, (turn_deg, length_mm)| {
                *here += Vec2::from_angle(turn_deg.to_radians()) * *length_mm;
                Some(*here)
            }));
            Stroke::open(burned_corners(&Stroke::open(points)))
        })
    }

    /// Returns the burning time of each stroke on a stock arm, relative to that at this speed.
    fn times_as_long(strokes: &[Stroke], burn_speed_mm_s: f64) -> Vec<f64> {
        let laser = Laser {
            burn_speed_mm_s,
            ..Laser::default()
        };
        let arm_limits = ArmLimits {
            has_ticks: true,
            ..ArmLimits::default()
        };
        let pass = Pass::new(DrawingTool::Laser(laser), strokes.to_vec());
        let plan = Plan::new(&[pass], &Paper::level(-40.0), &arm_limits).expect("a plan");
        let mut ticker = Ticker::new(&arm_limits, 0.0);
        let mut burned_s = vec![0.0; strokes.len()];
        for vector in &plan.moves {
            let tick_stroke = ticker.run(&write(vector));
            if vector.kind == MoveKind::Burn {
                burned_s[vector.stroke as usize] +=
                    f64::from(tick_stroke.ticks()) * f64::from(TICK_S);
            }
        }
        let both = burned_s.iter().zip(strokes);
        both.map(|(burned_s, stroke)| burned_s * burn_speed_mm_s / stroke.length_mm())
            .collect()
    }

    #[test]
    fn a_stock_arm_burns_slow_lines_at_the_requested_speed() {
        let lines = [0.0, 10.0].map(|y| {
            let begin = Point::new(200.0, y);
            Stroke::open(vec![begin, begin + Vec2::new(3.0, 3.0)])
        });
        for speed_mm_s in [1.0, 1.5, 2.0, 3.0, 5.0, 8.0] {
            for times in times_as_long(&lines, speed_mm_s) {
                assert!((times - 1.0).abs() < 0.1, "{times} at {speed_mm_s} mm/s");
            }
        }
    }

    proptest! {
        #[test]
        fn a_stock_arm_burns_lines_at_the_requested_speed(
            burn_speed_mm_s in 1.0..15.0_f64,
            lines in proptest::collection::vec((0.0..360.0_f64, 0.2..2.0_f64), 1..4),
        ) {
            // Shorter lines are burned for whole ticks of 20 ms anyway.
            let strokes: Vec<Stroke> = lines.iter().zip(0_u8..).map(|((turn_deg, wanted_s), i)| {
                let begin = Point::new(200.0, 40.0 * f64::from(i) - 40.0);
                let way = Vec2::from_angle(turn_deg.to_radians()) * (burn_speed_mm_s * wanted_s);
                Stroke::open(vec![begin, begin + way])
            }).collect();
            for times in times_as_long(&strokes, burn_speed_mm_s) {
                // Within 0.05 in nine of ten cases.
                prop_assert!((times - 1.0).abs() < 0.25, "{times}");
            }
        }

        #[test]
        fn a_stock_arm_burns_a_stroke_from_its_start_to_its_end(
            stroke in stroke(),
            burn_speed_mm_s in prop_oneof![1.0..5.0_f64, 2.0..30.0_f64],
        ) {
            let strokes = [stroke];
            prop_assume!(strokes[0].length_mm() > 0.4);
            let laser = Laser { burn_speed_mm_s, ..Laser::default() };
            let arm_limits = ArmLimits { has_ticks: true, ..ArmLimits::default() };
            let pass = Pass::new(DrawingTool::Laser(laser), strokes.to_vec());
            let plan = Plan::new(&[pass], &Paper::level(-40.0), &arm_limits).expect("a plan");
            let off = deviation(&strokes, &lit(&plan));
            // 0.01 in nine of ten strokes, 0.033 in 99 %, and at most 0.069 in eight thousand, for
            // a sharp first corner as close to the start as a laser burns at all.
            prop_assert!(off.largest_mm() <= MIN_BURN_MM, "{off:?}");
        }
    }
}
