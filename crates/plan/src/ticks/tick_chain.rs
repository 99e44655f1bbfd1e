//! Search for the speeds of a chain among those that a stock arm's ticks allow.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use dobot_geometry::CancelToken;
use dobot_wire::single;

use crate::path::commands::write;
use crate::speed::lookahead::ChainVector;
use crate::speed::objective::Objective;
use crate::speed::sampled_acceleration::{WINDOW_TICKS, sampled_limit_mm, second_difference};
use crate::speed::speeds::Speeds;
use crate::ticks::TICK_S;
use crate::ticks::tick_fit::{MAX_FITS, MIN_BURN_MM_S, TickFit, TickPreference};
use crate::ticks::ticker::Ticker;
use crate::{MoveKind, PlannedVector};

/// A chain and its target speeds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TickChain<'a> {
    /// Once it is cancelled, the first speeds found are kept.
    pub cancel: &'a CancelToken,
    pub moves: &'a [PlannedVector],
    pub chain: &'a [ChainVector],
    pub speeds: &'a [Speeds],
    pub objective: Objective,
    /// The weight of end speeds above the target, for each vector.
    pub over: &'a [f64],
    /// The maximum speed in each packet, in mm/s.
    pub most_mm_s: &'a [f32],
    /// The tool positions before the chain.
    pub before: LastPositions,
}

/// The tool positions at the last ticks, in mm from an arbitrary origin.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct LastPositions {
    /// A ring buffer.
    places: [[f64; 3]; SAMPLED_TICKS],
    /// The index of the oldest position.
    oldest: usize,
}

impl LastPositions {
    /// Returns the positions after these vectors.
    pub(crate) fn after(mut self, chain: &[ChainVector], fits: &[TickFit]) -> Self {
        for (run, fit) in chain.iter().zip(fits) {
            for speed_mm_s in fit.tick_stroke.speeds_mm_s() {
                self.advance(run.direction, speed_mm_s);
            }
        }
        self
    }

    /// Adds a tick.
    fn advance(&mut self, direction: [f64; 3], speed_mm_s: f32) {
        let (last, way_mm) = (self.last(), f64::from(speed_mm_s * TICK_S));
        self.places[self.oldest] = [0, 1, 2].map(|i| last[i] + way_mm * direction[i]);
        self.oldest = (self.oldest + 1) % SAMPLED_TICKS;
    }

    fn last(&self) -> [f64; 3] {
        self.places[(self.oldest + SAMPLED_TICKS - 1) % SAMPLED_TICKS]
    }

    /// Returns the oldest position and the one a window later.
    fn before_and_now(&self) -> [[f64; 3]; 2] {
        [0, SAMPLED_TICKS / 2].map(|age| self.places[(self.oldest + age) % SAMPLED_TICKS])
    }
}

/// The breadth of the search.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Breadth {
    /// The number of candidates kept (beam width).
    candidates: usize,
    /// The number of continuations per candidate, at most [`MAX_FITS`].
    fits: usize,
    /// The difference in speed, as a share of a tick's change, below which candidates are equal.
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
        fits: MAX_FITS,
        same_share: 0.1,
    };
    pub(crate) const MAX: Self = Self {
        candidates: 20,
        fits: MAX_FITS,
        same_share: 0.1,
    };
    /// For vectors between two rests, at which the arm keeps less than a tick's change.
    pub(crate) const TRAVEL: Self = Self {
        candidates: 8,
        fits: MAX_FITS,
        same_share: 0.05,
    };
}

impl TickChain<'_> {
    /// Finds the speeds with which a stock arm comes closest to the target speeds.
    ///
    /// The best choice for one vector may leave a speed from which the next cannot be executed in
    /// the desired ticks, or turns the tool too fast. Therefore several candidates are kept.
    pub(crate) fn fits(&self, ticker: &Ticker, breadth: Breadth) -> Vec<TickFit> {
        self.follow(0, Candidate::new(ticker, self.before), breadth, |_, _| None)
    }

    /// Replans the changed vectors, and those after them until the arm continues as before and the
    /// link keeps up. Everything else is unchanged.
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
            // Start slightly earlier: the vectors before determine the speed at the change.
            let begin = change.saturating_sub(MARGIN).max(at);
            for (speeds, fit) in self.speeds[at..begin].iter().zip(&fits[at..begin]) {
                here.take(speeds, fit);
            }
            let candidate = Candidate::new(&here, self.positions_before(begin, fits));
            let continues = |i: usize, candidates: &[Candidate]| {
                let ends = (i + 1..changed.len().min(i + 1 + MARGIN)).all(|i| !changed[i]);
                let next = fits.get(i + 1).filter(|_| i >= change && ends)?;
                let max_cost = candidates[0].cost + MAX_LOSS;
                candidates.iter().position(|candidate| {
                    let same = candidate
                        .ticker
                        .tick_stroke_with(&write(&self.moves[i + 1]), next)
                        == next.tick_stroke;
                    let rest = fits[i + 1..].iter().zip(&credits[i + 1..]);
                    same && self.cost_after(i, candidate, fits) <= max_cost
                        && candidate.ticker.keeps_up(rest.take(MAX_AHEAD))
                })
            };
            let again = self.follow(begin, candidate, breadth, continues);
            at = begin + again.len();
            for (speeds, fit) in self.speeds[begin..at].iter().zip(&again) {
                here.take(speeds, fit);
            }
            fits[begin..at].copy_from_slice(&again);
        }
    }

    /// Runs the beam search from a vector on, up to the end of the chain or until `ends` selects a
    /// candidate.
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
            let breadth = if self.cancel.is_cancelled() {
                Breadth::ONE
            } else {
                breadth
            };
            let packet = write(&self.moves[i]);
            let wish = TickPreference {
                objective: self.objective,
                over: self.over[i],
                most_mm_s: self.most_mm_s[i],
                least_mm_s: self.least_mm_s(i),
                same_share: breadth.same_share,
            };
            self.prune_before_long_vector(i, &mut candidates);
            // The heap holds lower bounds first; a candidate is computed only when its bound is the
            // cheapest.
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
        // Follow the links back from the last vector.
        while let Some(step) = last.map(|step| &steps[step]) {
            fits.push(step.fit);
            last = step.before;
        }
        fits.reverse();
        fits
    }

    /// Returns the minimum speed in the packet of a burning laser, unless a lower one is requested.
    fn least_mm_s(&self, i: usize) -> f32 {
        if self.moves[i].kind == MoveKind::Burn && self.most_mm_s[i] >= MIN_BURN_MM_S {
            MIN_BURN_MM_S
        } else {
            0.0
        }
    }

    /// Reduces the candidates before a long vector: its beginning does not affect its end, so only
    /// the candidates that turn best into it are kept.
    fn prune_before_long_vector(&self, i: usize, candidates: &mut Vec<Candidate>) {
        let speeds = &self.speeds[i];
        if candidates.len() <= ALONG_LONG || speeds.duration_s < LONG_S {
            return;
        }
        let turned = |candidate: &Candidate| {
            let mut candidate = candidate.clone();
            let change = candidate.ticker.step_mm_s();
            let faster = std::iter::successors(Some(candidate.ticker.stored_mm_s()), |mm_s| {
                Some(mm_s + change)
            });
            let most = single(speeds.peak_mm_s);
            candidate.sample_ticks(self.chain[i].direction, faster.map(|mm_s| mm_s.min(most)));
            candidate.cost + candidate.recovery
        };
        let mut turned: Vec<(f64, Candidate)> = candidates
            .drain(..)
            .map(|candidate| (turned(&candidate), candidate))
            .collect();
        turned.sort_by(|a, b| a.0.total_cmp(&b.0));
        candidates.extend(turned.into_iter().take(ALONG_LONG).map(|turned| turned.1));
    }

    /// Returns the cheapest candidates after a vector that leave different speeds, the best first.
    /// Their sampled positions are computed only if they may be among these.
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
            // Equal end speeds have the same continuations, so only the cheapest is kept.
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

    /// Returns the cost of a candidate after which the arm continues as before, including the
    /// samples that depend on the candidate.
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

    /// Returns the tool positions at the last ticks before a vector.
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

/// A candidate for the speeds of the first vectors of a chain.
#[derive(Clone, Debug)]
struct Candidate {
    /// The arm's state after them.
    ticker: Ticker,
    cost: f64,
    /// The cost of accelerating to the target speed again afterwards.
    recovery: f64,
    /// Its last step.
    last: Option<usize>,
    places: LastPositions,
}

impl Candidate {
    /// Creates the candidate before the first vector.
    fn new(ticker: &Ticker, places: LastPositions) -> Self {
        Self {
            ticker: ticker.clone(),
            cost: 0.0,
            recovery: 0.0,
            last: None,
            places,
        }
    }

    /// Returns the candidate with one more vector.
    fn step(&self, speeds: &Speeds, fit: &TickFit, direction: [f64; 3]) -> Self {
        let mut next = self.clone();
        next.ticker.take(speeds, fit);
        next.cost += fit.cost;
        next.recovery = fit.recovery;
        next.sample(direction, fit);
        next
    }

    /// Adds the cost of the sampled acceleration of a vector. After its first ticks, only the
    /// vector itself is sampled, which respects the acceleration.
    fn sample(&mut self, direction: [f64; 3], fit: &TickFit) {
        let mut speeds_mm_s = fit.tick_stroke.speeds_mm_s();
        self.sample_ticks(direction, speeds_mm_s.by_ref());
        // Of the rest, only the last ticks will be sampled later.
        let (mut last_mm_s, mut count) = ([0.0; SAMPLED_TICKS], 0);
        for (last, speed_mm_s) in last_mm_s.iter_mut().zip(speeds_mm_s.rev()) {
            *last = speed_mm_s;
            count += 1;
        }
        for &speed_mm_s in last_mm_s[..count].iter().rev() {
            self.places.advance(direction, speed_mm_s);
        }
    }

    /// Adds the cost of the sampled acceleration in the first ticks of a vector.
    fn sample_ticks(&mut self, direction: [f64; 3], speeds_mm_s: impl Iterator<Item = f32>) {
        let allowed_mm = sampled_limit_mm(self.ticker.acceleration_mm_s2());
        for speed_mm_s in speeds_mm_s.take(SAMPLED_TICKS) {
            let [before, now] = self.places.before_and_now();
            self.places.advance(direction, speed_mm_s);
            let sampled_mm = second_difference(before, now, self.places.last());
            if sampled_mm > allowed_mm {
                self.cost += (sampled_mm / allowed_mm - 1.0).powi(2) * BEYOND;
            }
        }
    }
}

/// The speeds of one vector of a candidate.
#[derive(Clone, Copy, Debug)]
struct Step {
    fit: TickFit,
    /// The step before, if any.
    before: Option<usize>,
}

/// A possible continuation of a candidate.
#[derive(Debug)]
struct Choice {
    /// A lower bound of the cost, or the exact cost once the candidate is known.
    cost: f64,
    /// The candidate that it continues.
    before: usize,
    fit: TickFit,
    /// The resulting candidate, once computed.
    candidate: Option<Box<Candidate>>,
}

impl Ord for Choice {
    /// Orders the cheaper one as greater, for a max-heap.
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

/// The ticks from two windows ago to now, without the last.
const SAMPLED_TICKS: usize = 2 * WINDOW_TICKS;
/// The cost, in ticks, of sampling twice the allowed acceleration; it grows with the square of the
/// excess.
const BEYOND: f64 = 30_000.0;
/// The number of candidates kept along a vector of this duration.
const ALONG_LONG: usize = 4;
const LONG_S: f64 = 0.8;
/// The number of vectors before and after a change that are replanned too.
const MARGIN: usize = 2;
/// The extra cost over the best that a candidate may have if the arm continues as before.
const MAX_LOSS: f64 = 4.0;
/// The number of vectors over which the link must not wait more than before.
const MAX_AHEAD: usize = 200;

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

    /// Checks that each vector has its length, and that none finishes before its successor can
    /// arrive.
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
        fn a_repaired_chain_is_exact_and_keeps_up_with_the_link(
            candidates in proptest::collection::vec([-3.0..3.0_f32, 0.1..3.0_f32], 2..60),
            slower in proptest::collection::vec((0..60_usize, 0.1..0.9_f64), 1..6),
        ) {
            let arm_limits = ArmLimits { has_ticks: true, ..ArmLimits::default() };
            let ticker = Ticker::new(&arm_limits, 0.0);
            let moves: Vec<PlannedVector> = candidates.into_iter().map(vector).collect();
            let run = |vector: &PlannedVector| ChainVector::of(vector.increments(), 40.0);
            let mut chain: Vec<ChainVector> = moves.iter().map(run).collect();
            let (over, most_mm_s) = (vec![1.0; moves.len()], vec![40.0; moves.len()]);
            let before: Vec<Speeds> = ChainSpeeds::new(&arm_limits).plan(&mut chain, Objective::Fast).collect();
            let mut fits = TickChain { cancel: &CancelToken::default(), moves: &moves, chain: &chain, speeds: &before, objective: Objective::Fast, over: &over, most_mm_s: &most_mm_s, before: LastPositions::default() }
                .fits(&ticker, Breadth::MANY);
            check(&ticker, &moves, &before, &fits)?;
            for (at, share) in slower {
                let at = at % chain.len();
                chain[at].corner_mm_s = before[at].end_mm_s * share;
            }
            let speeds: Vec<Speeds> = ChainSpeeds::new(&arm_limits).plan(&mut chain, Objective::Fast).collect();
            let changed: Vec<bool> = speeds.iter().zip(&before).map(|(now, before)| now != before).collect();
            TickChain { cancel: &CancelToken::default(), moves: &moves, chain: &chain, speeds: &speeds, objective: Objective::Fast, over: &over, most_mm_s: &most_mm_s, before: LastPositions::default() }
                .repair(&ticker, &mut fits, &changed, Breadth::MANY);
            prop_assert_eq!(fits.len(), moves.len());
            check(&ticker, &moves, &speeds, &fits)?;
        }
    }
}
