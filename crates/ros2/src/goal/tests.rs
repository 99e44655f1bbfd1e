use proptest::prelude::*;
use ros2_client::builtin_interfaces::Duration;

use super::*;
use crate::messages::{
    Header, JointTrajectory, JointTrajectoryPoint, MultiDofTrajectory, duration,
};

const ARM_DEG: [f64; 4] = [0.0, 45.0, 45.0, 0.0];

/// A goal through positions in degrees, each with its time.
pub(crate) fn goal(names: &[&str], points: &[(&[f64], f64)]) -> FollowGoal {
    let header = || Header {
        stamp: Time::ZERO,
        frame_id: String::new(),
    };
    let point = |(deg, at_s): &(&[f64], f64)| JointTrajectoryPoint {
        positions: deg.iter().map(|deg| deg.to_radians()).collect(),
        velocities: Vec::new(),
        accelerations: Vec::new(),
        effort: Vec::new(),
        time_from_start: duration(*at_s),
    };
    FollowGoal {
        trajectory: JointTrajectory {
            header: header(),
            joint_names: names.iter().map(|name| (*name).to_owned()).collect(),
            points: points.iter().map(point).collect(),
        },
        multi_dof_trajectory: MultiDofTrajectory {
            header: header(),
            joint_names: Vec::new(),
            points: Vec::new(),
        },
        path_tolerance: Vec::new(),
        component_path_tolerance: Vec::new(),
        goal_tolerance: Vec::new(),
        component_goal_tolerance: Vec::new(),
        goal_time_tolerance: Duration::zero(),
    }
}

fn wanted(goal: &FollowGoal) -> Result<Wanted, Fault> {
    Wanted::new(goal, ARM_DEG, Time::new(1000, 0))
}

fn near(found: [f64; 4], expected: [f64; 4]) {
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() < 1e-9, "{found:?}, not {expected:?}");
    }
}

#[test]
fn joints_may_come_in_any_order_and_unnamed_ones_do_not_move() {
    let goal = goal(
        &["fore", "base"],
        &[(&[50.0, 10.0], 1.0), (&[55.0, 20.0], 2.0)],
    );
    let wanted = wanted(&goal).expect("it is allowed");
    assert_eq!(wanted.at_s, [0.0, 1.0, 2.0]);
    near(wanted.places[0], ARM_DEG);
    near(wanted.places[2], [20.0, 45.0, 55.0, 0.0]);
    near(wanted.at(1.5), [15.0, 45.0, 52.5, 0.0]);
    near(wanted.at(0.5), [5.0, 45.0, 47.5, 0.0]);
    near(wanted.at(99.0), [20.0, 45.0, 55.0, 0.0]);
}

#[test]
fn a_first_point_at_time_zero_is_the_current_place_or_the_goal_is_refused() {
    let begins = |base: f64| goal(&["base"], &[(&[base], 0.0), (&[20.0], 2.0)]);
    let found = wanted(&begins(0.4)).expect("it is near enough");
    // From its actual position.
    near(found.places[0], ARM_DEG);
    assert_eq!(found.at_s, [0.0, 2.0]);
    let fault = wanted(&begins(5.0)).unwrap_err();
    assert_eq!(fault.code, FaultCode::InvalidGoal);
    assert!(fault.text.contains("base at 0.0873 rad"), "{}", fault.text);
    assert!(fault.text.contains("joint_states"), "{}", fault.text);
}

#[test]
fn an_invalid_goal_is_refused_with_what_is_allowed() {
    use FaultCode::{InvalidGoal, InvalidJoints};
    for (goal, code, expected) in [
        (
            goal(&[], &[(&[], 1.0)]),
            InvalidJoints,
            "base, rear, fore, servo",
        ),
        (
            goal(&["elbow"], &[(&[1.0], 1.0)]),
            InvalidJoints,
            "\"elbow\"",
        ),
        (
            goal(&["base", "base"], &[(&[1.0, 1.0], 1.0)]),
            InvalidJoints,
            "twice",
        ),
        (goal(&["base"], &[]), InvalidGoal, "0 points"),
        (
            goal(&["base"], &[(&[1.0, 2.0], 1.0)]),
            InvalidGoal,
            "2 positions",
        ),
        (
            goal(&["base"], &[(&[f64::NAN], 1.0)]),
            InvalidGoal,
            "NaN for base",
        ),
        (
            goal(&["base"], &[(&[f64::INFINITY], 1.0)]),
            InvalidGoal,
            "inf for base",
        ),
        (
            goal(&["base"], &[(&[1.0], 2.0), (&[2.0], 2.0)]),
            InvalidGoal,
            "points[1].time_from_start",
        ),
        (
            goal(&["base"], &[(&[1.0], 4000.0)]),
            InvalidGoal,
            "up to 3600 s",
        ),
    ] {
        let fault = wanted(&goal).unwrap_err();
        assert_eq!(fault.code, code, "{}", fault.text);
        assert!(fault.text.contains(expected), "{}", fault.text);
    }
}

#[test]
fn invalid_speeds_and_forces_are_refused() {
    let plain = goal(&["base"], &[(&[1.0], 1.0)]);
    let mut speeds = plain.clone();
    speeds.trajectory.points[0].velocities = vec![f64::NAN];
    assert!(wanted(&speeds).unwrap_err().text.contains("velocities"));
    let mut forces = plain;
    forces.trajectory.points[0].effort = vec![1.0];
    assert!(wanted(&forces).unwrap_err().text.contains("effort"));
}

#[test]
fn a_trajectory_starts_now_and_not_later_or_after_its_end() {
    let mut goal = goal(&["base"], &[(&[1.0], 5.0)]);
    goal.trajectory.header.stamp = Time::new(998, 0);
    assert!(wanted(&goal).is_ok());
    goal.trajectory.header.stamp = Time::new(990, 0);
    let fault = wanted(&goal).unwrap_err();
    assert_eq!(fault.code, FaultCode::OldHeaderTimestamp);
    goal.trajectory.header.stamp = Time::new(1010, 0);
    assert!(wanted(&goal).unwrap_err().text.contains("ahead"));
}

#[test]
fn a_tolerance_of_zero_is_the_default_and_a_negative_one_is_unlimited() {
    let mut goal = goal(&["base"], &[(&[1.0], 5.0)]);
    let tolerance = |name: &str, position| JointTolerance {
        name: name.to_owned(),
        position,
        velocity: 0.0,
        acceleration: 0.0,
    };
    goal.path_tolerance = vec![
        tolerance("base", 1_f64.to_radians()),
        tolerance("rear", 0.0),
        tolerance("fore", -1.0),
    ];
    let found = wanted(&goal).expect("it is allowed").path_deg;
    assert!((found[0].expect("it is given") - 1.0).abs() < 1e-9);
    assert_eq!(found[1..], [None; 3]);
    goal.goal_tolerance = vec![tolerance("wrist", 0.1)];
    assert_eq!(wanted(&goal).unwrap_err().code, FaultCode::InvalidJoints);
}

proptest! {
    #[test]
    fn the_times_of_any_accepted_trajectory_rise_from_the_current_place(
        points in prop::collection::vec((prop::collection::vec(prop::num::f64::ANY, 0..4), prop::num::f64::ANY), 0..6),
        names in prop::sample::subsequence(vec!["base", "rear", "fore", "servo", "elbow"], 0..5),
        stamp in any::<(i32, u32)>(),
    ) {
        let points: Vec<(&[f64], f64)> = points.iter().map(|(deg, at)| (&deg[..], *at)).collect();
        let mut goal = goal(&names, &points);
        goal.trajectory.header.stamp = Time::new(stamp.0, stamp.1 % 1_000_000_000);
        if let Ok(wanted) = Wanted::new(&goal, ARM_DEG, Time::new(stamp.0, 0)) {
            prop_assert_eq!(wanted.places[0], ARM_DEG);
            prop_assert_eq!(wanted.places.len(), wanted.at_s.len());
            prop_assert!(wanted.at_s.is_sorted_by(|a, b| a < b));
            prop_assert!(wanted.places.iter().flatten().all(|value| value.is_finite()));
        }
    }
}
