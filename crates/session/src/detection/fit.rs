//! How well what was seen fits what a dialect would do.

use std::time::Duration;

use dobot_arm::Position;
use dobot_motion::Trajectory;
use dobot_wire::Status;

use crate::position;

/// The way of a trajectory, as a chain of points.
fn chain(trajectory: &Trajectory) -> Vec<Position> {
    let motion_s = trajectory.motion_s().unwrap_or_default();
    (0..=POINTS)
        .filter_map(|index| {
            let share = f64::from(index) / f64::from(POINTS);
            trajectory.place_at(motion_s * share).ok()
        })
        .map(|place| place.pose.position)
        .collect()
}

/// How far the statuses stray from a trajectory, in millimetres.
pub(super) fn off_way_mm(trajectory: &Trajectory, seen: &[(Duration, Status)]) -> f64 {
    let chain = chain(trajectory);
    let off = |at: Position| {
        let segments = chain.windows(2).map(|it| off_segment_mm(it[0], it[1], at));
        segments.fold(f64::INFINITY, f64::min)
    };
    let offs = seen.iter().map(|(_, status)| off(position(status)));
    offs.fold(0.0, f64::max)
}

/// How far two trajectories are apart somewhere, in millimetres.
pub(super) fn apart_mm(one: &Trajectory, other: &Trajectory) -> f64 {
    let other = chain(other);
    let off = |at: Position| {
        let segments = other.windows(2).map(|it| off_segment_mm(it[0], it[1], at));
        segments.fold(f64::INFINITY, f64::min)
    };
    chain(one).into_iter().map(off).fold(0.0, f64::max)
}

/// How long the motion took, from the sending to the first status that tells of its end.
pub(super) fn took_s(sent: Duration, seen: &[(Duration, Status)]) -> f64 {
    let Some((_, last)) = seen.last() else {
        return 0.0;
    };
    let there = |it: &&(Duration, Status)| position(&it.1).distance(position(last)).0 < HERE_MM;
    // Walking back from the end: the arm may have been there before.
    let first = seen.iter().rev().take_while(there).last();
    first.map_or(0.0, |(at, _)| at.saturating_sub(sent).as_secs_f64())
}

fn off_segment_mm(from: Position, to: Position, at: Position) -> f64 {
    let (way, here) = (to - from, at - from);
    let dot = |a: Position, b: Position| a.x.0 * b.x.0 + a.y.0 * b.y.0 + a.z.0 * b.z.0;
    let squared = dot(way, way);
    if squared == 0.0 {
        return here.length().0;
    }
    let share = (dot(way, here) / squared).clamp(0.0, 1.0);
    (here - way * share).length().0
}

const POINTS: u32 = 400;
const HERE_MM: f64 = 0.02;
