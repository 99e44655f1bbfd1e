//! What a session promises, on virtual arms: how far ahead it sends, by when the arm rests, whether
//! its pose is to be trusted, how good the link is.

use std::time::Duration;

use crate::common::{button, move_to, ms, vector};
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_session::{Arm, Connection, Event, LinkError, NotReached, SendError, Session, blocking};
use dobot_sim::{Fault, InProcess, SerialLine, VirtualArm};
use dobot_wire::{
    Command, Configuration, JointJogAxis, LinearJog, LinearJogAxis, MovingMode, WriteVector,
};
use proptest::prelude::*;

fn virtual_arm(personality: Personality, faults: &[&str], seed: u64) -> InProcess {
    let power_up = PowerUp::new(personality);
    let faults: Vec<Fault> = faults
        .iter()
        .map(|fault| fault.parse().expect("it is a fault"))
        .collect();
    let arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
    InProcess::new(arm.with_faults(power_up, &faults, seed))
}

fn connect(arm: &InProcess, personality: Personality) -> Connection {
    Connection::over_peer(arm.clone(), Some(personality.dialect()))
}

fn stroke(x_mm: f32, y_mm: f32) -> WriteVector {
    WriteVector {
        start_speed_mm_s: 0.0,
        end_speed_mm_s: 0.0,
        ..vector(x_mm, y_mm, 60.0)
    }
}

/// A program of long and short motions, near the middle of the reach.
fn program() -> impl Strategy<Value = Vec<Command>> {
    let mode = prop_oneof![
        Just(MovingMode::Jump),
        Just(MovingMode::MovL),
        Just(MovingMode::MovJ)
    ];
    let point = [205.0..255.0_f32, -60.0..60.0_f32, -10.0..50.0_f32];
    let target = (mode, point).prop_map(|(mode, [x, y, z])| Command::from(move_to(mode, x, y, z)));
    let vector = (-8.0..8.0_f32, 1.0..8.0_f32).prop_map(|(x, y)| Command::from(stroke(x, y)));
    prop::collection::vec(prop_oneof![1 => target, 3 => vector], 3..20)
}

async fn next(arm: &mut Connection) -> Event {
    arm.next_event().await.expect("the link is open")
}

/// Gives a program, stops some time later, and measures: what was promised, and how long the arm
/// moved on.
async fn stopped(
    personality: Personality,
    commands: &[Command],
    after: Duration,
) -> (Duration, Duration) {
    let arm = virtual_arm(personality, &[], 0);
    let mut connection = connect(&arm, personality);
    connection.next_status().await.expect("a status arrives");
    for command in commands {
        // Lines to where the arm will be are none for a stock arm.
        let _ = connection.send(*command);
    }
    while connection.now() < after {
        next(&mut connection).await;
    }
    connection.session_mut().discard_waiting();
    let promised = connection.session().rests_within();
    let stopped = connection.now();
    let mut moved = stopped;
    let mut before = arm.arm().controller().pose_at(stopped);
    while connection.now() < moved + Duration::from_secs(2) {
        connection.pass(ms(20)).await.expect("the link is open");
        let now = connection.now();
        let pose = arm.arm().controller().pose_at(now);
        if pose.position.distance(before.position).0 > 1e-4 {
            moved = now;
        }
        before = pose;
    }
    (promised, moved.saturating_sub(stopped))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn an_arm_that_is_sent_nothing_more_rests_within_the_promised_time(
        stock in any::<bool>(),
        commands in program(),
        after_ms in 100_u64..6000,
    ) {
        let personality = if stock { Personality::Firmware11 } else { Personality::Specification };
        let runtime = tokio::runtime::Builder::new_current_thread().build().expect("it is simple");
        let (promised, took) = runtime.block_on(stopped(personality, &commands, ms(after_ms)));
        prop_assert!(took <= promised, "it took {took:?}; {promised:?} were promised");
        // The command that is executed, half a second, one that was just sent, and what is rounded.
        prop_assert!(promised < Duration::from_secs(20), "{promised:?} is no promise");
    }
}

#[tokio::test]
async fn what_waits_in_the_arm_takes_half_a_second_and_a_command_at_the_most() {
    for personality in Personality::ALL {
        let arm = virtual_arm(personality, &[], 0);
        let mut connection = connect(&arm, personality);
        connection.next_status().await.expect("a status arrives");
        let mut last = None;
        for n in 0..40_u8 {
            // 6 mm in 0.49 s each, from rest to rest.
            let by = if n % 2 == 0 { 6.0 } else { -6.0 };
            last = Some(connection.send(stroke(0.0, by)).expect("it is allowed"));
        }
        let mut most_s: f64 = 0.0;
        let began = connection.now();
        loop {
            most_s = most_s.max(connection.session().ahead_s());
            if let Event::Completed(id) = next(&mut connection).await
                && Some(id) == last
            {
                break;
            }
        }
        assert!(most_s < 3.0 * 0.49 + 0.2, "{personality}: {most_s} s");
        // Nobody waited for the link meanwhile.
        let took_s = connection.now().saturating_sub(began).as_secs_f64();
        assert!(took_s < 40.0 * 0.53 + 0.5, "{personality}: {took_s} s");
    }
}

#[tokio::test]
async fn after_a_stop_no_motion_begins_later_than_half_a_second() {
    for personality in Personality::ALL {
        let arm = virtual_arm(personality, &[], 0);
        let mut connection = connect(&arm, personality);
        connection.next_status().await.expect("a status arrives");
        let there = move_to(MovingMode::MovL, 220.0, -60.0, 0.0);
        let id = connection.send(there).expect("it is allowed");
        connection.completed(id).await.expect("it is reached");
        // Strokes of 2.5 s, to and fro.
        for n in 0..6_u8 {
            let by = if n % 2 == 0 { 110.0 } else { -110.0 };
            connection.send(stroke(0.0, by)).expect("it is allowed");
        }
        let mut turns_at = connection.now();
        let mut left = 6;
        while left > 0 {
            match next(&mut connection).await {
                // The one before it goes on for half a second at the most, and the packet comes in time.
                Event::Sent(_) => {
                    let rests_in = connection.session().ahead_s();
                    assert!(rests_in < 2.5 + 0.5 + 0.2, "{personality}: {rests_in} s");
                }
                Event::Completed(_) => {
                    left -= 1;
                    let took_s = connection.now().saturating_sub(turns_at).as_secs_f64();
                    assert!(took_s < 2.5 + 0.35, "{personality}: it waited, {took_s} s");
                    turns_at = connection.now();
                }
                _ => {}
            }
        }
    }
}

#[tokio::test]
async fn targets_passed_without_a_rest_follow_each_other_without_a_pause() {
    let arm = virtual_arm(Personality::Specification, &[], 0);
    let mut connection = connect(&arm, Personality::Specification);
    connection.next_status().await.expect("a status arrives");
    let mut planned_s = 0.0;
    let mut last = None;
    for n in 0..20_u8 {
        let y_mm = if n % 2 == 0 { 30.0 } else { -30.0 };
        let target = move_to(MovingMode::MovJ, 230.0, y_mm, 0.0);
        let model = *connection.session().model().expect("it was seen");
        let trajectory = model.trajectory(&target.into()).expect("it is in reach");
        planned_s += trajectory.duration_s().expect("it ends");
        last = Some(connection.send(target).expect("it is allowed"));
    }
    let began = connection.now();
    let last = last.expect("there are some");
    connection.completed(last).await.expect("it is reached");
    let took_s = connection.now().saturating_sub(began).as_secs_f64();
    assert!(
        took_s < planned_s + 0.6,
        "{took_s} s; {planned_s} s were planned"
    );
}

#[tokio::test]
async fn an_arm_that_was_reset_is_sent_no_motion_until_its_pose_is_confirmed() {
    for personality in Personality::ALL {
        let arm = virtual_arm(personality, &["reset@8s"], 0);
        let mut connection = connect(&arm, personality);
        connection.next_status().await.expect("a status arrives");
        let aside = move_to(MovingMode::MovJ, 220.0, 60.0, 20.0);
        let id = connection.send(aside).expect("it is allowed");
        connection.completed(id).await.expect("it is reached");
        let evidence = loop {
            match next(&mut connection).await {
                Event::Reset { evidence, .. } => break evidence,
                Event::Status(_) | Event::LinkLost { .. } => {}
                event => panic!("{personality}: {event:?}"),
            }
        };
        assert!(evidence.base_is_zero && evidence.before.base.0 > 10.0);
        assert!(evidence.silent_for.is_some(), "{evidence}");
        let session = connection.session_mut();
        assert!(!session.is_trusted());
        assert!(
            session
                .distrust_reason()
                .expect("it says why")
                .contains("reset")
        );
        assert_eq!(session.send(aside), Err(SendError::Untrusted));
        let jog = button(JointJogAxis::BasePlus, 10.0);
        assert_eq!(session.send(jog), Err(SendError::Untrusted));
        session
            .send(button(JointJogAxis::LaserOff, 0.0))
            .expect("it moves nothing");
        session.confirm_pose();
        let id = session.send(aside).expect("a person has looked");
        connection.completed(id).await.expect("it is reached");
    }
}

#[tokio::test]
async fn a_reset_in_the_middle_of_a_drawing_is_noticed() {
    for personality in Personality::ALL {
        let arm = virtual_arm(personality, &["reset@4s"], 0);
        let mut connection = connect(&arm, personality);
        connection.next_status().await.expect("a status arrives");
        connection
            .send(move_to(MovingMode::MovJ, 220.0, 40.0, 0.0))
            .expect("it is allowed");
        for n in 0..60_u8 {
            let by = if n % 2 == 0 { 10.0 } else { -10.0 };
            connection.send(stroke(by, 0.0)).expect("it is allowed");
        }
        let forgotten = loop {
            match next(&mut connection).await {
                Event::Reset { forgotten, .. } => break forgotten,
                Event::NotReached { .. } => panic!("{personality}: it was reset"),
                _ => {}
            }
        };
        assert!(forgotten > 20, "{personality}: {forgotten}");
        assert_eq!(connection.session().waiting(), 0);
        assert_eq!(connection.session().in_flight(), 0);
    }
}

#[tokio::test]
async fn initial_angles_make_no_pose_trusted_and_a_trusted_one_untrusted() {
    for personality in Personality::ALL {
        let arm = virtual_arm(personality, &[], 0);
        let mut connection = connect(&arm, personality);
        let reported = Configuration::InitialAngles {
            rear_deg: 40.0,
            fore_deg: 50.0,
        };
        for was_trusted in [true, false] {
            if was_trusted {
                connection.session_mut().confirm_pose();
            }
            let id = connection.send(reported).expect("it moves nothing");
            assert!(!connection.session().is_trusted(), "{personality}: at once");
            connection.session_mut().confirm_pose();
            connection.completed(id).await.expect("it is seen");
            assert!(!connection.session().is_trusted(), "{personality}");
            let aside = move_to(MovingMode::MovJ, 220.0, 60.0, 20.0);
            assert_eq!(connection.send(aside), Err(SendError::Untrusted));
        }
        connection.session_mut().confirm_pose();
        let aside = move_to(MovingMode::MovJ, 220.0, 60.0, 20.0);
        let id = connection.send(aside).expect("a person has looked");
        connection.completed(id).await.expect("it is reached");
    }
}

#[tokio::test]
async fn moving_and_losing_statuses_is_no_reset() {
    for personality in Personality::ALL {
        for seed in 0..5 {
            let faults = ["drop=0.2%:from", "withhold@status40..+600ms"];
            let arm = virtual_arm(personality, &faults, seed);
            let mut connection = connect(&arm, personality);
            connection.next_status().await.expect("a status arrives");
            for n in 0..8_u8 {
                let y_mm = if n % 2 == 0 { 60.0 } else { 0.0 };
                let target = move_to(MovingMode::MovJ, 220.0, y_mm, 0.0);
                let id = connection.send(target).expect("it is allowed");
                connection.completed(id).await.expect("it is reached");
            }
            assert!(connection.session().is_trusted(), "{personality} {seed}");
        }
    }
}

#[test]
fn an_arm_is_untrusted_from_the_start_where_its_owner_wants_it_so() {
    let mut session = Session::new(None);
    let jog = button(JointJogAxis::BasePlus, 10.0);
    let error = session.send(jog).expect_err("nobody has looked");
    assert!(error.to_string().contains("confirm its pose"), "{error}");
    let text = session.distrust_reason().expect("it says why");
    assert!(text.contains("confirmed"), "{text}");
}

#[tokio::test]
async fn a_target_beyond_a_limit_and_a_lost_command_are_distinguished() {
    let arm = virtual_arm(Personality::Specification, &[], 0);
    let mut connection = connect(&arm, Personality::Specification);
    let far = connection.send(move_to(MovingMode::MovJ, 400.0, 0.0, 0.0));
    let error = connection.completed(far.expect("it is allowed")).await;
    let reason = |error: Result<(), LinkError>| match error {
        Err(LinkError::NotReached { reason, .. }) => reason,
        other => panic!("{other:?}"),
    };
    assert_eq!(reason(error), NotReached::AtLimit);

    let arm = virtual_arm(Personality::Specification, &["drop=100%:to"], 0);
    let mut connection = connect(&arm, Personality::Specification);
    let near = connection.send(move_to(MovingMode::MovJ, 220.0, 0.0, 0.0));
    let error = connection.completed(near.expect("it is allowed")).await;
    assert_eq!(reason(error), NotReached::Stalled);
}

#[tokio::test]
async fn the_quality_of_a_link_is_measured() {
    let good = virtual_arm(Personality::Firmware11, &[], 0);
    let mut connection = connect(&good, Personality::Firmware11);
    connection.next_status().await.expect("a status arrives");
    let id = connection.send(move_to(MovingMode::MovJ, 220.0, 40.0, 0.0));
    let id = id.expect("it is allowed");
    connection.completed(id).await.expect("it is reached");
    while connection.now() < Duration::from_secs(6) {
        next(&mut connection).await;
    }
    let quality = connection.session().link();
    assert!(
        (12.0..13.5).contains(&quality.statuses_per_s),
        "{quality:?}"
    );
    assert_eq!((quality.lost, quality.damaged_bytes), (0, 0));
    // Two packets of 43.68 ms, up to a tick, and what is left of a period.
    let latency = quality.latency.expect("it was seen to move");
    assert!(latency > ms(87) && latency < ms(200), "{latency:?}");

    let bad = virtual_arm(Personality::Firmware11, &["drop=0.1%:from"], 7);
    let mut connection = connect(&bad, Personality::Firmware11);
    while connection.now() < Duration::from_mins(2) {
        next(&mut connection).await;
    }
    let quality = connection.session().link();
    let reported = bad.arm().controller().tick_count() / 4;
    // A status of 42 bytes loses one with 4.1 %: 61 of 1500.
    let lost = quality.lost;
    assert!(
        (30..100).contains(&lost),
        "{lost} of {reported} lost: {quality:?}"
    );
    assert!(quality.damaged_bytes > lost, "{quality:?}");
}

#[tokio::test]
async fn an_arm_in_hand_does_what_each_call_says_and_returns_then() {
    for personality in Personality::ALL {
        let peer = virtual_arm(personality, &[], 0);
        let mut arm = Arm::over(connect(&peer, personality));
        let status = arm
            .move_to(move_to(MovingMode::MovL, 220.0, 30.0, 10.0))
            .await
            .expect("it is reached");
        assert!((status.y_mm - 30.0).abs() < 0.05, "{status:?}");
        let up = LinearJog::new(LinearJogAxis::ZPlus, 50.0);
        let status = arm.jog(up, ms(1000)).await.expect("it moves");
        assert!((20.0..60.0).contains(&status.z_mm), "{status:?}");

        arm.connection_mut()
            .send(button(JointJogAxis::BaseMinus, 50.0))
            .expect("it is allowed");
        for _ in 0..10 {
            arm.status().await.expect("a status arrives");
        }
        let status = arm.stop().await.expect("it stops");
        let again = arm.status().await.expect("a status arrives");
        assert_eq!(status, again, "{personality}");
    }
}

#[test]
fn an_arm_in_hand_works_without_async() {
    let personality = Personality::Firmware11;
    let peer = virtual_arm(personality, &[], 0);
    let mut arm = blocking::Arm::over_peer(peer, Some(personality.dialect())).expect("it opens");
    let status = arm
        .move_to(move_to(MovingMode::Jump, 220.0, -30.0, 10.0))
        .expect("it is reached");
    assert!((status.y_mm + 30.0).abs() < 0.05, "{status:?}");
    assert_eq!(arm.stop().expect("it rests"), status);
}
