//! The paths that jogs can cover until the release takes effect.

use dobot_motion::Model;
use dobot_wire::{Command, JointJogAxis as J, LinearJogAxis as L};

use crate::desk::{Desk, assert_near, jog, slide};

#[test]
fn a_jog_may_begin_where_there_is_room_to_stop() {
    let desk = Desk::with_joints(120.0, 20.0, 30.0);
    desk.allows(jog(J::BasePlus, 100.0));
    let near = Desk::with_joints(131.0, 20.0, 30.0);
    near.refuses("joints.base", jog(J::BasePlus, 100.0));
    near.allows(jog(J::BasePlus, 10.0));
    near.allows(jog(J::BaseMinus, 100.0));
}

#[test]
fn a_linear_jog_stops_above_the_table() {
    let desk = Desk::at(200.0, 0.0, 0.0);
    desk.allows(slide(L::ZMinus, 100.0));
    let low = Desk::at(200.0, 0.0, -55.0);
    let violation = low.refuses("table", slide(L::ZMinus, 100.0));
    assert_near(violation.nearest.expect("a place")[2], -63.0, 0.03);
    let text = violation.to_string();
    assert!(
        text.starts_with("before the jog can be stopped, z would be -"),
        "{text}"
    );
    low.allows(slide(L::ZMinus, 10.0));
    low.allows(slide(L::ZPlus, 100.0));
}

#[test]
fn a_held_jog_is_never_found_beyond_a_limit() {
    // 15 degrees/s; at every status, 80 ms apart, the path of a quarter of a second ahead is
    // checked. From the first refusal it takes the whole reaction time and the deceleration to
    // stop.
    let desk = Desk::with_joints(100.0, 20.0, 30.0);
    let hold = Command::from(jog(J::BasePlus, 100.0));
    let reaction_s = desk.policy.jog.reaction_s;
    let mut base_deg = 100.0;
    let at = |base_deg: f64| Desk::with_joints(base_deg, 20.0, 30.0).model;
    while desk
        .policy
        .check_jog(&at(base_deg), &hold, reaction_s)
        .is_ok()
    {
        base_deg += 15.0 * 0.08;
    }
    let end_deg = base_deg - 15.0 * 0.08 + 15.0 * (reaction_s) + 15.0 * 15.0 / (2.0 * 50.0);
    assert!(end_deg <= 135.0, "{end_deg}");
    assert!(base_deg > 120.0, "{base_deg}");
}

#[test]
fn a_longer_silence_needs_more_room() {
    let desk = Desk::with_joints(122.0, 20.0, 30.0);
    let hold = Command::from(jog(J::BasePlus, 100.0));
    let allowed = |within_s| desk.policy.check_jog(&desk.model, &hold, within_s).is_ok();
    assert!(allowed(desk.policy.jog.dead_man_s));
    assert!(!allowed(desk.policy.jog.raw_dead_man_s));
}

#[test]
fn an_arm_outside_may_be_jogged_back_in() {
    let desk = Desk::with_joints(150.0, 20.0, 30.0);
    desk.allows(jog(J::BaseMinus, 100.0));
    desk.refuses("joints.base", jog(J::BasePlus, 1.0));
    let low = Desk::at(200.0, 0.0, -80.0);
    low.allows(slide(L::ZPlus, 100.0));
    low.refuses("table", slide(L::ZMinus, 1.0));
}

#[test]
fn stops_and_releases_are_allowed_anywhere() {
    let mut desk = Desk::with_joints(170.0, 20.0, 30.0);
    desk.policy.laser.allowed = false;
    desk.model = held(&desk.model, jog(J::BasePlus, 100.0).into());
    for axis in [J::Released, J::LaserOff, J::SuctionOff] {
        desk.allows(jog(axis, 0.0));
    }
}

#[test]
fn a_jog_that_reverses_first_coasts_in_the_old_direction() {
    let mut desk = Desk::with_joints(133.5, 20.0, 30.0);
    desk.allows(jog(J::BaseMinus, 100.0));
    // At 15 degrees/s with 50 degrees/s2 it goes 2.25 degrees on before it turns.
    desk.model = held(&desk.model, jog(J::BasePlus, 100.0).into());
    desk.refuses("joints.base", jog(J::BaseMinus, 100.0));
}

#[test]
fn the_gripper_moves_nothing_else() {
    Desk::with_joints(150.0, 20.0, 30.0).allows(jog(J::GripperOpen, 100.0));
}

/// Returns the model during a jog that continues, at the same position.
fn held(model: &Model, command: Command) -> Model {
    let trajectory = model.trajectory(&command).expect("a jog");
    model.after(&command, &trajectory)
}
