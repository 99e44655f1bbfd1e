//! `dobot draw` with a file of defaults.

use std::fs;
use std::path::PathBuf;

use serde_json::{Value, json};
use tempfile::TempDir;

use crate::support::program::{Outcome, command_at, dobot, example, run};

/// A folder with a file of defaults.
struct Desk {
    folder: TempDir,
}

impl Desk {
    fn with(text: &str) -> Self {
        let folder = tempfile::tempdir().expect("there is room");
        fs::write(folder.path().join("mine.toml"), text).expect("there is room");
        Self { folder }
    }

    fn file(&self) -> PathBuf {
        self.folder.path().join("mine.toml")
    }

    /// A dry run with the file.
    fn draw(&self, arguments: &[&str]) -> Outcome {
        let file = self.file();
        let file = file.to_str().expect("the path is text");
        dobot(&[&["draw", "--dry-run", "--defaults", file], arguments].concat())
    }

    fn report(&self, arguments: &[&str]) -> Value {
        report(&self.draw(&[arguments, &["--json"]].concat()))
    }
}

fn report(outcome: &Outcome) -> Value {
    assert_eq!(outcome.code, Some(0), "{outcome:?}");
    serde_json::from_str(&outcome.stdout).expect("the report is JSON")
}

fn ink_width_mm(report: &Value) -> f64 {
    let at = |i: usize| report["ink_mm"][i].as_f64().expect("it is a number");
    at(3) - at(1)
}

#[test]
fn a_default_has_the_effect_of_its_option() {
    let square = example("square.svg");
    let file = "scale = 2\nat = [200, 10]\nhatch = 4\nhatch-angle = 30\ncross = true\nmirror = false\npen = \"marker\"\n";
    let by_file = Desk::with(file).report(&[&square]);
    let options = [
        "--scale",
        "2",
        "--at",
        "200",
        "10",
        "--hatch",
        "4",
        "--hatch-angle",
        "30",
        "--cross",
        "--pen",
        "marker",
    ];
    let by_hand = report(&dobot(
        &[&["draw", &square, "--dry-run", "--json"], &options[..]].concat(),
    ));
    for key in ["ink_mm", "drawn_mm", "vectors", "estimated_s"] {
        assert_eq!(by_file[key], by_hand[key], "{key}");
    }
    assert_eq!(
        by_file["defaults"]["used"],
        json!([
            "scale",
            "at",
            "hatch",
            "hatch-angle",
            "cross",
            "mirror",
            "pen"
        ])
    );
    assert_eq!(by_hand["defaults"], Value::Null);
}

#[test]
fn the_command_line_wins_over_the_file() {
    let square = example("square.svg");
    let desk = Desk::with("scale = 2\npen = \"marker\"\nspeed = 30\nrotate = 45\n");
    let larger = desk.report(&[&square]);
    let given = desk.report(&[&square, "--scale", "1", "--laser", "felt-cut"]);
    assert!((ink_width_mm(&larger) - 2.0 * ink_width_mm(&given)).abs() < 0.1);
    assert_eq!(given["defaults"]["used"], json!(["speed", "rotate"]));
    let why = "the command line gives --laser";
    assert_eq!(
        given["defaults"]["unused"],
        json!([{"option": "pen", "why": why}])
    );
    // A requested option may need one from the file.
    let laser = Desk::with("laser = \"felt-cut\"\n");
    laser.draw(&[&square, "--kerf", "0.2"]).succeeds();
}

#[test]
fn a_default_without_effect_on_this_drawing_is_ignored_and_reported() {
    let (square, photo) = (example("square.svg"), example("still-life.jpg"));
    let desk =
        Desk::with("shade = \"outline\"\nhatch = true\nhatch-angle = 30\nkerf = 0.2\ngap = 9\n");
    let defaults = |report: &Value| {
        let unused = report["defaults"]["unused"].as_array().expect("a list");
        let unused = unused.iter().map(|option| option["option"].clone());
        (
            report["defaults"]["used"].clone(),
            unused.collect::<Value>(),
        )
    };
    assert_eq!(
        defaults(&desk.report(&[&square])),
        (
            json!(["hatch", "hatch-angle"]),
            json!(["shade", "kerf", "gap"])
        )
    );
    assert_eq!(
        defaults(&desk.report(&[&photo])),
        (
            json!(["shade"]),
            json!(["hatch", "hatch-angle", "kerf", "gap"])
        )
    );
    let report = desk.draw(&[&square]).succeeds().stdout;
    assert!(
        report.contains("defaults           hatch, hatch-angle (of "),
        "{report}"
    );
    assert!(
        report.contains("kerf: it has no effect without --laser"),
        "{report}"
    );
    assert!(report.contains("shade: it is for pictures"), "{report}");
}

#[test]
fn the_file_in_the_data_folder_is_read_unless_it_is_disabled() {
    let square = example("square.svg");
    let data = tempfile::tempdir().expect("there is room");
    fs::write(data.path().join("draw.toml"), "scale = 2\nrotate = 45\n").expect("there is room");
    let draw = |arguments: &[&str]| {
        let all = [&["draw", &square, "--dry-run", "--json"], arguments].concat();
        let outcome = run(&mut command_at(data.path(), &all), b"");
        report(&outcome)["defaults"]["used"].clone()
    };
    assert_eq!(draw(&[]), json!(["scale", "rotate"]));
    assert_eq!(draw(&["--no-defaults"]), Value::Null);
    assert_eq!(draw(&["--no-defaults=rotate"]), json!(["scale"]));
}

#[test]
fn materials_are_looked_up_next_to_the_file_that_names_them() {
    let desk = Desk::with("materials = \"inks.toml\"\npen = \"quill\"\n");
    let inks = "[materials.quill]\ntool = \"pen\"\nspeed_mm_s = 20\n";
    fs::write(desk.folder.path().join("inks.toml"), inks).expect("there is room");
    desk.draw(&[&example("square.svg")]).succeeds();
}

#[test]
fn a_mistake_in_the_file_is_one_line_with_its_place_and_the_allowed_values() {
    let square = example("square.svg");
    for (text, parts) in [
        (
            "scale = 1\nsped = 4\n",
            &[
                "line 2: sped is not a key of a file of defaults; did you mean speed?",
                "hint: ",
            ][..],
        ),
        (
            "text = \"a\"",
            &["line 1: text is not a key of a file of defaults\n"],
        ),
        ("arm-laser = 60", &["line 1: arm-laser is not a key"]),
        ("[tool]\npen = \"marker\"", &["line 1: tool is not a key"]),
        (
            "\nspeed = \"fast\"",
            &["line 2: speed is \"fast\"; expected a number"],
        ),
        (
            "speed = true",
            &["line 1: speed is true; expected a number"],
        ),
        (
            "tries = 1.5",
            &["line 1: tries is 1.5; expected a whole number"],
        ),
        (
            "tries = -1",
            &["line 1: tries is -1; expected a whole number, 0 or more"],
        ),
        ("fit = 1", &["line 1: fit is 1; expected true or false"]),
        (
            "at = [1]",
            &["line 1: at is [1]; expected 2 numbers in brackets"],
        ),
        (
            "at = 5",
            &["line 1: at is 5; expected 2 numbers in brackets"],
        ),
        (
            "materials = 7",
            &["line 1: materials is 7; expected a file name"],
        ),
        (
            "passes-by = \"heap\"",
            &["line 1: passes-by is \"heap\"; allowed are shape and layer"],
        ),
        (
            "paper-size = \"a9\"",
            &["line 1: paper-size is \"a9\"; ", "a4"],
        ),
        (
            "pen = 1979-05-27",
            &["line 1: pen is 1979-05-27; expected a text"],
        ),
        ("\n\npen = ", &["line 3: "]),
        ("pen = \"a\"\npen = \"b\"", &["line 2: "]),
        (
            "laser = \"felt-cut\"\npen = \"marker\"",
            &["line 2: pen and laser exclude each other"],
        ),
        (
            "\nspeed = 1e9",
            &["line 2: --speed is 1000000000 mm/s; it takes 0 to 1000 mm/s"],
        ),
        (
            "pen = \"markr\"",
            &["line 1: there is no material 'markr'; did you mean 'marker'?"],
        ),
        (
            "tolerance = 0",
            &["line 1: --tolerance is 0 mm; it takes 0.02 to 10 mm"],
        ),
        ("margin = 200", &["margin", "`--no-defaults`"]),
    ] {
        let desk = Desk::with(text);
        let refused = desk.draw(&[&square]);
        // A number out of its range is a usage error, as it is on the command line.
        let is_usage = ["1e9", "markr", "tolerance"]
            .iter()
            .any(|part| text.contains(part));
        let refused = refused.fails(if is_usage { 2 } else { 1 }, parts);
        let errors = refused
            .stderr
            .lines()
            .filter(|line| !line.starts_with("hint: "));
        assert_eq!(errors.count(), 1, "{}", refused.stderr);
    }
    let missing = ["draw", &square, "--defaults", "/nowhere/mine.toml"];
    dobot(&missing).fails(1, &["cannot read /nowhere/mine.toml"]);
    dobot(&["draw", &square, "--no-defaults=sped"]).fails(2, &["expected options"]);
}
