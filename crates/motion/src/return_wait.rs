//! How long an arm waits where its path returns to a place.

use dobot_arm::Position;

use crate::{Model, Trajectory};

/// The waits of an arm that gets one command per status, and only commands whose ends show how many
/// are done.
///
/// After a failure, a station finds the last command that is done by where the arm rests. So it
/// gives no command that ends where an unfinished one began: the lift after a dot, a line drawn
/// back, a vector that hardly moves. The arm then rests until the statuses have shown the end of
/// the unfinished one.
///
/// ```text
///   lower | lift          the lift ends where the lowering began, so it is
///     \   |  /            given once two equal statuses have shown the pen
///      \__|_/  wait       down
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ReturnWait {
    period_s: f64,
    /// The last commands, the latest one first: where each began and when it ended.
    last: [Option<(Position, f64)>; RECENT],
    /// The end of the last command, and the earliest time at which the link allows the next one to
    /// begin, after a wait.
    now_s: f64,
    earliest_s: Option<f64>,
    /// When the last command began that was given directly after a status.
    in_step_s: Option<f64>,
}

impl ReturnWait {
    /// Starts at rest, with this time between two statuses in s; 0 if there are no waits.
    #[must_use]
    pub const fn new(period_s: f64) -> Self {
        Self {
            period_s,
            last: [None; RECENT],
            now_s: 0.0,
            earliest_s: None,
            in_step_s: None,
        }
    }

    /// Adds a command of a job with its trajectory, from a model to the model after it; returns how
    /// long the arm waits, in s: before a motion, and for the next status after anything else.
    pub fn before(&mut self, model: &Model, trajectory: &Trajectory, after: &Model) -> f64 {
        let duration_s = trajectory.duration_s().unwrap_or_default();
        if !trajectory.moves() {
            return (self.period_s - duration_s).max(0.0);
        }
        let [from, to] = [model, after].map(|model| model.place.pose.position);
        self.before_motion(from, to, duration_s)
    }

    /// Adds a motion with its start, its end and its duration in s; returns how long the arm waits
    /// before it, in s.
    pub fn before_motion(&mut self, from: Position, to: Position, duration_s: f64) -> f64 {
        if self.period_s <= 0.0 {
            return 0.0;
        }
        let mut begin_s = self.earliest_s.map_or(self.now_s, |at| at.max(self.now_s));
        if let Some(returns_s) = self.returns_s(from, to)
            && returns_s > self.now_s
        {
            begin_s = returns_s;
            (self.in_step_s, self.earliest_s) = (Some(begin_s), Some(begin_s));
        }
        self.earliest_s = self
            .earliest_s
            .map(|at| at.max(begin_s - QUEUED * self.period_s) + self.period_s);
        let wait_s = begin_s - self.now_s;
        self.now_s = begin_s + duration_s;
        self.last.rotate_right(1);
        self.last[0] = Some((from, self.now_s));
        wait_s
    }

    /// Returns when a command may begin that ends where an unfinished one, or itself, began.
    fn returns_s(&self, from: Position, to: Position) -> Option<f64> {
        let is_here = |place: Position| place.distance(to).0 < SAME_PLACE_MM;
        let began_here = |last: &Option<(Position, f64)>| last.is_some_and(|last| is_here(last.0));
        let index = if is_here(from) {
            0
        } else {
            self.last.iter().position(began_here)?
        };
        let (_, ended_s) = self.last[index]?;
        let at_rest_s = self.after_rest_s();
        let next = index.checked_sub(1).and_then(|next| self.last[next]);
        let then = index
            .checked_sub(2)
            .map_or(Some(from), |then| Some(self.last[then]?.0));
        // The statuses show the arm on its way only if the way is long.
        let is_seen = next
            .zip(then)
            .is_some_and(|((next, _), then)| next.distance(then).0 > CLEARLY_MM);
        Some(if is_seen {
            at_rest_s.min(ended_s + SEEN_S + self.after_status_s())
        } else {
            at_rest_s
        })
    }

    /// Returns when a command begins that is given once the arm was seen at rest: the second status
    /// after the end of the last command shows that.
    fn after_rest_s(&self) -> f64 {
        let Some(in_step_s) = self.in_step_s else {
            return self.now_s + self.after_status_s() + self.period_s;
        };
        let periods = libm::ceil((self.now_s - in_step_s + ON_LINE_S) / self.period_s);
        in_step_s + (periods + 1.0) * self.period_s
    }

    /// Returns the mean time from an event to the begin of a command given after the next status.
    fn after_status_s(&self) -> f64 {
        0.5 * self.period_s + ON_LINE_S
    }
}

/// Places closer than this are not distinguishable by the status of an arm at rest, in mm. The
/// status repeats to a ten-thousandth; the margin is for what the model omits.
pub const SAME_PLACE_MM: f64 = 0.02;
/// The time of a status and of a packet on the line at 9600 baud, and of half a tick, in s.
const ON_LINE_S: f64 = 0.0974;
/// The distance at which the arm is clearly on a path, in mm.
const CLEARLY_MM: f64 = 0.1;
/// The time from the end of a command until the arm is clearly on the path of the next one, in s.
const SEEN_S: f64 = 0.08;
/// The number of commands that wait in the arm.
const QUEUED: f64 = 2.0;
/// Commands before these are over long before.
const RECENT: usize = 16;

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the waits before vectors of 0.6 s between these heights in mm.
    fn waits_s<const N: usize>(period_s: f64, heights_mm: [f64; N]) -> [f64; N] {
        let mut return_wait = ReturnWait::new(period_s);
        let mut here = Position::new(200.0, 0.0, 0.0);
        heights_mm.map(|z_mm| {
            let from = core::mem::replace(&mut here, Position::new(200.0, 0.0, z_mm));
            return_wait.before_motion(from, here, 0.6)
        })
    }

    #[test]
    fn a_path_back_waits_for_two_statuses_and_other_paths_do_not() {
        let [down, back, on, over, again] = waits_s(0.08, [-10.0, 0.0, 10.0, 20.0, 10.0]);
        assert_eq!([down, on, over], [0.0; 3]);
        for wait_s in [back, again] {
            assert!((0.17..0.27).contains(&wait_s), "{wait_s} s");
        }
    }

    #[test]
    fn a_vector_that_hardly_moves_waits_for_the_one_before() {
        let [_, tiny] = waits_s(0.08, [-10.0, -10.01]);
        assert!((0.17..0.27).contains(&tiny), "{tiny} s");
    }

    #[test]
    fn nothing_waits_without_a_link() {
        assert_eq!(waits_s(0.0, [-10.0, 0.0]), [0.0; 2]);
    }
}
