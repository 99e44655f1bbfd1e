//! Pen-up vectors from rest to rest: between strokes, and the moves of a dot.
//!
//! A stock arm keeps less than a tick's change of speed at a rest and begins the next vector with
//! it (note N48). A single vector cannot choose that speed, so consecutive vectors are planned
//! together.
//!
//! ```text
//!   stroke |  Lift . Travel . Lower |  stroke        . a rest between two travel vectors
//!          '------------------------'
//!               planned together
//! ```

use crate::path::planner::{Planner, round_down};
use crate::speed::lookahead::ChainVector;
use crate::speed::objective::Objective;
use crate::speed::speeds::Speeds;
use crate::ticks::tick_chain::{Breadth, TickChain};

/// The travel vectors not yet planned.
#[derive(Debug, Default)]
pub(crate) struct TravelVectors {
    chain: Vec<ChainVector>,
    /// The speeds without ticks.
    speeds: Vec<Speeds>,
    /// The maximum speed in each packet.
    most_mm_s: Vec<f32>,
}

impl Planner<'_> {
    /// Records the chain as a single travel vector.
    pub(crate) fn push_travel(&mut self) {
        let limits_mm_s = [self.chain[0].limit_mm_s];
        let (chain_speeds, speeds) = self.wanted(&limits_mm_s);
        self.chain_speeds = chain_speeds;
        self.travel.chain.push(self.chain[0]);
        self.travel.speeds.extend(speeds);
        self.travel.most_mm_s.push(round_down(limits_mm_s[0]));
        // Bound the memory and the time of the search in drawings of many dots.
        if self.travel.chain.len() >= MAX_TRAVEL {
            self.chain.clear();
            self.plan_travel(TRAVEL_BEFORE_LAST);
        }
    }

    /// Plans the recorded travel vectors, which directly precede the chain, except the last `but`,
    /// whose plans may change with their successors.
    pub(crate) fn plan_travel(&mut self, but: usize) {
        let Some(mut ticker) = self.ticker.take() else {
            return;
        };
        let end = self.moves.len() - self.chain.len();
        let begin = end - self.travel.chain.len();
        // The positions show the speeds kept between the vectors; the successor of the last one is
        // unknown.
        let mut over = vec![0.0; self.travel.chain.len()];
        if let Some(last) = over.last_mut() {
            *last = 1.0;
        }
        let fits = TickChain {
            cancel: self.cancel,
            moves: &self.moves[begin..end],
            chain: &self.travel.chain,
            speeds: &self.travel.speeds,
            objective: Objective::Fast,
            over: &over,
            most_mm_s: &self.travel.most_mm_s,
            before: self.last_positions,
        }
        .fits(&ticker, Breadth::TRAVEL);
        let planned = fits.len().saturating_sub(but);
        let (fits, moves) = (&fits[..planned], &mut self.moves[begin..]);
        ticker.set(moves, &self.travel.speeds, fits);
        self.last_positions = self.last_positions.after(&self.travel.chain, fits);
        self.travel.chain.drain(..planned);
        self.travel.speeds.drain(..planned);
        self.travel.most_mm_s.drain(..planned);
        self.ticker = Some(ticker);
        self.settle(begin + planned);
    }
}

/// The maximum number of travel vectors planned together.
const MAX_TRAVEL: usize = 60;
/// The number of these that are planned again with their successors.
const TRAVEL_BEFORE_LAST: usize = 12;
