//! One move after the other, and where each ends.

use super::*;

#[tokio::test]
async fn every_way_to_move_ends_at_its_target_and_the_status_says_so() {
    for mode in [MovingMode::Jump, MovingMode::MovJ, MovingMode::MovL] {
        let peer = in_process();
        let mut arm = connect(&peer);
        let events = run(&mut arm, &[move_to(mode, 220.0, -60.0, 30.0).into()]).await;
        assert_eq!(completed(&events), [0], "{mode:?}: {events:?}");
        let status = arm.session().status().expect("one came");
        let reported = Position::new(status.x_mm.into(), status.y_mm.into(), status.z_mm.into());
        assert_at(reported, 220.0, -60.0, 30.0, 1e-3);
        assert_at(found(&peer), 220.0, -60.0, 30.0, 1e-6);
        assert_eq!(refusals(&peer), []);
    }
}

#[tokio::test]
async fn a_target_in_joint_angles_ends_at_these_angles() {
    let peer = in_process();
    let mut arm = connect(&peer);
    let target = MoveJoints {
        base_deg: 25.0,
        rear_deg: 20.0,
        fore_deg: 30.0,
        servo_deg: -10.0,
        suction: true,
        mode: MovingMode::MovJ,
        gripper_deg: 15.0,
        pause_s: 0.0,
    };
    let events = run(&mut arm, &[target.into()]).await;
    assert_eq!(completed(&events), [0], "{events:?}");
    let status = arm.next_status().await.expect("another one comes");
    let angles = [
        status.base_deg,
        status.rear_deg,
        status.fore_deg,
        status.servo_deg,
        status.gripper_deg,
    ];
    assert_eq!(angles, [25.0, 20.0, 30.0, -10.0, 15.0]);
    assert!(status.suction);
}

#[tokio::test]
async fn a_mixed_program_is_over_command_by_command_in_order() {
    let peer = in_process();
    let mut arm = connect(&peer);
    let program: Vec<Command> = vec![
        playback(100.0).into(),
        move_to(MovingMode::MovL, 220.0, 0.0, 10.0).into(),
        Configuration::Writing {
            acceleration_mm_s2: 200.0,
        }
        .into(),
        vector(0.0, 20.0, 20.0).into(),
        vector(20.0, 0.0, 20.0).into(),
        vector(0.0, -20.0, 20.0).into(),
        button(JointJogAxis::SuctionOn, 0.0).into(),
        move_to(MovingMode::Jump, 200.0, 30.0, 0.0).into(),
        move_to(MovingMode::MovJ, 240.0, -30.0, 0.0).into(),
        vector(-10.0, 0.0, 10.0).into(),
    ];
    let events = run(&mut arm, &program).await;
    assert_eq!(completed(&events), (0..10).collect::<Vec<_>>());
    assert_eq!(refusals(&peer), []);
    assert_at(found(&peer), 230.0, -30.0, 0.0, 1e-6);
    let counters = *peer.arm().controller().counters();
    assert_eq!((counters.packets, counters.begun), (10, 10));
    assert_eq!((counters.skipped_bytes, counters.refused), (0, 0));
}

#[tokio::test]
async fn a_target_out_of_reach_is_reported_with_the_place_where_the_arm_rests() {
    let peer = in_process();
    let mut arm = connect(&peer);
    let far = move_to(MovingMode::MovL, 400.0, 0.0, 0.0);
    let events = run(&mut arm, &[far.into()]).await;
    let Some(Event::NotReached {
        command,
        expected,
        found,
        ..
    }) = events.last()
    else {
        panic!("{events:?}");
    };
    assert_eq!(*command, CommandId(0));
    assert_at(*expected, 400.0, 0.0, 0.0, 0.0);
    assert_at(*found, POWER_UP_X_MM, 0.0, -17.677_669_5, 1e-3);
    assert!(matches!(
        refusals(&peer)[..],
        [Refused::Trajectory(TrajectoryError::Unreachable(_))]
    ));
}

#[tokio::test]
async fn two_targets_out_of_reach_are_both_reported() {
    let peer = in_process();
    let mut arm = connect(&peer);
    let mut short = Vec::new();
    for x_mm in [400.0, 500.0] {
        arm.send(move_to(MovingMode::MovJ, x_mm, 0.0, 0.0))
            .expect("it is allowed");
    }
    while short.len() < 2 {
        match arm.next_event().await.expect("the link is open") {
            Event::NotReached {
                command, expected, ..
            } => short.push((command.0, expected.x.0)),
            Event::Completed(id) => panic!("{id:?} leads nowhere"),
            _ => {}
        }
    }
    assert_eq!(short, [(0, 400.0), (1, 500.0)]);
}

#[tokio::test]
async fn a_released_jog_is_over_when_the_arm_stands() {
    let peer = in_process();
    let mut arm = connect(&peer);
    let jog = button(JointJogAxis::BasePlus, 100.0);
    let released = button(JointJogAxis::Released, 0.0);
    let slow = Configuration::teach([20.0, 10.0, 30.0, 10.0, 40.0, 10.0]);
    let mut program: Vec<Command> = vec![slow.into()];
    program.extend([Command::from(jog); 12]);
    program.push(released.into());
    let events = run(&mut arm, &program).await;
    assert_eq!(completed(&events).len(), 14, "{events:?}");
    let rest = found(&peer);
    for _ in 0..20 {
        arm.next_status().await.expect("the link is open");
    }
    assert_eq!(found(&peer), rest);
    let events = run(&mut arm, &[vector(5.0, 5.0, 20.0).into()]).await;
    assert_eq!(completed(&events), [14], "{events:?}");
    assert_at(found(&peer), rest.x.0 + 5.0, rest.y.0 + 5.0, rest.z.0, 1e-6);
}

/// A configuration is seen to be over late, so that nobody listens yet when the target behind it ends; which status
/// tells of the jog that follows depends on how long all that takes.
#[tokio::test]
async fn a_target_away_from_which_a_jog_took_the_arm_at_once_is_over() {
    let jogs: [[Command; 2]; 4] = [
        [
            LinearJog::new(LinearJogAxis::YPlus, 20.0).into(),
            LinearJog::new(LinearJogAxis::Released, 0.0).into(),
        ],
        [
            LinearJog::new(LinearJogAxis::ZMinus, 20.0).into(),
            LinearJog::new(LinearJogAxis::Released, 0.0).into(),
        ],
        [
            button(JointJogAxis::BaseMinus, 20.0).into(),
            button(JointJogAxis::Released, 0.0).into(),
        ],
        [
            button(JointJogAxis::RearPlus, 20.0).into(),
            button(JointJogAxis::Released, 0.0).into(),
        ],
    ];
    let ways = jogs
        .iter()
        .flat_map(|jog| (0..25_u8).map(move |part| (jog, part)));
    for (jog, part) in ways {
        let peer = in_process();
        let mut arm = connect(&peer);
        let y_mm = -60.0 - f32::from(part);
        let mut program: Vec<Command> = vec![
            move_to(MovingMode::Jump, 190.0, y_mm, 0.0).into(),
            PlaybackAdjustment {
                speed_percent: 10.0,
                acceleration_percent: 50.0,
                teach_speed_percent: 100.0,
            }
            .into(),
            move_to(MovingMode::Jump, 205.0, 0.0, 0.0).into(),
            move_to(MovingMode::Jump, 205.0, y_mm / 3.0, 0.0).into(),
            Configuration::InitialAngles {
                rear_deg: 32.0,
                fore_deg: 49.4,
            }
            .into(),
            MoveJoints::to([0.0, 21.9, 51.5, 0.0])
                .with_mode(MovingMode::MovJ)
                .into(),
        ];
        program.extend(jog);
        let events = run(&mut arm, &program).await;
        assert_eq!(
            completed(&events),
            (0..8).collect::<Vec<_>>(),
            "{jog:?} {y_mm}: {events:?}"
        );
        assert_eq!(refusals(&peer), []);
    }
}
