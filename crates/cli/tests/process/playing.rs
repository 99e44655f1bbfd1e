//! Taught programs: checked, timed and played.

use std::path::PathBuf;

use serde_json::{Value, json};
use tempfile::TempDir;

use crate::support::api::Api;
use crate::support::program::{command, dobot, example};
use crate::support::terminal::Terminal;
use crate::support::up::Up;

const CARRY: &str = r#"
title = "one cube, to and fro"
start_speed_percent = 20

[points]
here = { x = 200, y = 60, z = 0 }
there = { x = 200, y = -60, z = 0 }

[[steps]]
repeat = 5
[[steps.steps]]
go = "here"
suction = true
pause = 0.5
[[steps.steps]]
go = "there"
suction = false
"#;
/// When the end of a program is seen depends on when the statuses come.
const PREDICTED_S: f64 = 0.2;
const STATUS_S: f64 = 0.08;

/// A program in a file.
struct InFile {
    folder: TempDir,
}

impl InFile {
    fn new(text: &str) -> Self {
        let folder = tempfile::tempdir().expect("there is room");
        std::fs::write(folder.path().join("job.toml"), text).expect("there is room");
        Self { folder }
    }

    fn path(&self) -> String {
        let path = self.folder.path().join("job.toml");
        path.to_str().expect("the path is text").to_owned()
    }
}

fn json(arguments: &[&str]) -> Value {
    let printed = dobot(&[arguments, &["--json"]].concat()).succeeds().stdout;
    serde_json::from_str(&printed).expect("it is JSON")
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("it is a number")
}

#[test]
fn a_program_has_the_predicted_duration() {
    let file = InFile::new(CARRY);
    for dialect in ["specification", "firmware-1.1"] {
        let play = [
            "play",
            &file.path(),
            "--to",
            "virtual:",
            "--dialect",
            dialect,
        ];
        let predicted = json(&[&play[..], &["--dry-run"]].concat());
        let done = json(&play);
        let (wanted_s, took_s) = (number(&predicted["total_s"]), number(&done["took_s"]));
        assert!(
            (wanted_s - took_s).abs() <= PREDICTED_S,
            "{predicted} {done}"
        );
        let twice = json(&[&play[..], &["--times", "10", "--dry-run"]].concat());
        let five_more_s = number(&twice["total_s"]) - wanted_s;
        assert!(
            (five_more_s - 5.0 * number(&predicted["cycle_s"])).abs() < 1e-6,
            "{twice}"
        );
    }
}

/// At eight times the speed of a clock, a delay of this machine counts eightfold.
const STATION_S: f64 = 3.0;

#[test]
fn a_dry_run_uses_the_current_settings_of_the_arm_of_the_station() {
    let file = InFile::new(CARRY);
    for personality in ["specification", "firmware-1.1"] {
        let up = Up::new(&["--personality", personality]);
        up.dobot(&["move", "190", "120", "40"]).succeeds();
        up.dobot(&[
            "set",
            "percent",
            "--speed-percent",
            "30",
            "--acceleration-percent",
            "60",
        ])
        .succeeds();
        let predicted = up.json(&["play", &file.path(), "--dry-run"]);
        let checked = up.json(&["check", &file.path()]);
        assert_eq!(checked["report"]["total_s"], predicted["total_s"]);
        let arm = predicted["arm"].as_str().expect("a line");
        assert!(arm.contains(personality), "{arm}");
        let done = up.json(&["play", &file.path()]);
        let (wanted_s, took_s) = (number(&predicted["total_s"]), number(&done["took_s"]));
        assert!((wanted_s - took_s).abs() < STATION_S, "{predicted} {done}");
    }
}

#[test]
fn a_program_forbidden_by_the_policy_of_the_station_is_refused_with_step_and_line() {
    let file = InFile::new(CARRY);
    let up = Up::new(&[]);
    let policy = json!({"text": "[workspace]\ny_mm = [-20, 100]\n"});
    Api::with_control(&up.page).asks("PUT", "policy", &policy);
    for verb in [&["play"][..], &["play", "--dry-run"]] {
        let refused = up.dobot(&[verb, &[&file.path()]].concat());
        refused.fails(1, &["line 15", "go to there", "-20 to 100"]);
    }
}

#[test]
fn without_a_station_a_check_names_the_assumed_arm() {
    let file = InFile::new("[[steps]]\ngo = { x = 200, y = 60, z = 0 }\n");
    let output = dobot(&["check", &file.path()]).succeeds().stdout;
    assert!(output.contains("assumed a specification arm"), "{output}");
    // The one motion takes its time.
    assert!(!output.contains("0.0 s"), "{output}");
}

#[test]
fn the_questions_of_a_program_are_answered_by_a_command_and_over_http() {
    let file = InFile::new(
        r#"
title = "sides"
[[steps]]
go = { x = 220, y = 0, z = 40 }
[[steps]]
go = { from = "cube" }
[[steps]]
choose = "Which side?"
by = "seen"
[[steps.when]]
answer = "left"
[[steps.when.steps]]
go = { x = 200, y = 80, z = 40 }
[[steps.when]]
answer = "right"
[[steps]]
choose = "Is it good?"
[[steps.when]]
answer = "yes"
[[steps.when]]
answer = "no"
"#,
    );
    let up = Up::new(&[]);
    let text = std::fs::read_to_string(file.path()).expect("it was written");
    let api = Api::with_control(&up.page);
    api.wait_for_state(|state| state["arm"].is_object());
    let job = api.asks("POST", "programs/jobs", &json!({"program": {"text": text}}));
    let job = job["job"]["job"].as_u64().expect("a number").to_string();
    api.asks("POST", &format!("jobs/{job}/start"), &Value::Null);
    let asks = |what: &str| {
        api.wait_for_state(|state| {
            let question = &state["job"]["question"];
            question["asks"] == what || question["text"] == what
        })
    };
    asks("place");
    let far = ["jobs", "answer", &job, "--at", "500", "0", "0"];
    up.dobot(&far).fails(1, &["the arm allows"]);
    up.dobot(&["jobs", "answer", &job, "left"])
        .fails(2, &["x, y and z in mm"]);
    let place = json!({"x_mm": 200, "y_mm": -40, "z_mm": 20});
    api.asks("PUT", &format!("jobs/{job}/places/cube"), &place);
    asks("Which side?");
    let listed = up.dobot(&["jobs"]).succeeds().stdout;
    assert!(
        listed.contains("asks: Which side? (left, right)"),
        "{listed}"
    );
    up.dobot(&["jobs", "answer", &job, "LEFT"]).succeeds();
    let state = asks("Is it good?");
    let y_mm = number(&state["arm"]["y_mm"]);
    assert!((y_mm - 80.0).abs() < 0.5, "{y_mm}");
    // Only a person may answer, and there is no terminal.
    up.dobot(&["jobs", "answer", &job, "yes"])
        .fails(1, &["only a person", "--as-person"]);
    up.dobot(&["jobs", "answer", &job, "yes", "--as-person"])
        .succeeds();
    api.wait_for_state(|state| state["job"].is_null());
    let listed = up.dobot(&["jobs"]).succeeds().stdout;
    assert!(listed.contains("done"), "{listed}");
}

#[test]
fn a_person_answers_the_questions_of_a_program_in_the_terminal() {
    for station in [None, Some(Up::new(&[]))] {
        let program = example("../programs/sorting.toml");
        let to = match &station {
            None => vec!["--to", "virtual:"],
            Some(up) => vec!["--station", &up.page],
        };
        let play = [&["play", &program, "--pose-confirmed"], &to[..]].concat();
        let mut terminal = Terminal::with_errors(&command(&play));
        terminal.shows("asks: Which colour is next? (red, yellow, blue, none)");
        terminal.types("green\r");
        terminal.shows("the answer is \"green\"; allowed: red, yellow, blue, none");
        for answer in ["red\r", "Blue\r", "none\r"] {
            terminal.types(answer);
            if answer != "none\r" {
                terminal.shows("asks: Which colour is next?");
            }
        }
        terminal.shows("sort by colour is done");
        assert!(terminal.ends().success());
    }
}

#[test]
fn a_start_after_a_question_names_the_answers_that_it_assumes() {
    let file = InFile::new(
        "[[steps]]\ngo = { x = 220, y = 0, z = 40 }\n[[steps]]\nchoose = \"Which side?\"\n\
         [[steps.when]]\nanswer = \"left\"\n[[steps.when.steps]]\ngo = { x = 200, y = 80, z = 40 }\n\
         [[steps.when]]\nanswer = \"right\"\n[[steps]]\ngo = { from = \"bottle\" }\n",
    );
    let path = file.path();
    let from = |step| {
        dobot(&[
            "play",
            &path,
            "--to",
            "virtual:",
            "--dry-run",
            "--from",
            step,
        ])
    };
    let outcome = from("2").succeeds();
    let line = "starts at step 2; the questions before it count as answered: left";
    assert!(outcome.stdout.contains(line), "{outcome:?}");
    from("3").fails(
        1,
        &["line 11", "the position \"bottle\"", "start at step 2"],
    );
    from("4").fails(2, &["has 3 steps with the first answer to each question"]);
}

#[test]
fn every_example_has_the_predicted_duration() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples/programs");
    let files = std::fs::read_dir(folder).expect("the examples are there");
    let files = files.map(|entry| entry.expect("it can be read").path());
    let mut count = 0;
    for file in files.filter(|file| {
        file.extension()
            .is_some_and(|extension| extension == "toml")
    }) {
        for dialect in ["specification", "firmware-1.1"] {
            let file = file.to_str().expect("the path is text");
            // A drawing on each sheet would continue until a person ends it.
            let endless = ["--times", "3"].repeat(usize::from(file.ends_with("drawing.toml")));
            let play = ["play", file, "--to", "virtual:", "--dialect", dialect];
            let play = [&play[..], &endless].concat();
            let predicted = json(&[&play[..], &["--dry-run"]].concat());
            if predicted["depends_on_answers"] == true {
                // Nobody answers here.
                dobot(&play).fails(1, &["the program asks", "dobot up"]);
                continue;
            }
            let predicted = number(&predicted["total_s"]);
            let took_s = number(&json(&play)["took_s"]);
            // The time until a status permits the next command depends on the person.
            let waits_s = if endless.is_empty() {
                0.0
            } else {
                2.0 * STATUS_S
            };
            assert!(
                (predicted - took_s).abs() <= PREDICTED_S + waits_s,
                "{file}: {predicted} s, {took_s} s"
            );
        }
        count += 1;
    }
    assert!(count >= 5, "{count} examples");
}

#[test]
fn every_problem_of_a_program_is_reported_with_its_line_before_anything_moves() {
    let file = InFile::new(
        "[points]\nfar = { x = 500, y = 0, z = 0 }\nlow = { x = 200, y = 0, z = -200 }\n\
         [[steps]]\ngo = \"far\"\n[[steps]]\ngo = \"low\"\n",
    );
    let parts = [
        "2 problems",
        "line 4",
        "line 6",
        "149.93 mm too far",
        "22.6034° too much",
    ];
    for verb in ["play", "check"] {
        let outcome = dobot(&[verb, &file.path()]);
        assert_eq!(outcome.code, Some(1), "{outcome:?}");
        let output = format!("{}{}", outcome.stdout, outcome.stderr);
        for part in parts {
            assert!(output.contains(part), "{verb}: {part} is missing: {output}");
        }
    }
}

#[test]
fn all_mistakes_of_a_text_are_listed_one_on_a_line() {
    let file = InFile::new("[[steps]]\nspeed = 50\n[[steps]]\ngo = \"home\"\npause = \"long\"\n");
    for verb in ["play", "check"] {
        let outcome = dobot(&[verb, &file.path()]).fails(1, &["job.toml has 3 mistakes:"]);
        let lines: Vec<&str> = outcome.stderr.lines().skip(1).collect();
        let starts = ["  line 2: ", "  line 3: ", "  line 5: "];
        assert_eq!(lines.len(), starts.len(), "{outcome:?}");
        for (line, start) in lines.iter().zip(starts) {
            assert!(line.starts_with(start), "{outcome:?}");
        }
    }
}

#[test]
fn an_old_file_of_the_vendors_program_plays_on_the_twin() {
    let data = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../teach/tests/data");
    for name in ["PlayBackPoints.xml", "program.play"] {
        let file = data.join(name);
        let file = file.to_str().expect("the path is text");
        let play = [
            "play",
            file,
            "--to",
            "virtual:",
            "--dialect",
            "firmware-1.1",
        ];
        let done = dobot(&play).succeeds().stdout;
        assert!(done.contains("is done"), "{done}");
    }
}

#[test]
fn a_program_is_played_starting_at_one_of_its_steps() {
    let file = InFile::new(CARRY);
    let play = ["play", &file.path(), "--to", "virtual:", "--dry-run"];
    let whole = json(&play);
    let rest = json(&[&play[..], &["--from", "2"]].concat());
    assert!(number(&rest["total_s"]) < number(&whole["total_s"]));
    let beyond = dobot(&[&play[..], &["--from", "99"]].concat());
    beyond.fails(2, &["4 steps", "--from is 99"]);
}

/// The numbers of a file of the vendor's program, in their order.
fn numbers(xml: &str) -> Vec<String> {
    let text = xml.split(['<', '>']).skip(2).step_by(2);
    text.filter(|part| part.trim().parse::<f64>().is_ok())
        .map(|part| part.trim().to_owned())
        .collect()
}

#[test]
fn an_old_file_becomes_a_program_and_an_old_file_again_with_all_its_numbers() {
    let folder = tempfile::tempdir().expect("there is room");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let old =
        PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../teach/tests/data/PlayBackPoints.xml");
    let (program, again) = (path("job.toml"), path("again.xml"));
    dobot(&["convert", &old.display().to_string(), &program]).succeeds();
    dobot(&["check", &program, "--schema"]).fails(2, &["--schema"]);
    dobot(&["convert", &program, &again]).succeeds();
    let read = |file: &str| std::fs::read_to_string(file).expect("it was written");
    let old = numbers(&read(&old.display().to_string()));
    assert!(old.len() > 20);
    assert_eq!(numbers(&read(&again)), old);
}

#[test]
fn an_existing_file_is_overwritten_only_on_request() {
    let file = InFile::new(CARRY);
    let other = InFile::new("what was there");
    let convert = ["convert", &file.path(), &other.path()];
    dobot(&convert).fails(1, &["cannot write", "--force"]);
    let text = || std::fs::read_to_string(other.path()).expect("it is there");
    assert_eq!(text(), "what was there");
    dobot(&[&convert[..], &["--force"]].concat()).succeeds();
    dobot(&["check", &other.path()]).succeeds();
}

#[test]
fn content_that_another_form_cannot_carry_is_reported() {
    let file = InFile::new(
        "[[steps]]\ngo = { base = 0, rear = 40, fore = 40 }\nsuction = true\n[[steps]]\nwait = \"put a cube down\"\n",
    );
    let points = file.folder.path().join("points.xml").display().to_string();
    let output = dobot(&["convert", &file.path(), &points]).succeeds().stderr;
    assert!(
        output.contains("warning: ") && output.contains("line 4"),
        "{output}"
    );
}

#[test]
fn positions_are_converted_to_joint_angles_and_those_out_of_reach_are_named() {
    let folder = tempfile::tempdir().expect("there is room");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let example = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("../../examples/programs/pick-and-place.toml");
    let points = path("points.xml");
    dobot(&["convert", &example.display().to_string(), &points]).succeeds();
    dobot(&["check", &points]).succeeds();
    let far = InFile::new("[[steps]]\ngo = { x = 400, y = 0, z = 0 }\n");
    dobot(&["convert", &far.path(), &path("far.xml")])
        .fails(1, &["line 1: step 1 (go to x 400 y 0 z 0)", "too far"]);
}

#[test]
fn speeds_of_jogs_do_not_become_those_of_moves() {
    let jog = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../teach/tests/data/JogParams.json");
    let folder = tempfile::tempdir().expect("there is room");
    let speeds = folder.path().join("speeds.toml").display().to_string();
    dobot(&["convert", &jog.display().to_string(), &speeds]).fails(
        1,
        &[
            "speeds of jogs",
            "dobot set jog --joint-speed 15 ",
            "--percent 50",
        ],
    );
    let jog = folder.path().join("JogParams.json").display().to_string();
    let program = example("../programs/pick-and-place.toml");
    dobot(&["convert", &program, &jog]).fails(1, &["speeds of jogs", "PlayBackParams.json"]);
}

#[test]
fn a_correct_program_is_reported_with_its_times() {
    let file = InFile::new(CARRY);
    let report = &json(&["check", &file.path()])["report"];
    assert_eq!(report["problems"], Value::Array(Vec::new()), "{report}");
    assert!(number(&report["cycle_s"]) > 1.0, "{report}");
    let schema = dobot(&["check", "--schema"]).succeeds().stdout;
    let schema: Value = serde_json::from_str(&schema).expect("it is JSON");
    assert!(schema["properties"]["steps"].is_object(), "{schema}");
}
