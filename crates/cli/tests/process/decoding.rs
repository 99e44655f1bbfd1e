//! `dobot decode`.

use serde_json::Value;

use crate::program::{dobot, dobot_reading};

/// Go to 200, -50, 20 with the moving mode of float 8, the tool turned by 15 degrees.
fn target(mode: f32) -> Vec<u8> {
    let floats: [f32; 10] = [3.0, 0.0, 200.0, -50.0, 20.0, 15.0, 0.0, mode, 0.0, 0.0];
    let body = floats.iter().flat_map(|float| float.to_le_bytes());
    [0xA5].into_iter().chain(body).chain([0x5A]).collect()
}

fn hex(bytes: &[u8]) -> String {
    use std::fmt::Write;
    bytes.iter().fold(String::new(), |mut text, byte| {
        write!(text, "{byte:02x}").expect("a string takes all");
        text
    })
}

#[test]
fn hex_digits_are_annotated() {
    let outcome = dobot(&["decode", &hex(&target(0.0))]).succeeds();
    assert_eq!(outcome.stdout.lines().count(), 1);
    for part in [
        "move_to",
        "x 200 mm",
        "y -50 mm",
        "z 20 mm",
        "rotation 15°",
        "mode jump",
    ] {
        assert!(outcome.stdout.contains(part), "{part}: {outcome:?}");
    }
}

#[test]
fn a_command_that_the_dialects_read_differently_is_shown_in_both() {
    let both = dobot(&["decode", &hex(&target(1.0))]).succeeds();
    assert!(both.stdout.contains("[specification] move_to"), "{both:?}");
    assert!(both.stdout.contains("[firmware-1.1] move_to"), "{both:?}");
    let one = dobot(&["decode", &hex(&target(1.0)), "--dialect", "firmware-1.1"]).succeeds();
    assert!(one.stdout.contains("mode movj"), "{one:?}");
    assert_eq!(one.stdout.lines().count(), 1);
}

#[test]
fn a_binary_capture_with_noise_says_where_everything_is() {
    let mut capture = vec![0x00, 0xA5, 0x17];
    capture.extend(target(0.0));
    capture.extend(target(7.0));
    capture.push(0xA5);
    let outcome = dobot_reading(&["decode", "-", "--json"], &capture).succeeds();
    let lines: Vec<Value> = outcome
        .stdout
        .lines()
        .map(|line| serde_json::from_str(line).expect("each line is JSON"))
        .collect();
    let offsets: Vec<u64> = lines
        .iter()
        .filter_map(|it| it["offset"].as_u64())
        .collect();
    assert_eq!(offsets, [0, 3, 45, 87], "{outcome:?}");
    assert_eq!(lines[0]["skipped_bytes"], 3);
    assert_eq!(lines[1]["command"]["x_mm"], 200.0);
    let error = lines[2]["error"].as_str().expect("7 is no moving mode");
    assert!(error.contains("float 8"), "{error}");
    assert_eq!(lines[3]["skipped_bytes"], 1);
}

#[test]
fn statuses_are_told_from_commands() {
    // Rear arm upright, forearm level: x = 160 + 55.07, z = 135.
    let floats: [f32; 10] = [215.07, 0.0, 135.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    let body = floats.iter().flat_map(|float| float.to_le_bytes());
    let bytes: Vec<u8> = [0xA5].into_iter().chain(body).chain([0x5A]).collect();
    let outcome = dobot_reading(&["decode", "-"], &bytes).succeeds();
    assert!(outcome.stdout.contains("status"), "{outcome:?}");
    assert!(outcome.stdout.contains("suction on"), "{outcome:?}");
}

#[test]
fn what_holds_no_packet_is_an_error() {
    dobot(&["decode", "a5 00 5a"]).fails(1, &["no packet in 3 bytes", "42 bytes"]);
    dobot(&["decode", "a5 0"]).fails(1, &["3 hex digits"]);
    dobot(&["decode", "hello"]).fails(1, &["hex digit 1 is `h`"]);
    dobot(&["decode", "no-such-file.bin"]).fails(1, &["there is no file no-such-file.bin"]);
    dobot_reading(&["decode", "-"], b"").fails(1, &["no bytes"]);
}
