//! Parsing of `FollowJointTrajectory` goals.

use ros2_client::builtin_interfaces::Time;

use crate::joints::JOINTS;
use crate::messages::{FollowGoal, FollowResult, JointTolerance, seconds};

/// A valid trajectory: joint positions over time, with tolerances.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Wanted {
    /// The positions, beginning with the arm's position at 0 s; in the order of [`JOINTS`], in
    /// degrees.
    pub(crate) places: Vec<[f64; 4]>,
    /// The times of the positions, in seconds since the beginning.
    pub(crate) at_s: Vec<f64>,
    /// The path tolerance of each joint, in degrees, if given.
    pub(crate) path_deg: [Option<f64>; 4],
    /// The goal tolerance of each joint, in degrees, if given.
    pub(crate) end_deg: [Option<f64>; 4],
    /// The goal time tolerance, in seconds, if given.
    pub(crate) late_s: Option<f64>,
}

/// The reason why a trajectory is refused or aborted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Fault {
    pub(crate) code: FaultCode,
    pub(crate) text: String,
}

/// The error codes of `control_msgs/FollowJointTrajectory`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FaultCode {
    InvalidGoal = -1,
    InvalidJoints = -2,
    OldHeaderTimestamp = -3,
    PathToleranceViolated = -4,
    GoalToleranceViolated = -5,
}

impl Fault {
    pub(crate) fn new(code: FaultCode, text: impl Into<String>) -> Self {
        Self {
            code,
            text: text.into(),
        }
    }

    /// Returns a fault for an invalid goal, or for one that the station refuses.
    pub(crate) fn invalid(text: impl Into<String>) -> Self {
        Self::new(FaultCode::InvalidGoal, text)
    }
}

impl From<Result<String, Fault>> for FollowResult {
    fn from(done: Result<String, Fault>) -> Self {
        match done {
            Ok(error_string) => Self {
                error_code: 0,
                error_string,
            },
            Err(Fault { code, text }) => Self {
                error_code: code as i32,
                error_string: text,
            },
        }
    }
}

impl Wanted {
    /// Parses a goal for an arm at this position (in degrees), at this time.
    ///
    /// Joints that are not in the goal do not move.
    ///
    /// # Errors
    ///
    /// [`Fault`] with the problem and what is allowed.
    pub(crate) fn new(goal: &FollowGoal, arm_deg: [f64; 4], now: Time) -> Result<Self, Fault> {
        if !goal.multi_dof_trajectory.joint_names.is_empty()
            || !goal.multi_dof_trajectory.points.is_empty()
            || !goal.component_path_tolerance.is_empty()
            || !goal.component_goal_tolerance.is_empty()
        {
            return Err(Fault::invalid(
                "multi_dof_trajectory or a tolerance of its components is given; the arm has no such joints",
            ));
        }
        let joints = joints(&goal.trajectory.joint_names)?;
        let (places, at_s) = places(goal, &joints, arm_deg)?;
        let ends_s = at_s.last().copied().unwrap_or_default();
        check_start(goal.trajectory.header.stamp, ends_s, now)?;
        let late_s = seconds(&goal.goal_time_tolerance);
        Ok(Self {
            places,
            at_s,
            path_deg: tolerances("path_tolerance", &goal.path_tolerance)?,
            end_deg: tolerances("goal_tolerance", &goal.goal_tolerance)?,
            late_s: (late_s > 0.0).then_some(late_s),
        })
    }

    /// Returns its duration, in seconds.
    pub(crate) fn duration_s(&self) -> f64 {
        self.at_s.last().copied().unwrap_or_default()
    }

    /// Returns the joint positions at a time, in degrees, linearly interpolated.
    pub(crate) fn at(&self, time_s: f64) -> [f64; 4] {
        let next = self.at_s.partition_point(|at_s| *at_s <= time_s);
        let Some(to) = self.places.get(next) else {
            return self.places[self.places.len() - 1];
        };
        let Some(before) = next.checked_sub(1) else {
            return *to;
        };
        let (from, [begin, end]) = (
            self.places[before],
            [before, next].map(|index| self.at_s[index]),
        );
        let share = (time_s - begin) / (end - begin);
        std::array::from_fn(|i| from[i] + (to[i] - from[i]) * share)
    }

    /// Returns the same path with more points: none takes longer than a time, in seconds.
    pub(crate) fn divided(&self, longest_s: f64) -> Self {
        let (mut places, mut at_s) = (vec![self.places[0]], vec![self.at_s[0]]);
        for (ends, times) in self.places.windows(2).zip(self.at_s.windows(2)) {
            let takes_s = times[1] - times[0];
            let pieces = (takes_s / longest_s).ceil().max(1.0);
            let mut n = 1.0;
            while n < pieces {
                let share = n / pieces;
                let place = std::array::from_fn(|i| ends[0][i] + (ends[1][i] - ends[0][i]) * share);
                places.push(place);
                at_s.push(times[0] + takes_s * share);
                n += 1.0;
            }
            places.push(ends[1]);
            at_s.push(times[1]);
        }
        Self {
            places,
            at_s,
            ..self.clone()
        }
    }
}

/// Returns the index of each named joint.
fn joints(names: &[String]) -> Result<Vec<usize>, Fault> {
    let allowed = JOINTS.join(", ");
    let fault = |text| Err(Fault::new(FaultCode::InvalidJoints, text));
    if names.is_empty() {
        return fault(format!("joint_names is empty; allowed are {allowed}"));
    }
    let mut found = Vec::new();
    for name in names {
        let Some(joint) = JOINTS.iter().position(|joint| joint == name) else {
            return fault(format!(
                "joint_names has {name:?}; allowed are {allowed}: all others follow these"
            ));
        };
        if found.contains(&joint) {
            return fault(format!("joint_names has {name:?} twice"));
        }
        found.push(joint);
    }
    Ok(found)
}

/// Returns the positions and their times, beginning with the arm's position.
fn places(
    goal: &FollowGoal,
    joints: &[usize],
    arm_deg: [f64; 4],
) -> Result<(Vec<[f64; 4]>, Vec<f64>), Fault> {
    let points = &goal.trajectory.points;
    if !(1..=MAX_POINTS).contains(&points.len()) {
        let found = points.len();
        return Err(Fault::invalid(format!(
            "the trajectory has {found} points; allowed are 1 to {MAX_POINTS}"
        )));
    }
    let (mut places, mut at_s) = (vec![arm_deg], vec![0.0]);
    for (number, point) in points.iter().enumerate() {
        let place = place(number, &point.positions, joints, arm_deg)?;
        for (name, values) in [
            ("velocities", &point.velocities),
            ("accelerations", &point.accelerations),
        ] {
            check_rates(number, name, values, joints.len())?;
        }
        if !point.effort.is_empty() {
            return Err(Fault::invalid(format!(
                "points[{number}].effort is given; the arm has no force control"
            )));
        }
        let time_s = seconds(&point.time_from_start);
        if number == 0 && time_s <= 0.0 {
            check_first_point(&place, arm_deg)?;
        }
        if number == 0 && time_s == 0.0 {
            continue;
        }
        let least = at_s.last().copied().unwrap_or_default();
        if time_s <= least || time_s > LONGEST_S {
            return Err(Fault::invalid(format!(
                "points[{number}].time_from_start is {time_s} s; allowed are more than {least} s, the time of the previous point, and up to {LONGEST_S} s"
            )));
        }
        places.push(place);
        at_s.push(time_s);
    }
    Ok((places, at_s))
}

/// Returns the positions of all joints, in degrees.
fn place(
    number: usize,
    positions: &[f64],
    joints: &[usize],
    arm_deg: [f64; 4],
) -> Result<[f64; 4], Fault> {
    if positions.len() != joints.len() {
        let (found, allowed) = (positions.len(), joints.len());
        return Err(Fault::invalid(format!(
            "points[{number}] has {found} positions; allowed are {allowed}, one for each of joint_names"
        )));
    }
    let mut place = arm_deg;
    for (joint, rad) in joints.iter().zip(positions) {
        let deg = rad.to_degrees();
        if !(-FULL_TURN_DEG..=FULL_TURN_DEG).contains(&deg) {
            let name = JOINTS[*joint];
            return Err(Fault::invalid(format!(
                "points[{number}].positions has {rad} for {name}; allowed are radians within a full turn either way"
            )));
        }
        place[*joint] = deg;
    }
    Ok(place)
}

/// Checks speeds and accelerations, which are otherwise ignored: the points and their times define
/// the motion.
fn check_rates(number: usize, name: &str, values: &[f64], joints: usize) -> Result<(), Fault> {
    if values.is_empty() || values.len() == joints && values.iter().all(|value| value.is_finite()) {
        return Ok(());
    }
    Err(Fault::invalid(format!(
        "points[{number}].{name} is {values:?}; allowed are {joints} finite numbers, or none"
    )))
}

/// Checks that a trajectory with a start position begins at the arm's position.
fn check_first_point(begins: &[f64; 4], here: [f64; 4]) -> Result<(), Fault> {
    let off = (0..4).find(|joint| (begins[*joint] - here[*joint]).abs() > START_DEG);
    let Some(joint) = off else {
        return Ok(());
    };
    let [name, begins, here, allowed] = [
        JOINTS[joint].to_owned(),
        rad(begins[joint]),
        rad(here[joint]),
        rad(START_DEG),
    ];
    Err(Fault::invalid(format!(
        "the trajectory begins with {name} at {begins} rad, but the arm is at {here} rad; allowed is a difference of {allowed} rad; plan it from joint_states"
    )))
}

/// Checks the start time: no stamp, or one that is not in the future and not older than the
/// duration.
fn check_start(stamp: Time, ends_s: f64, now: Time) -> Result<(), Fault> {
    if stamp == Time::ZERO {
        return Ok(());
    }
    #[expect(
        clippy::cast_precision_loss,
        reason = "microseconds over years do not matter"
    )]
    let ahead_s = stamp.to_nanos().saturating_sub(now.to_nanos()) as f64 / 1e9;
    if ahead_s > AHEAD_S {
        return Err(Fault::invalid(format!(
            "header.stamp is {ahead_s:.3} s ahead; allowed is 0, for now"
        )));
    }
    if ahead_s + ends_s < 0.0 {
        return Err(Fault::new(
            FaultCode::OldHeaderTimestamp,
            format!(
                "header.stamp is {:.3} s old, and the trajectory takes {ends_s} s; allowed is 0, for now",
                -ahead_s
            ),
        ));
    }
    Ok(())
}

/// Returns the tolerance of each joint, in degrees: 0 means the default, and below 0 means
/// unlimited.
fn tolerances(field: &str, tolerances: &[JointTolerance]) -> Result<[Option<f64>; 4], Fault> {
    let mut found = [None; 4];
    for tolerance in tolerances {
        let Some(joint) = JOINTS.iter().position(|name| *name == tolerance.name) else {
            let (name, allowed) = (&tolerance.name, JOINTS.join(", "));
            return Err(Fault::new(
                FaultCode::InvalidJoints,
                format!("{field} has {name:?}; allowed are {allowed}"),
            ));
        };
        if tolerance.position.is_nan() {
            let name = &tolerance.name;
            return Err(Fault::invalid(format!(
                "{field} of {name} is NaN; allowed are radians"
            )));
        }
        found[joint] = (tolerance.position > 0.0).then(|| tolerance.position.to_degrees());
    }
    Ok(found)
}

/// Formats degrees as radians, as in the messages.
pub(crate) fn rad(degrees: f64) -> String {
    format!("{:.4}", degrees.to_radians())
}

const MAX_POINTS: usize = 10_000;
const LONGEST_S: f64 = 3600.0;
const FULL_TURN_DEG: f64 = 360.0;
/// The allowed difference between the start of a trajectory and the arm's position.
const START_DEG: f64 = 1.0;
/// The allowed difference between clocks.
const AHEAD_S: f64 = 1.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
pub(crate) mod tests;
