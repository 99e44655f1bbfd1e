//! Speeds, accelerations and heights against their ceilings.

use dobot_wire::{
    Configuration, Dialect, Gesture, JointJogAxis, LinearJogAxis, MouseMove,
    MovingMode::{Jump, MovJ, MovL},
    PlaybackAdjustment, WriteVector,
};

use crate::desk::{Desk, assert_near, go, jog, slide, turn, vector};

fn playback(speed: f32, jump_height_mm: f32) -> Configuration {
    Configuration::playback(
        [speed, 200.0, 200.0, 200.0, 100.0, 200.0],
        0.0,
        jump_height_mm,
    )
}

#[test]
fn configured_speeds_count_with_their_percentage() {
    let mut desk = Desk::at(200.0, 0.0, 0.0);
    // At the 50 % of power-up.
    desk.allows(playback(400.0, 20.0));
    let violation = desk.refuses("speed.joint", playback(500.0, 20.0));
    assert_near(
        violation.value.as_ref().expect("a value").found,
        250.0,
        1e-9,
    );
    assert_near(
        violation.value.as_ref().expect("a value").nearest,
        200.0,
        1e-9,
    );
    desk.model.settings.playback.joint_deg_s = 400.0;
    let percent = |speed_percent| PlaybackAdjustment {
        speed_percent,
        acceleration_percent: 50.0,
        teach_speed_percent: 100.0,
    };
    desk.allows(percent(50.0));
    desk.refuses("speed.joint", percent(60.0));
}

#[test]
fn the_height_of_a_jump_has_a_ceiling() {
    let desk = Desk::at(200.0, 0.0, 0.0);
    desk.allows(playback(200.0, 150.0));
    desk.refuses("jump.height", playback(200.0, 151.0));
}

#[test]
fn a_move_never_exceeds_the_ceiling_of_its_speed_for_any_settings() {
    let mut desk = Desk::at(200.0, 0.0, 0.0).under("[speed]\nline_mm_s = 40");
    // 50 mm/s after power-up.
    desk.refuses("speed.line", go(MovL, 200.0, 50.0, 0.0));
    desk.refuses("speed.line", go(Jump, 200.0, 50.0, 0.0));
    desk.allows(go(MovJ, 200.0, 50.0, 0.0));
    desk.model.settings.playback.joint_deg_s2 = 5000.0;
    desk.refuses("acceleration.joint", turn(MovJ, 10.0, 45.0, 45.0));
}

#[test]
fn write_vectors_have_their_own_ceilings() {
    let mut desk = Desk::at(200.0, 0.0, 0.0);
    let fast = |max_speed_mm_s| WriteVector {
        max_speed_mm_s,
        ..vector(20.0, 0.0, 0.0)
    };
    desk.allows(fast(200.0));
    desk.refuses("speed.writing", fast(201.0));
    let writing = |acceleration_mm_s2| Configuration::Writing { acceleration_mm_s2 };
    desk.allows(writing(500.0));
    desk.refuses("acceleration.writing", writing(501.0));
    desk.model.settings.write_acceleration_mm_s2 = 600.0;
    desk.refuses("acceleration.writing", fast(100.0));
}

#[test]
fn jogs_have_a_largest_percentage_and_the_speeds_of_their_axes() {
    let desk = Desk::at(200.0, 0.0, 30.0).under("[speed]\njog_percent = 60\nline_mm_s = 30");
    desk.allows(jog(JointJogAxis::BasePlus, 60.0));
    desk.refuses("speed.jog", jog(JointJogAxis::BasePlus, 61.0));
    // 60 mm/s at 100 %.
    desk.allows(slide(LinearJogAxis::YPlus, 50.0));
    desk.refuses("speed.line", slide(LinearJogAxis::YPlus, 55.0));
}

#[test]
fn teaching_speeds_count_with_the_largest_percentage_of_a_jog() {
    let teach =
        |joint_speed_deg_s| Configuration::teach([joint_speed_deg_s, 50.0, 30.0, 50.0, 60.0, 60.0]);
    let desk = Desk::at(200.0, 0.0, 30.0);
    desk.allows(teach(200.0));
    desk.refuses("speed.joint", teach(220.0));
    desk.under("[speed]\njog_percent = 50").allows(teach(390.0));
}

#[test]
fn a_stock_arm_follows_mouse_and_hand_no_faster_than_its_joints_may() {
    let desk = Desk::at(230.0, 0.0, 0.0).speaking(Dialect::FIRMWARE_1_1);
    // A swing of 0.225 degrees a unit, in a tenth of a second.
    let swing = |y| MouseMove {
        y,
        x: 0.0,
        z: 0.0,
        rotation_deg: 0.0,
        suction: false,
    };
    desk.allows(swing(80.0));
    desk.refuses("speed.joint", swing(100.0));
    desk.allows(Gesture {
        x: 0.0,
        y: 15.0,
        z: 200.0,
        grab: false,
    });
}
