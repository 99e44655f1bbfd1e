//! How a stock arm is to run a chain of vectors: a search among the ways that its ticks allow.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use dobot_wire::single;

use crate::path::commands::write;
use crate::speed::lookahead::ChainVector;
use crate::speed::objective::Objective;
use crate::speed::sampled_acceleration::{WINDOW_TICKS, sampled_limit_mm, second_difference};
use crate::speed::speeds::Speeds;
use crate::ticks::tick::TICK_S;
use crate::ticks::tick_fit::{LEAST_BURN_MM_S, MOST_FITS, TickFit, TickPreference};
use crate::ticks::ticker::Ticker;
use crate::{MoveKind, PlannedVector};

/// A chain, and what is wanted of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TickChain<'a> {
    pub moves: &'a [PlannedVector],
    pub chain: &'a [ChainVector],
    pub speeds: &'a [Speeds],
    pub objective: Objective,
    /// How many times as much an end speed above the one wanted counts, for each vector.
    pub over: &'a [f64],
    /// No packet may tell a larger speed, in mm/s, for each vector.
    pub most_mm_s: &'a [f32],
    /// Where the tool was before it.
    pub before: LastPositions,
}

/// Where the tool was at the last ticks, in mm from anywhere.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct LastPositions {
    /// In a ring.
    places: [[f64; 3]; SAMPLED_TICKS],
    /// Where the oldest one is.
    oldest: usize,
}

impl LastPositions {
    /// The same behind these vectors.
    pub(crate) fn after(mut self, chain: &[ChainVector], fits: &[TickFit]) -> Self {
        for (run, fit) in chain.iter().zip(fits) {
            for speed_mm_s in fit.tick_stroke.speeds_mm_s() {
                self.advance(run.direction, speed_mm_s);
            }
        }
        self
    }

    /// One more tick.
    fn advance(&mut self, direction: [f64; 3], speed_mm_s: f32) {
        let (last, way_mm) = (self.last(), f64::from(speed_mm_s * TICK_S));
        self.places[self.oldest] = [0, 1, 2].map(|i| last[i] + way_mm * direction[i]);
        self.oldest = (self.oldest + 1) % SAMPLED_TICKS;
    }

    fn last(&self) -> [f64; 3] {
        self.places[(self.oldest + SAMPLED_TICKS - 1) % SAMPLED_TICKS]
    }

    /// The oldest one, and that of a window later.
    fn before_and_now(&self) -> [[f64; 3]; 2] {
        [0, SAMPLED_TICKS / 2].map(|it| self.places[(self.oldest + it) % SAMPLED_TICKS])
    }
}

/// How far a search looks.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Breadth {
    /// So many ways are followed.
    candidates: usize,
    /// Each is continued so often, at most [`MOST_FITS`] times.
    fits: usize,
    /// Ways whose speeds have so little of a tick's change between them are the same.
    same_share: f32,
}

impl Breadth {
    pub(crate) const ONE: Self = Self {
        candidates: 1,
        fits: 1,
        same_share: 0.25,
    };
    pub(crate) const MANY: Self = Self {
        candidates: 8,
        fits: MOST_FITS,
        same_share: 0.1,
    };
    pub(crate) const MOST: Self = Self {
        candidates: 20,
        fits: MOST_FITS,
        same_share: 0.1,
    };
    /// For vectors between two rests, of which the arm keeps less than a tick's change.
    pub(crate) const TRAVEL: Self = Self {
        candidates: 8,
        fits: MOST_FITS,
        same_share: 0.05,
    };
}

impl TickChain<'_> {
    /// The speeds with which a stock arm comes nearest to those wanted, and how it runs the vectors then.
    ///
    /// What is best for one vector may leave a speed from which the next cannot be run in the
    /// ticks that it should take, or turns the tool too fast. So several choices are followed.
    pub(crate) fn fits(&self, ticker: &Ticker, breadth: Breadth) -> Vec<TickFit> {
        self.follow(0, Candidate::new(ticker, self.before), breadth, |_, _| None)
    }

    /// Runs the changed vectors anew, and those after them until the arm goes on as it did and the link keeps up: what
    /// lies between the changes stays as it is.
    pub(crate) fn repair(
        &self,
        ticker: &Ticker,
        fits: &mut [TickFit],
        changed: &[bool],
        breadth: Breadth,
    ) {
        let credits = ticker.credits(fits);
        let (mut here, mut at) = (ticker.clone(), 0);
        let next_change = |from: usize| (from..changed.len()).find(|&i| changed[i]);
        while let Some(change) = next_change(at) {
            let begin = change.saturating_sub(MARGIN).max(at);
            for (speeds, fit) in self.speeds[at..begin].iter().zip(&fits[at..begin]) {
                here.take(speeds, fit);
            }
            let candidate = Candidate::new(&here, self.positions_before(begin, fits));
            let goes_on = |i: usize, candidates: &[Candidate]| {
                let ends = (i + 1..changed.len().min(i + 1 + MARGIN)).all(|it| !changed[it]);
                let next = fits.get(i + 1).filter(|_| i >= change && ends)?;
                let max_cost = candidates[0].cost + MOST_LOSS;
                candidates.iter().position(|candidate| {
                    let same = candidate
                        .ticker
                        .tick_stroke_with(&write(&self.moves[i + 1]), next)
                        == next.tick_stroke;
                    let rest = fits[i + 1..].iter().zip(&credits[i + 1..]);
                    same && self.cost_after(i, candidate, fits) <= max_cost
                        && candidate.ticker.keeps_up(rest.take(MOST_AHEAD))
                })
            };
            let anew = self.follow(begin, candidate, breadth, goes_on);
            at = begin + anew.len();
            for (speeds, fit) in self.speeds[begin..at].iter().zip(&anew) {
                here.take(speeds, fit);
            }
            fits[begin..at].copy_from_slice(&anew);
        }
    }

    /// The best way from a vector on, as far as the chain goes or `ends` chooses one of the ways behind a vector.
    fn follow(
        &self,
        begin: usize,
        first: Candidate,
        breadth: Breadth,
        ends: impl Fn(usize, &[Candidate]) -> Option<usize>,
    ) -> Vec<TickFit> {
        let mut steps: Vec<Step> = Vec::new();
        let mut candidates = vec![first];
        for i in begin..self.moves.len() {
            let packet = write(&self.moves[i]);
            let wish = TickPreference {
                objective: self.objective,
                over: self.over[i],
                most_mm_s: self.most_mm_s[i],
                least_mm_s: self.least_mm_s(i),
                same_share: breadth.same_share,
            };
            self.prune_before_long_vector(i, &mut candidates);
            let mut choices = BinaryHeap::new();
            for (before, candidate) in candidates.iter().enumerate() {
                let fits = candidate.ticker.fits(&packet, self.speeds[i], wish);
                let fits = fits.into_iter().take(breadth.fits);
                choices.extend(fits.map(|fit| Choice {
                    cost: candidate.cost + fit.cost + fit.recovery,
                    before,
                    fit,
                    candidate: None,
                }));
            }
            candidates = self.select_best(i, &candidates, choices, breadth, &mut steps);
            if let Some(chosen) = ends(i, &candidates) {
                candidates.swap(0, chosen);
                break;
            }
        }
        let mut fits = Vec::new();
        let mut last = candidates[0].last;
        while let Some(step) = last.map(|it| &steps[it]) {
            fits.push(step.fit);
            last = step.before;
        }
        fits.reverse();
        fits
    }

    /// No packet for a burning laser tells less than is allowed to burn with, unless less is wanted.
    fn least_mm_s(&self, i: usize) -> f32 {
        if self.moves[i].kind == MoveKind::Burn && self.most_mm_s[i] >= LEAST_BURN_MM_S {
            LEAST_BURN_MM_S
        } else {
            0.0
        }
    }

    /// How a long vector begins does not matter for how it ends: only the ways that turn into it the best are followed along it.
    fn prune_before_long_vector(&self, i: usize, candidates: &mut Vec<Candidate>) {
        let speeds = &self.speeds[i];
        if candidates.len() <= ALONG_LONG || speeds.duration_s < LONG_S {
            return;
        }
        let turned = |candidate: &Candidate| {
            let mut candidate = candidate.clone();
            let change = candidate.ticker.step_mm_s();
            let faster =
                std::iter::successors(Some(candidate.ticker.stored_mm_s()), |it| Some(it + change));
            let most = single(speeds.peak_mm_s);
            candidate.sample_ticks(self.chain[i].direction, faster.map(|it| it.min(most)));
            candidate.cost + candidate.recovery
        };
        let mut turned: Vec<(f64, Candidate)> = candidates
            .drain(..)
            .map(|candidate| (turned(&candidate), candidate))
            .collect();
        turned.sort_by(|a, b| a.0.total_cmp(&b.0));
        candidates.extend(turned.into_iter().take(ALONG_LONG).map(|it| it.1));
    }

    /// The cheapest ways over a vector that leave different speeds, the best first. What is seen of them is looked at only
    /// where they may be among these.
    fn select_best(
        &self,
        i: usize,
        candidates: &[Candidate],
        mut choices: BinaryHeap<Choice>,
        breadth: Breadth,
        steps: &mut Vec<Step>,
    ) -> Vec<Candidate> {
        let mut best: Vec<Candidate> = Vec::with_capacity(breadth.candidates);
        while best.len() < breadth.candidates
            && let Some(choice) = choices.pop()
        {
            let (before, fit) = (&candidates[choice.before], choice.fit);
            let same_mm_s = breadth.same_share * before.ticker.step_mm_s();
            let is_new = |other: &Candidate| {
                (other.ticker.stored_mm_s() - fit.tick_stroke.end_mm_s).abs() >= same_mm_s
            };
            if !best.iter().all(is_new) {
                continue;
            }
            if let Some(candidate) = choice.candidate {
                steps.push(Step {
                    fit,
                    before: before.last,
                });
                best.push(Candidate {
                    last: Some(steps.len() - 1),
                    ..*candidate
                });
            } else {
                let candidate = before.step(&self.speeds[i], &fit, self.chain[i].direction);
                choices.push(Choice {
                    cost: candidate.cost + candidate.recovery,
                    candidate: Some(Box::new(candidate)),
                    ..choice
                });
            }
        }
        best
    }

    /// The cost of a way over a vector behind which the arm goes on as it did, with what is seen as long as that depends on the way.
    fn cost_after(&self, i: usize, candidate: &Candidate, fits: &[TickFit]) -> f64 {
        let mut candidate = candidate.clone();
        let mut ticks = 0;
        for (run, fit) in self.chain[i + 1..].iter().zip(&fits[i + 1..]) {
            if ticks >= SAMPLED_TICKS {
                break;
            }
            candidate.sample(run.direction, fit);
            ticks += fit.ticks() as usize;
        }
        candidate.cost
    }

    /// Where the tool is at the last ticks before a vector.
    fn positions_before(&self, begin: usize, fits: &[TickFit]) -> LastPositions {
        let mut from = begin;
        let mut ticks = 0;
        while from > 0 && ticks < SAMPLED_TICKS {
            from -= 1;
            ticks += fits[from].ticks() as usize;
        }
        let before = if ticks < SAMPLED_TICKS {
            self.before
        } else {
            LastPositions::default()
        };
        before.after(&self.chain[from..begin], &fits[from..begin])
    }
}

/// A way to run the first vectors of a chain.
#[derive(Clone, Debug)]
struct Candidate {
    /// What the arm carries over behind them.
    ticker: Ticker,
    cost: f64,
    /// What it costs to be as fast as wanted again behind them.
    recovery: f64,
    /// Its last step.
    last: Option<usize>,
    places: LastPositions,
}

impl Candidate {
    /// Before the first vector.
    fn new(ticker: &Ticker, places: LastPositions) -> Self {
        Self {
            ticker: ticker.clone(),
            cost: 0.0,
            recovery: 0.0,
            last: None,
            places,
        }
    }

    /// The way with one more vector.
    fn step(&self, speeds: &Speeds, fit: &TickFit, direction: [f64; 3]) -> Self {
        let mut next = self.clone();
        next.ticker.take(speeds, fit);
        next.cost += fit.cost;
        next.recovery = fit.recovery;
        next.sample(direction, fit);
        next
    }

    /// What is seen while a vector is run like that, as a cost. Behind its first ticks only the vector itself is seen, which
    /// accelerates no more than it may.
    fn sample(&mut self, direction: [f64; 3], fit: &TickFit) {
        let mut speeds_mm_s = fit.tick_stroke.speeds_mm_s();
        self.sample_ticks(direction, speeds_mm_s.by_ref());
        // Of the rest the last ticks will be seen.
        let (mut last_mm_s, mut count) = ([0.0; SAMPLED_TICKS], 0);
        for (last, speed_mm_s) in last_mm_s.iter_mut().zip(speeds_mm_s.rev()) {
            *last = speed_mm_s;
            count += 1;
        }
        for &speed_mm_s in last_mm_s[..count].iter().rev() {
            self.places.advance(direction, speed_mm_s);
        }
    }

    /// What is seen in the first ticks of a vector, as a cost.
    fn sample_ticks(&mut self, direction: [f64; 3], speeds_mm_s: impl Iterator<Item = f32>) {
        let allowed_mm = sampled_limit_mm(self.ticker.acceleration_mm_s2());
        for speed_mm_s in speeds_mm_s.take(SAMPLED_TICKS) {
            let [before, now] = self.places.before_and_now();
            self.places.advance(direction, speed_mm_s);
            let sampled_limit_mm = second_difference(before, now, self.places.last());
            if sampled_limit_mm > allowed_mm {
                self.cost += (sampled_limit_mm / allowed_mm - 1.0).powi(2) * BEYOND;
            }
        }
    }
}

/// How one vector of a way is run.
#[derive(Clone, Copy, Debug)]
struct Step {
    fit: TickFit,
    /// The step before, where there is one.
    before: Option<usize>,
}

/// How a way may go on.
#[derive(Debug)]
struct Choice {
    /// What it costs at the least, or if its way is known just that.
    cost: f64,
    /// The way that it goes on from.
    before: usize,
    fit: TickFit,
    /// The way as it is then, where it was looked at.
    candidate: Option<Box<Candidate>>,
}

impl Ord for Choice {
    /// The cheaper one is the greater one.
    fn cmp(&self, other: &Self) -> Ordering {
        other.cost.total_cmp(&self.cost)
    }
}

impl PartialOrd for Choice {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Eq for Choice {}

impl PartialEq for Choice {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

/// From where the tool was a window ago to where it is, both ends included, without the last.
const SAMPLED_TICKS: usize = 2 * WINDOW_TICKS;
/// How many ticks it is worth not to be seen to accelerate twice as much as allowed; in the square of what is too much.
const BEYOND: f64 = 30_000.0;
/// So many ways are followed along a vector that takes so long.
const ALONG_LONG: usize = 4;
const LONG_S: f64 = 0.8;
/// So many vectors before a change and behind it are run anew too.
const MARGIN: usize = 2;
/// How much worse than the best a way may be that goes on as the arm did.
const MOST_LOSS: f64 = 4.0;
/// So many vectors later the link is to wait for none of them more than it did.
const MOST_AHEAD: usize = 200;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::ArmLimits;
    use crate::speed::chain::ChainSpeeds;

    fn vector([x_mm, y_mm]: [f32; 2]) -> PlannedVector {
        PlannedVector {
            x_mm,
            y_mm,
            z_mm: 0.0,
            start_speed_mm_s: 0.0,
            end_speed_mm_s: 0.0,
            max_speed_mm_s: 0.0,
            duration_s: 0.0,
            kind: MoveKind::Draw,
            stroke: 0,
            pass: 0,
        }
    }

    /// Each vector is as long as it should be, and none is over before its successor can be there.
    fn check(
        ticker: &Ticker,
        moves: &[PlannedVector],
        speeds: &[Speeds],
        fits: &[TickFit],
    ) -> Result<(), TestCaseError> {
        let mut ticker = ticker.clone();
        for ((vector, speeds), fit) in moves.iter().zip(speeds).zip(fits) {
            let packet = write(vector);
            prop_assert_eq!(ticker.tick_stroke_with(&packet, fit), fit.tick_stroke);
            prop_assert!(fit.tick_stroke.is_exact());
            prop_assert!(fit.ticks() >= ticker.least_ticks());
            ticker.take(speeds, fit);
        }
        Ok(())
    }

    proptest! {
        #[test]
        fn a_repaired_chain_runs_true_and_keeps_up_with_the_link(
            candidates in proptest::collection::vec([-3.0..3.0_f32, 0.1..3.0_f32], 2..60),
            slower in proptest::collection::vec((0..60_usize, 0.1..0.9_f64), 1..6),
        ) {
            let arm_limits = ArmLimits { has_ticks: true, ..ArmLimits::default() };
            let ticker = Ticker::new(&arm_limits, 0.0);
            let moves: Vec<PlannedVector> = candidates.into_iter().map(vector).collect();
            let run = |it: &PlannedVector| ChainVector::of(it.increments(), 40.0);
            let mut chain: Vec<ChainVector> = moves.iter().map(run).collect();
            let (over, most_mm_s) = (vec![1.0; moves.len()], vec![40.0; moves.len()]);
            let before: Vec<Speeds> = ChainSpeeds::new(&arm_limits).plan(&mut chain, Objective::Fast).collect();
            let mut fits = TickChain { moves: &moves, chain: &chain, speeds: &before, objective: Objective::Fast, over: &over, most_mm_s: &most_mm_s, before: LastPositions::default() }
                .fits(&ticker, Breadth::MANY);
            check(&ticker, &moves, &before, &fits)?;
            for (at, share) in slower {
                let at = at % chain.len();
                chain[at].corner_mm_s = before[at].end_mm_s * share;
            }
            let speeds: Vec<Speeds> = ChainSpeeds::new(&arm_limits).plan(&mut chain, Objective::Fast).collect();
            let changed: Vec<bool> = speeds.iter().zip(&before).map(|(now, before)| now != before).collect();
            TickChain { moves: &moves, chain: &chain, speeds: &speeds, objective: Objective::Fast, over: &over, most_mm_s: &most_mm_s, before: LastPositions::default() }
                .repair(&ticker, &mut fits, &changed, Breadth::MANY);
            prop_assert_eq!(fits.len(), moves.len());
            check(&ticker, &moves, &speeds, &fits)?;
        }
    }
}
