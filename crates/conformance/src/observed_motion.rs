//! A motion observed in its statuses.

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

    /// The duration in status periods: the number of statuses at neither end, including lost ones.
    pub(crate) fn duration_s(&self) -> f64 {
        let in_motion = self.in_motion();
        match (in_motion.first(), in_motion.last()) {
            (Some(first), Some(last)) => (periods(first, last) + 1.0) * PERIOD_S,
            _ => 0.0,
        }
    }

    /// The largest speed between two statuses, in millimetres per second.
    pub(crate) fn peak_mm_s(&self) -> f64 {
        let steps = self.seen.windows(2);
        let speeds =
            steps.map(|pair| apart(&pair[0], &pair[1]) / periods(&pair[0], &pair[1]).max(1.0));
        speeds.fold(0.0, f64::max) / PERIOD_S
    }

    /// The mean covered fraction of the path over the statuses in motion: one half for a symmetric
    /// motion, more for one that starts fast.
    pub(crate) fn mean_progress(&self) -> Option<f64> {
        let (first, last) = (self.seen.first()?, self.seen.last()?);
        let length = apart(first, last);
        let in_motion = self.in_motion();
        let sum: f64 = in_motion
            .iter()
            .map(|status| apart(first, status) / length)
            .sum();
        let count = u32::try_from(in_motion.len()).ok()?;
        (count > 0).then(|| sum / f64::from(count))
    }

    /// The largest deviation from the straight line between its ends, in millimetres.
    pub(crate) fn off_line_mm(&self) -> f64 {
        self.strays(|from, to, at| off_segment(position(from), position(to), at))
    }

    /// The largest deviation from the joint path between its ends, in millimetres.
    pub(crate) fn off_joints_mm(&self, tool: Tool) -> f64 {
        self.strays(|from, to, at| off_joints(from, to, at, tool))
    }

    /// The rest time at an intermediate position, from its statuses.
    pub(crate) fn rest_s(&self, at: [f32; 3]) -> f64 {
        let [x, y, z] = at.map(f64::from);
        let place = Position::new(x, y, z);
        let near = |seen: &&TimedStatus| position(&seen.status).distance(place).0 < HERE_MM;
        let count = self.seen.iter().filter(near).count();
        f64::from(u32::try_from(count).unwrap_or(u32::MAX)) * PERIOD_S
    }

    /// The statuses at neither end.
    fn in_motion(&self) -> Vec<TimedStatus> {
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
            .map(|timed| off(&first.status, &last.status, &timed.status));
        offs.fold(0.0, f64::max)
    }
}

/// The distance of a position from the line between two others.
pub(crate) fn off_segment(from: Position, to: Position, at: &Status) -> f64 {
    let (way, here) = (to - from, position(at) - from);
    let squared = dot(way, way);
    if squared == 0.0 {
        return here.length().0;
    }
    let share = (dot(way, here) / squared).clamp(0.0, 1.0);
    (here - way * share).length().0
}

/// The distance of a position from the joint path.
fn off_joints(from: &Status, to: &Status, at: &Status, tool: Tool) -> f64 {
    let (a, b) = (joints(from), joints(to));
    let here = position(at);
    nearest(|share| {
        let joints = a.towards(&b, share);
        forward(&joints, tool).position.distance(here).0
    })
}

/// The minimum of a unimodal function between 0 and 1.
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

/// The number of status periods between two statuses, including lost statuses.
pub(crate) fn periods(a: &TimedStatus, b: &TimedStatus) -> f64 {
    (b.at.saturating_sub(a.at).as_secs_f64() / PERIOD_S).round()
}

fn apart(a: &TimedStatus, b: &TimedStatus) -> f64 {
    position(&a.status).distance(position(&b.status)).0
}

/// The status period (note N20).
pub(crate) const PERIOD_S: f64 = Dialect::SPECIFICATION.status_period().as_secs_f64();
/// The distance within which a status is at a position.
const HERE_MM: f64 = 0.01;
