//! The tick planner: plans a chain for a stock arm in rounds, until no corner turns the tool too
//! fast.

use crate::path::planner::{Planner, round_down};
use crate::speed::chain::{ChainSpeeds, MIN_SHARE};
use crate::speed::lookahead::ChainVector;
use crate::speed::objective::Objective;
use crate::speed::sampled_acceleration::TickPositions;
use crate::speed::speeds::Speeds;
use crate::ticks::TICK_S;
use crate::ticks::tick_chain::{Breadth, LastPositions, TickChain};
use crate::ticks::tick_fit::TickFit;
use crate::ticks::ticker::Ticker;
use crate::{MoveKind, PlannedVector};

impl Planner<'_> {
    /// Ends the chain and plans its speeds on an arm with ticks.
    pub(crate) fn plan_ticks(&mut self, begin: usize) {
        self.plan_travel(0);
        let Some(ticker) = self.ticker.take() else {
            return;
        };
        let travel_mm_s = round_down(self.travel_mm_s);
        let moves = &self.moves[begin..];
        let mut plan = TickPlan::new(begin, ticker, moves, &self.chain, travel_mm_s);
        let attempt = match self.objective {
            Objective::Fast => {
                // A greedy attempt is often good enough and far cheaper than a search.
                let attempt = self.attempt(&plan, Breadth::ONE);
                if attempt.is_good() {
                    attempt
                } else {
                    self.search(&mut plan)
                }
            }
            // The speed left by a vector limits the next one, and for a laser all of them must be
            // right.
            Objective::Even => self.attempt(&plan, Breadth::MANY),
        };
        plan.ticker
            .set(&mut self.moves[begin..], &attempt.speeds, &attempt.fits);
        self.settle(self.moves.len());
        self.last_positions = self.last_positions.after(&self.chain, &attempt.fits);
        self.ticker = Some(plan.ticker);
        self.chain_speeds = attempt.chain_speeds;
    }

    /// Searches for better speeds: corners at which the sampled acceleration of a pen is too high
    /// are slowed down, and the affected vectors are planned again. If that does not help, the
    /// vectors before them are split. Returns the best attempt.
    fn search(&mut self, plan: &mut TickPlan) -> Attempt {
        let mut attempt = self.attempt(plan, Breadth::MANY);
        let mut best = attempt.clone();
        let (mut splits, mut in_vain) = (0, 0);
        for _ in 0..MAX_ROUNDS {
            // Neither more rounds nor splits would help further.
            let is_cancelled = self.cancel.is_cancelled();
            if is_cancelled || !attempt.is_sharp() || in_vain == MAX_FAILED_ROUNDS {
                break;
            }
            let is_split =
                in_vain >= PATIENCE && splits < MAX_SPLITS && self.split(plan, &mut best);
            if is_split {
                // Continue from the best attempt, whose vectors were just split.
                attempt = best.clone();
                splits += 1;
            } else {
                self.slow_corners(plan, &attempt);
            }
            self.repair(plan, &mut attempt, Breadth::MAX);
            let gets_better = attempt.sharpness() < BETTER * best.sharpness();
            in_vain = if is_split || gets_better {
                0
            } else {
                in_vain + 1
            };
            if is_split || attempt.sharpness() < best.sharpness() {
                best = attempt.clone();
            }
        }
        best
    }

    /// Splits the straight vectors before corners that are still too fast, if they take long
    /// enough. Returns whether any was split.
    ///
    /// The arm keeps the correction that it spreads over the ticks of a vector, and on a long
    /// vector that is always a small increase, which adds up from corner to corner. With two
    /// vectors, some choices keep next to nothing.
    fn split(&mut self, plan: &mut TickPlan, attempt: &mut Attempt) -> bool {
        let sharp = (0..self.chain.len()).filter(|&i| attempt.shares[i] < 1.0);
        let mut split: Vec<usize> = sharp
            .map(|i| self.straight_start(i))
            .filter(|&i| attempt.fits[i].ticks() >= SPLIT_TICKS)
            .collect();
        split.dedup();
        // From the end, so that earlier indices remain valid.
        for &i in split.iter().rev() {
            let second_mm = self.brakes_mm(attempt.speeds[i].peak_mm_s);
            let second_mm = second_mm.min(0.5 * self.chain[i].length_mm);
            let parts = self.moves[plan.begin + i].parts(second_mm);
            let runs = parts.map(|part| ChainVector::of(part.increments(), plan.limits_mm_s[i]));
            self.moves.splice(plan.begin + i..=plan.begin + i, parts);
            self.chain.splice(i..=i, runs);
            plan.split(i);
            attempt.split(i);
        }
        !split.is_empty()
    }

    /// Returns the first of the collinear vectors that end with this one.
    fn straight_start(&self, mut i: usize) -> usize {
        let is_straight = |i: usize| {
            let [a, b] = [i - 1, i].map(|i| self.chain[i].direction);
            a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>() > STRAIGHT_COS
        };
        while i > 0 && is_straight(i) {
            i -= 1;
        }
        i
    }

    /// Returns the length of a second part: enough to brake from this speed to rest, with some
    /// ticks to choose the start of braking.
    fn brakes_mm(&self, speed_mm_s: f64) -> f64 {
        let brakes_mm = 0.5 * speed_mm_s * speed_mm_s / self.arm_limits.acceleration_mm_s2;
        brakes_mm + EVEN_TICKS * f64::from(TICK_S) * speed_mm_s
    }

    fn attempt(&mut self, plan: &TickPlan, breadth: Breadth) -> Attempt {
        let (chain_speeds, speeds) = self.wanted(&plan.limits_mm_s);
        let fits = self.tick_chain(plan, &speeds).fits(&plan.ticker, breadth);
        Attempt {
            shares: self.shares(&fits),
            chain_speeds,
            speeds,
            fits,
        }
    }

    /// Returns the target speeds without ticks. A pen may use the full limit of each vector: the
    /// ticks show what the link allows.
    pub(crate) fn wanted(&mut self, limits_mm_s: &[f64]) -> (ChainSpeeds, Vec<Speeds>) {
        let mut chain_speeds = self.chain_speeds.clone();
        let mut speeds: Vec<Speeds> = chain_speeds.plan(&mut self.chain, self.objective).collect();
        if self.objective == Objective::Fast {
            for (speeds, &limit_mm_s) in speeds.iter_mut().zip(limits_mm_s) {
                speeds.limit_mm_s = limit_mm_s;
            }
        }
        (chain_speeds, speeds)
    }

    /// Replans everything that has changed since an attempt.
    fn repair(&mut self, plan: &TickPlan, attempt: &mut Attempt, breadth: Breadth) {
        let (chain_speeds, speeds) = self.wanted(&plan.limits_mm_s);
        let both = speeds.iter().zip(&attempt.speeds);
        let changed: Vec<bool> = both
            .zip(&attempt.shares)
            .map(|((now, before), share)| now != before || *share < 1.0)
            .collect();
        let chain = self.tick_chain(plan, &speeds);
        chain.repair(&plan.ticker, &mut attempt.fits, &changed, breadth);
        attempt.shares = self.shares(&attempt.fits);
        attempt.chain_speeds = chain_speeds;
        attempt.speeds = speeds;
    }

    fn tick_chain<'a>(&'a self, plan: &'a TickPlan, speeds: &'a [Speeds]) -> TickChain<'a> {
        TickChain {
            cancel: self.cancel,
            objective: self.objective,
            moves: &self.moves[plan.begin..],
            chain: &self.chain,
            speeds,
            over: &plan.over,
            most_mm_s: &plan.most_mm_s,
            before: match self.objective {
                Objective::Fast => self.last_positions,
                Objective::Even => LastPositions::default(),
            },
        }
    }

    /// Returns the allowed share of the sampled acceleration at the corner after each vector.
    fn shares(&self, fits: &[TickFit]) -> Vec<f64> {
        let mut ticks = TickPositions::default();
        for (run, fit) in self.chain.iter().zip(fits) {
            ticks.push(run, &fit.tick_stroke);
        }
        ticks.shares(self.arm_limits.acceleration_mm_s2, MIN_SHARE)
    }

    /// Slows corners that are too fast, more with each round; a corner slower than one step finally
    /// becomes a stop.
    fn slow_corners(&mut self, plan: &mut TickPlan, attempt: &Attempt) {
        let step_mm_s = f64::from(plan.ticker.step_mm_s());
        let shares = attempt.shares.iter().enumerate();
        for (i, share) in shares.filter(|share| *share.1 < 1.0) {
            // Lowering the target alone may round to the same ticks; a higher weight forces a
            // change.
            plan.over[i] = (2.0 * plan.over[i]).min(MAX_OVER);
            let slower_mm_s = attempt.speeds[i].end_mm_s * share;
            let stops = plan.over[i] == MAX_OVER && slower_mm_s < step_mm_s;
            self.chain[i].corner_mm_s = if stops { 0.0 } else { slower_mm_s };
        }
    }
}

/// The chain being planned on an arm with ticks.
struct TickPlan {
    /// Its first vector.
    begin: usize,
    /// The arm's state before it.
    ticker: Ticker,
    /// The maximum speed of each vector, regardless of the link.
    limits_mm_s: Vec<f64>,
    /// The weight of end speeds above the target, for each vector.
    over: Vec<f64>,
    /// The maximum speed in each packet.
    most_mm_s: Vec<f32>,
}

impl TickPlan {
    /// Creates the plan. A vector without a mark has at most `travel_mm_s` or the chain's maximum
    /// speed in its packet.
    fn new(
        begin: usize,
        ticker: Ticker,
        moves: &[PlannedVector],
        chain: &[ChainVector],
        travel_mm_s: f32,
    ) -> Self {
        let limits_mm_s: Vec<f64> = chain.iter().map(|run| run.limit_mm_s).collect();
        let most_mm_s = round_down(limits_mm_s.iter().copied().fold(0.0, f64::max));
        // From rest, an arm reaches only whole steps of speed, and a laser must not burn slower
        // because of that.
        let next_mm_s = (most_mm_s + 0.5 * ticker.step_mm_s()).min(travel_mm_s);
        let most = |vector: &PlannedVector| match vector.kind {
            MoveKind::RunUp => most_mm_s.max(next_mm_s),
            _ => most_mm_s,
        };
        Self {
            begin,
            ticker,
            over: vec![1.0; chain.len()],
            most_mm_s: moves.iter().map(most).collect(),
            limits_mm_s,
        }
    }

    /// Records that a vector became two.
    fn split(&mut self, i: usize) {
        self.over[i] = 1.0;
        self.over.insert(i, 1.0);
        self.most_mm_s.insert(i, self.most_mm_s[i]);
        self.limits_mm_s.insert(i, self.limits_mm_s[i]);
    }
}

/// A chain with its speeds in ticks.
#[derive(Clone)]
struct Attempt {
    chain_speeds: ChainSpeeds,
    /// The target speeds.
    speeds: Vec<Speeds>,
    /// The resulting fits.
    fits: Vec<TickFit>,
    /// The allowed share of the sampled acceleration at the corner after each vector.
    shares: Vec<f64>,
}

impl Attempt {
    /// Whether a search could not improve it much.
    fn is_good(&self) -> bool {
        self.late_share() < MAX_LATE_SHARE && !self.is_sharp()
    }

    /// Records that a vector became two, which must be planned again.
    fn split(&mut self, i: usize) {
        self.speeds.insert(i, self.speeds[i]);
        self.fits.insert(i, self.fits[i]);
        self.shares.insert(i, 0.0);
        self.shares[i + 1] = 0.0;
    }

    /// Whether the sampled acceleration exceeds the limit.
    fn is_sharp(&self) -> bool {
        self.shares.iter().any(|share| *share < 1.0)
    }

    /// Returns the squared excess of the sampled acceleration, summed over all corners.
    fn sharpness(&self) -> f64 {
        self.shares
            .iter()
            .map(|share| (1.0 / share - 1.0).powi(2))
            .sum()
    }

    /// Returns the excess duration as a share of the target.
    fn late_share(&self) -> f64 {
        let wanted_s: f64 = self.speeds.iter().map(|speeds| speeds.duration_s).sum();
        let took_s: f64 = self.fits.iter().map(TickFit::duration_s).sum();
        took_s / wanted_s - 1.0
    }
}

/// A smaller excess duration is not worth a search.
const MAX_LATE_SHARE: f64 = 0.01;
/// The maximum number of rounds for a chain.
const MAX_ROUNDS: u32 = 40;
/// A round is an improvement if it leaves less than this share of the excess.
const BETTER: f64 = 0.8;
/// The number of rounds without improvement before vectors are split.
const PATIENCE: u32 = 2;
/// The number of rounds without improvement that ends the search.
const MAX_FAILED_ROUNDS: u32 = 8;
/// The maximum number of splits.
const MAX_SPLITS: u32 = 6;
/// The minimum number of ticks of a vector to split: each part takes as long as the link needs.
const SPLIT_TICKS: u32 = 8;
/// The number of constant-speed ticks of a second part before it brakes.
const EVEN_TICKS: f64 = 10.0;
/// The cosine above which two vectors are collinear.
const STRAIGHT_COS: f64 = 0.999_999;
/// The maximum weight of end speeds above the target.
const MAX_OVER: f64 = 16.0;
