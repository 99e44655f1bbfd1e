//! A chain of vectors for a stock arm, tick by tick.

use dobot_motion::Cut;
use dobot_wire::{WriteMode, WriteVector};

use crate::commands::write;
use crate::link::Credit;
use crate::speeds::Speeds;
use crate::tick::TICK_S;
use crate::tick_fit::{OVER, TickFit, TickTarget};
use crate::{Machine, PlannedVector};

/// What the arm carries over from vector to vector.
#[derive(Clone, Debug)]
pub(super) struct Ticker {
    acceleration_mm_s2: f32,
    /// The end speed that the arm has stored, in mm/s.
    stored_mm_s: f32,
    /// The largest speed that the next packets may tell, in mm/s.
    most_mm_s: f32,
    /// How many ticks the vectors so far were too short, in ticks.
    early: f64,
    credit: Credit,
}

impl Ticker {
    #[expect(clippy::cast_possible_truncation, reason = "as the packet holds it")]
    pub(super) fn new(machine: &Machine, stored_mm_s: f32) -> Self {
        Self {
            acceleration_mm_s2: machine.acceleration_mm_s2 as f32,
            stored_mm_s,
            most_mm_s: f32::MAX,
            early: 0.0,
            credit: Credit::new(machine.link),
        }
    }

    /// The ticks of a machine that has some.
    pub(super) fn of(machine: &Machine, stored_mm_s: f32) -> Option<Self> {
        machine.has_ticks.then(|| Self::new(machine, stored_mm_s))
    }

    /// No packet of the next chain may tell a larger speed, in mm/s. Speeds are whole ticks: the arm
    /// would not begin to accelerate to less than one and a half.
    pub(super) fn limit(&mut self, most_mm_s: f32) {
        self.most_mm_s = most_mm_s.max(1.5 * self.step_mm_s());
    }

    /// Gives a vector the speeds with which a stock arm comes nearest to these, and tells how it runs
    /// it then.
    pub(super) fn set(&mut self, vector: &mut PlannedVector, speeds: Speeds, over: f64) -> Cut {
        let begin_mm_s = self.stored_mm_s;
        let packet = write(vector);
        let fit = self.fit(length(&packet), speeds, factor(&packet), over);
        vector.start_speed_mm_s = begin_mm_s.min(fit.max_mm_s);
        vector.end_speed_mm_s = fit.end_mm_s;
        vector.max_speed_mm_s = fit.max_mm_s;
        vector.duration_s = f32::from(fit.cut.ticks()) * TICK_S;
        fit.cut
    }

    /// The same for a vector of a job, whose speeds are those of a plan without ticks.
    pub(super) fn respeed(&mut self, vector: &mut WriteVector, rests: bool, acceleration: f64) {
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
        let fit = self.fit(length_mm, speeds, factor(vector), OVER);
        self.stored_mm_s = stored_mm_s;
        vector.start_speed_mm_s = stored_mm_s.clamp(0.0, fit.max_mm_s);
        vector.end_speed_mm_s = fit.end_mm_s;
        vector.max_speed_mm_s = fit.max_mm_s;
    }

    /// How the arm runs a vector behind those before.
    pub(super) fn run(&mut self, vector: &WriteVector) -> Cut {
        let cut = self.cut(vector, self.stored_mm_s);
        self.stored_mm_s = cut.end_mm_s;
        cut
    }

    /// Whether the arm makes each of these vectors as long as it should be.
    pub(super) fn runs_true(&self, vectors: &[WriteVector]) -> bool {
        let mut stored_mm_s = self.stored_mm_s;
        vectors.iter().all(|vector| {
            let cut = self.cut(vector, stored_mm_s);
            stored_mm_s = cut.end_mm_s;
            cut.is_true()
        })
    }

    /// How much faster one tick may be than the one before, in mm/s.
    pub(super) fn step_mm_s(&self) -> f32 {
        self.acceleration_mm_s2 * TICK_S
    }

    fn cut(&self, vector: &WriteVector, stored_mm_s: f32) -> Cut {
        Cut::of(
            length(vector),
            stored_mm_s,
            vector.end_speed_mm_s,
            vector.max_speed_mm_s,
            factor(vector) * self.acceleration_mm_s2,
        )
    }

    /// The next vector, of this length.
    fn fit(&mut self, length_mm: f32, speeds: Speeds, factor: f32, over: f64) -> TickFit {
        let ticks = speeds.duration_s / f64::from(TICK_S);
        let fit = TickTarget {
            length_mm,
            speeds,
            ticks: ticks + self.early,
            least_ticks: least_ticks(self.credit),
            rests: speeds.end_mm_s == 0.0,
            acceleration_mm_s2: factor * self.acceleration_mm_s2,
            most_mm_s: self.most_mm_s,
            over,
        }
        .fit(self.stored_mm_s);
        let took = f64::from(fit.cut.ticks());
        self.early = (self.early + ticks - took).clamp(-MOST_EARLY, MOST_EARLY);
        self.credit.take(took * f64::from(TICK_S));
        self.stored_mm_s = fit.cut.end_mm_s;
        fit
    }
}

#[expect(clippy::cast_possible_truncation, reason = "a handful")]
fn least_ticks(credit: Credit) -> i16 {
    (credit.least_s() / f64::from(TICK_S) - 1e-3)
        .ceil()
        .max(1.0) as i16
}

/// The length as the arm calculates it.
fn length(vector: &WriteVector) -> f32 {
    let [x, y, z] = [vector.x_mm, vector.y_mm, vector.z_mm];
    (x * x + y * y + z * z).sqrt()
}

fn factor(vector: &WriteVector) -> f32 {
    if vector.mode == WriteMode::Laser && !vector.laser {
        RAPID_FACTOR
    } else {
        1.0
    }
}

/// With the laser off, laser mode accelerates that much faster (note N48).
const RAPID_FACTOR: f32 = 100.0;
const MOST_EARLY: f64 = 0.5;
