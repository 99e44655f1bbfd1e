//! A motion as its statuses tell it.

use dobot_arm::{Position, Tool, forward};
use dobot_session::position;
use dobot_wire::{Dialect, Status};

use crate::rig::joints;
use crate::timed_status::TimedStatus;

/// The statuses of one motion, from rest to rest.
#[derive(Debug)]
pub(crate) struct ObservedMotion<'s> {
    seen: &'s [TimedStatus],
}

impl<'s> ObservedMotion<'s> {
    pub(crate) const fn new(seen: &'s [TimedStatus]) -> Self {
        Self { seen }
    }

    /// How long it took, to the period of statuses: how many of them told of neither end, or would
    /// have, had they come.
    pub(crate) fn duration_s(&self) -> f64 {
        let under_way = self.under_way();
        match (under_way.first(), under_way.last()) {
            (Some(first), Some(last)) => (periods(first, last) + 1.0) * PERIOD_S,
            _ => 0.0,
        }
    }

    /// The largest speed between two statuses, in millimetres per second.
    pub(crate) fn peak_mm_s(&self) -> f64 {
        let steps = self.seen.windows(2);
        let speeds = steps.map(|it| apart(&it[0], &it[1]) / periods(&it[0], &it[1]).max(1.0));
        speeds.fold(0.0, f64::max) / PERIOD_S
    }

    /// The way covered at a status, on average of those under way: half of it for a motion that is
    /// the same backwards, more for one that begins fast.
    pub(crate) fn mean_progress(&self) -> Option<f64> {
        let (first, last) = (self.seen.first()?, self.seen.last()?);
        let length = apart(first, last);
        let under_way = self.under_way();
        let sum: f64 = under_way.iter().map(|it| apart(first, it) / length).sum();
        let count = u32::try_from(under_way.len()).ok()?;
        (count > 0).then(|| sum / f64::from(count))
    }

    /// How far it strays from the straight line between its ends, in millimetres.
    pub(crate) fn off_line_mm(&self) -> f64 {
        self.strays(|from, to, at| off_segment(position(from), position(to), at))
    }

    /// How far it strays from the way on which all joints go together, in millimetres.
    pub(crate) fn off_joints_mm(&self, tool: Tool) -> f64 {
        self.strays(|from, to, at| off_joints(from, to, at, tool))
    }

    /// How long it rested at a place in the middle: the time of the statuses that tell of it.
    pub(crate) fn rest_s(&self, at: [f32; 3]) -> f64 {
        let [x, y, z] = at.map(f64::from);
        let place = Position::new(x, y, z);
        let near = |seen: &&TimedStatus| position(&seen.status).distance(place).0 < HERE_MM;
        let count = self.seen.iter().filter(near).count();
        f64::from(u32::try_from(count).unwrap_or(u32::MAX)) * PERIOD_S
    }

    /// The statuses that tell of neither end.
    fn under_way(&self) -> Vec<TimedStatus> {
        let (Some(first), Some(last)) = (self.seen.first(), self.seen.last()) else {
            return Vec::new();
        };
        let between = |it: &&TimedStatus| apart(first, it) > HERE_MM && apart(last, it) > HERE_MM;
        self.seen.iter().filter(between).copied().collect()
    }

    fn strays(&self, off: impl Fn(&Status, &Status, &Status) -> f64) -> f64 {
        let (Some(first), Some(last)) = (self.seen.first(), self.seen.last()) else {
            return 0.0;
        };
        let offs = self
            .seen
            .iter()
            .map(|it| off(&first.status, &last.status, &it.status));
        offs.fold(0.0, f64::max)
    }
}

/// How far a position is from the line between two others.
pub(crate) fn off_segment(from: Position, to: Position, at: &Status) -> f64 {
    let (way, here) = (to - from, position(at) - from);
    let squared = dot(way, way);
    if squared == 0.0 {
        return here.length().0;
    }
    let share = (dot(way, here) / squared).clamp(0.0, 1.0);
    (here - way * share).length().0
}

/// How far a position is from the nearest one on the way of all joints together.
fn off_joints(from: &Status, to: &Status, at: &Status, tool: Tool) -> f64 {
    let (a, b) = (joints(from), joints(to));
    let here = position(at);
    nearest(|share| {
        let joints = a.towards(&b, share);
        forward(&joints, tool).position.distance(here).0
    })
}

/// The least value of a function with one valley between 0 and 1.
fn nearest(off: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    for _ in 0..40 {
        let third = (high - low) / 3.0;
        if off(low + third) < off(high - third) {
            high -= third;
        } else {
            low += third;
        }
    }
    off(f64::midpoint(low, high))
}

fn dot(a: Position, b: Position) -> f64 {
    a.x.0 * b.x.0 + a.y.0 * b.y.0 + a.z.0 * b.z.0
}

/// How many periods of statuses lie between two, whether all between them came or not.
pub(crate) fn periods(a: &TimedStatus, b: &TimedStatus) -> f64 {
    (b.at.saturating_sub(a.at).as_secs_f64() / PERIOD_S).round()
}

fn apart(a: &TimedStatus, b: &TimedStatus) -> f64 {
    position(&a.status).distance(position(&b.status)).0
}

/// The time between two statuses (note N20).
pub(crate) const PERIOD_S: f64 = Dialect::SPECIFICATION.status_period().as_secs_f64();
/// A status tells of a place where it is as near as this.
const HERE_MM: f64 = 0.01;
