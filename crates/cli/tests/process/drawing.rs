//! `dobot draw` with a virtual arm in the process.

use std::fs;

use serde_json::Value;

use crate::program::{dobot, dobot_reading, example};

fn report(text: &str) -> Value {
    serde_json::from_str(text).expect("the report is JSON")
}

/// A page in millimetres with that inside.
fn page(inside: &str) -> String {
    format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="60mm" viewBox="0 0 100 60">{inside}</svg>"#
    )
}

#[test]
fn every_bundled_drawing_is_drawn_within_tolerance_of_the_true_position() {
    for entry in fs::read_dir(example("")).expect("it is bundled") {
        let path = entry.expect("it can be read").path();
        if path.extension().is_none_or(|it| it != "svg") {
            continue;
        }
        let file = path.to_str().expect("the path is text");
        for (tolerance, dialect) in [
            ("0.05", "specification"),
            ("0.2", "specification"),
            ("0.05", "firmware-1.1"),
        ] {
            let arguments = ["--tolerance", tolerance, "--dialect", dialect, "--json"];
            let outcome = dobot(&[&["draw", file][..], &arguments].concat()).succeeds();
            let report = report(&outcome.stdout);
            let deviation = report["deviation_mm"].as_f64().expect("a number");
            let allowed = tolerance.parse::<f64>().expect("a number") + 0.05;
            assert!(deviation <= allowed, "{file}: {report}");
            assert_eq!(report["measured_from"], "the arm's true position");
            if dialect == "specification" {
                // The plan is what happens: two statuses pass until the end is seen.
                let [planned, time] =
                    ["planned_s", "time_s"].map(|it| report[it].as_f64().expect("a number"));
                assert!((time - planned).abs() < 1.0, "{file}: {report}");
            }
        }
    }
}

#[test]
fn a_square_is_as_long_as_its_sides() {
    let svg = page(r#"<rect x="10" y="10" width="30" height="20" fill="none" stroke="black"/>"#);
    let report = report(
        &dobot_reading(&["draw", "-", "--json"], svg.as_bytes())
            .succeeds()
            .stdout,
    );
    assert_eq!(report["strokes"], 1);
    assert!(
        (report["drawn_mm"].as_f64().expect("a number") - 100.0).abs() < 1e-3,
        "{report}"
    );
}

#[test]
fn a_picture_comes_out_as_svg_and_as_png() {
    let folder = tempfile::tempdir().expect("there is room");
    for (name, begins) in [("drawn.svg", &b"<svg"[..]), ("drawn.png", b"\x89PNG")] {
        let file = folder.path().join(name);
        let file_text = file.to_str().expect("the path is text");
        dobot(&["draw", &example("square.svg"), "--picture", file_text]).succeeds();
        let bytes = fs::read(&file).expect("it was written");
        assert!(bytes.starts_with(begins), "{name}");
    }
}

#[test]
fn a_picture_that_cannot_be_written_is_told() {
    let arguments = [
        "draw",
        &example("square.svg"),
        "--picture",
        "/no/such/folder/a.svg",
    ];
    dobot(&arguments).fails(1, &["cannot write /no/such/folder/a.svg"]);
}

#[test]
fn size_and_place_are_obeyed() {
    let svg = page(r#"<rect width="40" height="20" fill="none" stroke="black"/>"#);
    for (arguments, drawn_mm) in [
        (&["draw", "-", "--json", "--scale", "0.5"][..], 60.0),
        (&["draw", "-", "--json", "--fit"], 2.0 * (200.0 + 100.0)),
        (&["draw", "-", "--json", "--at", "200", "30"], 120.0),
    ] {
        let outcome = dobot_reading(arguments, svg.as_bytes()).succeeds();
        let found = report(&outcome.stdout)["drawn_mm"]
            .as_f64()
            .expect("a number");
        assert!((found - drawn_mm).abs() < 1e-3, "{arguments:?}: {found}");
    }
}

#[test]
fn bad_drawings_are_one_clear_error_each() {
    let large = r#"<svg xmlns="http://www.w3.org/2000/svg" width="500mm" height="300mm"><rect width="1800" height="1000"/></svg>"#;
    for (svg, parts) in [
        (String::new(), &["-:"][..]),
        ("hello".to_owned(), &["1:1"]),
        ("<svg".to_owned(), &["1:"]),
        ("<html/>".to_owned(), &["html"]),
        (page(""), &["nothing"]),
        (
            page(r#"<path d="M0 0 L10 10 L NaN 5 L20 20" stroke="red"/>"#),
            &["NaN", "1:"],
        ),
        (large.to_owned(), &["--fit"]),
    ] {
        let outcome = dobot_reading(&["draw", "-"], svg.as_bytes()).fails(1, parts);
        assert_eq!(outcome.stdout, "", "{svg}");
    }
    dobot(&["draw", "no-such-file.svg"]).fails(1, &["no-such-file.svg", "hint:"]);
    dobot(&["draw", &example("")]).fails(1, &["cannot read"]);
    dobot_reading(&["draw", "-"], &[0xFF, 0xFE, 0x00]).fails(1, &["is not text"]);
}

#[test]
fn settings_that_make_no_sense_are_told_before_anything_moves() {
    let square = example("square.svg");
    for (option, value, part) in [
        ("--tolerance", "0", "tolerance"),
        ("--tolerance", "nan", "tolerance"),
        ("--speed", "0", "speed"),
        ("--speed", "-5", "speed"),
        ("--acceleration", "inf", "acceleration"),
        ("--scale", "0", "scale"),
        ("--pen-lift", "-10", "lifted"),
        ("--pen-down", "200", "z"),
    ] {
        dobot(&["draw", &square, option, value]).fails(1, &[part]);
    }
    dobot(&["draw", &square, "--at", "400", "0"]).fails(1, &["reach"]);
}
