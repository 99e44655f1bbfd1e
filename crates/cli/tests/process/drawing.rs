//! `dobot draw` with a virtual arm in the process.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use serde_json::Value;

#[cfg(unix)]
use crate::support::program::{Outcome, command};
use crate::support::program::{dobot, dobot_reading, example};
#[cfg(target_os = "linux")]
use crate::support::terminal::Terminal;

fn report(text: &str) -> Value {
    serde_json::from_str(text).expect("the report is JSON")
}

fn number(report: &Value, key: &str) -> f64 {
    report[key]
        .as_f64()
        .unwrap_or_else(|| panic!("{key} of {report} is no number"))
}

/// A page in millimetres with that inside.
fn page(inside: &str) -> String {
    format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="60mm" viewBox="0 0 100 60">{inside}</svg>"#
    )
}

/// Draws every bundled drawing, and checks each against the true position of the arm.
fn draws_every_bundled_drawing(tolerance: &str, dialect: &str) {
    let mut kinds = BTreeSet::new();
    for entry in fs::read_dir(example("")).expect("it is bundled") {
        let path = entry.expect("it can be read").path();
        kinds.insert(path.extension().map(ToOwned::to_owned));
        let file = path.to_str().expect("the path is text");
        let arguments = ["--tolerance", tolerance, "--dialect", dialect, "--json"];
        let outcome = dobot(&[&["draw", file][..], &arguments].concat()).succeeds();
        let report = report(&outcome.stdout);
        let allowed = tolerance.parse::<f64>().expect("a number");
        assert!(
            number(&report, "deviation_mm") <= allowed,
            "{file}: {report}"
        );
        assert_eq!(report["measured_from"], "the arm's true position");
        // Some statuses pass until the end is seen.
        let time_s = number(&report, "time_s");
        let late_s = time_s - number(&report, "planned_s");
        assert!(late_s.abs() < 0.01 * time_s + 0.4, "{file}: {report}");
    }
    let known = ["csv", "dxf", "gcode", "jpg", "json", "lbrn2", "plt", "svg"];
    assert_eq!(kinds, known.map(|kind| Some(kind.into())).into());
}

#[test]
fn a_drawing_without_a_station_reports_that_no_real_arm_draws_it() {
    let drawn = dobot(&["draw", &example("square.svg"), "--pen-down", "-40"]).succeeds();
    assert!(drawn.stderr.contains("no real arm moves"), "{drawn:?}");
    let meant = [
        "draw",
        &example("square.svg"),
        "--pen-down",
        "-40",
        "--to",
        "virtual:",
    ];
    let drawn = dobot(&meant).succeeds();
    assert!(!drawn.stderr.contains("no real arm"), "{drawn:?}");
}

#[test]
fn every_bundled_drawing_of_each_kind_is_drawn_within_tolerance_of_the_true_position() {
    draws_every_bundled_drawing("0.05", "specification");
}

#[test]
fn every_bundled_drawing_is_drawn_within_a_coarse_tolerance() {
    draws_every_bundled_drawing("0.2", "specification");
}

#[test]
fn every_bundled_drawing_is_drawn_within_tolerance_by_a_stock_arm() {
    draws_every_bundled_drawing("0.05", "firmware-1.1");
}

#[test]
fn a_dry_run_has_the_duration_of_the_run_itself() {
    for dialect in ["specification", "firmware-1.1"] {
        let harbour = example("harbour.svg");
        let arguments = ["draw", &harbour, "--dialect", dialect, "--json"];
        let estimated = dobot(&[&arguments[..], &["--dry-run"]].concat()).succeeds();
        let made = dobot(&arguments).succeeds();
        let [estimated, made] = [&estimated, &made].map(|outcome| report(&outcome.stdout));
        // Their statuses may come at other moments.
        let apart_s = number(&estimated, "estimated_s") - number(&made, "time_s");
        assert!(apart_s.abs() < 0.17, "{dialect}: {apart_s}");
        assert_eq!(estimated["time_s"], Value::Null);
    }
}

#[test]
fn a_photo_and_a_text_become_ink_with_one_line_each() {
    let photo = example("still-life.jpg");
    for shade in ["hatch", "lines", "stipple", "outline"] {
        // Dots apart as far as this are few enough for a test.
        let outcome = dobot(&["draw", &photo, "--shade", shade, "--spacing", "4", "--json"]);
        assert!(number(&report(&outcome.succeeds().stdout), "strokes") > 1.0);
    }
    let text = ["draw", "--text", "Hello,\\narm", "--json"];
    for more in [
        &["--font", "script"][..],
        &["--height", "20", "--align", "center"],
    ] {
        let outcome = dobot(&[&text[..], more].concat()).succeeds();
        assert!(number(&report(&outcome.stdout), "drawn_mm") > 50.0);
    }
    for blank in ["", " ", "\\n"] {
        let expected = ["error: text: ", "nothing to draw"];
        dobot(&["draw", "--text", blank]).fails(1, &expected);
    }
}

#[test]
fn several_files_and_a_text_are_placed_on_one_sheet() {
    let folder = tempfile::tempdir().expect("there is a folder");
    let file = |name: &str, text: &str| {
        let file = folder.path().join(name);
        fs::write(&file, text).expect("it can be written");
        file.to_str().expect("it is text").to_owned()
    };
    let line = |x: f64, color: &str| {
        let path = format!(r#"<path d="M{x} 20v20" stroke="{color}" fill="none"/>"#);
        page(&path)
    };
    let left = file("left.svg", &line(10.0, "red"));
    let right = file("right.svg", &line(90.0, "blue"));
    let sides = ["draw", left.as_str(), right.as_str(), "--dry-run", "--json"];
    let drawn = |more: &[&str]| report(&dobot(&[&sides[..], more].concat()).succeeds().stdout);
    let ink = |report: &Value| {
        let ink = report["ink_mm"].as_array().expect("it has four numbers");
        let [x0, y0, x1, y1] = [0, 1, 2, 3].map(|corner| ink[corner].as_f64().expect("a number"));
        ((y1 - y0).round(), (x1 - x0).round())
    };
    // 80 mm apart on their pages; one job with a pass for each colour.
    let pages = drawn(&["--layers", "color"]);
    assert_eq!(ink(&pages), (80.0, 20.0));
    assert_eq!(number(&pages, "drawn_mm").round(), 40.0);
    let layers = pages["layers"].as_array().expect("the report lists them");
    let names: Vec<_> = layers.iter().map(|layer| layer["name"].as_str()).collect();
    assert_eq!(names, [Some("red"), Some("blue")]);
    assert_eq!(ink(&drawn(&["--grid", "2x1", "--gap", "30"])), (30.0, 20.0));
    // Capitals of 10 mm, 5 mm below the lines.
    assert_eq!(ink(&drawn(&["--text", "HHH"])), (80.0, 35.0));

    let grid = ["--grid", "1x1"];
    dobot(&[&sides[..], &grid].concat()).fails(1, &["1 cell ", "2 files", "--grid 2x1"]);
    let spoiled = file("spoiled.svg", "<svg><path d='M0,0 L'/></svg>");
    dobot(&["draw", &left, &spoiled]).fails(1, &["spoiled.svg: "]);
    dobot(&["draw", "-", "-"]).fails(2, &["one standard input"]);
    let burn = ["draw", &left, "--card", "5", "--laser", "cork-engrave"];
    dobot(&burn).fails(2, &["--card"]);
    dobot(&["draw", &left, &right, "--shade", "lines"]).fails(2, &["none of these"]);
}

#[test]
fn layers_are_separate_passes() {
    let sailing = example("sailing.svg");
    let names = |more: &[&str]| -> Vec<String> {
        let arguments = ["draw", &sailing, "--layers", "color", "--json", "--dry-run"];
        let outcome = dobot(&[&arguments[..], more].concat()).succeeds();
        let report = report(&outcome.stdout);
        let passes = report["passes"].as_array().expect("a list").clone();
        passes
            .iter()
            .map(|pass| pass["name"].as_str().expect("a name").to_owned())
            .collect()
    };
    assert_eq!(names(&[]), ["orange", "crimson", "navy"]);
    assert_eq!(names(&["--only", "navy,orange"]), ["orange", "navy"]);
    assert_eq!(names(&["--from", "layer:crimson"]), ["crimson", "navy"]);
    let wrong = ["draw", &sailing, "--layers", "color", "--only", "green"];
    dobot(&wrong).fails(1, &["green", "orange, crimson, navy"]);
}

#[test]
fn a_drawing_may_start_later() {
    let drawn_mm = |more: &[&str]| {
        let square = example("square.svg");
        let arguments = ["draw", &square, "--json"];
        let outcome = dobot(&[&arguments[..], more].concat()).succeeds();
        number(&report(&outcome.stdout), "drawn_mm")
    };
    let (whole, rest) = (drawn_mm(&[]), drawn_mm(&["--from", "40%"]));
    assert!((rest - 0.6 * whole).abs() < 0.1, "{rest} of {whole}");
    for (wrong, part) in [
        ("stroke:9", "1 to 1"),
        ("100%", "below 100"),
        ("layer:x", "x"),
    ] {
        dobot(&["draw", &example("square.svg"), "--from", wrong]).fails(1, &[part]);
    }
    dobot(&["draw", &example("square.svg"), "--from", "9"]).fails(2, &["stroke:NUMBER"]);
}

#[test]
fn a_timeline_describes_every_moment_of_the_drawing() {
    let folder = tempfile::tempdir().expect("there is room");
    let file = folder.path().join("timeline.json");
    let file_text = file.to_str().expect("the path is text");
    let arguments = ["draw", &example("rosette.svg"), "--dry-run", "--json"];
    let outcome = dobot(&[&arguments[..], &["--timeline", file_text]].concat()).succeeds();
    let timeline = report(&fs::read_to_string(&file).expect("it was written"));
    let summary = report(&outcome.stdout);
    let estimated_s = number(&summary, "estimated_s");
    // The timeline begins on the paper, and the report includes the way there, too.
    assert!(estimated_s > number(&timeline, "duration_s"), "{summary}");
    let late_s = estimated_s - number(&summary, "planned_s");
    assert!((0.0..1.0).contains(&late_s), "{late_s}");
    let moments = timeline["path"]["t_s"].as_array().expect("a column");
    assert_eq!(moments.last(), Some(&timeline["duration_s"]));
}

#[test]
fn a_drawing_refused_by_the_policy_is_reported_with_remedies_for_drawings() {
    let square = example("square.svg");
    // Within reach, and beyond where the laser may burn.
    let beyond = ["--at", "180", "-198", "--scale", "0.3", "--dry-run"];
    let draw = ["draw", &square, "--laser", "paper-engrave", "--no-defaults"];
    let refused = dobot(&[&draw[..], &beyond].concat());
    refused.fails(
        1,
        &["laser.area allows -200 to 200 mm", "--at", "dobot policy"],
    );
    // Elsewhere it would be as fast.
    let policy = tempfile::NamedTempFile::new().expect("there is room");
    fs::write(&policy, "[speed]\nwriting_mm_s = 20\n").expect("there is room");
    let policy = policy.path().to_str().expect("the path is text");
    for (options, rule, helps) in [
        (
            &["--acceleration", "1000"][..],
            "acceleration.writing allows 0 to 500 mm/s²",
            "another `--acceleration`",
        ),
        (
            &["--laser", "felt-cut", "--speed", "0.2"],
            "laser.least_speed allows 1 to 200 mm/s",
            "another `--speed`",
        ),
        (
            &["--policy", policy],
            "speed.writing allows 0 to 20 mm/s",
            "another `--speed` or `--travel-speed`",
        ),
    ] {
        let draw = ["draw", &square, "--no-defaults", "--dry-run"];
        let refused = dobot(&[&draw[..], options].concat());
        let refused = refused.fails(1, &[rule, helps, "dobot policy"]);
        assert!(!refused.stderr.contains("--at"), "{}", refused.stderr);
    }
}

#[test]
fn the_laser_burns_materials_and_the_pen_does_not() {
    let square = example("square.svg");
    // A stock arm switches the laser at a tick of 20 ms: where the last tick before that is not as
    // fast as the others, the line ends up to a tick's way off, 0.16 mm at this material's 8 mm/s.
    for (dialect, most_mm) in [("specification", 0.05), ("firmware-1.1", 0.16)] {
        let arguments = [
            "draw",
            &square,
            "--laser",
            "plywood-engrave",
            "--dialect",
            dialect,
        ];
        let outcome = dobot(&[&arguments[..], &["--dry-run", "--json"]].concat()).succeeds();
        let report = report(&outcome.stdout);
        assert!(
            (number(&report, "drawn_mm") - 120.0).abs() < 0.2,
            "{report}"
        );
        assert!(number(&report, "deviation_mm") <= most_mm, "{report}");
    }
    dobot(&["draw", &square, "--laser", "fineliner"]).fails(2, &["fineliner is a pen", "--pen"]);
    for (option, other, kind, not) in [
        ("--pen", "biro", "ballpoint", "plywood-engrave"),
        ("--laser", "steel", "plywood-engrave", "ballpoint"),
    ] {
        let refused = dobot(&["draw", &square, option, other]).fails(2, &[other, kind]);
        assert!(!refused.stderr.contains(not), "{}", refused.stderr);
    }
    dobot(&["draw", "--card", "5,10"]).fails(2, &["--laser"]);
    let card = [
        "draw",
        "--card",
        "5,10",
        "--card-passes",
        "2",
        "--laser",
        "cork-engrave",
    ];
    let outcome = dobot(&[&card[..], &["--dry-run", "--json"]].concat()).succeeds();
    let passes = report(&outcome.stdout)["passes"].clone();
    assert_eq!(
        passes.as_array().map(Vec::len),
        Some(5),
        "labels and four fields"
    );
}

#[test]
fn the_sides_of_a_square_have_its_length() {
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
fn a_picture_is_written_as_svg_and_as_png() {
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
fn a_file_that_cannot_be_written_is_reported_before_anything_is_drawn() {
    let folder = tempfile::tempdir().expect("there is room");
    let picture = folder.path().join("a.svg");
    let picture = picture.to_str().expect("the path is text");
    let draw = ["draw", &example("square.svg"), "--picture"];
    let missing = ["/no/such/folder/a.svg", "--json"];
    dobot(&[&draw[..], &missing].concat()).fails(1, &["cannot write /no/such/folder/a.svg"]);
    // The picture comes first: where it is missing, nothing was drawn.
    let timeline = [picture, "--timeline", "/no/such/folder/a.json"];
    dobot(&[&draw[..], &timeline].concat()).fails(1, &["cannot write /no/such/folder/a.json"]);
    assert!(!Path::new(picture).exists());
}

#[test]
fn no_output_overwrites_the_drawing_or_another_output() {
    let folder = tempfile::tempdir().expect("there is room");
    let named = |name: &str| {
        let file = folder.path().join(name);
        file.to_str().expect("the path is text").to_owned()
    };
    let text = page(r#"<path d="M10 10H40" stroke="black"/>"#);
    let (drawing, new) = (named("self.svg"), named("new.svg"));
    fs::write(&drawing, &text).expect("there is room");
    let other = folder.path().join(".").join("self.svg");
    let mut names = vec![drawing.clone(), other.to_str().expect("text").to_owned()];
    #[cfg(unix)]
    {
        let (soft, hard) = (named("soft.svg"), named("hard.svg"));
        std::os::unix::fs::symlink(&drawing, &soft).expect("there is room");
        fs::hard_link(&drawing, &hard).expect("there is room");
        names.extend([soft, hard]);
    }
    let draw = ["draw", drawing.as_str(), "--dry-run"];
    for name in &names {
        for option in ["--export", "--picture", "--timeline"] {
            let refused = dobot(&[&draw[..], &[option, name]].concat());
            let expected = format!("{option} would overwrite {name}, which is also the drawing");
            refused.fails(2, &[&expected, "name another file"]);
        }
    }
    let both = ["--picture", &new, "--export", &new];
    let expected = format!("--export would overwrite {new}, which is also --picture");
    dobot(&[&draw[..], &both].concat()).fails(2, &[&expected]);
    let kept = fs::read_to_string(&drawing).expect("it is there");
    assert_eq!(kept, text);
    assert!(!Path::new(&new).exists());
}

#[test]
fn an_option_that_does_not_fit_the_source_is_refused() {
    let (square, photo) = (example("square.svg"), example("still-life.jpg"));
    let (square, photo) = (&[square.as_str()][..], &[photo.as_str()][..]);
    let text = &["--text", "arm"][..];
    let card = &["--card", "5,10", "--laser", "cork-engrave"][..];
    for (source, option, parts) in [
        (
            square,
            &["--shade", "lines"][..],
            ["pictures", "square.svg is in SVG format"],
        ),
        (square, &["--spacing", "2"], ["pictures", "square.svg"]),
        (square, &["--invert"], ["pictures", "square.svg"]),
        (square, &["--height", "20"], ["--text", "square.svg"]),
        (square, &["--font", "serif"], ["--text", "square.svg"]),
        (square, &["--align", "left"], ["--text", "square.svg"]),
        (square, &["--card-passes", "3"], ["--card", "square.svg"]),
        (
            photo,
            &["--hatch"],
            ["areas", "still-life.jpg is a picture"],
        ),
        (photo, &["--layers", "color"], ["layers", "still-life.jpg"]),
        (text, &["--shade", "hatch"], ["pictures", "this is a text"]),
        (text, &["--layers", "color"], ["layers", "this is a text"]),
        (card, &["--hatch", "2"], ["areas", "this is a test card"]),
        (card, &["--fit"], ["drawings", "this is a test card"]),
        (
            card,
            &["--passes", "2"],
            ["drawings", "this is a test card"],
        ),
    ] {
        let refused = dobot(&[&["draw"], source, option].concat()).fails(2, &parts);
        let named = format!("error: {} is for ", option[0]);
        assert!(refused.stderr.starts_with(&named), "{}", refused.stderr);
    }
    // A material has its own spacing and passes.
    let burn = ["--laser", "plywood-engrave", "--dry-run"];
    dobot(&[&["draw"], photo, &["--spacing", "4"], &burn].concat()).succeeds();
    dobot(&[&["draw"], text, &["--hatch"], &burn].concat()).succeeds();
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
fn a_drawing_larger_than_the_area_shrinks_unless_a_scale_is_given() {
    let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="500mm" height="300mm" viewBox="0 0 500 300">
        <rect width="400" height="100" fill="none" stroke="black"/></svg>"#;
    let outcome = dobot_reading(&["draw", "-", "--json"], svg.as_bytes()).succeeds();
    let scale = number(&report(&outcome.stdout), "scale");
    // 344 x 86 mm: half of it is as far to the side as its near edge is before the arm.
    assert!((scale - 0.86).abs() < 0.005, "{scale}");
    dobot_reading(&["draw", "-", "--scale", "1"], svg.as_bytes()).fails(1, &["--fit"]);
}

#[test]
fn the_drawing_is_exported_for_other_programs() {
    let folder = tempfile::tempdir().expect("there is room");
    let file = folder.path().join("plan.svg");
    let name = file.to_str().expect("it is text");
    let svg = page(
        r#"<rect width="40" height="20" fill="none" stroke="red"/><path d="M5 5H200" stroke="red"/>"#,
    );
    let asked = [
        "draw",
        "-",
        "--dry-run",
        "--json",
        "--paper-size",
        "a5",
        "--landscape",
        "--export",
        name,
    ];
    let outcome = dobot_reading(&asked, svg.as_bytes()).succeeds();
    let summary = report(&outcome.stdout);
    assert_eq!(summary["warnings"][0]["what"], "cut line");
    assert_eq!(summary["layers"][0]["strokes"], 2);
    assert_eq!(summary["sheet_mm"][0][1], 105.0);
    let written = std::fs::read_to_string(&file).expect("it was written");
    assert!(
        written.contains("width=\"210mm\" height=\"148mm\""),
        "{written}"
    );
    // What was written can be drawn, and is the same.
    let again = dobot(&[
        "draw",
        name,
        "--dry-run",
        "--json",
        "--paper-size",
        "210x148",
    ])
    .succeeds();
    let again = number(&report(&again.stdout), "drawn_mm");
    assert!(
        (again - number(&summary, "drawn_mm")).abs() < 0.01,
        "{again}"
    );
    dobot(&["draw", name, "--dry-run", "--export", "plan.png"]).fails(2, &[".gcode"]);
}

#[test]
fn a_drawing_of_days_is_announced_before_it_begins_and_not_rehearsed() {
    // 500 lines, back and forth over 180 mm and 200 times around each: 18 km.
    let lines = (0..500).map(|i| format!("M0 {}H180", f64::from(i) * 0.2));
    let lines: Vec<String> = lines.collect();
    let lines = lines.concat();
    let svg = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="180mm" height="100mm" viewBox="0 0 180 100"><path d="{lines}" stroke="red"/></svg>"#
    );
    let long = [
        "draw",
        "-",
        "--dry-run",
        "--json",
        "--passes",
        "100",
        "--speed",
        "20",
    ];
    let outcome = dobot_reading(&long, svg.as_bytes()).succeeds();
    assert!(
        outcome.stderr.contains("this takes about 1"),
        "{}",
        outcome.stderr
    );
    let report = report(&outcome.stdout);
    assert_eq!(report["measured_from"], "nothing");
    assert!(number(&report, "planned_s") > 400_000.0);
}

#[cfg(target_os = "linux")]
#[test]
fn a_terminal_shows_the_progress_and_announces_hours_before_they_are_planned() {
    let lines = (0..500).map(|i| format!("M0 {}H90", f64::from(i) * 0.1));
    let lines = page(&format!(
        r#"<path d="{}" stroke="red"/>"#,
        lines.collect::<String>()
    ));
    let file = tempfile::NamedTempFile::with_suffix(".svg").expect("there is room");
    fs::write(file.path(), lines).expect("there is room");
    let file = file.path().to_str().expect("the path is text");
    let draw = ["draw", file, "--dry-run", "--speed", "20", "--passes", "20"];
    let mut terminal = Terminal::with_errors(&command(&draw));
    terminal.shows("hours of drawing (rough estimate before planning)");
    terminal.shows("warning: this takes about");
    terminal.shows("h planned");
    assert!(terminal.ends().success());
    // A program receives the time when it is known, and nothing before.
    let outcome = dobot(&draw).succeeds();
    assert!(
        outcome.stderr.starts_with("warning: this takes about"),
        "{}",
        outcome.stderr
    );
    assert_eq!(outcome.stderr.lines().count(), 1, "{}", outcome.stderr);
}

#[test]
fn a_long_drawing_has_its_dots_in_the_picture_and_its_timeline_without_a_rehearsal() {
    let folder = tempfile::tempdir().expect("there is room");
    let [picture, timeline] = ["a.svg", "a.json"].map(|name| {
        let file = folder.path().join(name);
        file.to_str().expect("the path is text").to_owned()
    });
    let inside = r#"<path d="M0 0H90M50 50h0" stroke="red" stroke-linecap="round"/>"#;
    // Five hours.
    let slow = [
        "draw", "-", "--speed", "0.5", "--passes", "100", "--at", "210", "0",
    ];
    let files = ["--picture", &picture, "--timeline", &timeline];
    let outcome = dobot_reading(
        &[&slow[..], &["--dry-run", "--json"], &files].concat(),
        page(inside).as_bytes(),
    );
    let report = report(&outcome.succeeds().stdout);
    assert_eq!(report["estimated_s"], Value::Null, "{report}");
    assert_eq!(report["measured_from"], "the plan");
    let picture = fs::read_to_string(&picture).expect("it was written");
    assert!(picture.contains("h.001"), "{picture}");
    let timeline = fs::read_to_string(&timeline).expect("it was written");
    let timeline: Value = serde_json::from_str(&timeline).expect("it is JSON");
    let ink = timeline["path"]["ink"].as_array().expect("a column");
    assert_eq!(
        ink.iter().filter(|mark| **mark == 2).count(),
        2,
        "a line and a dot"
    );
    let late_s = number(&timeline, "duration_s") - number(&report, "planned_s");
    assert!(late_s.abs() < 0.01, "{late_s}");
}

#[test]
fn the_planned_duration_of_a_table_of_single_points_is_that_of_the_arm() {
    // 28 dots in four rows; an empty line ends a stroke.
    let dot = |i: i32| format!("{},{}\n", 200 + 10 * (i % 7), 10 * (i / 7) - 15);
    let table = (0..28).map(dot).collect::<Vec<_>>().join("\n");
    for dialect in ["specification", "firmware-1.1"] {
        let arguments = ["draw", "-", "--json", "--dialect", dialect];
        let report = report(
            &dobot_reading(&arguments, table.as_bytes())
                .succeeds()
                .stdout,
        );
        assert_eq!(report["strokes"], 28, "{report}");
        let (time_s, planned_s) = (number(&report, "time_s"), number(&report, "planned_s"));
        // Some statuses pass until the end is seen.
        assert!((time_s - planned_s).abs() < 0.01 * time_s + 0.4, "{report}");
    }
}

#[test]
fn the_length_of_dots_alone_is_zero() {
    let dots = page(r#"<path d="M50 30h0M60 30h0" stroke="red" stroke-linecap="round"/>"#);
    let outcome = dobot_reading(&["draw", "-", "--dry-run", "--json"], dots.as_bytes());
    let stdout = outcome.succeeds().stdout;
    assert!(stdout.contains(r#""length_mm":0.0"#), "{stdout}");
    assert!(!stdout.contains("-0.0"), "{stdout}");
}

#[test]
fn a_file_after_an_option_that_takes_numbers_is_reported_as_such() {
    let square = example("square.svg");
    let laser = ["--laser", "felt-cut"];
    for (arguments, parts) in [
        (
            &["draw", "--card", &square][..],
            &["expected speeds in mm/s", "2,5,10", "without a file"][..],
        ),
        (
            &["draw", "--card", "5", &square],
            &["FILE", "cannot be used with", "--card"],
        ),
        (
            &["draw", "--hatch", &square],
            &["expected a number of millimetres", "put the file before"],
        ),
    ] {
        dobot(&[arguments, &laser].concat()).fails(2, parts);
    }
    let card = ["draw", "--card", "5,10", "--dry-run"];
    dobot(&[&card[..], &laser].concat()).succeeds();
}

#[test]
fn a_font_is_read_from_its_file() {
    let folder = tempfile::tempdir().expect("there is room");
    let file = folder.path().join("sticks.svg");
    let font = r#"<svg xmlns="http://www.w3.org/2000/svg"><font horiz-adv-x="9"><glyph unicode="H" d="M0 0V7"/></font></svg>"#;
    fs::write(&file, font).expect("there is room");
    let name = file.to_str().expect("it is text");
    let text = |font| {
        [
            "draw", "--text", "HHH", "--height", "20", "--json", "--font", font,
        ]
    };
    let drawn = report(&dobot(&text(name)).succeeds().stdout);
    assert!((number(&drawn, "drawn_mm") - 60.0).abs() < 0.01, "{drawn}");
    fs::write(&file, "<svg/>").expect("there is room");
    dobot(&text(name)).fails(1, &["--font", "no <font> element"]);
    dobot(&text("nowhere.svg")).fails(1, &["cannot read nowhere.svg", "name an SVG font"]);
}

#[test]
fn options_without_effect_are_reported() {
    let square = example("square.svg");
    let hatched = dobot(&["draw", &square, "--hatch", "--dry-run"]).succeeds();
    let expected = "warning: 1 hatching without filled areas: nothing is hatched";
    assert!(hatched.stderr.contains(expected), "{}", hatched.stderr);
    let photo = example("still-life.jpg");
    for (arguments, expected) in [
        (
            &["draw", &square, "--gap", "9"][..],
            "--gap has no effect without --grid, --border, --sign or --text",
        ),
        (
            &["draw", "--text", "arm", "--gap", "9"],
            "--gap has no effect without --grid, --border, --sign, or a file above the text",
        ),
        (
            &["draw", &photo, "--shade", "stipple", "--levels", "3"],
            "--levels has no effect without --shade hatch or outline",
        ),
    ] {
        dobot(arguments).fails(2, &[expected]);
    }
}

#[test]
fn the_options_are_grouped() {
    let help = dobot(&["draw", "--help"]).succeeds().stdout;
    let is_heading = |line: &&str| line.ends_with(':') && !line.starts_with(' ');
    let headings: Vec<&str> = help.lines().filter(is_heading).collect();
    let groups = ["Source:", "Paper:", "Pen:", "Laser:", "Run:"];
    assert_eq!(
        headings[..7],
        [&["Arguments:", "Options:"], &groups[..]].concat()
    );
    let group = |name: &str| {
        let begin = help.find(&format!("\n{name}\n")).expect("it is there");
        let group = &help[begin + name.len() + 2..];
        let end = group.lines().take_while(|line| !is_heading(line));
        end.collect::<Vec<_>>().join("\n")
    };
    assert!(!group("Options:").contains("--policy"));
    for (name, options) in [
        ("Pen:", ["--pen ", "--lift "]),
        ("Laser:", ["--laser ", "--kerf "]),
        ("Run:", ["--speed ", "--dry-run"]),
        ("Connection:", ["--to ", "--station "]),
        ("Output:", ["--picture ", "--json"]),
    ] {
        for option in options {
            assert!(group(name).contains(option), "{option} of {name}");
        }
    }
}

#[test]
fn parts_out_of_reach_are_cut_off_on_request() {
    let svg = page(r#"<path d="M0 0H100" stroke="black"/>"#);
    let far = ["draw", "-", "--at", "300", "0", "--rotate", "90"];
    dobot_reading(&far, svg.as_bytes()).fails(1, &["reach", "--clip"]);
    let outcome = dobot_reading(&[&far[..], &["--clip", "--json"]].concat(), svg.as_bytes());
    let outcome = outcome.succeeds();
    let drawn_mm = number(&report(&outcome.stdout), "drawn_mm");
    assert!((60.0..75.0).contains(&drawn_mm), "{drawn_mm}");
    assert!(outcome.stderr.contains("cut off"), "{}", outcome.stderr);
}

#[test]
fn each_bad_drawing_is_one_clear_error() {
    for (svg, parts) in [
        (
            String::new(),
            &["error: standard input: the file is empty"][..],
        ),
        (
            "hello".to_owned(),
            &["error: \"standard input\" is not a supported file"],
        ),
        ("<svg".to_owned(), &["1:"]),
        (
            "<html/>".to_owned(),
            &["found an HTML page", "download it again"],
        ),
        (page(""), &["error: standard input: ", "nothing"]),
    ] {
        let outcome = dobot_reading(&["draw", "-"], svg.as_bytes()).fails(1, parts);
        assert_eq!(outcome.stdout, "", "{svg}");
    }
    // A path is drawn up to its mistake, unless that is to be refused.
    let bad = page(r#"<path d="M0 0 L10 10 L NaN 5 L20 20" stroke="red"/>"#);
    let drawn = dobot_reading(&["draw", "-", "--json"], bad.as_bytes()).succeeds();
    let drawn_mm = number(&report(&drawn.stdout), "drawn_mm");
    assert!((drawn_mm - 200.0_f64.sqrt()).abs() < 0.1, "{drawn_mm}");
    assert!(drawn.stderr.contains("NaN"), "{}", drawn.stderr);
    dobot_reading(&["draw", "-", "--strict"], bad.as_bytes()).fails(1, &["NaN", "1:"]);
    dobot(&["draw", "no-such-file.svg"]).fails(1, &["no-such-file.svg", "hint:"]);
    let program = tempfile::Builder::new().suffix(".toml").tempfile();
    let program = program.expect("there is room");
    let name = program.path().to_str().expect("the path is text");
    fs::write(&program, "[[steps]]\npause = 1\n").expect("there is room");
    dobot(&["draw", name]).fails(
        1,
        &["is a program, not a drawing", &format!("dobot play {name}")],
    );
    dobot(&["draw", &example("")]).fails(1, &["cannot read"]);
    dobot_reading(&["draw", "-"], &[0xFF, 0xFE, 0x00]).fails(1, &["is not a supported file"]);
}

/// Unit tests reach lower limits.
#[test]
fn a_drawing_above_a_limit_is_refused_with_the_limit() {
    let path = "l1 1".repeat(2_000_001);
    let faint = r#"<path opacity="0.5" d="M0 0H1"/>"#.repeat(96_000);
    for (svg, part) in [
        (
            page(&format!(r#"<path d="M0 0{path}" stroke="red"/>"#)),
            "the drawing has more than 2000000 line segments",
        ),
        (page(&faint), "more than 190000 elements"),
    ] {
        dobot_reading(&["draw", "-"], svg.as_bytes()).fails(1, &[part]);
    }
}

#[test]
fn invalid_settings_are_reported_before_anything_moves() {
    let square = example("square.svg");
    for (option, value, part) in [
        ("--tolerance", "0", "tolerance"),
        ("--speed", "0", "speed"),
        ("--speed", "-5", "speed"),
        ("--scale", "0", "scale"),
        ("--lift", "-10", "lift"),
    ] {
        dobot(&["draw", &square, option, value]).fails(2, &[part]);
    }
    for (option, value, part) in [
        ("--margin", "70", "margin"),
        ("--hatch", "0", "spacing"),
        ("--pen-down", "200", "z"),
    ] {
        dobot(&["draw", &square, option, value]).fails(1, &[part]);
    }
    for (option, value) in [
        ("--tolerance", "nan"),
        ("--acceleration", "inf"),
        ("--rotate", "nan"),
    ] {
        let outcome = dobot(&["draw", &square, option, value]);
        outcome.fails(2, &[option, value, "expected a"]);
    }
    dobot(&["draw", &square, "--at", "400", "0"]).fails(1, &["reach"]);
}

#[cfg(unix)]
#[test]
fn an_endless_input_is_not_read_for_ever() {
    let most = ["more than 64 MB", "draw it in parts"];
    dobot(&["draw", "/dev/zero"]).fails(1, &[&["/dev/zero"], &most[..]].concat());
    let zeros = fs::File::open("/dev/zero").expect("it is there");
    let output = command(&["draw", "-"]).stdin(zeros).output();
    let outcome = Outcome::from(output.expect("the program starts"));
    outcome.fails(1, &[&["standard input"], &most[..]].concat());
    for option in ["--defaults", "--materials", "--policy", "--calibration"] {
        let square = example("square.svg");
        let expected = [
            "/dev/zero",
            "more than 1 MB",
            "check that it is the right file",
        ];
        dobot(&["draw", &square, "--dry-run", option, "/dev/zero"]).fails(1, &expected);
    }
}
