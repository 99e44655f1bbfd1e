//! How soon an interrupted drawing stops.

use dobot_wire::WriteVector;
use rustix::process::Signal;

use crate::Turn;
use crate::support::trouble::{Trouble, is_laser_off, troubled, vector};

#[test]
fn ctrl_c_in_a_drawing_lifts_the_pen_switches_the_laser_off_and_reports_the_progress() {
    let _turn = Turn::wait();
    parts(
        Trouble::Signal(Signal::INT),
        &[
            "job 1 is paused: interrupted; the tool is up",
            "dobot jobs start 1 --to tcp:",
        ],
    );
}

#[test]
fn a_system_that_shuts_down_in_a_drawing_leaves_the_pen_up_and_the_laser_off() {
    let _turn = Turn::wait();
    parts(
        Trouble::Signal(Signal::TERM),
        &["job 1 is paused: interrupted; the tool is up"],
    );
}

/// How high the default pen travels (crates/draw/materials.toml).
const FINELINER_LIFT_MM: f32 = 5.0;

/// The vector that is drawn comes to its end, the pen goes up, and the last word is laser off.
fn parts(trouble: Trouble, expected: &[&str]) {
    // Travel, lower, and four vectors with the pen down.
    let (outcome, before, after) = troubled(6, trouble);
    let outcome = outcome.fails(1, expected);
    assert!(
        after.last().is_some_and(is_laser_off),
        "{after:?} {outcome:?}"
    );
    let vectors: Vec<&WriteVector> = after.iter().filter_map(vector).collect();
    let (lift, rest) = vectors.split_last().expect("the pen is lifted");
    let z_mm = |vectors: &mut dyn Iterator<Item = f32>| vectors.sum::<f32>();
    let sent_down = z_mm(&mut before.iter().filter_map(vector).map(|stroke| stroke.z_mm))
        + z_mm(&mut rest.iter().map(|stroke| stroke.z_mm));
    assert!(
        (sent_down + FINELINER_LIFT_MM).abs() < 1e-3,
        "the pen was down: {sent_down}"
    );
    assert!((lift.z_mm - FINELINER_LIFT_MM).abs() < 1e-3, "{lift:?}");
    assert_eq!((lift.x_mm, lift.y_mm), (0.0, 0.0));
    // Only packets that were already permitted.
    assert!(rest.len() < 6, "{after:?}");
}
