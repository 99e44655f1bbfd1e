//! State 4: writing and laser.

use dobot_wire::{Configuration, JointJog, JointJogAxis, WriteVector};

use crate::lab::Lab;

fn vector(x_mm: f32, y_mm: f32, z_mm: f32) -> WriteVector {
    WriteVector::by(x_mm, y_mm, z_mm, 40.0)
}

#[test]
fn vectors_add_up() {
    let lab = Lab::power_up();
    let from = lab.position();
    lab.send(vector(-20.0, 10.0, 5.0))
        .send(vector(0.0, -30.0, 0.0))
        .wait_ms(5000)
        .expect_at(from.x.0 - 20.0, from.y.0 - 20.0, from.z.0 + 5.0)
        .expect_no_refusal();
}

#[test]
fn vectors_with_matching_speeds_pass_their_joint_without_a_stop() {
    let first = WriteVector {
        end_speed_mm_s: 30.0,
        max_speed_mm_s: 30.0,
        ..vector(0.0, 30.0, 0.0)
    };
    let second = WriteVector {
        start_speed_mm_s: 30.0,
        max_speed_mm_s: 30.0,
        ..vector(0.0, 30.0, 0.0)
    };
    let mut lab = Lab::power_up().send(first).send(second).wait_ms(500);
    let mut before = lab.position();
    while before.y.0 < 54.0 {
        lab = lab.wait_ms(10);
        let speed = lab.position().distance(before).0 / 0.01;
        assert!((speed - 30.0).abs() < 1e-6, "{speed} mm/s at {before:?}");
        before = lab.position();
    }
    lab.wait_ms(2000).expect_no_refusal();
}

#[test]
fn the_writing_acceleration_can_be_set() {
    let quick = Configuration::Writing {
        acceleration_mm_s2: 400.0,
    };
    let lab = Lab::power_up()
        .send(quick)
        .send(vector(0.0, 40.0, 0.0))
        .wait_ms(100);
    // From the tick at 20 ms on: half the acceleration times the square of the time.
    assert!((lab.position().y.0 - 0.5 * 400.0 * 0.08 * 0.08).abs() < 1e-9);
}

#[test]
fn the_laser_burns_in_its_mode_only_and_goes_off_with_the_last_vector() {
    let burn = vector(0.0, 20.0, 0.0).burning();
    let lab = Lab::power_up().send(burn).send(burn).wait_ms(1000);
    assert!(lab.controller.laser());
    let lab = lab.wait_ms(3000);
    assert!(!lab.controller.laser());

    let pen = WriteVector {
        laser: true,
        ..vector(0.0, -20.0, 0.0)
    };
    let lab = lab.send(pen).wait_ms(200);
    assert!(!lab.controller.laser());
}

#[test]
fn a_refused_vector_switches_the_laser_off() {
    let burn = vector(0.0, 20.0, 0.0).burning();
    let too_far = vector(500.0, 0.0, 0.0).burning();
    let lab = Lab::power_up().send(burn).send(too_far).wait_ms(5000);
    assert!(!lab.controller.laser());
    lab.expect_refusal("on its way");
}

#[test]
fn a_laser_switched_on_by_hand_stays_on_until_it_is_switched_off() {
    let press = |axis| JointJog::new(axis, 0.0);
    let lab = Lab::power_up()
        .send(press(JointJogAxis::LaserOn))
        .wait_ms(5000);
    assert!(lab.controller.laser());
    let lab = lab.send(press(JointJogAxis::LaserOff)).wait_ms(20);
    assert!(!lab.controller.laser());
}
