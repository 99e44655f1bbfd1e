//! The fit of observed statuses to the motion of a dialect.

use std::time::Duration;

use dobot_arm::Position;
use dobot_motion::Trajectory;
use dobot_wire::Status;

use crate::position;

/// The path of a trajectory as a polyline.
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

/// The largest distance of the statuses from a trajectory, in millimetres.
pub(super) fn path_deviation_mm(trajectory: &Trajectory, seen: &[(Duration, Status)]) -> f64 {
    let chain = chain(trajectory);
    let off = |at: Position| {
        let segments = chain
            .windows(2)
            .map(|pair| segment_distance_mm(pair[0], pair[1], at));
        segments.fold(f64::INFINITY, f64::min)
    };
    let offs = seen.iter().map(|(_, status)| off(position(status)));
    offs.fold(0.0, f64::max)
}

/// The largest distance between two trajectories, in millimetres.
pub(super) fn path_difference_mm(one: &Trajectory, other: &Trajectory) -> f64 {
    let other = chain(other);
    let off = |at: Position| {
        let segments = other
            .windows(2)
            .map(|pair| segment_distance_mm(pair[0], pair[1], at));
        segments.fold(f64::INFINITY, f64::min)
    };
    chain(one).into_iter().map(off).fold(0.0, f64::max)
}

/// The duration of the motion in seconds, from sending to the first status at its end.
pub(super) fn duration_s(sent: Duration, seen: &[(Duration, Status)]) -> f64 {
    let Some((_, last)) = seen.last() else {
        return 0.0;
    };
    let at_end =
        |(_, status): &&(Duration, Status)| position(status).distance(position(last)).0 < HERE_MM;
    // Search backwards: the arm may have passed this point earlier.
    let first = seen.iter().rev().take_while(at_end).last();
    first.map_or(0.0, |(at, _)| at.saturating_sub(sent).as_secs_f64())
}

fn segment_distance_mm(from: Position, to: Position, at: Position) -> f64 {
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
