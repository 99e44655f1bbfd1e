//! States 2 and 7: jogging.

use dobot_controller::{Personality, PowerUp};
use dobot_wire::{JointJog, JointJogAxis, LinearJog, LinearJogAxis};

use crate::lab::Lab;
use crate::moving::movl;

fn joint(axis: JointJogAxis, speed_percent: f32) -> JointJog {
    JointJog::new(axis, speed_percent)
}

fn linear(axis: LinearJogAxis, speed_percent: f32) -> LinearJog {
    LinearJog::new(axis, speed_percent)
}

#[test]
fn a_held_button_ramps_up_and_a_released_one_runs_down() {
    // 15 degrees/s at 100 %, 50 degrees/s2: 0.3 s each way.
    let lab = Lab::power_up()
        .send(joint(JointJogAxis::BasePlus, 100.0))
        .wait_ms(1000);
    // It acts from the tick at 20 ms on: 0.3 s of ramp at half the speed, 0.68 s at full speed.
    let expected = 0.5 * 15.0 * 0.3 + 15.0 * 0.68;
    assert!(
        (lab.joints().base.0 - expected).abs() < 1e-9,
        "{:?}",
        lab.joints()
    );
    let running = lab.joints().base.0;
    let lab = lab.send(joint(JointJogAxis::Released, 0.0)).wait_ms(1000);
    let rest = lab.joints().base.0;
    // One tick at full speed until it acts, then 2.25 degrees of run-down.
    assert!(
        (rest - running - 0.3 - 2.25).abs() < 1e-9,
        "{running} {rest}"
    );
    assert_eq!(lab.wait_ms(500).joints().base.0, rest);
}

#[test]
fn a_linear_jog_moves_one_coordinate_only() {
    let lab = Lab::power_up();
    let from = lab.position();
    let lab = lab.send(linear(LinearJogAxis::YMinus, 50.0)).wait_ms(2000);
    let at = lab.position();
    assert!(at.y.0 < -40.0);
    assert!(
        (at.x.0 - from.x.0).abs() < 1e-9 && (at.z.0 - from.z.0).abs() < 1e-9,
        "{at:?}"
    );
}

#[test]
fn a_lower_percentage_slows_the_same_axis_without_a_stop() {
    let lab = Lab::power_up()
        .send(joint(JointJogAxis::BasePlus, 100.0))
        .wait_ms(1000)
        .send(joint(JointJogAxis::BasePlus, 20.0))
        .wait_ms(1000);
    let before = lab.joints().base.0;
    let lab = lab.wait_ms(1000);
    assert!((lab.joints().base.0 - before - 3.0).abs() < 1e-9);
}

#[test]
fn every_jog_stops_inside_the_limits_and_says_so() {
    for axis in [
        JointJogAxis::BasePlus,
        JointJogAxis::BaseMinus,
        JointJogAxis::RearPlus,
        JointJogAxis::RearMinus,
        JointJogAxis::ForePlus,
        JointJogAxis::ForeMinus,
        JointJogAxis::ServoPlus,
        JointJogAxis::ServoMinus,
        JointJogAxis::GripperOpen,
        JointJogAxis::GripperClose,
    ] {
        let lab = Lab::power_up().send(joint(axis, 100.0)).wait_ms(30_000);
        stands_within_the_limits(&lab);
        lab.expect_refusal("a jog stopped at a limit");
    }
    for axis in [
        LinearJogAxis::XPlus,
        LinearJogAxis::XMinus,
        LinearJogAxis::YPlus,
        LinearJogAxis::YMinus,
        LinearJogAxis::ZPlus,
        LinearJogAxis::ZMinus,
    ] {
        let lab = Lab::power_up().send(linear(axis, 100.0)).wait_ms(30_000);
        stands_within_the_limits(&lab);
        lab.expect_refusal("a jog stopped at a limit");
    }
}

fn stands_within_the_limits(lab: &Lab) {
    let checked = dobot_arm::Limits::STOCK.check(&lab.joints(), dobot_arm::Tool::SuctionCup);
    assert_eq!(checked, Ok(()));
    let gripper = lab
        .statuses
        .last()
        .expect("there are statuses")
        .1
        .gripper_deg;
    assert!(gripper.abs() <= 90.0, "gripper {gripper}");
}

#[test]
fn an_arm_powered_up_outside_of_the_limits_can_be_jogged_in_but_not_further_out() {
    // rear - fore = 55, 20 more than allowed.
    let outside = PowerUp::new(Personality::Specification).with_tilt(60.0, 5.0);
    Lab::power_up_with(outside)
        .send(joint(JointJogAxis::ForeMinus, 50.0))
        .wait_ms(1000)
        .expect_joints(0.0, 60.0, 5.0, 0.0)
        .expect_refusal("a jog stopped at a limit");
    let lab = Lab::power_up_with(outside)
        .send(joint(JointJogAxis::ForePlus, 50.0))
        .wait_ms(4000);
    assert!(lab.joints().fore.0 > 25.0);
    lab.expect_no_refusal();
}

#[test]
fn switches_act_at_once_and_a_jog_goes_on() {
    let lab = Lab::power_up()
        .send(joint(JointJogAxis::BasePlus, 50.0))
        .wait_ms(500)
        .send(joint(JointJogAxis::LaserOn, 0.0))
        .send(joint(JointJogAxis::SuctionOn, 0.0))
        .wait_ms(20);
    assert!(lab.controller.laser() && lab.controller.suction());
    let before = lab.joints().base.0;
    let lab = lab
        .wait_ms(100)
        .send(linear(LinearJogAxis::LaserOff, 0.0))
        .wait_ms(20);
    assert!(!lab.controller.laser());
    assert!(lab.joints().base.0 > before);
}

#[test]
fn another_command_waits_until_the_jog_has_come_to_rest() {
    let mut lab = Lab::power_up()
        .send(linear(LinearJogAxis::ZPlus, 100.0))
        .wait_ms(1500)
        .send(movl(220.0, 0.0, 0.0));
    let mut speed = f64::NAN;
    let mut before = lab.position();
    for _ in 0..200 {
        lab = lab.wait_ms(10);
        let next = lab.position().distance(before).0 / 0.01;
        // 60 mm/s2 of the jog and 100 mm/s2 of the line: no step is larger.
        assert!(
            speed.is_nan() || (next - speed).abs() < 2.1,
            "{speed} to {next} mm/s"
        );
        (speed, before) = (next, lab.position());
    }
    lab.wait_ms(5000)
        .expect_at(220.0, 0.0, 0.0)
        .expect_no_refusal();
}

#[test]
fn a_jog_of_another_axis_begins_after_the_first_has_run_down() {
    let lab = Lab::power_up()
        .send(joint(JointJogAxis::BasePlus, 100.0))
        .wait_ms(1000)
        .send(joint(JointJogAxis::RearMinus, 100.0))
        .wait_ms(1000);
    let base = lab.joints().base.0;
    assert!(lab.joints().rear.0 < 40.0);
    assert_eq!(lab.wait_ms(200).joints().base.0, base);
}
