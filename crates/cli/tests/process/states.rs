//! Every state of the protocol has a verb, and the arm gets its packet.

use dobot_wire::{
    Command, Gesture, JointJogAxis, LinearJogAxis, MouseMove, MoveTo, MovingMode, Voice, WriteMode,
    WriteVector,
};

use crate::support::arm::{WiredArm, real_time_arm};
use crate::support::program::dobot;

/// What an arm of this kind got by a verb. It keeps to a clock, as a jog does.
fn packets(dialect: &str, verb: &[&str]) -> Vec<Command> {
    let serve = ["--tcp", "127.0.0.1:0", "--personality", dialect];
    let arm = WiredArm::new(real_time_arm(&serve));
    let to = [
        "--to",
        &arm.address,
        "--dialect",
        dialect,
        "--pose-confirmed",
    ];
    dobot(&[verb, &to].concat()).succeeds();
    arm.got()
}

#[track_caller]
fn gets(verb: &[&str], expected: impl Into<Command>) {
    let packets = packets("specification", verb);
    let expected = expected.into();
    assert!(
        packets.contains(&expected),
        "{expected:?} is missing: {packets:?}"
    );
}

#[test]
fn a_mouse_moves_by_an_increment() {
    let verb = ["mouse", "-12", "3", "4.5", "--rotation", "10", "--suction"];
    let expected = MouseMove {
        y: 3.0,
        x: -12.0,
        z: 4.5,
        rotation_deg: 10.0,
        suction: true,
    };
    gets(&[&verb[..], &["on"]].concat(), expected);
}

#[test]
fn a_hand_guides_the_arm_to_its_place() {
    let expected = Gesture {
        x: 230.0,
        y: -20.0,
        z: 30.0,
        grab: true,
    };
    gets(&["hand", "230", "-20", "30", "--grab", "on"], expected);
}

#[test]
fn a_vector_is_drawn_with_its_speeds() {
    let verb = ["vector", "10", "-5", "0", "--speed", "15", "--start-speed"];
    let expected = WriteVector {
        mode: WriteMode::Writing,
        start_speed_mm_s: 2.0,
        ..WriteVector::by(10.0, -5.0, 0.0, 15.0)
    };
    gets(&[&verb[..], &["2"]].concat(), expected);
}

#[test]
fn a_vector_burns_only_with_the_laser_armed() {
    let burn = ["vector", "-5", "10", "0", "--burn"];
    let verb = [&burn[..], &["--arm-laser", "60"]].concat();
    gets(&verb, WriteVector::by(-5.0, 10.0, 0.0, 20.0).burning());
    dobot(&["vector", "0", "20", "0", "--arm-laser", "60"]).fails(2, &["--burn"]);
}

#[test]
fn words_are_sent_as_text_to_an_arm_with_voice_support() {
    let voice = Voice::new("left ten").expect("it is ASCII");
    gets(&["say", "left", "ten"], voice);
    gets(&["say", "left ten"], voice);
}

#[test]
fn words_become_a_straight_line_for_a_stock_arm_over_usb() {
    let packets = packets("firmware-1.1", &["say", "up twelve"]);
    // By the specification's reading, MOVL of a stock arm is MOVJ.
    let is_up = |command: &&Command| match command {
        Command::MoveTo(MoveTo { z_mm, mode, .. }) => {
            // It rests with both arms at 45 degrees, at -17.68 mm.
            (*z_mm + 17.678 - 12.0).abs() < 0.01 && *mode != MovingMode::Jump
        }
        _ => false,
    };
    assert!(packets.iter().any(|command| is_up(&command)), "{packets:?}");
    assert!(
        !packets
            .iter()
            .any(|command| matches!(command, Command::Voice(_))),
        "{packets:?}"
    );
}

#[test]
fn words_that_a_voice_command_cannot_express_are_refused_with_those_it_can() {
    dobot(&["say", "sideways ten"]).fails(2, &["ahead, back, left", "a number"]);
    dobot(&["say", "left 10"]).fails(2, &["`left` needs one number in words", "`left ten`"]);
    dobot(&["say", "stock", "--dialect", "firmware-1.1"]).fails(2, &["ahead, back, left"]);
    dobot(&["say", "grüezi"]).fails(2, &["ASCII"]);
    let long = "left ".repeat(9);
    dobot(&["say", &long]).fails(2, &["45", "40"]);
}

#[test]
fn the_linear_jog_moves_the_axes_common_to_both_jogs() {
    for (button, axis) in [
        ("servo+", LinearJogAxis::ServoPlus),
        ("gripper-", LinearJogAxis::GripperClose),
        ("suction-on", LinearJogAxis::SuctionOn),
    ] {
        let packets = packets(
            "specification",
            &["jog", button, "--frame", "linear", "--for", "1"],
        );
        let is_match =
            |command: &Command| matches!(command, Command::LinearJog(jog) if jog.axis == axis);
        assert!(packets.iter().any(is_match), "{button}: {packets:?}");
    }
}

#[test]
fn a_laser_switched_on_by_the_linear_jog_is_switched_off_again() {
    let verb = ["jog", "laser-on", "--frame", "linear", "--for", "0.2"];
    let folder = tempfile::tempdir().expect("there is room");
    let policy = folder.path().join("policy.toml");
    std::fs::write(&policy, "[laser]\nstanding = true\n").expect("there is room");
    let policy = policy.to_str().expect("the path is text");
    let allowed = ["--arm-laser", "60", "--policy", policy];
    let packets = packets("specification", &[&verb[..], &allowed].concat());
    let on = packets.iter().position(
        |command| matches!(command, Command::LinearJog(jog) if jog.axis == LinearJogAxis::LaserOn),
    );
    let on = on.unwrap_or_else(|| panic!("the laser was never on: {packets:?}"));
    let is_off = |command: &Command| match command {
        Command::LinearJog(jog) => jog.axis == LinearJogAxis::LaserOff,
        Command::JointJog(jog) => jog.axis == JointJogAxis::LaserOff,
        _ => false,
    };
    assert!(packets[on..].iter().any(is_off), "{packets:?}");
}

#[test]
fn an_axis_of_the_other_jog_is_refused() {
    dobot(&["jog", "x+", "--frame", "joint"]).fails(2, &["linear jog", "--frame"]);
    dobot(&["jog", "rear-", "--frame", "linear"]).fails(2, &["joint jog", "--frame"]);
}

#[test]
fn a_packet_that_would_hang_a_stock_arm_is_not_sent() {
    let stock = ["--dialect", "firmware-1.1"];
    dobot(&[&["mouse", "0", "0", "0"][..], &stock].concat()).fails(1, &["hang"]);
    dobot(&["vector", "0", "0", "0"]).fails(1, &["N16", "0.0001"]);
    dobot(&["mouse", "nan", "0", "0"]).fails(2, &["'nan'", "finite number"]);
    dobot(&["hand", "500", "0", "0"]).fails(1, &[]);
}
