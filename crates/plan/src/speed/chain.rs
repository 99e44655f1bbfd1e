//! Planning of the speeds between two rests within acceleration and link limits.

use std::iter::repeat;

use dobot_geometry::CancelToken;

use crate::ArmLimits;
use crate::speed::link::Credit;
use crate::speed::lookahead::{ChainVector, Cornering, Junction};
use crate::speed::objective::Objective;
use crate::speed::sampled_acceleration::SampledMotion;
use crate::speed::speeds::Speeds;

/// The speed planner of a chain; its buffers are reused.
#[derive(Clone, Debug)]
pub(crate) struct ChainSpeeds {
    cornering: Cornering,
    cancel: CancelToken,
    /// Seconds between packets.
    period_s: f64,
    /// The vectors queued in the arm.
    credit: Credit,
    junctions: Vec<Junction>,
    /// The target duration of each vector, in s.
    wanted_s: Vec<f64>,
    speeds: Vec<Speeds>,
    /// The speeds at the last check of the sampled acceleration.
    sampled: Vec<Speeds>,
}

impl ChainSpeeds {
    pub(crate) fn new(arm_limits: &ArmLimits) -> Self {
        Self {
            cornering: Cornering {
                acceleration_mm_s2: arm_limits.planned_acceleration_mm_s2(),
                ..arm_limits.cornering()
            },
            cancel: CancelToken::default(),
            period_s: arm_limits.link.period_s,
            credit: Credit::new(arm_limits.link),
            junctions: Vec::new(),
            wanted_s: Vec::new(),
            speeds: Vec::new(),
            sampled: Vec::new(),
        }
    }

    /// Ends the rounds of a plan once the token is cancelled.
    pub(crate) fn until(self, cancel: &CancelToken) -> Self {
        Self {
            cancel: cancel.clone(),
            ..self
        }
    }

    /// Takes into account that vectors of longer duration are divided.
    pub(crate) fn with_pieces(self, piece_s: f64) -> Self {
        Self {
            credit: self.credit.with_pieces(piece_s),
            ..self
        }
    }

    /// Returns the speeds of the chain's vectors, from rest to rest. Lowers its limits where the
    /// link requires it.
    pub(crate) fn plan<'a>(
        &'a mut self,
        chain: &'a mut [ChainVector],
        objective: Objective,
    ) -> impl Iterator<Item = Speeds> + 'a {
        self.plan_from(0.0, chain, objective)
    }

    /// Returns the speeds of the chain's vectors from an initial speed. If the distance is too
    /// short for braking, it is ignored.
    pub(crate) fn plan_from<'a>(
        &'a mut self,
        begin_mm_s: f64,
        chain: &'a mut [ChainVector],
        objective: Objective,
    ) -> impl Iterator<Item = Speeds> + 'a {
        self.cornering
            .set_junctions(begin_mm_s, chain, &mut self.junctions);
        let slow_from = match objective {
            Objective::Even => Some(0),
            Objective::Fast => {
                self.plan_motion(chain);
                // Up to the first wait the queue covers short vectors, so their limits need not be
                // lowered.
                self.first_wait().map(|waits| waits.saturating_sub(REACH))
            }
        };
        if let Some(from) = slow_from {
            self.lower_to_link(chain, from);
            self.plan_motion(chain);
        }
        self.plan_with_link(chain);
        self.speeds.iter().copied()
    }

    /// Returns the first vector that would finish before the next one arrives, after the queue is
    /// used up.
    fn first_wait(&self) -> Option<usize> {
        let mut credit = self.credit;
        self.wanted_s.iter().position(|&wanted_s| {
            let waits = wanted_s < credit.least_s();
            credit.take(wanted_s);
            waits
        })
    }

    /// Averages the limits from a vector on: a short vector between long ones may be fast, because
    /// others arrive in the meantime.
    fn lower_to_link(&self, chain: &mut [ChainVector], from: usize) {
        let lengths: Vec<f64> = chain.iter().map(|run| run.length_mm).collect();
        for (i, run) in chain.iter_mut().enumerate().skip(from) {
            let near = &lengths[i.saturating_sub(REACH)..lengths.len().min(i + REACH + 1)];
            #[expect(clippy::cast_precision_loss, reason = "a handful")]
            let packets_s = near.len() as f64 * self.period_s;
            let even_mm_s = near.iter().sum::<f64>() / packets_s;
            let alone_mm_s = run.length_mm / self.period_s;
            run.limit_mm_s = run.limit_mm_s.min(even_mm_s.max(alone_mm_s));
        }
    }

    /// Iterates until acceleration and link limits hold, from the planned motion. Without a link every
    /// vector is available immediately.
    fn plan_with_link(&mut self, chain: &mut [ChainVector]) {
        self.sampled.clear();
        for round in 0..ROUNDS {
            if self.cancel.is_cancelled() {
                break;
            }
            let credit = self.credit;
            let keeps_up = self.wait_for_link(chain);
            // Stop only when neither the corners nor the link changed anything in this round.
            if !self.ease_corners(chain, 1 + round / PATIENCE) && keeps_up {
                return;
            }
            self.credit = credit;
            self.plan_motion(chain);
        }
        // Slow enough regardless of the neighbours.
        for run in chain.iter_mut() {
            run.limit_mm_s = run.limit_mm_s.min(run.length_mm / self.period_s);
        }
        self.plan_motion(chain);
        self.wait_for_link(chain);
    }

    /// Slows down corners at which the sampled acceleration exceeds the limit, which happens if
    /// several corners lie within the sampling window. Returns whether any was slowed.
    ///
    /// The corner speed is multiplied by the allowed share raised to this power. Only corners near
    /// changed vectors are examined; the others passed before.
    fn ease_corners(&mut self, chain: &mut [ChainVector], power: i32) -> bool {
        if chain.len() < 2 {
            return false;
        }
        let a = self.cornering.acceleration_mm_s2;
        let before = self.sampled.iter().map(Some).chain(repeat(None));
        let changed: Vec<bool> = self
            .speeds
            .iter()
            .zip(before)
            .map(|(now, before)| Some(now) != before)
            .collect();
        let shares = SampledMotion::new(chain, &self.speeds, a).shares(MIN_SHARE, &changed);
        for (corner, share) in shares.iter().enumerate().filter(|share| *share.1 < 1.0) {
            chain[corner].corner_mm_s = self.speeds[corner].end_mm_s * share.powi(power);
        }
        self.sampled.clone_from(&self.speeds);
        shares.iter().any(|share| *share < 1.0)
    }

    fn plan_motion(&mut self, chain: &[ChainVector]) {
        self.cornering.set_speeds(chain, &mut self.junctions);
        let junctions = self.junctions.windows(2).zip(chain);
        self.wanted_s.clear();
        self.wanted_s.extend(
            junctions.map(|(pair, run)| self.cornering.duration_s(&pair[0], run, &pair[1])),
        );
    }

    /// Sets the speeds, of vectors extended to the time that the link needs; if a vector cannot be that
    /// slow between its end speeds, its limit is lowered. Returns whether none was lowered.
    fn wait_for_link(&mut self, chain: &mut [ChainVector]) -> bool {
        let (mut credit, mut done) = (self.credit, true);
        self.speeds.clear();
        for i in 0..chain.len() {
            let least_s = credit.least_s();
            if self.wanted_s[i] < least_s {
                self.wanted_s[i] = least_s;
            }
            let mut speeds = self.speeds_of(chain, i);
            let can_s = speeds.duration_s;
            // The ends are too fast for such a slow vector; lowering the limit slows the ends too.
            if can_s < least_s * (1.0 - 1e-9) {
                let run = &mut chain[i];
                run.limit_mm_s = run.limit_mm_s.min(run.length_mm / least_s) * SLOWER;
                done = false;
                speeds = self.speeds_of(chain, i);
            }
            self.speeds.push(speeds);
            credit.take(can_s.max(least_s));
        }
        if done {
            self.credit = credit;
        }
        done
    }

    /// Returns the speeds of a vector, with the maximum speed that best matches the target
    /// duration.
    fn speeds_of(&self, chain: &[ChainVector], i: usize) -> Speeds {
        let (run, a) = (&chain[i], self.cornering.acceleration_mm_s2);
        let [start, end] = [i, i + 1].map(|at| self.junctions[at].speed_mm_s());
        let wanted_s = self.wanted_s[i];
        // Accelerate to the speed v, keep it, brake: wanted = (2 v - start - end) / a + (length -
        // (2 v2 - start2 - end2) / 2 a) / v
        let time = a * wanted_s + start + end;
        let way = a * run.length_mm + 0.5 * (start * start + end * end);
        let root = (time * time - 4.0 * way).max(0.0).sqrt();
        let even = 2.0 * way / (time + root);
        let max = even.clamp(start.max(end), run.limit_mm_s.max(start).max(end));
        Speeds::of(run.length_mm, [start, end, max], run.limit_mm_s, a)
    }
}

/// The number of neighbours on each side that count for the average speed.
const REACH: usize = 2;
const ROUNDS: i32 = 60;
/// After this many rounds corners are slowed more than computed, and even more after twice as many,
/// because their neighbours accelerate meanwhile.
const PATIENCE: i32 = 6;
const SLOWER: f64 = 0.999;
/// Rounds end when no corner exceeds the sampled acceleration by more than about half a percent.
pub(crate) const MIN_SHARE: f64 = 0.994;
