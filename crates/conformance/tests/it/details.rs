//! Controllers that are broken in a detail in which the dialects differ.

use dobot_conformance::{Outcome, Verdict};
use dobot_controller::Personality;
use dobot_wire::Frame;

use crate::broken::Broken;
use crate::{ON_A_PORT, check, good, is_release, speaking, table};

/// The checks that say something else of a broken arm than of a good one, where both were tried.
async fn expect_distinguished(personality: Personality, broken: Broken, ids: &[&str]) {
    let (good, broken) = (
        check(speaking(personality), ON_A_PORT).await,
        check(broken, ON_A_PORT).await,
    );
    let rows = good.rows().iter().zip(broken.rows());
    let others = rows.filter(|(good, broken)| {
        let tried = !matches!(broken.outcome, Outcome::NotTried(_));
        tried && good.outcome.word() != broken.outcome.word()
    });
    let others: Vec<_> = others.map(|(good, _)| good.check.id).collect();
    assert_eq!(others, ids, "{}", table(&broken));
    assert!(!broken.conforms());
}

/// Packets sent right behind each other instead of one.
fn instead(
    personality: Personality,
    change: impl Fn(&Frame) -> Option<Vec<Frame>> + Send + 'static,
) -> Broken {
    Broken::new(speaking(personality)).on_receive(move |_, bytes| {
        let frame = bytes.first_chunk().and_then(Frame::from_bytes);
        let frames = frame
            .filter(|_| bytes.len() == 42)
            .and_then(|it| change(&it));
        if let Some(frames) = frames {
            *bytes = frames.iter().flat_map(Frame::to_bytes).collect();
        }
    })
}

#[tokio::test]
async fn a_jump_that_crosses_in_another_way_is_caught() {
    // The target that is higher than the arm stands for all other checks.
    let rises = |frame: &Frame| {
        let jumps = frame.float(1) == 3.0 && frame.float(8) == 0.0;
        jumps && frame.float(5) > -5.0
    };
    let straight = instead(Personality::Firmware11, move |frame| {
        rises(frame).then(|| vec![frame.with(8, 1.0)])
    });
    expect_distinguished(Personality::Firmware11, straight, &["jump-across"]).await;
    // Up, across and down by joints, by as much at either end: 6 mm to the left and 4 mm up.
    let lifts = instead(Personality::Specification, move |frame| {
        let (y, z) = (frame.float(4), frame.float(5));
        let by_joints = frame.with(8, 2.0);
        rises(frame).then(|| {
            vec![
                by_joints.with(4, y - 6.0).with(5, z - 4.0 + 5.0),
                by_joints.with(5, z + 5.0),
                by_joints,
            ]
        })
    });
    expect_distinguished(Personality::Specification, lifts, &["jump-across"]).await;
}

#[tokio::test]
async fn a_release_of_the_other_kind_that_takes_the_acceleration_of_its_own_is_caught() {
    let broken = Broken::new(speaking(Personality::Firmware11)).obeys(|frame| {
        let is_teach = frame.float(1) == 9.0 && frame.float(2) == 0.0;
        let (joint, line) = (frame.float(4), frame.float(8));
        Some(if is_teach {
            frame.with(4, line).with(8, joint)
        } else {
            frame
        })
    });
    expect_distinguished(Personality::Firmware11, broken, &["release-kind"]).await;
}

#[tokio::test]
async fn a_release_of_the_other_kind_that_is_ignored_is_caught() {
    for personality in Personality::ALL {
        let mut held = 0.0;
        let broken = Broken::new(speaking(personality)).obeys(move |frame| {
            let is_jog = matches!(frame.float(1), 2.0 | 7.0);
            if is_jog && !is_release(&frame) {
                held = frame.float(1);
            }
            (!is_release(&frame) || frame.float(1) == held).then_some(frame)
        });
        expect_distinguished(personality, broken, &["release-kind"]).await;
    }
}

#[tokio::test]
async fn a_stock_arm_that_runs_down_where_it_is_makes_a_mixed_dialect() {
    let mut held = 2.0;
    let broken = Broken::new(speaking(Personality::Firmware11)).obeys(move |frame| {
        let is_jog = matches!(frame.float(1), 2.0 | 7.0);
        if is_jog && !is_release(&frame) {
            held = frame.float(1);
        }
        Some(if is_release(&frame) {
            frame.with(1, held)
        } else {
            frame
        })
    });
    let report = check(broken, ON_A_PORT).await;
    let Verdict::Mixed { specification, .. } = report.verdict() else {
        panic!("{}", table(&report));
    };
    assert_eq!(specification, ["release-kind"]);
}

#[tokio::test]
async fn a_run_down_with_an_acceleration_that_was_set_behind_the_press_is_caught() {
    // By the document: the acceleration of the setting counts from the beginning.
    let broken = good().obeys(|frame| {
        let is_slow = frame.float(1) == 9.0 && frame.float(2) == 0.0 && frame.float(6) == 8.0;
        Some(if is_slow { frame.with(6, 80.0) } else { frame })
    });
    expect_distinguished(Personality::Specification, broken, &["release-settings"]).await;
    // On a stock arm: the button acts once more, with what was set.
    let button = Frame::ZERO.with(1, 2.0).with(2, 7.0).with(8, 20.0);
    let press = std::sync::Mutex::new(false);
    let broken = instead(Personality::Firmware11, move |frame| {
        let mut pressed = press.lock().expect("nobody else has it");
        let is_fast = frame.float(1) == 9.0 && frame.float(6) == 80.0;
        *pressed |= is_fast;
        (*pressed && is_release(frame)).then(|| {
            *pressed = false;
            vec![button, *frame]
        })
    });
    expect_distinguished(Personality::Firmware11, broken, &["release-settings"]).await;
}

#[tokio::test]
async fn a_move_of_whole_ticks_that_takes_another_number_of_them_is_caught() {
    // A trifle less of a turn: a stock arm needs no tick more for it.
    let broken = Broken::new(speaking(Personality::Firmware11)).obeys(|frame| {
        let base = frame.float(3);
        Some(if frame.float(1) == 6.0 {
            frame.with(3, base - 4e-6)
        } else {
            frame
        })
    });
    expect_distinguished(Personality::Firmware11, broken, &["move-ticks"]).await;
    // A tick of rest behind each move.
    let broken = good().obeys(|frame| {
        let pauses = frame.float(1) == 6.0;
        Some(if pauses { frame.with(10, 0.02) } else { frame })
    });
    expect_distinguished(Personality::Specification, broken, &["move-ticks"]).await;
}
