//! Vectors from rest to rest: from one stroke to the next, and all of a dot.
//!
//! A stock arm keeps less than a tick's change of speed at a rest, and begins the next vector with it (note N48). What a lone
//! vector keeps is no choice of its own: so those in a row are planned together.
//!
//! ```text
//!   stroke |  Lift . Travel . Lower |  stroke        . a rest between two lone vectors
//!          '------------------------'
//!               planned together
//! ```

use crate::path::planner::{Planner, round_down};
use crate::speed::lookahead::ChainVector;
use crate::speed::objective::Objective;
use crate::speed::speeds::Speeds;
use crate::ticks::tick_chain::{Breadth, TickChain};

/// Those that are not planned yet.
#[derive(Debug, Default)]
pub(crate) struct TravelVectors {
    chain: Vec<ChainVector>,
    /// How each should be run if there were no ticks.
    speeds: Vec<Speeds>,
    /// No packet may tell a larger speed.
    most_mm_s: Vec<f32>,
}

impl Planner<'_> {
    /// The chain is a lone vector.
    pub(crate) fn push_travel(&mut self) {
        let limits_mm_s = [self.chain[0].limit_mm_s];
        let (chain_speeds, speeds) = self.wanted(&limits_mm_s);
        self.chain_speeds = chain_speeds;
        self.travel.chain.push(self.chain[0]);
        self.travel.speeds.extend(speeds);
        self.travel.most_mm_s.push(round_down(limits_mm_s[0]));
        if self.travel.chain.len() >= MOST_TRAVEL {
            self.chain.clear();
            self.plan_travel(TRAVEL_BEFORE_LAST);
        }
    }

    /// Plans the lone vectors so far, which are the last ones before the chain: all but so many of them, whose plans may
    /// change with what follows.
    pub(crate) fn plan_travel(&mut self, but: usize) {
        let Some(mut ticker) = self.ticker.take() else {
            return;
        };
        let end = self.moves.len() - self.chain.len();
        let begin = end - self.travel.chain.len();
        // What is kept between them is seen; what follows the last one is not known.
        let mut over = vec![0.0; self.travel.chain.len()];
        if let Some(last) = over.last_mut() {
            *last = 1.0;
        }
        let fits = TickChain {
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

/// So many lone vectors are planned together at the most.
const MOST_TRAVEL: usize = 60;
/// So many of these are planned again with those that follow.
const TRAVEL_BEFORE_LAST: usize = 12;
