use dobot_course::Settings;
use dobot_safety::Policy;
use dobot_wire::{Dialect, Frame, Packet, Voice};

use super::amended;

fn frame(floats: &[f32]) -> Frame {
    let floats = (1..).zip(floats);
    floats.fold(Frame::ZERO, |frame, (n, value)| frame.with(n, *value))
}

/// What becomes of a packet on a stock arm that was just switched on.
fn sent(floats: &[f32]) -> Option<(Frame, String)> {
    let dialect = Dialect::FIRMWARE_1_1;
    let packet = frame(floats).into();
    let settings = Settings::stock(&dialect);
    let (packet, told) = amended(&packet, &settings, &dialect, &Policy::default())?;
    let Packet::Frame(frame) = packet else {
        panic!("a frame stays one");
    };
    Some((frame, told))
}

#[test]
fn the_sliders_of_the_vendors_client_keep_the_teaching_speed_in_force() {
    let (packet, told) = sent(&[10.0, 0.0, 58.0, 38.0, 0.0]).unwrap();
    assert_eq!(packet, frame(&[10.0, 0.0, 58.0, 38.0, 100.0]));
    assert_eq!(
        told,
        "state 10: float 5 (teaching speed) is 0; 100, which is in force, is sent"
    );
}

#[test]
fn the_start_of_the_vendors_demo_for_arduino_sets_what_it_names_and_keeps_the_rest() {
    let (packet, _) = sent(&[9.0, 0.0, 50.0, 100.0]).unwrap();
    let kept = [9.0, 0.0, 50.0, 100.0, 30.0, 50.0, 60.0, 60.0];
    assert_eq!(packet, frame(&kept));
}

#[test]
fn speeds_above_the_policy_come_down_to_it_and_the_height_of_a_jump_is_kept() {
    // As programs of the pyDobot family begin; 50 % of it counts, so twice the ceiling may be set.
    let asked = [
        9.0, 1.0, 200.0, 200.0, 200.0, 200.0, 800.0, 1000.0, 0.0, 50.0,
    ];
    let (packet, told) = sent(&asked).unwrap();
    let most_mm_s = 2.0 * Policy::default().speed.line_mm_s;
    assert!((f64::from(packet.float(7)) - most_mm_s).abs() < 1e-3);
    assert_eq!(packet.float(10), 50.0);
    assert_eq!([packet.float(3), packet.float(9)], [200.0, 0.0]);
    assert!(
        told.contains("float 7 (max linear moving speed) is 800"),
        "{told}"
    );
    // What comes down once stays as it is.
    assert_eq!(sent(packet.floats()), None);
}

#[test]
fn what_is_allowed_and_what_is_no_setting_stays_as_it_is() {
    assert_eq!(sent(&[10.0, 0.0, 50.0, 50.0, 100.0]), None);
    assert_eq!(
        sent(&[9.0, 1.0, 60.0, 60.0, 60.0, 60.0, 60.0, 60.0, 0.0, 0.0]),
        None
    );
    for state in [0.0, 1.0, 2.0, 3.0, 4.0, 6.0, 7.0, 8.0, f32::NAN] {
        assert_eq!(sent(&[state, 0.0, 1e9, 1e9]), None);
    }
    let settings = Settings::stock(&Dialect::FIRMWARE_1_1);
    let voice = Packet::Voice(Voice::new("left ten").unwrap());
    let dialect = Dialect::FIRMWARE_1_1;
    assert_eq!(
        amended(&voice, &settings, &dialect, &Policy::default()),
        None
    );
}
