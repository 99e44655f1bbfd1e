//! The state of a stock arm along a chain of vectors.

use dobot_motion::TickStroke;
use dobot_wire::{WriteMode, WriteVector};

use crate::path::commands::write;
use crate::speed::link::Credit;
use crate::speed::objective::Objective;
use crate::speed::speeds::Speeds;
use crate::ticks::TICK_S;
use crate::ticks::tick_fit::{MIN_LEFT_MM_S, TickFit, TickPreference, TickTarget};
use crate::{ArmLimits, MoveKind, PlannedVector};

/// The state that a stock arm carries from vector to vector.
#[derive(Clone, Debug)]
pub(crate) struct Ticker {
    acceleration_mm_s2: f32,
    /// The stored end speed, in mm/s.
    stored_mm_s: f32,
    /// Possible other stored speeds, if it is unknown.
    possible_mm_s: Option<[f32; 3]>,
    /// The ticks by which the vectors before were too short.
    early: f64,
    credit: Credit,
}

impl Ticker {
    #[expect(clippy::cast_possible_truncation, reason = "as the packet holds it")]
    pub(crate) fn new(arm_limits: &ArmLimits, stored_mm_s: f32) -> Self {
        Self {
            acceleration_mm_s2: arm_limits.acceleration_mm_s2 as f32,
            stored_mm_s,
            possible_mm_s: None,
            early: 0.0,
            credit: Credit::new(arm_limits.link),
        }
    }

    /// Creates the state for an arm with ticks; `None` without ticks.
    pub(crate) fn of(arm_limits: &ArmLimits, stored_mm_s: f32) -> Option<Self> {
        arm_limits
            .has_ticks
            .then(|| Self::new(arm_limits, stored_mm_s))
    }

    /// Marks the stored speed as unknown, because others used the arm before.
    pub(crate) const fn with_unknown_speed(self) -> Self {
        Self {
            possible_mm_s: Some(LEFT_BY_OTHERS_MM_S),
            ..self
        }
    }

    /// Takes into account that vectors of longer duration are divided.
    pub(crate) const fn with_pieces(self, piece_s: f64) -> Self {
        Self {
            credit: self.credit.with_pieces(piece_s),
            ..self
        }
    }

    /// Assigns the fits to the vectors of a chain and executes them.
    pub(crate) fn set(&mut self, moves: &mut [PlannedVector], speeds: &[Speeds], fits: &[TickFit]) {
        for ((vector, speeds), fit) in moves.iter_mut().zip(speeds).zip(fits) {
            vector.start_speed_mm_s = self.stored_mm_s.min(fit.max_mm_s);
            vector.end_speed_mm_s = fit.end_mm_s;
            vector.max_speed_mm_s = fit.max_mm_s;
            vector.duration_s = f32::from(fit.tick_stroke.ticks()) * TICK_S;
            self.take(speeds, fit);
        }
    }

    /// Returns the fits of the next vector closest to these speeds, best first.
    pub(crate) fn fits(
        &self,
        vector: &WriteVector,
        speeds: Speeds,
        wish: TickPreference,
    ) -> Vec<TickFit> {
        let target = self.target(length(vector), speeds, factor(vector), wish);
        target.fits(self.stored_mm_s)
    }

    /// Returns the execution of the next vector with the speeds of this fit.
    pub(crate) fn tick_stroke_with(&self, vector: &WriteVector, fit: &TickFit) -> TickStroke {
        let acceleration_mm_s2 = factor(vector) * self.acceleration_mm_s2;
        TickStroke::of(
            length(vector),
            self.stored_mm_s,
            fit.end_mm_s,
            fit.max_mm_s,
            acceleration_mm_s2,
        )
    }

    /// Replaces the speeds of a job's vector, planned without ticks, by the closest ones for a
    /// stock arm.
    pub(crate) fn respeed(
        &mut self,
        vector: &mut WriteVector,
        rests: bool,
        acceleration: f64,
        most_mm_s: f32,
    ) {
        let [start, end, max] = [
            vector.start_speed_mm_s,
            vector.end_speed_mm_s,
            vector.max_speed_mm_s,
        ]
        .map(f64::from);
        let length_mm = length(vector);
        let end = if rests { 0.0 } else { end };
        let speeds = Speeds::of(length_mm.into(), [start, end, max], max, acceleration);
        let stored_mm_s = self.stored_mm_s;
        let wish = TickPreference {
            objective: Objective::Even,
            over: 1.0,
            most_mm_s,
            least_mm_s: 0.0,
            same_share: 0.0,
        };
        let target = self.target(length_mm, speeds, factor(vector), wish);
        let fit = target.fits(stored_mm_s)[0];
        // `take` updates timing and credit; the stored speed follows when the vector is executed.
        self.take(&speeds, &fit);
        self.stored_mm_s = stored_mm_s;
        vector.start_speed_mm_s = stored_mm_s.clamp(0.0, fit.max_mm_s);
        vector.end_speed_mm_s = fit.end_mm_s;
        vector.max_speed_mm_s = fit.max_mm_s;
    }

    /// Executes a vector.
    pub(crate) fn run(&mut self, vector: &WriteVector) -> TickStroke {
        let tick_stroke = self.tick_stroke(vector, self.stored_mm_s);
        self.stored_mm_s = tick_stroke.end_mm_s;
        tick_stroke
    }

    /// Executes a vector and returns its displacement, in mm.
    pub(crate) fn displacement_mm(&mut self, vector: &WriteVector) -> [f32; 3] {
        let way = [vector.x_mm, vector.y_mm, vector.z_mm];
        self.run(vector).displacement_mm(way, length(vector))
    }

    /// Whether the arm executes the exact length of each of these vectors.
    pub(crate) fn runs_exactly(&self, vectors: &[WriteVector]) -> bool {
        let mut stored_mm_s = self.stored_mm_s;
        vectors.iter().all(|vector| {
            let tick_stroke = self.tick_stroke(vector, stored_mm_s);
            stored_mm_s = tick_stroke.end_mm_s;
            tick_stroke.is_exact()
        })
    }

    /// Whether any of these vectors is executed wrongly, or the arm may creep after the laser goes
    /// off, with any possible stored speed.
    pub(crate) fn fails(&self, moves: &[PlannedVector]) -> bool {
        let wrong = |stored_mm_s: f32, is_sure: bool| {
            let mut stored_mm_s = stored_mm_s;
            moves.iter().any(|vector| {
                let creeps = vector.kind == MoveKind::RunOut && stored_mm_s < MIN_LEFT_MM_S;
                let tick_stroke = self.tick_stroke(&write(vector), stored_mm_s);
                stored_mm_s = tick_stroke.end_mm_s;
                creeps || is_sure && !tick_stroke.is_exact()
            })
        };
        let mut possible_mm_s = self.possible_mm_s.iter().flatten();
        wrong(self.stored_mm_s, true) || possible_mm_s.any(|&mm_s| wrong(mm_s, false))
    }

    /// Returns the link credit before each vector of a chain with these fits.
    pub(crate) fn credits(&self, fits: &[TickFit]) -> Vec<Credit> {
        let mut credit = self.credit;
        let before = |fit: &TickFit| {
            let before = credit;
            credit.take(fit.duration_s());
            before
        };
        fits.iter().map(before).collect()
    }

    /// Whether none of these vectors arrives too late, until the credit reaches the given one.
    pub(crate) fn keeps_up<'a>(
        &self,
        rest: impl IntoIterator<Item = (&'a TickFit, &'a Credit)>,
    ) -> bool {
        let mut credit = self.credit;
        for (fit, was) in rest {
            if credit.least_s() <= was.least_s() {
                return true;
            }
            if i32::from(fit.tick_stroke.ticks()) < i32::from(least_ticks(credit)) {
                return false;
            }
            credit.take(fit.duration_s());
        }
        false
    }

    /// Returns the minimum number of ticks of the next vector.
    #[cfg(test)]
    pub(crate) fn least_ticks(&self) -> u32 {
        u32::from(least_ticks(self.credit).unsigned_abs())
    }

    pub(crate) const fn stored_mm_s(&self) -> f32 {
        self.stored_mm_s
    }

    pub(crate) fn acceleration_mm_s2(&self) -> f64 {
        self.acceleration_mm_s2.into()
    }

    /// Returns the speed change per tick, in mm/s.
    pub(crate) fn step_mm_s(&self) -> f32 {
        self.acceleration_mm_s2 * TICK_S
    }

    fn tick_stroke(&self, vector: &WriteVector, stored_mm_s: f32) -> TickStroke {
        TickStroke::of(
            length(vector),
            stored_mm_s,
            vector.end_speed_mm_s,
            vector.max_speed_mm_s,
            factor(vector) * self.acceleration_mm_s2,
        )
    }

    /// Returns the target of the next vector. Speeds are whole steps: the arm would not accelerate
    /// to less than one and a half.
    fn target(
        &self,
        length_mm: f32,
        speeds: Speeds,
        factor: f32,
        wish: TickPreference,
    ) -> TickTarget {
        let early = match wish.objective {
            Objective::Even => self.early,
            Objective::Fast => 0.0,
        };
        TickTarget {
            length_mm,
            speeds,
            ticks: speeds.duration_s / f64::from(TICK_S) + early,
            least_ticks: least_ticks(self.credit),
            rests: speeds.end_mm_s == 0.0,
            acceleration_mm_s2: factor * self.acceleration_mm_s2,
            possible_mm_s: self.possible_mm_s,
            wish: TickPreference {
                most_mm_s: wish.most_mm_s.max(1.5 * self.step_mm_s()),
                ..wish
            },
        }
    }

    /// Records the execution of the next vector.
    pub(crate) fn take(&mut self, speeds: &Speeds, fit: &TickFit) {
        let ticks = speeds.duration_s / f64::from(TICK_S);
        let took = f64::from(fit.tick_stroke.ticks());
        // Bounded, so that one odd vector does not distort many others.
        self.early = (self.early + ticks - took).clamp(-MAX_EARLY, MAX_EARLY);
        self.credit.take(fit.duration_s());
        self.stored_mm_s = fit.tick_stroke.end_mm_s;
        self.possible_mm_s = fit.possible_mm_s;
    }
}

#[expect(clippy::cast_possible_truncation, reason = "a handful")]
fn least_ticks(credit: Credit) -> i16 {
    (credit.least_s() / f64::from(TICK_S) - 1e-3)
        .ceil()
        .max(1.0) as i16
}

/// Returns the length in the arm's own arithmetic.
pub(crate) fn length(vector: &WriteVector) -> f32 {
    let [x, y, z] = [vector.x_mm, vector.y_mm, vector.z_mm];
    (x * x + y * y + z * z).sqrt()
}

/// Whether a stock arm accelerates it a hundredfold (note N48).
pub(crate) fn is_rapid(vector: &WriteVector) -> bool {
    vector.mode == WriteMode::Laser && !vector.laser
}

fn factor(vector: &WriteVector) -> f32 {
    if is_rapid(vector) { RAPID_FACTOR } else { 1.0 }
}

/// The acceleration factor of laser mode with the laser off (note N48).
const RAPID_FACTOR: f32 = 100.0;
/// Speeds that a vector braked to rest may leave, in mm/s, as in the policy.
const LEFT_BY_OTHERS_MM_S: [f32; 3] = [-0.01, -0.1, -0.3];
const MAX_EARLY: f64 = 0.5;
