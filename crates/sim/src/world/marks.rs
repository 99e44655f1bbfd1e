//! The marks of pen and laser.

use dobot_geometry::Point;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::place::{rounded, rounded_place};
use super::tip::Tip;
use super::track::{Track, length_mm};

/// A line of ink.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(rename = "InkStroke")]
pub struct Stroke {
    /// Where the pen went while it was down; a single point is a dot.
    #[serde(with = "super::place::pairs")]
    #[schemars(with = "Vec<[f64; 2]>")]
    pub points_mm: Vec<Point>,
}

/// A line that the laser burned at about one speed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Burn {
    /// Where the laser went.
    #[serde(with = "super::place::pairs")]
    #[schemars(with = "Vec<[f64; 2]>")]
    pub points_mm: Vec<Point>,
    /// With which power, in watts.
    pub power_w: f64,
    /// How fast, in mm/s.
    pub speed_mm_s: f64,
}

/// A hole that the laser burned while it stood.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Hole {
    /// Where.
    #[serde(with = "super::place::pair")]
    #[schemars(with = "[f64; 2]")]
    pub at_mm: Point,
    /// With which power, in watts.
    pub power_w: f64,
    /// For how long, in seconds.
    pub time_s: f64,
}

impl Burn {
    /// The energy for each millimetre, in joules: how dark the line is.
    #[must_use]
    pub fn dose_j_mm(&self) -> f64 {
        self.power_w / self.speed_mm_s
    }
}

/// The ink on the paper.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ink {
    strokes: Vec<Track>,
    writing: bool,
}

impl Ink {
    /// Takes a straight piece of the tip's way. The pen writes on that part of it where it is down;
    /// returns where that ended, if it did.
    pub(crate) fn draw(&mut self, from: &Tip, to: &Tip) -> Option<Point> {
        let Some([start, end]) = shares_below(from.height_mm, to.height_mm, WRITES_MM) else {
            self.writing = false;
            return None;
        };
        if !self.writing || start > 0.0 {
            self.strokes.push(Track::new(from.at.lerp(to.at, start)));
        }
        let reached = from.at.lerp(to.at, end);
        if let Some(stroke) = self.strokes.last_mut() {
            stroke.push(reached);
        }
        self.writing = end >= 1.0;
        Some(reached)
    }

    pub(crate) fn strokes(&self) -> Vec<Stroke> {
        let stroke = |it: &Track| Stroke {
            points_mm: it.points().iter().copied().map(rounded_place).collect(),
        };
        self.strokes.iter().map(stroke).collect()
    }
}

/// What the laser burned.
#[derive(Clone, Debug, Default)]
pub(crate) struct Burns {
    /// Each with its mean speed, in mm/s.
    lines: Vec<(Track, f64)>,
    holes: Vec<Hole>,
    /// What goes on with the next piece.
    going: BurnState,
}

/// What the laser is about.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum BurnState {
    /// Nothing burns.
    #[default]
    Off,
    /// The last burn grows; that is for how long it has.
    Line(f64),
    /// The last hole grows.
    Hole,
}

impl Burns {
    /// Nothing burns here.
    pub(crate) fn stop(&mut self) {
        self.going = BurnState::Off;
    }

    /// Burns along a straight piece within a given time. Returns the hole that grew, and for how long
    /// it had burned before.
    pub(crate) fn burn(
        &mut self,
        from: Point,
        to: Point,
        time_s: f64,
        power_w: f64,
    ) -> Option<(Hole, f64)> {
        if time_s <= 0.0 {
            return None;
        }
        let speed_mm_s = from.distance(to) / time_s;
        if speed_mm_s < STANDS_MM_S {
            return Some(self.stand(to, time_s, power_w));
        }
        self.line(from, to, time_s, speed_mm_s);
        None
    }

    fn stand(&mut self, at_mm: Point, time_s: f64, power_w: f64) -> (Hole, f64) {
        let same = |it: &&mut Hole| it.at_mm.distance(at_mm) < SAME_HOLE_MM;
        let going = self.going == BurnState::Hole;
        self.going = BurnState::Hole;
        if let Some(hole) = self.holes.last_mut().filter(|_| going).filter(same) {
            let before_s = hole.time_s;
            hole.time_s += time_s;
            return (*hole, before_s);
        }
        let hole = Hole {
            at_mm,
            power_w,
            time_s,
        };
        self.holes.push(hole);
        (hole, 0.0)
    }

    fn line(&mut self, from: Point, to: Point, time_s: f64, speed_mm_s: f64) {
        if let (BurnState::Line(burned_s), Some((track, mean_mm_s))) =
            (self.going, self.lines.last_mut())
            && (speed_mm_s / *mean_mm_s - 1.0).abs() < SAME_SPEED
        {
            track.push(to);
            let total_s = burned_s + time_s;
            *mean_mm_s = (*mean_mm_s * burned_s + speed_mm_s * time_s) / total_s;
            self.going = BurnState::Line(total_s);
            return;
        }
        let mut track = Track::new(from);
        track.push(to);
        self.lines.push((track, speed_mm_s));
        self.going = BurnState::Line(time_s);
    }

    pub(crate) fn burns(&self, power_w: f64) -> Vec<Burn> {
        let burn = |(track, speed_mm_s): &(Track, f64)| Burn {
            points_mm: track.points().iter().copied().map(rounded_place).collect(),
            power_w,
            speed_mm_s: rounded(*speed_mm_s),
        };
        self.lines.iter().map(burn).collect()
    }

    pub(crate) fn holes(&self) -> Vec<Hole> {
        let hole = |it: &Hole| Hole {
            at_mm: rounded_place(it.at_mm),
            time_s: rounded(it.time_s),
            ..*it
        };
        self.holes.iter().map(hole).collect()
    }
}

/// The length of all ink.
#[must_use]
pub(crate) fn ink_mm(strokes: &[Stroke]) -> f64 {
    strokes.iter().map(|it| length_mm(&it.points_mm)).sum()
}

/// From where to where, as shares of the way, a height that changes evenly is no more than `most`.
fn shares_below(from: f64, to: f64, most: f64) -> Option<[f64; 2]> {
    let crossing = |from: f64, to: f64| (most - from) / (to - from);
    match (from <= most, to <= most) {
        (true, true) => Some([0.0, 1.0]),
        (false, true) => Some([crossing(from, to), 1.0]),
        (true, false) => Some([0.0, crossing(from, to)]),
        (false, false) => None,
    }
}

/// What motor steps, 0.03 mm each at the wrist, may lift a pen that still writes.
pub(crate) const WRITES_MM: f64 = 0.1;
/// Slower than that the laser stands.
const STANDS_MM_S: f64 = 0.05;
const SAME_HOLE_MM: f64 = 0.1;
/// By how much the speed may change along one burn.
const SAME_SPEED: f64 = 0.1;
