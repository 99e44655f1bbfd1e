//! Conversion of a trajectory to a job: as many targets as the link can carry, each with the speed
//! of the trajectory.

use std::time::Duration;

use dobot_api::{JobKind, JobProgram, NewJob};
use dobot_arm::Joints;
use dobot_geometry::distance_from_chord;
use dobot_motion::{ArmPlace, Model, Speeds, Trajectory};
use dobot_wire::{Command, Dialect, MoveJoints, MovingMode, PlaybackAdjustment, Status, single};

use crate::goal::{Fault, FaultCode, Wanted, rad};
use crate::joints::JOINTS;
use crate::thin::{Thinned, thinned};

/// A planned trajectory.
#[derive(Clone, Debug)]
pub(crate) struct FollowPlan {
    pub(crate) job: NewJob,
    /// Its duration by the motion model, in seconds.
    #[cfg(test)]
    pub(crate) takes_s: f64,
    /// The largest deviation from the requested path by the motion model, in degrees.
    #[cfg(test)]
    pub(crate) deviation_deg: f64,
    /// The deviations from the requested trajectory, as text.
    pub(crate) summary: String,
}

impl FollowPlan {
    /// Plans a trajectory for an arm of a dialect that reports a status. Without a tolerance in the
    /// goal, the joints stay within the default tolerance (in degrees, combined) as far as the link
    /// can carry that.
    ///
    /// # Errors
    ///
    /// [`Fault`] if a tolerance of the goal cannot be met, or the arm cannot get to a position.
    pub(crate) fn new(
        wanted: &Wanted,
        status: &Status,
        dialect: Dialect,
        tolerance_deg: f64,
    ) -> Result<Self, Fault> {
        let tolerances = wanted.path_deg.iter().flatten();
        let tolerance_deg =
            tolerances.fold(tolerance_deg, |least, tolerance| least.min(*tolerance));
        let period = dialect.status_period();
        let model = Model::new(dialect, status);
        let path = wanted.divided(TARGET_PERIODS * period.as_secs_f64());
        let most = carried(wanted.duration_s(), period);
        let bow = |from, to| bow_deg(&model, &path, from, to);
        let holds = holds(wanted, period).into_iter();
        let holds: Vec<usize> = holds
            .map(|hold| path.at_s.partition_point(|at_s| *at_s < wanted.at_s[hold]))
            .collect();
        let thin = thinned(&path.places, &holds, tolerance_deg, most, bow);
        check_path(wanted, &thin)?;
        let moves = moves(&model, &path, &thin)?;
        let takes_s: f64 = moves.iter().map(FollowMove::takes_s).sum();
        check_time(wanted, takes_s)?;
        let deviation = thin.farthest.map(|at| (thin.deviation, path.at_s[at]));
        Ok(Self {
            summary: summary(wanted, deviation, moves.len(), takes_s),
            job: job(&moves, status),
            #[cfg(test)]
            takes_s,
            #[cfg(test)]
            deviation_deg: thin.deviation,
        })
    }
}

/// Returns how far the joints leave the straight line between two points of a path, in degrees: the
/// joints of a stock arm do not turn in proportion (note N45). A target that the arm cannot get to
/// counts as none here.
fn bow_deg(model: &Model, path: &Wanted, from: usize, to: usize) -> f64 {
    let within_s = path.at_s[to] - path.at_s[from];
    // All pieces bow alike.
    let piece = divided(path.places[from], path.places[to], within_s).next();
    let planned = piece.and_then(|piece| piece.planned(model).ok());
    let Some(Planned { piece, trajectory }) = planned else {
        return 0.0;
    };
    let corners = trajectory.corners();
    corners.fold(0.0, |most: f64, (place, _)| {
        let at = place.joints.angles_deg();
        most.max(distance_from_chord(at, piece.from_deg, piece.to_deg))
    })
}

/// Returns the number of targets that the link can carry in a time: each takes two commands, its
/// speed and itself, and a status permits one (note N20).
fn carried(duration_s: f64, period: Duration) -> usize {
    let periods = duration_s / period.as_secs_f64();
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "an hour has 45,000 periods"
    )]
    let targets = (periods / TARGET_PERIODS) as usize;
    targets.max(1)
}

/// Returns the first and the last point of each pause in the trajectory that is long enough for the
/// link to carry its two targets and one more.
fn holds(wanted: &Wanted, period: Duration) -> Vec<usize> {
    let least_s = HOLD_PERIODS * period.as_secs_f64();
    let mut holds = Vec::new();
    let mut first = 0;
    for at in 1..=wanted.places.len() {
        let place = wanted.places.get(at);
        if place.is_some_and(|place| way_deg(&wanted.places[first], place) < STILL_DEG) {
            continue;
        }
        let last = at - 1;
        if wanted.at_s[last] - wanted.at_s[first] >= least_s {
            holds.extend([first, last]);
        }
        first = at;
    }
    holds
}

/// Returns the largest angle that a joint turns, in degrees.
fn way_deg(from: &[f64; 4], to: &[f64; 4]) -> f64 {
    let ways = from.iter().zip(to).map(|(from, to)| (to - from).abs());
    ways.fold(0.0, f64::max)
}

fn check_path(wanted: &Wanted, thin: &Thinned) -> Result<(), Fault> {
    let broken = (0..4)
        .find(|joint| wanted.path_deg[*joint].is_some_and(|allowed| thin.deviation > allowed));
    let Some(joint) = broken else {
        return Ok(());
    };
    let (name, found) = (JOINTS[joint], rad(thin.deviation));
    let allowed = rad(wanted.path_deg[joint].unwrap_or_default());
    Err(Fault::new(
        FaultCode::PathToleranceViolated,
        format!(
            "the link can carry {} targets in {} s, which deviate {found} rad from the trajectory; path_tolerance allows {allowed} rad for {name}; use a longer time or a larger tolerance",
            thin.kept.len() - 1,
            wanted.duration_s(),
        ),
    ))
}

fn check_time(wanted: &Wanted, takes_s: f64) -> Result<(), Fault> {
    let (within_s, late_s) = (wanted.duration_s(), takes_s - wanted.duration_s());
    match wanted.late_s {
        Some(allowed_s) if late_s > allowed_s => Err(Fault::new(
            FaultCode::GoalToleranceViolated,
            format!(
                "the arm takes {takes_s:.2} s, the trajectory {within_s:.2} s; goal_time_tolerance allows {allowed_s:.2} s more; use a longer time"
            ),
        )),
        _ => Ok(()),
    }
}

/// A target, and the motion to it from rest to rest.
#[derive(Clone, Copy, Debug)]
struct FollowMove {
    to_deg: [f64; 4],
    /// The speed, in percent of the configured speed.
    percent: f64,
    /// The duration of the motion, in seconds.
    moves_s: f64,
    /// The pause at the target, in seconds.
    pause_s: f64,
}

/// Returns the targets, each in the time that the trajectory gives or as fast as the arm may.
///
/// The arm cannot abort a motion to a target. So a motion that would take longer than the time
/// allowed for holding is divided.
fn moves(model: &Model, path: &Wanted, thin: &Thinned) -> Result<Vec<FollowMove>, Fault> {
    let mut moves: Vec<FollowMove> = Vec::new();
    let (mut from_deg, mut from_s) = (path.places[0], 0.0);
    for &at in &thin.kept[1..] {
        let (to_deg, within_s) = (path.places[at], path.at_s[at] - from_s);
        if way_deg(&from_deg, &to_deg) >= STILL_DEG {
            for piece in divided(from_deg, to_deg, within_s) {
                moves.push(piece.planned(model)?.as_move());
            }
            from_deg = to_deg;
        } else if let Some(before) = moves.last().copied() {
            moves.extend(waits(before, within_s));
        } else {
            // It is at rest at the beginning: the first target gets more time.
            continue;
        }
        from_s = path.at_s[at];
    }
    wait_in_ticks(&mut moves);
    Ok(moves)
}

/// Merges pauses below a tick, the shortest pause of the controller, into later ones.
fn wait_in_ticks(moves: &mut [FollowMove]) {
    let mut due_s = 0.0;
    for step in moves {
        due_s += step.pause_s;
        step.pause_s = if due_s < NO_PAUSE_S {
            0.0
        } else {
            std::mem::take(&mut due_s)
        };
    }
}

/// A straight joint path, and the time for it.
#[derive(Clone, Copy, Debug)]
struct Piece {
    from_deg: [f64; 4],
    to_deg: [f64; 4],
    within_s: f64,
}

/// A piece, and the motion of the arm.
struct Planned {
    piece: Piece,
    trajectory: Trajectory,
}

/// Divides a straight joint path into as many pieces as necessary.
fn divided(from_deg: [f64; 4], to_deg: [f64; 4], within_s: f64) -> impl Iterator<Item = Piece> {
    let pieces = (within_s / HOLD_S).ceil().max(1.0);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "an hour has 1,800 pieces"
    )]
    let count = pieces as u32;
    let at = move |n: u32| {
        let share = f64::from(n) / pieces;
        std::array::from_fn(|i| from_deg[i] + (to_deg[i] - from_deg[i]) * share)
    };
    (1..=count).map(move |n| Piece {
        from_deg: at(n - 1),
        to_deg: if n == count { to_deg } else { at(n) },
        within_s: within_s / pieces,
    })
}

/// Divides a pause into as many moves in place as necessary.
fn waits(before: FollowMove, wait_s: f64) -> impl Iterator<Item = FollowMove> {
    let there = before.to_deg;
    divided(there, there, wait_s).map(move |piece| FollowMove {
        moves_s: 0.0,
        pause_s: piece.within_s,
        ..before
    })
}

impl Piece {
    fn percent(&self) -> f64 {
        percent(way_deg(&self.from_deg, &self.to_deg), self.within_s)
    }

    /// Plans the motion of an arm with the settings of a model, from the beginning of the piece.
    fn planned(self, model: &Model) -> Result<Planned, Fault> {
        let [base, rear, fore, servo] = self.from_deg;
        let mut arm = model.begun(&speed(self.percent()));
        arm.place = ArmPlace::at_joints(Joints::new(base, rear, fore, servo), arm.tool);
        let target = MoveJoints {
            mode: MovingMode::MovJ,
            ..MoveJoints::to(self.to_deg.map(single))
        };
        let trajectory = arm.trajectory(&target.into());
        let trajectory = trajectory.map_err(|error| Fault::invalid(error.to_string()))?;
        Ok(Planned {
            piece: self,
            trajectory,
        })
    }
}

impl Planned {
    fn as_move(&self) -> FollowMove {
        let Piece {
            to_deg, within_s, ..
        } = self.piece;
        let moves_s = self.trajectory.motion_s().unwrap_or_default();
        FollowMove {
            to_deg,
            percent: self.piece.percent(),
            moves_s,
            pause_s: (within_s - moves_s).max(0.0),
        }
    }
}

impl FollowMove {
    fn takes_s(&self) -> f64 {
        self.moves_s + self.pause_s
    }
}

/// Returns the speed, in percent of the configured speed, at which joints turn by an angle from
/// rest to rest in a time.
///
/// ```text
///  speed |    ______          way = v T - v^2 / a, and so
///      v |   /      \         v = (a T - sqrt(a^2 T^2 - 4 a way)) / 2;
///        |__/________\____    if there is no such v, even accelerating for half the way and decelerating for
///           <--- T --->       the other half is enough
/// ```
fn percent(way_deg: f64, within_s: f64) -> f64 {
    let a = Speeds::STOCK.joint_deg_s2 * ACCELERATION_PERCENT / 100.0;
    let under_root = (a * within_s).powi(2) - 4.0 * a * way_deg;
    if under_root < 0.0 {
        return MAX_PERCENT;
    }
    let deg_s = (a * within_s - under_root.sqrt()) / 2.0;
    (deg_s / Speeds::STOCK.joint_deg_s * 100.0).clamp(MIN_PERCENT, MAX_PERCENT)
}

/// Returns the commands, and the first command of each move.
fn commands(moves: &[FollowMove], status: &Status) -> (Vec<Command>, Vec<usize>) {
    let mut commands = Vec::new();
    let mut steps = Vec::new();
    let mut now_percent: Option<f64> = None;
    for step in moves {
        steps.push(commands.len());
        // A difference of a hundredth is not worth a packet.
        if now_percent.is_none_or(|now| (step.percent - now).abs() >= now / 100.0) {
            commands.push(speed(step.percent));
            now_percent = Some(step.percent);
        }
        commands.push(target(step, status));
    }
    if !moves.is_empty() {
        commands.push(speed(MAX_PERCENT));
    }
    (commands, steps)
}

/// Returns the commands: pump and gripper do not change, and the speed at the end is that of
/// power-up.
fn job(moves: &[FollowMove], status: &Status) -> NewJob {
    let (commands, steps) = commands(moves, status);
    NewJob {
        title: "trajectory of ROS 2".to_owned(),
        kind: JobKind::Program,
        commands,
        lift_mm: 0.0,
        pauses: Vec::new(),
        program: JobProgram {
            steps,
            ..JobProgram::default()
        },
    }
}

fn speed(percent: f64) -> Command {
    PlaybackAdjustment {
        speed_percent: single(percent),
        acceleration_percent: single(ACCELERATION_PERCENT),
        teach_speed_percent: 100.0,
    }
    .into()
}

fn target(to: &FollowMove, status: &Status) -> Command {
    let pause_s = single(to.pause_s);
    MoveJoints {
        suction: status.suction,
        gripper_deg: status.gripper_deg,
        mode: MovingMode::MovJ,
        pause_s,
        ..MoveJoints::to(to.to_deg.map(single))
    }
    .into()
}

/// Returns the result as text, with the largest deviation in degrees and its time in seconds.
fn summary(wanted: &Wanted, deviation: Option<(f64, f64)>, targets: usize, takes_s: f64) -> String {
    let points = wanted.places.len() - 1;
    let aside = match deviation {
        Some((deg, at_s)) => format!("deviation at most {} rad, at {at_s:.2} s", rad(deg)),
        None => "without deviation".to_owned(),
    };
    let time = format!(
        "{takes_s:.2} s by the motion model, for {:.2} s",
        wanted.duration_s()
    );
    format!("{targets} targets for {points} points, {aside}; {time}")
}

/// The percentages of an arm after power-up; no trajectory is followed faster than that.
const ACCELERATION_PERCENT: f64 = 50.0;
const MAX_PERCENT: f64 = 50.0;
const MIN_PERCENT: f64 = 1.0;
/// Below the resolution of the arm.
const STILL_DEG: f64 = 0.01;
/// A target takes two commands.
const TARGET_PERIODS: f64 = 2.0;
/// A shorter pause is part of the motion.
const HOLD_PERIODS: f64 = 6.0;
/// A tick of the controller.
const NO_PAUSE_S: f64 = dobot_arm::TICK_S;
/// The maximum time that the arm continues after a command to hold, besides the in-flight commands.
const HOLD_S: f64 = 2.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests;
