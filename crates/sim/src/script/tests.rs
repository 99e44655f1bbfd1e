use proptest::prelude::*;

use super::*;

fn problem(line: &str) -> String {
    let script = format!("# the first line\n{line}\n");
    let error = Script::parse(&script).unwrap_err();
    assert_eq!(error.line, 2, "{line}: {error}");
    error.problem.to_string()
}

#[track_caller]
fn expect_problem(line: &str, parts: &[&str]) {
    let problem = problem(line);
    for part in parts {
        assert!(
            problem.contains(part),
            "{line}: `{part}` is missing: {problem}"
        );
    }
}

fn only_line(text: &str) -> ScriptLine {
    let script = Script::parse(text).unwrap();
    assert_eq!(script.lines.len(), 1);
    script.lines[0].clone()
}

#[test]
fn directives_set_the_end_the_pose_and_the_port() {
    let script = Script::parse("# words\n!end 1500\n\n!pose 60 -30.5\r\n  !port bt \n").unwrap();
    assert_eq!(script.end, Some(Duration::from_millis(1500)));
    assert_eq!((script.rear_deg, script.fore_deg), (60.0, -30.5));
    assert_eq!(script.port, Port::Bluetooth);
    assert_eq!(script.lines, []);
}

#[test]
fn a_script_that_says_nothing_is_for_usb_and_the_usual_pose() {
    let script = Script::parse("").unwrap();
    assert_eq!(script.end, None);
    assert_eq!((script.rear_deg, script.fore_deg), (45.0, 45.0));
    assert_eq!(script.port, Port::Usb);
}

#[test]
fn ten_floats_are_a_packet() {
    // By hand: 1.0 is 3F80 0000, -2.5 is C020 0000, and so on, the least byte first.
    let line = only_line("100 1 -2.5 0 0 0 0 0 0 nan inf");
    assert_eq!(line.start, Start::At(Duration::from_millis(100)));
    let mut bytes = vec![0xA5, 0, 0, 0x80, 0x3F, 0, 0, 0x20, 0xC0];
    bytes.extend([0; 24]);
    bytes.extend([0, 0, 0xC0, 0x7F, 0, 0, 0x80, 0x7F, 0x5A]);
    assert_eq!(line.bytes, bytes);
}

#[test]
fn raw_lines_are_bytes_as_they_stand() {
    let line = only_line("raw credit 00 A5ff f:1 3*0102 f:-2.5");
    assert_eq!(line.start, Start::Credit);
    let expected = [
        0, 0xA5, 0xFF, 0, 0, 0x80, 0x3F, 1, 2, 1, 2, 1, 2, 0, 0, 0x20, 0xC0,
    ];
    assert_eq!(line.bytes, expected);
}

#[test]
fn a_voice_line_is_a_packet_of_text() {
    let line = only_line("voice 12.5  Left twenty five ");
    assert_eq!(line.start, Start::At(Duration::from_micros(12_500)));
    assert_eq!(line.bytes.len(), 42);
    assert_eq!((line.bytes[0], line.bytes[41]), (0xB5, 0x5B));
    assert_eq!(&line.bytes[1..17], b"Left twenty five");
    assert!(line.bytes[17..41].iter().all(|&it| it == 0));
}

#[test]
fn an_invalid_line_is_reported_with_the_allowed_forms() {
    expect_problem(
        "jump 3",
        &["begins with `jump`", "`credit`, `raw`, `voice`"],
    );
    expect_problem("!stop 3", &["`!stop`", "`!end MS`"]);
    expect_problem("!end", &["ends before a time"]);
    expect_problem("!end soon", &["`soon`", "0 to 86400000"]);
    expect_problem("!end -1", &["`-1`"]);
    expect_problem("!end 5 6", &["`6`", "nothing more"]);
    expect_problem("!pose 45", &["ends before a tilt sensor's angle"]);
    expect_problem("!pose 45 nan", &["`nan`", "-180 to 180"]);
    expect_problem("!pose 181 0", &["`181`"]);
    expect_problem("!port usb3", &["`usb3`", "`usb` and `bt`"]);
}

#[test]
fn times_that_cannot_be_are_refused() {
    for time in ["-5", "nan", "86400001", "1e9", "99999999", "1:30", "5ms"] {
        let text = problem(&format!("{time} 0 0 0 0 0 0 0 0 0 0"));
        assert!(text.contains(time), "{text}");
    }
    expect_problem("raw -1 00", &["`-1`", "`credit`"]);
    expect_problem("voice", &["ends before a time"]);
}

#[test]
fn a_packet_has_ten_floats_that_fit() {
    expect_problem("5 1 2 3", &["3 floats", "10"]);
    expect_problem("credit 1 2 3 4 5 6 7 8 9 10 11 12", &["12 floats"]);
    expect_problem("5 1 2 x 4 5 6 7 8 9 10", &["float 3", "`x`"]);
    expect_problem(
        "5 1 2 1e40 4 5 6 7 8 9 10",
        &["float 3", "`1e40`", "four bytes"],
    );
}

#[test]
fn bytes_are_hex_floats_and_repeats() {
    for word in [
        "0", "0g", "f:", "f:x", "f:1e40", "*00", "0*00", "2*", "70000*00", "+2*00", "é",
    ] {
        expect_problem(
            &format!("raw 5 00 {word}"),
            &["word 2", word, "two hex digits"],
        );
    }
    expect_problem("raw 5", &["ends before a byte"]);
    expect_problem("raw 5 40000*00 40000*00", &["word 2"]);
}

#[test]
fn a_text_is_up_to_40_printable_bytes() {
    expect_problem("voice 5", &["ends before a text"]);
    expect_problem(&format!("voice 5 {}", "x".repeat(41)), &["41"]);
    expect_problem("voice 5 à gauche", &["byte 1"]);
    assert_eq!(
        only_line(&format!("voice 5 {}", "x".repeat(40)))
            .bytes
            .len(),
        42
    );
}

#[test]
fn a_directive_is_allowed_once_and_time_does_not_decrease() {
    let twice = Script::parse("!end 5\n!end 5").unwrap_err();
    assert_eq!(
        twice.to_string(),
        "line 2: `!end` is repeated; it is allowed once"
    );
    let back = Script::parse("raw 200 00\nraw credit 00\nraw 199.5 00").unwrap_err();
    assert_eq!(back.line, 3);
    assert!(back.to_string().contains("199.5 ms"), "{back}");
    assert!(back.to_string().contains("at 200 ms"), "{back}");
    assert!(Script::parse("raw 200 00\nraw 200 00").is_ok());
}

proptest! {
    #[test]
    fn no_text_makes_it_panic(text in "\\PC{0,80}") {
        let _ = Script::parse(&text);
    }

    #[test]
    fn no_words_make_it_panic(
        words in prop::collection::vec(
            prop::sample::select(vec![
                "\n", "!end", "!pose", "!port", "raw", "voice", "credit", "5", "-1", "nan", "f:",
                "f:1", "3*00", "9999999999999999999999*00", "A5", "*", "#", "é", "1e999", "\0",
            ]),
            0..40,
        )
    ) {
        let _ = Script::parse(&words.join(" "));
    }

    #[test]
    fn what_is_written_as_floats_is_sent_as_these_floats(
        floats in prop::collection::vec(any::<f32>(), 10),
        ms in 0_u32..86_400_000,
    ) {
        let words: Vec<_> = floats.iter().map(|it| format!("{it:?}")).collect();
        let line = only_line(&format!("{ms} {}", words.join(" ")));
        prop_assert_eq!(line.start, Start::At(Duration::from_millis(ms.into())));
        for (float, bytes) in floats.iter().zip(line.bytes[1..].chunks_exact(4)) {
            let found = f32::from_le_bytes(bytes.try_into().unwrap());
            prop_assert!(found == *float || found.is_nan() && float.is_nan());
        }
    }
}
