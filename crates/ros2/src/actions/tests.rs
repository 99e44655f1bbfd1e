use dobot_controller::{Personality, PowerUp};
use dobot_geometry::distance_from_chord;
use dobot_safety::{Bounds, Policy};
use ros2_client::builtin_interfaces::Time;

use super::*;
use crate::goal::tests::goal;

async fn station(personality: Personality) -> StationClient {
    station_with(personality, Policy::default()).await
}

/// Returns a station whose arm has reported.
async fn station_with(personality: Personality, policy: Policy) -> StationClient {
    let power_up = PowerUp::new(personality);
    let mut station = StationClient::with_virtual_arm(power_up, policy, "ros2");
    station.first_state().await.expect("the arm reports");
    station
}

fn never() -> watch::Receiver<bool> {
    watch::Sender::new(false).subscribe()
}

/// Plans a trajectory that begins at the arm's position.
async fn planned(
    station: &mut StationClient,
    points: &[(&[f64], f64)],
) -> (Wanted, Result<FollowPlan, Fault>) {
    let Stand { status, dialect } = take_at_rest(station).await.expect("the station reports");
    let goal = goal(&["base", "rear", "fore"], points);
    let wanted = Wanted::new(&goal, degrees_of(&status), Time::ZERO).expect("it makes sense");
    let plan = FollowPlan::new(&wanted, &status, dialect, 1.0);
    (wanted, plan)
}

async fn angles_at_rest(station: &mut StationClient) -> [f64; 4] {
    degrees_of(
        &state_at_rest(station)
            .await
            .expect("the station reports")
            .status,
    )
}

fn near(found: [f64; 4], expected: [f64; 4], tolerance: f64) {
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() < tolerance, "{found:?}, not {expected:?}");
    }
}

#[tokio::test]
async fn both_arms_follow_a_trajectory_to_its_end_in_the_requested_time() {
    for personality in [Personality::Specification, Personality::Firmware11] {
        let mut station = station(personality).await;
        let points: [(&[f64], f64); 3] = [
            (&[10.0, 40.0, 45.0], 1.0),
            (&[20.0, 40.0, 40.0], 2.0),
            (&[0.0, 45.0, 45.0], 4.0),
        ];
        let (wanted, plan) = planned(&mut station, &points).await;
        let began = station.now();
        let (mut last_s, mut never) = (0.0, never());
        let followed = follow(
            &mut station,
            &wanted,
            plan.expect("it can be followed"),
            &mut never,
            |_, at_s| last_s = at_s,
        );
        let followed = followed.await.expect("it is followed");
        assert!(matches!(followed, Followed::Done(_)), "{followed:?}");
        near(
            angles_at_rest(&mut station).await,
            [0.0, 45.0, 45.0, 0.0],
            0.05,
        );
        let took = station.now().saturating_sub(began).as_secs_f64();
        assert!((3.9..6.0).contains(&took), "{personality:?} took {took} s");
        assert!(last_s > 3.0, "{last_s}");
    }
}

#[tokio::test]
async fn both_arms_stay_as_close_to_the_trajectory_as_the_plan_says() {
    for personality in [Personality::Specification, Personality::Firmware11] {
        let mut station = station(personality).await;
        // The joints of a stock arm do not turn in proportion (note N45): those that turn less bend the path.
        let points: [(&[f64], f64); 2] = [(&[60.0, 30.0, 45.0], 3.0), (&[10.0, 45.0, 20.0], 6.0)];
        let (wanted, plan) = planned(&mut station, &points).await;
        let plan = plan.expect("it can be followed");
        let (path, allowed_deg) = (wanted.places.clone(), plan.deviation_deg);
        assert!(allowed_deg <= 1.0, "{personality:?}: {}", plan.summary);
        let (mut worst_deg, mut never): (f64, _) = (0.0, never());
        let followed = follow(&mut station, &wanted, plan, &mut never, |state, _| {
            let status = &state.arm.as_ref().expect("it reports").status;
            let off = |ends: &[[f64; 4]]| distance_from_chord(degrees_of(status), ends[0], ends[1]);
            worst_deg = worst_deg.max(path.windows(2).map(off).fold(f64::INFINITY, f64::min));
        });
        followed.await.expect("it is followed");
        // An arm reports hundredths of a degree, and a stock arm rounds its angles to whole motor pulses.
        assert!(
            worst_deg <= allowed_deg + 0.05,
            "{personality:?}: {worst_deg}, planned {allowed_deg}"
        );
    }
}

#[tokio::test]
async fn a_trajectory_that_the_policy_forbids_moves_nothing_and_is_refused_with_the_reason() {
    let mut policy = Policy::default();
    policy.joints.base_deg = Bounds::new(-90.0, 90.0);
    let mut station = station_with(Personality::Firmware11, policy).await;
    let before = angles_at_rest(&mut station).await;
    let (wanted, plan) = planned(&mut station, &[(&[100.0, 45.0, 45.0], 8.0)]).await;
    let plan = plan.expect("the policy is the station's");
    let followed = follow(&mut station, &wanted, plan, &mut never(), |_, _| {}).await;
    let fault = followed.unwrap_err();
    assert_eq!(fault.code, FaultCode::InvalidGoal);
    assert!(fault.text.contains("base"), "{}", fault.text);
    assert_eq!(angles_at_rest(&mut station).await, before);
}

#[tokio::test]
async fn a_cancelled_trajectory_holds_on_its_path_and_leaves_no_job_behind() {
    let mut station = station(Personality::Specification).await;
    let (wanted, plan) = planned(
        &mut station,
        &[
            (&[20.0, 45.0, 45.0], 2.0),
            (&[20.0, 30.0, 45.0], 4.0),
            (&[-60.0, 45.0, 45.0], 10.0),
        ],
    )
    .await;
    let cancel = watch::Sender::new(false);
    let mut cancelled = cancel.subscribe();
    let plan = plan.expect("it can be followed");
    let followed = follow(&mut station, &wanted, plan, &mut cancelled, |_, at_s| {
        if at_s > 1.0 {
            cancel.send_replace(true);
        }
    });
    let followed = followed.await.expect("it holds");
    assert!(matches!(followed, Followed::Held(_)), "{followed:?}");
    let held = angles_at_rest(&mut station).await;
    assert!(held[0] > 0.0, "{held:?}");
    let jobs = station.jobs().await.expect("the jobs are listed");
    assert!(jobs.iter().all(|job| job.phase.is_over()), "{jobs:?}");
}

#[tokio::test]
async fn an_end_outside_the_tolerance_of_the_goal_is_reported() {
    let mut station = station(Personality::Specification).await;
    let (mut wanted, _) = planned(&mut station, &[(&[10.0, 45.0, 45.0], 1.0)]).await;
    wanted.end_deg[0] = Some(1.0);
    let fault = check_end(&mut station, &wanted).await.unwrap_err();
    assert_eq!(fault.code, FaultCode::GoalToleranceViolated);
    assert!(fault.text.starts_with("base is "), "{}", fault.text);
}

#[tokio::test]
async fn pump_and_gripper_obey_and_the_arm_does_not_move() {
    let mut station = station(Personality::Firmware11).await;
    let before = angles_at_rest(&mut station).await;
    suction(&mut station, true).await.expect("it is allowed");
    gripper(&mut station, -GRIPPER_DEG, &mut never())
        .await
        .expect("it is allowed");
    let status = state_at_rest(&mut station)
        .await
        .expect("the station reports")
        .status;
    assert!(status.suction, "{status:?}");
    assert!((status.gripper_deg + 90.0).abs() < 0.1, "{status:?}");
    near(degrees_of(&status), before, 0.05);
}

#[tokio::test]
async fn a_stopped_arm_refuses_to_move_and_asks_for_a_check_by_a_person() {
    let mut station = station(Personality::Specification).await;
    let text = stop(&mut station, "a hand").await.expect("anyone may");
    assert!(text.contains("a person must check"), "{text}");
    let target = Target {
        place: TargetPlace::Point {
            mm: [220.0, 0.0, 50.0],
            rotation_deg: None,
        },
        servo_deg: None,
        mode: MovingMode::MovJ,
        suction: None,
        gripper_deg: None,
        pause_s: 0.0,
    };
    let refused = go(&mut station, &target, &mut never()).await.unwrap_err();
    assert!(refused.contains("stopped"), "{refused}");
}
