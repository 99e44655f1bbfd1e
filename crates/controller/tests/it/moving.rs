//! States 1, 3, 5, 6, 8, 9 and 10: motion to a target.

use dobot_arm::Tool;
use dobot_wire::{
    Configuration, Gesture, MouseMove, MoveJoints, MoveTo, MovingMode, PlaybackAdjustment, Voice,
};

use crate::lab::Lab;

#[expect(
    clippy::cast_possible_truncation,
    reason = "the wire is single precision"
)]
pub(crate) fn target(mode: MovingMode, x_mm: f64, y_mm: f64, z_mm: f64) -> MoveTo {
    MoveTo::to(x_mm as f32, y_mm as f32, z_mm as f32).with_mode(mode)
}

pub(crate) fn movl(x_mm: f64, y_mm: f64, z_mm: f64) -> MoveTo {
    target(MovingMode::MovL, x_mm, y_mm, z_mm)
}

fn joints(base_deg: f32, rear_deg: f32, fore_deg: f32, servo_deg: f32) -> MoveJoints {
    MoveJoints::to([base_deg, rear_deg, fore_deg, servo_deg]).with_mode(MovingMode::MovJ)
}

#[test]
fn each_moving_mode_ends_exactly_at_the_target() {
    for mode in [MovingMode::Jump, MovingMode::MovL, MovingMode::MovJ] {
        Lab::power_up()
            .send(target(mode, 220.0, 60.0, 30.0))
            .wait_ms(10_000)
            .expect_at(220.0, 60.0, 30.0)
            .expect_no_refusal();
    }
}

#[test]
fn a_jump_lifts_20_mm_above_the_higher_end_before_it_goes_across() {
    let mut lab = Lab::power_up()
        .send(movl(220.0, -50.0, 10.0))
        .wait_ms(10_000)
        .send(target(MovingMode::Jump, 220.0, 50.0, 0.0));
    let mut highest: f64 = 0.0;
    for _ in 0..1000 {
        lab = lab.wait_ms(10);
        let at = lab.position();
        highest = highest.max(at.z.0);
        let between = at.y.0 > -49.999 && at.y.0 < 49.999;
        assert!(!between || (at.z.0 - 30.0).abs() < 1e-6, "across at {at:?}");
    }
    assert!((highest - 30.0).abs() < 1e-6);
    lab.expect_at(220.0, 50.0, 0.0).expect_no_refusal();
}

#[test]
fn a_movj_moves_all_joints_in_the_same_share_of_their_way() {
    let mut lab = Lab::power_up().send(joints(40.0, 25.0, 30.0, -20.0));
    for _ in 0..50 {
        lab = lab.wait_ms(20);
        let now = lab.joints();
        let share = now.base.0 / 40.0;
        assert!(((now.rear.0 - 45.0) / -20.0 - share).abs() < 1e-9);
        assert!(((now.fore.0 - 45.0) / -15.0 - share).abs() < 1e-9);
        assert!((now.servo.0 / -20.0 - share).abs() < 1e-9);
    }
    lab.wait_ms(3000).expect_joints(40.0, 25.0, 30.0, -20.0);
}

#[test]
fn a_movl_stays_on_the_straight_line_and_keeps_the_speed_of_the_settings() {
    let mut lab = Lab::power_up()
        .send(movl(200.0, -100.0, 0.0))
        .wait_ms(10_000)
        .send(movl(200.0, 100.0, 0.0));
    let (mut before, mut fastest) = (lab.position(), 0.0_f64);
    for _ in 0..600 {
        lab = lab.wait_ms(10);
        let at = lab.position();
        assert!(
            (at.x.0 - 200.0).abs() < 1e-6 && at.z.0.abs() < 1e-6,
            "{at:?}"
        );
        fastest = fastest.max(at.distance(before).0 / 0.01);
        before = at;
    }
    // 100 mm/s at the 50 % of power-up.
    assert!((fastest - 50.0).abs() < 1e-6, "{fastest}");
    lab.expect_at(200.0, 100.0, 0.0);
}

#[test]
fn the_tool_is_set_after_the_move_and_the_pause_comes_after_that() {
    let grab = MoveTo {
        suction: true,
        gripper_deg: 30.0,
        pause_s: 1.5,
        ..movl(263.0, 0.0, -17.0)
    };
    let lab = Lab::power_up()
        .send(grab)
        .send(movl(263.0, 40.0, -17.0))
        .wait_ms(1000);
    assert!(lab.controller.suction());
    let status = lab.statuses.last().expect("a status").1;
    assert_eq!((status.suction, status.gripper_deg), (true, 30.0));
    let lab = lab
        .expect_at(263.0, 0.0, -17.0)
        .wait_ms(600)
        .expect_at(263.0, 0.0, -17.0);
    assert!(lab.wait_ms(400).position().y.0 > 0.0);
}

#[test]
fn a_target_without_a_pause_takes_the_default_one() {
    let playback = Configuration::playback([200.0, 200.0, 200.0, 200.0, 200.0, 2000.0], 5.0, 20.0);
    Lab::power_up()
        .send(playback)
        .send(movl(263.0, 0.0, -17.0))
        .send(movl(263.0, 40.0, -17.0))
        .wait_ms(4900)
        .expect_at(263.0, 0.0, -17.0)
        .wait_ms(3000)
        .expect_at(263.0, 40.0, -17.0);
}

#[test]
fn the_percentages_scale_speed_and_acceleration() {
    let slow = PlaybackAdjustment {
        speed_percent: 10.0,
        acceleration_percent: 100.0,
        teach_speed_percent: 100.0,
    };
    let lab = Lab::power_up()
        .send(slow)
        .send(movl(203.597, 0.0, -17.7))
        .wait_ms(4000);
    // 60 mm at 10 mm/s take six seconds.
    assert!(lab.position().x.0 > 210.0);
    lab.wait_ms(3000).expect_no_refusal();
}

#[test]
fn a_mouse_moves_by_millimetres_of_y_x_and_z() {
    let by = MouseMove {
        y: 5.0,
        x: -10.0,
        z: 2.0,
        rotation_deg: 0.0,
        suction: true,
    };
    let lab = Lab::power_up();
    let from = lab.position();
    let lab = lab.send(by).wait_ms(1000);
    assert!(lab.controller.suction());
    lab.expect_at(from.x.0 - 10.0, from.y.0 + 5.0, from.z.0 + 2.0);
}

#[test]
fn a_gesture_goes_to_the_place_of_the_hand() {
    let hand = Gesture {
        x: 220.0,
        y: 30.0,
        z: 40.0,
        grab: true,
    };
    let lab = Lab::power_up().send(hand).wait_ms(4000);
    assert!(lab.controller.suction());
    lab.expect_at(220.0, 30.0, 40.0);
}

#[test]
fn a_voice_moves_by_the_millimetres_that_it_says() {
    let lab = Lab::power_up();
    let from = lab.position();
    let text = Voice::new("left twenty five").expect("it is short");
    lab.send(text)
        .wait_ms(2000)
        .expect_at(from.x.0, 25.0, from.z.0)
        .expect_no_refusal();
}

#[test]
fn another_tool_moves_the_position_and_no_joint() {
    let laser = Configuration::EndEffector {
        tool: Tool::Laser.into(),
    };
    let lab = Lab::power_up();
    let from = lab.position();
    lab.send(laser)
        .wait_ms(40)
        .expect_joints(0.0, 45.0, 45.0, 0.0)
        .expect_at(from.x.0 - 5.5, 0.0, from.z.0);
}

#[test]
fn initial_angles_are_taken_over_without_motion() {
    let angles = Configuration::InitialAngles {
        rear_deg: 30.0,
        fore_deg: 20.0,
    };
    Lab::power_up()
        .send(joints(20.0, 40.0, 40.0, 5.0))
        .wait_ms(3000)
        .send(angles)
        .wait_ms(20)
        .expect_joints(0.0, 30.0, 20.0, 5.0);
}
