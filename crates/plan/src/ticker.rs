//! A chain of vectors for a stock arm, tick by tick.

use dobot_motion::Cut;
use dobot_wire::{WriteMode, WriteVector};

use crate::commands::write;
use crate::link::Credit;
use crate::lookahead::ChainVector;
use crate::seen::{WINDOW_TICKS, at_ticks, second_difference, seen_mm};
use crate::speeds::Speeds;
use crate::tick::TICK_S;
use crate::tick_fit::{OVER, SAME_SHARE, TickFit, TickTarget};
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

    /// Gives the vectors of a chain the speeds with which a stock arm comes nearest to these, and tells
    /// how it runs them then.
    ///
    /// What is best for one vector may leave a speed from which the next cannot be run in the
    /// ticks that it should take, or turns the tool too fast. So up to `most_ways` choices are followed.
    pub(super) fn set(
        &mut self,
        moves: &mut [PlannedVector],
        chain: &[ChainVector],
        speeds: &[Speeds],
        over: &[f64],
        most_ways: usize,
    ) -> Vec<Cut> {
        let mut steps: Vec<Step> = Vec::with_capacity(chain.len() * most_ways * most_ways);
        let mut ways = vec![Way::new(self)];
        for (i, vector) in moves.iter().enumerate() {
            let packet = write(vector);
            let mut next: Vec<Way> = Vec::with_capacity(most_ways * most_ways);
            for way in &ways {
                let target =
                    way.ticker
                        .target(length(&packet), speeds[i], factor(&packet), over[i]);
                for fit in target
                    .fits(way.ticker.stored_mm_s)
                    .into_iter()
                    .take(most_ways)
                {
                    next.push(way.step(steps.len(), &speeds[i], &fit, chain[i].direction));
                    steps.push(Step {
                        fit,
                        before: way.last,
                    });
                }
            }
            ways = the_best(next, most_ways);
        }
        let best = ways.swap_remove(0);
        let mut fits: Vec<TickFit> = Vec::with_capacity(chain.len());
        let mut last = best.last;
        while let Some(step) = last.map(|it| &steps[it]) {
            fits.push(step.fit);
            last = step.before;
        }
        fits.reverse();
        let mut stored_mm_s = self.stored_mm_s;
        for (vector, fit) in moves.iter_mut().zip(&fits) {
            vector.start_speed_mm_s = stored_mm_s.min(fit.max_mm_s);
            vector.end_speed_mm_s = fit.end_mm_s;
            vector.max_speed_mm_s = fit.max_mm_s;
            vector.duration_s = f32::from(fit.cut.ticks()) * TICK_S;
            stored_mm_s = fit.cut.end_mm_s;
        }
        *self = best.ticker;
        fits.into_iter().map(|fit| fit.cut).collect()
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
        let target = self.target(length_mm, speeds, factor(vector), OVER);
        let fit = target.fits(stored_mm_s)[0];
        self.take(&speeds, &fit);
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

    /// What the next vector should be, of this length.
    fn target(&self, length_mm: f32, speeds: Speeds, factor: f32, over: f64) -> TickTarget {
        TickTarget {
            length_mm,
            speeds,
            ticks: speeds.duration_s / f64::from(TICK_S) + self.early,
            least_ticks: least_ticks(self.credit),
            rests: speeds.end_mm_s == 0.0,
            acceleration_mm_s2: factor * self.acceleration_mm_s2,
            most_mm_s: self.most_mm_s,
            over,
        }
    }

    /// The next vector is run like that.
    fn take(&mut self, speeds: &Speeds, fit: &TickFit) {
        let ticks = speeds.duration_s / f64::from(TICK_S);
        let took = f64::from(fit.cut.ticks());
        self.early = (self.early + ticks - took).clamp(-MOST_EARLY, MOST_EARLY);
        self.credit.take(took * f64::from(TICK_S));
        self.stored_mm_s = fit.cut.end_mm_s;
    }
}

/// A way to run the first vectors of a chain.
#[derive(Clone, Debug)]
struct Way {
    /// What the arm carries over behind them.
    ticker: Ticker,
    cost: f64,
    /// Its last step.
    last: Option<usize>,
    /// Where the tool was at the last ticks, in mm from where the chain begins.
    places: [[f64; 3]; SEEN_TICKS],
}

impl Way {
    /// Before the first vector: the tool stands.
    fn new(ticker: &Ticker) -> Self {
        Self {
            ticker: ticker.clone(),
            cost: 0.0,
            last: None,
            places: [[0.0; 3]; SEEN_TICKS],
        }
    }

    /// The way with one more vector, that becomes step number `step`.
    fn step(&self, step: usize, speeds: &Speeds, fit: &TickFit, direction: [f64; 3]) -> Self {
        let mut next = self.clone();
        next.last = Some(step);
        next.ticker.take(speeds, fit);
        next.cost += fit.cost;
        let allowed_mm = seen_mm(self.ticker.acceleration_mm_s2.into());
        for place in at_ticks(self.places[SEEN_TICKS - 1], direction, &fit.cut) {
            let [before, now] = [next.places[0], next.places[SEEN_TICKS / 2]];
            let beyond = second_difference(before, now, place) / allowed_mm - 1.0;
            next.cost += beyond.max(0.0).powi(2) * BEYOND;
            next.places.rotate_left(1);
            next.places[SEEN_TICKS - 1] = place;
        }
        next
    }
}

/// How one vector of a way is run.
#[derive(Clone, Copy, Debug)]
struct Step {
    fit: TickFit,
    /// The step before, where there is one.
    before: Option<usize>,
}

/// The cheapest ways that leave different speeds, the best first.
fn the_best(mut ways: Vec<Way>, most: usize) -> Vec<Way> {
    ways.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    let mut best: Vec<Way> = Vec::with_capacity(most);
    for way in ways {
        let step_mm_s = SAME_SHARE * way.ticker.step_mm_s();
        let is_new =
            |other: &Way| (other.ticker.stored_mm_s - way.ticker.stored_mm_s).abs() >= step_mm_s;
        if best.iter().all(is_new) {
            best.push(way);
            if best.len() == most {
                break;
            }
        }
    }
    best
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

/// Whether a stock arm accelerates on it a hundredfold (note N48).
pub(super) fn is_rapid(vector: &WriteVector) -> bool {
    vector.mode == WriteMode::Laser && !vector.laser
}

fn factor(vector: &WriteVector) -> f32 {
    if is_rapid(vector) { RAPID_FACTOR } else { 1.0 }
}

/// With the laser off, laser mode accelerates that much faster (note N48).
const RAPID_FACTOR: f32 = 100.0;
const MOST_EARLY: f64 = 0.5;
/// From where the tool was a window ago to where it is, both ends included, without the last.
const SEEN_TICKS: usize = 2 * WINDOW_TICKS;
/// How much it counts if the tool is seen to accelerate by all of what is allowed too much; in the square.
const BEYOND: f64 = 2500.0;
