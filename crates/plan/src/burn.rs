//! Strokes that a laser burns.

use dobot_geometry::{Point, Stroke};
use dobot_motion::Cut;

use crate::aim::Aim;
use crate::commands::write;
use crate::laser_path::{LaserPath, SwitchLead, burn_speed_mm_s, burnable};
use crate::planner::Planner;
use crate::tick::TICK_S;
use crate::ticker::Ticker;
use crate::{Laser, MoveKind, PlannedVector};

impl Planner<'_> {
    /// ```text
    ///   off  -- Travel --> RunUp .                   . RunOut Brake -- Travel -->
    ///   on                       '- Burn Burn Burn --'
    /// ```
    ///
    /// How far the last ticks before the switching go is known only when they are planned: then the
    /// places of switching are moved, and the stroke is planned again.
    pub(super) fn burn(&mut self, stroke: &Stroke, laser: &Laser) {
        let points = burnable(stroke, self.here);
        let laser = &Laser {
            burn_speed_mm_s: burn_speed_mm_s(&points, laser, self.machine),
            ..*laser
        };
        let mut lead = SwitchLead::at_speed(laser, self.machine);
        let begin = self.moves.len();
        let before = (
            self.here,
            self.settled.clone(),
            self.chain_speeds.clone(),
            self.ticker.clone(),
        );
        let mut best = (f64::INFINITY, lead);
        for left in (0..BURN_ROUNDS).rev() {
            self.burn_once(&points, laser, lead);
            let Some(ticker) = &before.3 else {
                break;
            };
            let found = self.lead(begin, ticker.clone());
            let off_mm = found.distance_mm(lead);
            if left == 0 || off_mm < NEAR_MM {
                break;
            }
            if off_mm < best.0 {
                best = (off_mm, lead);
            }
            // Counts of ticks jump from one attempt to the next: half the way may lie between.
            lead = if left == 1 {
                best.1
            } else {
                lead.half_way(found)
            };
            self.moves.truncate(begin);
            (self.here, self.settled, self.chain_speeds, self.ticker) = before.clone();
        }
        self.stroke += 1;
    }

    fn burn_once(&mut self, points: &[Point], laser: &Laser, lead: SwitchLead) {
        let Laser {
            burn_speed_mm_s: speed,
            travel_speed_mm_s: travel,
            ..
        } = *laser;
        let path = LaserPath::of(points, speed, lead, self.machine);
        self.travel(path.run_up, 0.0, travel);
        for p in path.off_to {
            self.go(MoveKind::RunUp, p, 0.0, speed);
        }
        for p in path.on_to {
            self.go(MoveKind::Burn, p, 0.0, speed);
        }
        self.go(MoveKind::RunOut, path.run_out, 0.0, speed);
        self.go(MoveKind::Brake, path.brake, 0.0, speed);
        self.rest();
    }

    /// How far the ticks go in which the laser is switched, by the vectors from there on.
    fn lead(&self, begin: usize, mut ticker: Ticker) -> SwitchLead {
        let last_mm = |cut: &Cut| cut.speeds_mm_s().last().map_or(0.0, |it| it * TICK_S);
        let mut lead = SwitchLead {
            on_mm: 0.0,
            off_mm: 0.0,
        };
        for vector in &self.moves[begin..] {
            let cut = ticker.run(&write(vector));
            match vector.kind {
                MoveKind::RunUp => lead.on_mm = last_mm(&cut).into(),
                MoveKind::Burn => lead.off_mm = last_mm(&cut).into(),
                _ => {}
            }
        }
        lead
    }

    /// A laser burns more where it is slower. Where a stroke's corners and short vectors allow nearly its
    /// speed, all of the stroke is run at the speed that they do allow.
    pub(super) fn even_burning(&mut self, begin: usize) {
        let burns = |vector: &&PlannedVector| vector.kind == MoveKind::Burn;
        let Some(first) = self.moves[begin..].iter().position(|it| burns(&it)) else {
            return;
        };
        let burned = self.moves[begin..].iter().filter(burns).count();
        let limit_mm_s = self.chain[first].limit_mm_s;
        let mut chain = self.chain.clone();
        let mut chain_speeds = self.chain_speeds.clone();
        let speeds = chain_speeds
            .plan(&mut chain, Aim::Evenly)
            .skip(first)
            .take(burned);
        let slowest_mm_s = speeds
            .map(|it| it.start_mm_s.min(it.end_mm_s).min(it.max_mm_s))
            .fold(limit_mm_s, f64::min);
        if slowest_mm_s * MOST_SPREAD >= limit_mm_s {
            for run in &mut self.chain {
                run.limit_mm_s = run.limit_mm_s.min(slowest_mm_s);
            }
        }
    }
}

/// How often a burned stroke is planned for the ticks of a stock arm.
const BURN_ROUNDS: u32 = 12;
/// Nobody sees less burned.
const NEAR_MM: f64 = 0.005;
/// How much more may be burned on a millimetre for it to be as much everywhere.
const MOST_SPREAD: f64 = 1.2;
