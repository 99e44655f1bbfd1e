//! How fast the chain of vectors between two rests is run, so that neither the acceleration nor the
//! link is overdriven.

use std::iter::repeat;

use crate::ArmLimits;
use crate::speed::link::Credit;
use crate::speed::lookahead::{ChainVector, Cornering, Junction};
use crate::speed::objective::Objective;
use crate::speed::sampled_acceleration::SampledMotion;
use crate::speed::speeds::Speeds;

/// Speeds for a chain: reused from chain to chain.
#[derive(Clone, Debug)]
pub(crate) struct ChainSpeeds {
    cornering: Cornering,
    begin_mm_s: f64,
    /// Seconds from packet to packet.
    period_s: f64,
    /// Vectors that the arm has in hand.
    credit: Credit,
    junctions: Vec<Junction>,
    /// How long each vector is to take, in s.
    wanted_s: Vec<f64>,
    /// How it was run when it was last looked how the tool turns.
    sampled: Vec<Speeds>,
}

impl ChainSpeeds {
    pub(crate) fn new(arm_limits: &ArmLimits) -> Self {
        Self {
            cornering: Cornering {
                acceleration_mm_s2: arm_limits.planned_acceleration_mm_s2(),
                ..arm_limits.cornering()
            },
            begin_mm_s: 0.0,
            period_s: arm_limits.link.period_s,
            credit: Credit::new(arm_limits.link),
            junctions: Vec::new(),
            wanted_s: Vec::new(),
            sampled: Vec::new(),
        }
    }

    /// The same where vectors that take longer come in pieces.
    pub(crate) fn with_pieces(self, piece_s: f64) -> Self {
        Self {
            credit: self.credit.with_pieces(piece_s),
            ..self
        }
    }

    /// The speeds of the chain's vectors, from rest to rest. Its limits are lowered where the link
    /// needs that.
    pub(crate) fn plan<'a>(
        &'a mut self,
        chain: &'a mut [ChainVector],
        objective: Objective,
    ) -> impl Iterator<Item = Speeds> + 'a {
        self.plan_from(0.0, chain, objective)
    }

    /// The speeds of the chain's vectors, if it begins with this speed. Where braking takes longer
    /// than there is way, they are as if it did not.
    pub(crate) fn plan_from<'a>(
        &'a mut self,
        begin_mm_s: f64,
        chain: &'a mut [ChainVector],
        objective: Objective,
    ) -> impl Iterator<Item = Speeds> + 'a {
        self.begin_mm_s = begin_mm_s;
        match objective {
            Objective::Even => self.lower_to_link(chain, 0),
            Objective::Fast => {
                self.plan_motion(chain);
                if let Some(waits) = self.first_wait() {
                    self.lower_to_link(chain, waits.saturating_sub(REACH));
                }
            }
        }
        self.plan_with_link(chain);
        (0..chain.len()).map(|i| self.speeds(chain, i))
    }

    /// The first vector that would be over before the next is there: until then those in hand are enough.
    fn first_wait(&self) -> Option<usize> {
        let mut credit = self.credit;
        self.wanted_s.iter().position(|&wanted_s| {
            let waits = wanted_s < credit.least_s();
            credit.take(wanted_s);
            waits
        })
    }

    /// Evens the limits out from a vector on: a short vector between long ones may be fast, because others come
    /// meanwhile.
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

    /// Without a link every vector is there in no time, and nothing has to wait.
    fn plan_with_link(&mut self, chain: &mut [ChainVector]) {
        self.sampled.clear();
        for round in 0..ROUNDS {
            self.plan_motion(chain);
            let credit = self.credit;
            let keeps_up = self.wait_for_link(chain);
            if !self.ease_corners(chain, 1 + round / PATIENCE) && keeps_up {
                return;
            }
            self.credit = credit;
        }
        // Slow enough whatever the others do.
        for run in chain.iter_mut() {
            run.limit_mm_s = run.limit_mm_s.min(run.length_mm / self.period_s);
        }
        self.plan_motion(chain);
        self.wait_for_link(chain);
    }

    /// Uses less of the radius of a corner where the tool would be seen to accelerate more than it
    /// may: several corners may lie within the time over which that is measured. Whether any had
    /// to be eased. Their speed is taken times the share that is allowed, to this power. It is looked only where something has changed
    /// since the last round: elsewhere nothing had to be eased.
    fn ease_corners(&mut self, chain: &mut [ChainVector], power: i32) -> bool {
        if chain.len() < 2 {
            return false;
        }
        let speeds: Vec<Speeds> = (0..chain.len()).map(|i| self.speeds(chain, i)).collect();
        let a = self.cornering.acceleration_mm_s2;
        let before = self.sampled.iter().map(Some).chain(repeat(None));
        let changed: Vec<bool> = speeds
            .iter()
            .zip(before)
            .map(|(now, it)| Some(now) != it)
            .collect();
        let shares = SampledMotion::new(chain, &speeds, a).shares(LEAST_SHARE, &changed);
        for (corner, share) in shares.iter().enumerate().filter(|it| *it.1 < 1.0) {
            chain[corner].corner_mm_s = speeds[corner].end_mm_s * share.powi(power);
        }
        self.sampled = speeds;
        shares.iter().any(|it| *it < 1.0)
    }

    fn plan_motion(&mut self, chain: &[ChainVector]) {
        self.cornering
            .speeds(self.begin_mm_s, chain, &mut self.junctions);
        let junctions = self.junctions.windows(2).zip(chain);
        self.wanted_s.clear();
        self.wanted_s.extend(
            junctions.map(|(pair, run)| self.cornering.duration_s(&pair[0], run, &pair[1])),
        );
    }

    /// Gives vectors the time that the link needs; where a vector cannot be as slow between the
    /// speeds of its ends, its limit is lowered. Whether none had to be.
    fn wait_for_link(&mut self, chain: &mut [ChainVector]) -> bool {
        let (mut credit, mut done) = (self.credit, true);
        for i in 0..chain.len() {
            let least_s = credit.least_s();
            if self.wanted_s[i] < least_s {
                self.wanted_s[i] = least_s;
            }
            let can_s = self.speeds(chain, i).duration_s;
            if can_s < least_s * (1.0 - 1e-9) {
                let run = &mut chain[i];
                run.limit_mm_s = run.limit_mm_s.min(run.length_mm / least_s) * SLOWER;
                done = false;
            }
            credit.take(can_s.max(least_s));
        }
        if done {
            self.credit = credit;
        }
        done
    }

    /// The largest speed in between is chosen so that the vector takes the time wanted, as nearly
    /// as can be.
    fn speeds(&self, chain: &[ChainVector], i: usize) -> Speeds {
        let (run, a) = (&chain[i], self.cornering.acceleration_mm_s2);
        let [start, end] = [i, i + 1].map(|at| self.junctions[at].speed_mm_s());
        let wanted_s = self.wanted_s[i];
        // Accelerate to the speed v, keep it, brake:
        // wanted = (2 v - start - end) / a + (length - (2 v2 - start2 - end2) / 2 a) / v
        let time = a * wanted_s + start + end;
        let way = a * run.length_mm + 0.5 * (start * start + end * end);
        let root = (time * time - 4.0 * way).max(0.0).sqrt();
        let even = 2.0 * way / (time + root);
        let max = even.clamp(start.max(end), run.limit_mm_s.max(start).max(end));
        Speeds::of(run.length_mm, [start, end, max], run.limit_mm_s, a)
    }
}

/// How many vectors before and behind count for how fast one may be.
const REACH: usize = 2;
const ROUNDS: i32 = 60;
/// After so many rounds corners are eased by more than it seems they need, and more so after twice as
/// many: their neighbours speed up meanwhile.
const PATIENCE: i32 = 6;
const SLOWER: f64 = 0.999;
/// Rounds of easing end where no corner is seen to accelerate more than half a percent too much.
pub(crate) const LEAST_SHARE: f64 = 0.994;
