//! `dobot decode`.

use serde_json::Value;

use crate::support::program::{dobot, dobot_reading};

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
fn a_binary_capture_with_noise_is_listed_with_all_offsets() {
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
        .filter_map(|line| line["offset"].as_u64())
        .collect();
    assert_eq!(offsets, [0, 3, 45, 87], "{outcome:?}");
    assert_eq!(lines[0]["skipped_bytes"], 3);
    assert_eq!(lines[1]["command"]["x_mm"], 200.0);
    let error = lines[2]["error"].as_str().expect("7 is no moving mode");
    assert!(error.contains("float 8"), "{error}");
    assert_eq!(lines[3]["skipped_bytes"], 1);
}

#[test]
fn statuses_are_distinguished_from_commands() {
    // Rear arm upright, forearm level: x = 160 + 55.07, z = 135.
    let floats: [f32; 10] = [215.07, 0.0, 135.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    let body = floats.iter().flat_map(|float| float.to_le_bytes());
    let bytes: Vec<u8> = [0xA5].into_iter().chain(body).chain([0x5A]).collect();
    let outcome = dobot_reading(&["decode", "-"], &bytes).succeeds();
    assert!(outcome.stdout.contains("status"), "{outcome:?}");
    assert!(outcome.stdout.contains("suction on"), "{outcome:?}");
}

#[test]
fn a_file_without_a_packet_is_an_error() {
    dobot(&["decode", "a5 00 5a"]).fails(1, &["no packet in 3 bytes", "42 bytes"]);
    dobot(&["decode", "a5 0"]).fails(1, &["3 hex digits"]);
    dobot(&["decode", "hello"]).fails(1, &["line 1: `hello` is not hex digits", "xxd"]);
    dobot(&["decode", "no-such-file.bin"]).fails(1, &["no file no-such-file.bin"]);
    dobot_reading(&["decode", "-"], b"").fails(1, &["the input is empty"]);
}

/// A packet as hex digits.
fn packet(floats: [f32; 10]) -> String {
    let body = floats.iter().flat_map(|float| float.to_le_bytes());
    let bytes: Vec<u8> = [0xA5].into_iter().chain(body).chain([0x5A]).collect();
    hex(&bytes)
}

/// A command with floats 3 and 4 of state 10, as the vendor's client sends it: float 5 is 0.
fn sliders() -> String {
    packet([10.0, 0.0, 58.0, 38.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
}

#[test]
fn both_directions_in_one_file_are_distinguished_packet_by_packet() {
    let status = packet([215.07, 0.0, 135.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    let bad = packet([263.66, 0.0, 135.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    let digits = [status.clone(), bad, hex(&target(0.0)), status].join("\n");
    let outcome = dobot_reading(&["decode", "-"], digits.as_bytes()).succeeds();
    let lines: Vec<&str> = outcome.stdout.lines().collect();
    let expected = [
        "     0  status  x 215.07 mm",
        "    42  damaged status",
        "    84  move_to",
        "   126  status",
    ];
    assert_eq!(lines.len(), 4, "{outcome:?}");
    for (line, expected) in lines.iter().zip(expected) {
        assert!(line.starts_with(expected), "{line}");
    }
}

#[test]
fn a_status_of_an_arm_that_has_lost_its_pose_is_shown() {
    let nan = f32::NAN;
    let lost = packet([nan, nan, nan, nan, 0.0, nan, nan, 0.0, 0.0, 0.0]);
    let text = dobot(&["decode", "--sender", "arm", &lost]).succeeds();
    for part in [
        "status with a lost pose (NaN)",
        "x NaN mm",
        "base 0°",
        "suction off",
    ] {
        assert!(text.stdout.contains(part), "{part}: {text:?}");
    }
    let json = dobot(&["decode", "--sender", "arm", &lost, "--json"]).succeeds();
    let json: Value = serde_json::from_str(&json.stdout).expect("it is JSON");
    assert_eq!(json["pose_lost"], true);
    assert_eq!(json["status"]["x_mm"], Value::Null);
}

#[test]
fn packets_that_a_stock_arm_accepts_against_the_tables_are_marked() {
    let stock = dobot(&["decode", &sliders(), "--dialect", "firmware-1.1"]).succeeds();
    let expected = "not allowed: float 5 (teaching speed) is 0; Table 3.9 allows above 0 to 100 (percent); \
                    an arm as sold executes it";
    assert!(stock.stdout.contains(expected), "{stock:?}");
    let other = dobot(&["decode", &sliders(), "--dialect", "specification"]).succeeds();
    assert!(!other.stdout.contains("takes it"), "{other:?}");
    let hangs = packet([11.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    let hangs = dobot(&["decode", &hangs, "--dialect", "firmware-1.1"]).succeeds();
    assert!(
        hangs.stdout.contains("not allowed") && !hangs.stdout.contains("takes it"),
        "{hangs:?}"
    );
}

/// A sample in the tests' folder.
pub(crate) fn sample(name: &str) -> String {
    format!(
        "{}/tests/process/samples/decode/{name}",
        env!("CARGO_MANIFEST_DIR")
    )
}

/// The samples hold the same command and the same status of a real arm, as the tools print them; three
/// of them after 96 zeros.
#[test]
fn the_output_of_the_usual_tools_is_read() {
    for (name, format, zeros) in [
        ("packets.bin", None, 0),
        ("xxd.txt", Some("xxd"), 0),
        ("xxd-p.txt", None, 0),
        ("xxd-i.txt", Some("a list of numbers"), 0),
        ("hexdump-C.txt", Some("hexdump -C"), 96),
        ("od.txt", Some("od -t x1"), 96),
        ("od-A-x.txt", Some("od -t x1"), 96),
        ("od-A-d-z.txt", Some("od -t x1"), 0),
        ("od-An.txt", None, 0),
        ("python.txt", Some("Python bytes"), 0),
        ("list.txt", Some("a list of numbers"), 0),
    ] {
        let outcome = dobot(&["decode", &sample(name), "--json"]).succeeds();
        let lines: Vec<Value> = json_lines(&outcome.stdout);
        let packets: Vec<_> = lines
            .iter()
            .filter(|line| line["skipped_bytes"].is_null())
            .collect();
        assert_eq!(packets.len(), 2, "{name}: {outcome:?}");
        assert_eq!(packets[0]["offset"], zeros, "{name}");
        assert_eq!(packets[0]["command"]["y_mm"], -50.0, "{name}");
        assert_eq!(packets[1]["offset"], zeros + 42, "{name}");
        assert_eq!(packets[1]["status"]["base_deg"], -33.0, "{name}");
        match format {
            None => assert_eq!(outcome.stderr, "", "{name}"),
            Some(format) => assert!(outcome.stderr.contains(format), "{name}: {outcome:?}"),
        }
    }
}

#[test]
fn the_directions_and_times_of_socat_are_kept() {
    let outcome = dobot(&["decode", &sample("socat.txt")]).succeeds();
    let lines: Vec<&str> = outcome.stdout.lines().collect();
    assert_eq!(lines.len(), 2, "{outcome:?}");
    assert!(
        lines[0].starts_with("2026/11/22 11:57:59.000792546  >  move_to"),
        "{outcome:?}"
    );
    assert!(
        lines[1].starts_with("2026/11/22 11:58:00.000097146  <  status"),
        "{outcome:?}"
    );
    let json = json_lines(
        &dobot(&["decode", &sample("socat.txt"), "--json"])
            .succeeds()
            .stdout,
    );
    assert_eq!(json[0]["direction"], ">");
    assert_eq!(json[1]["at"], "2026/11/22 11:58:00.000097146");
    // With -v there is text after the digits.
    let verbose = dobot(&["decode", &sample("socat-v.txt")]).succeeds();
    assert_eq!(verbose.stdout.lines().count(), 2, "{verbose:?}");
}

#[test]
fn an_unknown_format_is_reported_with_those_that_were_tried() {
    let words = b"0000000 00a5 4000 0040\n0000010\n";
    dobot_reading(&["decode", "-"], words)
        .fails(1, &["line 1: `00a5`", "hexdump -C", "od -t x1", "socat -x"]);
    let noise = [0xFE, 0x00, 0xFD];
    dobot_reading(&["decode", "-"], &noise).fails(1, &["no packet in 3 bytes, read as binary"]);
}

pub(crate) fn json_lines(text: &str) -> Vec<Value> {
    let lines = text.lines();
    lines
        .map(|line| serde_json::from_str(line).expect("each line is JSON"))
        .collect()
}
