//! Good controllers behind lines that are late, vary or lose something.

use std::time::Duration;

use dobot_conformance::{Blocker, Verdict};
use dobot_controller::Personality;
use dobot_geometry::Random;

use crate::broken::Broken;
use crate::delayed::Delayed;
use crate::{ALL, ON_A_PORT, caught, check, good, good_arms, speaking, table, untried};

const fn ms(ms: u64) -> Duration {
    Duration::from_millis(ms)
}

#[tokio::test]
async fn all_holds_behind_a_line_of_up_to_250_ms_each_way_and_its_latency_is_reported() {
    for one_way in (0..=250).step_by(5) {
        for arm in good_arms() {
            let peer = Delayed::by(arm, ms(one_way));
            let report = check(peer, ALL).await;
            assert!(report.conforms(), "{one_way} ms: {}", table(&report));
            assert_eq!(untried(&report), [""; 0]);
            let reported = report.latency().expect("it was measured").least;
            let off = reported.abs_diff(ms(2 * one_way));
            assert!(
                off <= ms(25),
                "{one_way} ms each way, reported {reported:?}"
            );
            let text = report.markdown("virtual:", "2016-02-26");
            assert!(text.contains(&format!("| latency | {} ms", reported.as_millis())));
        }
    }
}

#[tokio::test]
async fn a_line_that_is_now_fast_and_now_slow_is_waited_for() {
    for arm in good_arms() {
        let late = [20, 90, 35, 110, 60, 25, 80].map(ms).to_vec();
        let report = check(Delayed::in_turn(arm, late), ON_A_PORT).await;
        assert_eq!(report.differing(), [""; 0], "{}", table(&report));
    }
}

#[tokio::test]
async fn a_line_too_slow_is_reported_and_nothing_is_moved() {
    for (one_way, reported) in [(350, 700), (900, 1800), (2500, 5000)] {
        let arm = speaking(Personality::Firmware11);
        let report = check(Delayed::by(arm.clone(), ms(one_way)), ON_A_PORT).await;
        assert_eq!(report.differing(), [""; 0], "{}", table(&report));
        let Some(Blocker::Slow(took)) = report.blocker() else {
            panic!("{}", table(&report));
        };
        assert!(took.abs_diff(ms(reported)) <= ms(25), "{took:?}");
        let outcome = report.outcome("move-point").expect("it is one");
        assert!(
            outcome
                .found()
                .starts_with("the round-trip time of the line is "),
            "{outcome}"
        );
        assert!(outcome.found().contains("at most 600 ms"), "{outcome}");
        assert_eq!(arm.arm().controller().steps(), [0; 3]);
    }
}

#[tokio::test]
async fn an_unresponsive_controller_is_reported() {
    let deaf = good().on_receive(|_, bytes| bytes.clear());
    let report = check(deaf, ON_A_PORT).await;
    assert_eq!(report.differing(), ["line-delay"], "{}", table(&report));
    let outcome = report.outcome("line-delay").expect("it is one");
    assert!(
        outcome.found().starts_with("nothing that is sent shows"),
        "{outcome}"
    );
}

#[tokio::test]
async fn exchanged_angles_in_the_status_are_said_to_disagree_with_the_position() {
    let broken = good().says(|frame| {
        let (rear, fore) = (frame.float(6), frame.float(7));
        Some(frame.with(6, fore).with(7, rear).to_bytes().to_vec())
    });
    let report = check(broken, ON_A_PORT).await;
    let outcome = report.outcome("move-point").expect("it is one");
    assert!(outcome.differs(), "{outcome}");
    assert!(
        outcome
            .found()
            .contains("whose position and angles disagree"),
        "{outcome}"
    );
}

/// Chances that are the same every time.
fn every_so_often(seed: u64, percent: f64) -> impl FnMut() -> bool + Send {
    let mut random = Random::new(seed);
    move || random.chance(percent)
}

#[tokio::test]
async fn a_line_that_loses_commands_makes_no_good_controller_differ() {
    for seed in 1..=12 {
        for arm in good_arms() {
            let mut lost = every_so_often(seed, 3.0);
            let broken = Broken::new(arm).obeys(move |frame| (!lost()).then_some(frame));
            let report = check(broken, ON_A_PORT).await;
            assert_eq!(report.differing(), [""; 0], "{seed}: {}", table(&report));
            assert!(!matches!(report.verdict(), Verdict::Mixed { .. }));
        }
    }
}

#[tokio::test]
async fn a_line_that_loses_statuses_is_reported_and_makes_no_good_controller_differ() {
    for seed in 1..=12 {
        for arm in good_arms() {
            let mut lost = every_so_often(seed, 2.0);
            let broken =
                Broken::new(arm).says(move |frame| (!lost()).then(|| frame.to_bytes().to_vec()));
            let report = check(broken, ON_A_PORT).await;
            assert_eq!(report.differing(), [""; 0], "{seed}: {}", table(&report));
        }
    }
}

#[tokio::test]
async fn a_check_that_holds_at_the_second_time_only_is_unsteady() {
    let mut jumps = 0;
    let broken = good().obeys(move |frame| {
        let is_jump = frame.float(1) == 3.0 && frame.float(8) == 0.0;
        jumps += u32::from(is_jump);
        (!is_jump || jumps > 1).then_some(frame)
    });
    let report = check(broken, ON_A_PORT).await;
    assert_eq!(report.unsteady(), ["move-jump"], "{}", table(&report));
    assert_eq!(report.differing(), [""; 0]);
    assert!(!report.conforms());
    assert!(
        report.summary().contains("1 unsteady"),
        "{}",
        report.summary()
    );
}

#[tokio::test]
async fn a_pump_that_runs_is_said_to_hinder() {
    let broken = good().says(|frame| Some(frame.with(9, 1.0).to_bytes().to_vec()));
    let report = check(broken, ON_A_PORT).await;
    assert_eq!(report.blocker(), Some(&Blocker::Pump));
}

#[tokio::test]
async fn whichever_command_gets_lost_no_good_controller_differs_or_loses_its_pose() {
    for lost in (0..420).step_by(3) {
        for arm in good_arms() {
            let mut count = 0;
            let broken = Broken::new(arm.clone()).obeys(move |frame| {
                count += 1;
                (count != lost).then_some(frame)
            });
            let report = check(broken, ON_A_PORT).await;
            assert_eq!(report.differing(), [""; 0], "{lost}: {}", table(&report));
            let arm = arm.arm();
            let joints = arm.controller().joints_at(arm.now());
            assert!((joints.rear.0 - 45.0).abs() < 0.05, "{lost}: {joints:?}");
        }
    }
}

#[tokio::test]
async fn where_a_move_got_lost_no_line_without_length_follows_it() {
    let mut lost = 0;
    let broken = Broken::new(speaking(Personality::Firmware11)).obeys(move |frame| {
        let [state, servo, mode] = [1, 6, 8].map(|n| frame.float(n));
        // Only `move-joints` turns the servo by 4 degrees, and goes back in a line.
        assert!(lost == 0 || state != 6.0 || mode != 2.0);
        let is_lost = state == 6.0 && servo > 3.0;
        lost += u32::from(is_lost);
        (!is_lost).then_some(frame)
    });
    caught(broken, &["move-joints"]).await;
}
