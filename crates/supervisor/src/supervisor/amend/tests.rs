use dobot_arm::{Joints, Tool};
use dobot_motion::{ArmPlace, Model};
use dobot_safety::Policy;
use dobot_wire::{Dialect, Frame, Packet, Voice};

use super::amended;

fn frame(floats: &[f32]) -> Frame {
    let floats = (1..).zip(floats);
    floats.fold(Frame::ZERO, |frame, (n, value)| frame.with(n, *value))
}

/// An arm at rest, with its pump on and its gripper at 20 degrees.
fn model(dialect: Dialect) -> Model {
    let here = ArmPlace::at_joints(Joints::new(0.0, 45.0, 45.0, 0.0), Tool::SuctionCup);
    let mut model = Model::standing(dialect, here);
    model.suction = true;
    model.gripper_deg = 20.0;
    model
}

/// Returns the packet sent to a stock arm that was just switched on.
fn sent(floats: &[f32]) -> Option<(Frame, String)> {
    let packet = frame(floats).into();
    let model = model(Dialect::FIRMWARE_1_1);
    let (packet, text) = amended(&packet, &model, &Policy::default())?;
    let Packet::Frame(frame) = packet else {
        panic!("a frame stays one");
    };
    Some((frame, text))
}

#[test]
fn the_sliders_of_the_vendors_client_keep_the_teaching_speed_in_force() {
    let (packet, text) = sent(&[10.0, 0.0, 58.0, 38.0, 0.0]).unwrap();
    assert_eq!(packet, frame(&[10.0, 0.0, 58.0, 38.0, 100.0]));
    assert_eq!(
        text,
        "state 10: float 5 (teaching speed) is 0; Table 3.9 allows above 0 to 100 (percent); \
         a stock arm does not look at it, and 100, which is in force, is sent"
    );
}

#[test]
fn the_start_of_the_vendors_demo_for_arduino_sets_the_given_values_and_keeps_the_rest() {
    let (packet, _) = sent(&[9.0, 0.0, 50.0, 100.0]).unwrap();
    let kept = [9.0, 0.0, 50.0, 100.0, 30.0, 50.0, 60.0, 60.0];
    assert_eq!(packet, frame(&kept));
}

#[test]
fn speeds_above_the_policy_are_reduced_to_it_and_the_height_of_a_jump_is_kept() {
    // As programs of the pyDobot family begin; 50 % of it applies, so twice the ceiling may be set.
    let asked = [
        9.0, 1.0, 200.0, 200.0, 200.0, 200.0, 800.0, 1000.0, 0.0, 50.0,
    ];
    let (packet, text) = sent(&asked).unwrap();
    let most_mm_s = 2.0 * Policy::default().speed.line_mm_s;
    assert!((f64::from(packet.float(7)) - most_mm_s).abs() < 1e-3);
    assert_eq!(packet.float(10), 50.0);
    assert_eq!([packet.float(3), packet.float(9)], [200.0, 0.0]);
    assert!(
        text.contains("float 7 (max linear moving speed) is 800"),
        "{text}"
    );
    // A reduced packet is not changed again.
    assert_eq!(sent(packet.floats()), None);
}

#[test]
fn allowed_settings_and_other_packets_are_unchanged() {
    assert_eq!(sent(&[10.0, 0.0, 50.0, 50.0, 100.0]), None);
    let moderate = [9.0, 1.0, 60.0, 60.0, 60.0, 60.0, 60.0, 60.0, 0.0, 0.0];
    assert_eq!(sent(&moderate), None);
    for state in [0.0, 1.0, 2.0, 3.0, 6.0, 7.0, 8.0, f32::NAN] {
        assert_eq!(sent(&[state, 0.0, 1e9, 1e9]), None);
    }
    let voice = Packet::Voice(Voice::new("left ten").unwrap());
    let model = model(Dialect::FIRMWARE_1_1);
    assert_eq!(amended(&voice, &model, &Policy::default()), None);
}

#[test]
fn an_invalid_pump_value_keeps_pump_and_gripper_unchanged() {
    for state in [3.0, 6.0] {
        for grab in [0.5, 2.0, -1.0] {
            let (packet, text) = sent(&[state, 0.0, 1.0, 2.0, 3.0, 4.0, grab, 2.0, 5.0]).unwrap();
            let kept = [state, 0.0, 1.0, 2.0, 3.0, 4.0, 1.0, 2.0, 20.0];
            assert_eq!(packet, frame(&kept), "{grab}");
            let expected = format!(
                "state {state}: float 7 (isGrab) is {grab}; Table 3.7 allows 0 (off) or 1 (on); \
                 a stock arm leaves pump and gripper as they are, \
                 and 1, with 20 in float 9 (GripperValue), as they are, is sent"
            );
            assert_eq!(text, expected);
        }
    }
}

#[test]
fn a_gripper_that_would_open_too_far_opens_to_its_limit() {
    let (packet, text) = sent(&[3.0, 0.0, 1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 130.0]).unwrap();
    assert_eq!([packet.float(7), packet.float(9)], [0.0, 90.0]);
    assert_eq!(
        text,
        "state 3: float 9 (GripperValue) is 130; Table 3.7 allows -90 to 90 (degrees); \
         a stock arm drives the gripper's servo against its end, and 90 is sent"
    );
}

#[test]
fn a_jog_at_no_speed_is_a_release_and_one_that_is_too_fast_gets_the_highest_speed() {
    for state in [2.0, 7.0] {
        let (packet, text) = sent(&[state, 3.0]).unwrap();
        assert_eq!(packet, frame(&[state]));
        assert!(
            text.ends_with("a stock arm stands still, and a release is sent"),
            "{text}"
        );
        let (packet, text) = sent(&[state, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 130.0]).unwrap();
        assert_eq!(packet, frame(&[state, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 100.0]));
        assert_eq!(
            text,
            format!(
                "state {state}: float 8 (StarVel) is 130; the policy allows 100, which is sent"
            )
        );
    }
}

#[test]
fn a_pen_that_is_too_fast_is_slowed_to_the_ceiling_and_a_laser_is_not() {
    let vector = [4.0, 0.0, 10.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 4200.0];
    let (packet, _) = sent(&vector).unwrap();
    assert!((f64::from(packet.float(10)) - Policy::default().speed.writing_mm_s).abs() < 1e-3);
    assert_eq!(
        sent(&[4.0, 1.0, 10.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 4200.0]),
        None
    );
}

#[test]
fn a_packet_that_is_refused_anyway_is_refused_unchanged() {
    for floats in [
        // Each has a value that would be replaced, and a trap (note N51).
        [3.0, 0.0, 1.0, 2.0, 3.0, 0.0, 0.5, 3.0, 130.0, 0.0],
        [2.0, 15.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [10.0, 0.0, 0.0, 50.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0; 10],
        [15.0, 0.0, 45.0, 45.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    ] {
        assert_eq!(sent(&floats), None, "{floats:?}");
    }
}
