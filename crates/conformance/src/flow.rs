//! One run with a full queue.

use std::time::Duration;

use dobot_arm::Position;
use dobot_session::position;
use dobot_wire::Status;

use crate::timed_status::TimedStatus;

/// The result of a full queue.
#[derive(Debug)]
pub(crate) struct Flow {
    pub(crate) home: Position,
    /// The statuses from the first command to rest.
    pub(crate) seen: Vec<TimedStatus>,
    /// Those of them that permit a command.
    pub(crate) permits: Vec<TimedStatus>,
    pub(crate) end: Status,
}

impl Flow {
    /// The longest time without a permit, and the number of the permit that ended it.
    pub(crate) fn longest_gap(&self) -> (usize, Duration) {
        let gaps = self
            .permits
            .windows(2)
            .map(|pair| pair[1].at.saturating_sub(pair[0].at));
        let numbered = (1..).zip(gaps);
        numbered.max_by_key(|(_, gap)| *gap).unwrap_or_default()
    }

    /// The subset of the eight that leads from the start to the end.
    pub(crate) fn done(&self) -> Option<Vec<usize>> {
        let end = position(&self.end);
        (0..1_u32 << STEPS.len())
            .map(|chosen| (0..STEPS.len()).filter(|n| chosen >> n & 1 == 1).collect())
            .find(|done: &Vec<usize>| {
                let corners = self.corners(done);
                corners
                    .last()
                    .is_some_and(|point| point.distance(end).0 < NEAR_MM)
            })
    }

    /// The corners of the path of the slow vector and the given ones of the eight.
    pub(crate) fn corners(&self, done: &[usize]) -> Vec<Position> {
        let steps = done.iter().map(|&n| STEPS[n]);
        let mut at = self.home;
        let mut corners = vec![at];
        for [x, y, z] in std::iter::once(BLOCKER).chain(steps) {
            at = at + Position::new(x.into(), y.into(), z.into());
            corners.push(at);
        }
        corners
    }
}

/// Keeps the arm busy while the others arrive. Y and Z are the same in every dialect.
pub(crate) const BLOCKER: [f32; 3] = [0.0, -4.0, 0.0];
/// No two subsets lead to the same point; the last two exceed the queue.
pub(crate) const STEPS: [[f32; 3]; 8] = [
    [0.0, 0.0, 0.8],
    [0.0, 0.8, 0.0],
    [0.0, 0.0, 1.6],
    [0.0, 1.6, 0.0],
    [0.0, 0.0, 3.2],
    [0.0, 3.2, 0.0],
    [0.0, 0.0, 0.4],
    [0.0, 0.4, 0.0],
];
pub(crate) const NEAR_MM: f64 = 0.1;
