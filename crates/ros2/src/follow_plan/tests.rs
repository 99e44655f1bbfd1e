use proptest::prelude::*;
use ros2_client::builtin_interfaces::Time;

use super::*;
use crate::goal::tests::goal;
use crate::messages::JointTolerance;

fn status() -> Status {
    Status {
        rear_deg: 45.0,
        fore_deg: 45.0,
        suction: true,
        gripper_deg: 30.0,
        ..Status::AT_ZERO
    }
}

fn wanted(points: &[(&[f64], f64)]) -> Wanted {
    let goal = goal(&["base", "rear", "fore", "servo"], points);
    Wanted::new(&goal, [0.0, 45.0, 45.0, 0.0], Time::ZERO).expect("it makes sense")
}

fn plan(wanted: &Wanted) -> Result<FollowPlan, Fault> {
    FollowPlan::new(wanted, &status(), Dialect::SPECIFICATION, 1.0)
}

fn targets(plan: &FollowPlan) -> Vec<MoveJoints> {
    let commands = plan.job.commands.iter();
    commands
        .filter_map(|command| match command {
            Command::MoveJoints(command) => Some(*command),
            _ => None,
        })
        .collect()
}

/// A swing of the base that is far from any straight line of joints.
fn wave(points: u32, within_s: f64) -> Wanted {
    let at = |n: u32| {
        let share = f64::from(n) / f64::from(points);
        let (sin, _) = (share * std::f64::consts::TAU * 7.0).sin_cos();
        [30.0 * sin, 45.0, 45.0 - 10.0 * share, 0.0]
    };
    let places: Vec<[f64; 4]> = (1..=points).map(at).collect();
    let times = (1..=points).map(|n| within_s * f64::from(n) / f64::from(points));
    let points: Vec<(&[f64], f64)> = places.iter().map(|place| &place[..]).zip(times).collect();
    wanted(&points)
}

#[test]
fn a_straight_path_of_many_points_is_one_target_in_the_requested_time() {
    let places: Vec<[f64; 4]> = (1..=40).map(|n| [f64::from(n), 45.0, 45.0, 0.0]).collect();
    let points: Vec<(&[f64], f64)> = places
        .iter()
        .zip(1..)
        .map(|(place, n): (_, u32)| (&place[..], f64::from(n) * 0.05))
        .collect();
    let plan = plan(&wanted(&points)).expect("it can be followed");
    let [target] = targets(&plan)[..] else {
        panic!("{:?}", plan.job.commands);
    };
    assert!((target.base_deg - 40.0).abs() < 1e-3, "{target:?}");
    assert_eq!(target.mode, MovingMode::MovJ);
    assert!(target.suction && (target.gripper_deg - 30.0).abs() < 1e-6);
    assert!((plan.takes_s - 2.0).abs() < 1e-6, "{}", plan.takes_s);
    assert!(
        plan.summary.starts_with("1 targets for 40 points"),
        "{}",
        plan.summary
    );
}

#[test]
fn no_more_targets_are_sent_than_there_are_permits_and_the_deviation_is_reported() {
    // 2 s are 25 periods of 80 ms: 12 targets with a speed each.
    let plan = plan(&wave(400, 2.0)).expect("it can be followed");
    assert_eq!(targets(&plan).len(), 12);
    assert!(
        plan.summary
            .starts_with("12 targets for 400 points, deviation at most 0."),
        "{}",
        plan.summary
    );
}

#[test]
fn a_path_tolerance_that_the_link_cannot_keep_is_reported_before_anything_moves() {
    let mut wanted = wave(400, 2.0);
    wanted.path_deg[0] = Some(0.5);
    let fault = plan(&wanted).unwrap_err();
    assert_eq!(fault.code, FaultCode::PathToleranceViolated);
    assert!(fault.text.contains("0.0087 rad for base"), "{}", fault.text);
}

#[test]
fn a_duration_that_the_arm_cannot_keep_is_reported_before_anything_moves_if_it_matters() {
    // 90 degrees in a second: 100 degrees/s2 reach only 25 in that time.
    let mut fast = wanted(&[(&[90.0, 45.0, 45.0, 0.0], 1.0)]);
    let late = plan(&fast).expect("without a tolerance");
    // 90 degrees at 100 degrees/s and 100 degrees/s2: acceleration and deceleration only.
    let expected = 2.0 * (90.0_f64 / 100.0).sqrt();
    assert!((late.takes_s - expected).abs() < 1e-6, "{}", late.takes_s);
    fast.late_s = Some(0.5);
    let fault = plan(&fast).unwrap_err();
    assert_eq!(fault.code, FaultCode::GoalToleranceViolated);
    assert!(fault.text.contains("0.50 s more"), "{}", fault.text);
}

#[test]
fn the_arm_waits_while_the_trajectory_is_at_rest() {
    let place: &[f64] = &[20.0, 45.0, 45.0, 0.0];
    let back: &[f64] = &[0.0, 45.0, 45.0, 0.0];
    let plan = plan(&wanted(&[(place, 2.0), (place, 5.0), (back, 7.0)]));
    let plan = plan.expect("it can be followed");
    let [there, wait, longer, back] = targets(&plan)[..] else {
        panic!("{:?}", plan.job.commands);
    };
    assert_eq!((there.pause_s, back.pause_s), (0.0, 0.0));
    let waits = [wait, longer].map(|plan| (plan.base_deg, plan.pause_s));
    assert_eq!(waits, [(20.0, 1.5); 2]);
    assert!((plan.takes_s - 7.0).abs() < 1e-6, "{}", plan.takes_s);
}

#[test]
fn a_slow_path_is_divided_so_that_the_arm_can_hold_soon() {
    let plan = plan(&wanted(&[(&[60.0, 45.0, 45.0, 0.0], 11.0)]));
    let plan = plan.expect("it can be followed");
    let found: Vec<f32> = targets(&plan)
        .iter()
        .map(|target| target.base_deg)
        .collect();
    assert_eq!(found, [10.0, 20.0, 30.0, 40.0, 50.0, 60.0]);
    assert!((plan.takes_s - 11.0).abs() < 1e-6, "{}", plan.takes_s);
    // One speed for all of them, and that of power-up.
    assert_eq!(plan.job.commands.len(), 8);
}

#[test]
fn a_trajectory_to_the_current_place_moves_nothing() {
    let plan = plan(&wanted(&[(&[0.0, 45.0, 45.0, 0.0], 1.0)]));
    assert!(plan.expect("it can be followed").job.commands.is_empty());
}

#[test]
fn waits_shorter_than_a_tick_add_up() {
    let points: [(&[f64], f64); 4] = [
        (&[9.474, 45.0, 45.0, -39.119], 19.897),
        (&[-32.052, 45.0, 45.0, 14.379], 35.55),
        (&[-15.232, 45.0, 45.0, -41.15], 44.092),
        (&[62.172, 45.0, 45.0, -70.304], 62.613),
    ];
    let takes_s = plan(&wanted(&points)).expect("it can be followed").takes_s;
    assert!(takes_s > 62.613 - 0.021, "{takes_s}");
}

#[test]
fn the_power_up_speed_is_restored_at_the_end() {
    let plan = plan(&wanted(&[(&[20.0, 45.0, 45.0, 0.0], 4.0)]));
    let commands = plan.expect("it can be followed").job.commands;
    let percents: Vec<f32> = commands
        .iter()
        .filter_map(|command| match command {
            Command::PlaybackAdjustment(command) => Some(command.speed_percent),
            _ => None,
        })
        .collect();
    assert!(percents[0] < 5.0, "{percents:?}");
    assert_eq!(percents.last(), Some(&50.0));
}

#[test]
fn tolerances_of_a_goal_reach_the_plan() {
    let mut goal = goal(&["base"], &[(&[20.0], 2.0)]);
    goal.path_tolerance = vec![JointTolerance {
        name: "base".to_owned(),
        position: 0.01,
        velocity: 0.0,
        acceleration: 0.0,
    }];
    let wanted = Wanted::new(&goal, [0.0, 45.0, 45.0, 0.0], Time::ZERO);
    assert!(plan(&wanted.expect("it makes sense")).is_ok());
}

proptest! {
    #[test]
    fn the_arm_is_never_earlier_than_the_trajectory_nor_faster_than_at_power_up(
        points in prop::collection::vec((-90.0..90.0_f64, -90.0..90.0_f64, 0.05..20.0_f64), 1..30),
    ) {
        let places: Vec<[f64; 4]> = points.iter().map(|point| [point.0, 45.0, 45.0, point.1]).collect();
        let mut at_s = 0.0;
        let times = points.iter().map(|point| {
            at_s += point.2;
            at_s
        });
        let points: Vec<(&[f64], f64)> = places.iter().map(|place| &place[..]).zip(times).collect();
        let wanted = wanted(&points);
        let plan = plan(&wanted).expect("it can be followed");
        // A last pause of less than a tick of 20 ms is left out.
        prop_assert!(plan.takes_s > wanted.duration_s() - 0.021, "{} of {}", plan.takes_s, wanted.duration_s());
        for command in &plan.job.commands {
            if let Command::PlaybackAdjustment(speed) = command {
                prop_assert!((1.0..=50.0).contains(&speed.speed_percent));
            }
        }
        let last = targets(&plan).last().copied().expect("it moves");
        prop_assert!((f64::from(last.base_deg) - places[places.len() - 1][0]).abs() < 0.02);
    }
}
