//! Programs over HTTP, as taught on the page.

use dobot_api::{JobKind, Request};
use dobot_wire::Command;
use serde_json::{Value, json};

use super::{Answer, Harness};

const CUBE: &str = r#"title = "one cube"

[points]
here = { x = 200, y = 60, z = 0 }        # the tray

[[steps]]
go = "here"
suction = true
pause = 0.5

[[steps]]
go = { x = 200, y = -60, z = 0 }
suction = false
"#;

async fn ask(harness: &Harness, what: &str, body: Value) -> Answer {
    let path = format!("/api/v1/programs/{what}");
    harness.json("POST", &path, body.to_string()).await
}

#[tokio::test]
async fn a_program_is_checked_as_a_whole() {
    let harness = Harness::near();
    let answer = ask(&harness, "check", json!({"text": CUBE})).await;
    let report = answer.is(200).value();
    assert_eq!(report["title"], "one cube");
    assert_eq!(report["problems"], json!([]));
    let lines: Vec<&Value> = report["steps"]
        .as_array()
        .unwrap()
        .iter()
        .map(|problem| &problem["line"])
        .collect();
    assert_eq!(lines, [6, 11]);
    assert!(report["once_s"].as_f64().unwrap() > 1.0);
    assert_eq!(harness.asked(), []);
}

#[tokio::test]
async fn every_problem_is_reported_with_its_line_and_a_remedy() {
    let harness = Harness::near();
    let far = CUBE
        .replace("y = -60", "y = -600")
        .replace("y = 60", "y = 500");
    let report = ask(&harness, "check", json!({"text": far}))
        .await
        .is(200)
        .value();
    let problems = report["problems"].as_array().unwrap();
    assert_eq!(problems.len(), 2, "{problems:?}");
    assert_eq!(
        (&problems[0]["line"], &problems[1]["line"]),
        (&json!(6), &json!(11))
    );
    assert!(problems.iter().all(|problem| problem["remedy"].is_string()));
    let text = "[[steps]]\ngo = \"nowhere\"";
    let report = ask(&harness, "check", json!({"text": text}))
        .await
        .is(200)
        .value();
    assert_eq!(report["problems"][0]["line"], 1);
    assert!(
        report["problems"][0]["message"]
            .as_str()
            .unwrap()
            .contains("nowhere")
    );
}

#[tokio::test]
async fn a_program_may_call_and_draw_only_the_files_sent_with_it() {
    let harness = Harness::near();
    let text = "[[steps]]\ngo = { x = 200, y = 0, z = 40 }\n[[steps]]\ncall = \"cube.toml\"\n[[steps]]\ndrawing = { file = \"line.svg\", pen_down = -30 }\n";
    let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="40mm" viewBox="0 0 40 40"><path d="M5 5H35" fill="none" stroke="black"/></svg>"#;
    let files = json!({"cube.toml": CUBE, "line.svg": svg});
    let report = ask(&harness, "check", json!({"text": text, "files": files}))
        .await
        .value();
    assert_eq!(report["problems"], json!([]), "{report}");
    let report = ask(
        &harness,
        "check",
        json!({"text": text.replace("cube.toml", "/etc/passwd")}),
    )
    .await
    .value();
    let message = report["problems"][0]["message"].as_str().unwrap();
    assert!(message.contains("/etc/passwd is missing"), "{message}");
}

#[tokio::test]
async fn edits_preserve_everything_else() {
    let harness = Harness::near();
    let edits = json!([
        {"type": "set_point", "name": "there", "point": {"x": 210, "y": 0, "z": 20}},
        {"type": "insert", "at": 1, "step": {"go": "there", "path": "movl"}},
        {"type": "move", "from": 2, "to": 0},
        {"type": "remove", "at": 1},
    ]);
    let edited = ask(&harness, "edit", json!({"text": CUBE, "edits": edits}))
        .await
        .is(200)
        .value();
    let text = edited["text"].as_str().unwrap();
    assert_eq!(edited["steps"], 2);
    assert!(text.contains("# the tray"), "{text}");
    let report = ask(&harness, "check", json!({"text": text})).await.value();
    assert_eq!(report["problems"], json!([]), "{text}");
    let labels: Vec<&str> = report["steps"]
        .as_array()
        .unwrap()
        .iter()
        .map(|label| label["label"].as_str().unwrap())
        .collect();
    assert!(labels[1].contains("there"), "{labels:?}");
}

#[tokio::test]
async fn a_jogged_path_becomes_few_steps() {
    let harness = Harness::near();
    let place = |x: i32| json!({"point_mm": [200 + x, 0, 20], "rotation_deg": 0, "suction": x > 20, "gripper_deg": 0});
    let places: Vec<Value> = (0..=40).map(place).collect();
    let edit = json!({"type": "insert_path", "at": 0, "places": places, "tolerance_mm": 0.5});
    let edited = ask(&harness, "edit", json!({"edits": [edit]}))
        .await
        .is(200)
        .value();
    assert_eq!(edited["steps"], 4, "{edited}");
    assert_eq!(
        edited["text"]
            .as_str()
            .unwrap()
            .matches("suction = true")
            .count(),
        1
    );
}

#[tokio::test]
async fn edits_that_break_the_program_change_nothing_and_are_named() {
    let harness = Harness::near();
    let edits = json!([{"type": "remove", "at": 0}, {"type": "remove", "at": 7}]);
    let (kind, detail) = ask(&harness, "edit", json!({"text": CUBE, "edits": edits}))
        .await
        .is(422)
        .problem();
    assert_eq!(kind, "bad-program");
    assert!(detail.starts_with("edit 1: "), "{detail}");
    ask(&harness, "edit", json!({"edits": []}))
        .await
        .is(422)
        .is_problem("bad-program");
    ask(&harness, "edit", json!({"text": "steps = 3", "edits": []}))
        .await
        .is(422)
        .is_problem("bad-program");
}

#[tokio::test]
async fn a_program_becomes_a_job_with_the_requested_repetitions_and_first_step() {
    let harness = Harness::near();
    let new = json!({"program": {"text": CUBE}, "from_step": 2, "times": {"count": 3}});
    ask(&harness, "jobs", new).await.is(201);
    let [Request::SubmitJob { job, .. }] = &harness.asked()[..] else {
        panic!("{:?}", harness.asked());
    };
    assert_eq!((job.kind, &*job.title), (JobKind::Program, "one cube"));
    assert_eq!(job.program.repeat.unwrap().times, Some(2));
    for (new, kind) in [
        (
            json!({"program": {"text": CUBE}, "from_step": 3}),
            "out-of-range",
        ),
        (
            json!({"program": {"text": CUBE}, "times": {"count": 0}}),
            "out-of-range",
        ),
        (
            json!({"program": {"text": CUBE.replace("200", "900")}}),
            "bad-program",
        ),
        (json!({"program": {"text": "nonsense"}}), "bad-program"),
    ] {
        ask(&harness, "jobs", new).await.is(422).is_problem(kind);
    }
    assert_eq!(harness.asked().len(), 1);
}

/// Lines: 1 the first step, 3 a call, 5 the question, 10 and 15 the steps of its answers.
const LINES: &str = r#"[[steps]]
go = { x = 200, y = 0, z = 50 }
[[steps]]
call = "aside.toml"
[[steps]]
choose = "Where to?"
[[steps.when]]
answer = "left"

[[steps.when.steps]]
go = { x = 210, y = 50, z = 50 }
[[steps.when]]
answer = "right"

[[steps.when.steps]]
go = { x = 210, y = -50, z = 50 }
"#;

#[tokio::test]
async fn a_job_starts_at_the_first_step_from_a_line_on_in_calls_and_behind_answers() {
    let harness = Harness::near();
    let files = json!({"aside.toml": "title = \"aside\"\n\n\n\n\n\n\n\n[[steps]]\ngo = { x = 220, y = 0, z = 50 }"});
    let text = format!("title = \"t\"\n{LINES}");
    let job = |line: usize| json!({"program": {"text": text, "files": files}, "from_line": line});
    // The first target, and the line of its step. The title is a line, too.
    for (line, x, y, of) in [
        (1, 200.0, 0.0, 2),
        (3, 220.0, 0.0, 4),
        (4, 220.0, 0.0, 4),
        (6, 210.0, 50.0, 11),
        (11, 210.0, 50.0, 11),
        (13, 210.0, -50.0, 16),
        (16, 210.0, -50.0, 16),
    ] {
        ask(&harness, "jobs", job(line)).await.is(201);
        let asked = harness.asked();
        let Some(Request::SubmitJob { job, .. }) = asked.last() else {
            panic!("{asked:?}");
        };
        let Some(Command::MoveTo(first)) = job.commands.first() else {
            panic!("{:?}", job.commands);
        };
        assert_eq!((first.x_mm, first.y_mm), (x, y), "line {line}");
        assert_eq!(job.program.lines[0], of, "line {line}");
    }
    for line in [0, 18] {
        let (_, detail) = ask(&harness, "jobs", job(line)).await.is(422).problem();
        let expected = format!(
            "from_line is {line}; allowed are 1 to 16, the line of the last step that does something"
        );
        assert_eq!(detail, expected);
    }
    let both = json!({"program": {"text": CUBE}, "from_line": 1, "from_step": 1});
    ask(&harness, "jobs", both)
        .await
        .is(422)
        .is_problem("out-of-range");
}

#[tokio::test]
async fn a_vendor_file_becomes_a_program_and_a_vendor_file_again() {
    let harness = Harness::near();
    let text = "[[steps]]\ngo = { base = 0, rear = 40, fore = 45 }\n\n[[steps]]\ngo = { x = 200, y = 0, z = 30 }\n";
    let ask = async |body: serde_json::Value| {
        let path = "/api/v1/programs/convert";
        harness.json("POST", path, body.to_string()).await
    };
    for form in ["xml", "play"] {
        let answer = ask(json!({"text": text, "to": form})).await;
        let file = answer.is(200).value();
        assert_eq!(file["warnings"].as_array().unwrap().len(), 0, "{file}");
        let bytes = file["text"].as_str().unwrap().as_bytes();
        let data = data_encoding::BASE64.encode(bytes);
        let answer = ask(json!({"data": data, "from": form, "to": "toml"})).await;
        let back = answer.is(200).value();
        let back = back["text"].as_str().unwrap();
        assert!(back.contains("rear = 40"), "{back}");
        assert_eq!(back.matches("[[steps]]").count(), 2, "{back}");
    }
    let calls =
        "[[steps]]\ncall = \"twist.toml\"\n\n[[steps]]\ngo = { base = 10, rear = 40, fore = 45 }\n";
    let answer = ask(json!({"text": calls, "to": "play", "files": {"twist.toml": text}})).await;
    let file = answer.is(200).value();
    let points = dobot_teach::ProgramForm::Play
        .read(file["text"].as_str().unwrap().as_bytes())
        .unwrap();
    assert_eq!(points.content.steps.0.len(), 3, "{file}");
    for wrong in [
        json!({"text": calls, "to": "play"}),
        json!({"to": "xml"}),
        json!({"data": "%", "from": "xml", "to": "toml"}),
        json!({"text": "nonsense", "to": "xml"}),
        json!({"text": "[[steps]]\npause = 1\n", "to": "play"}),
        json!({"text": "[[steps]]\ngo = { x = 400, y = 0, z = 0 }\n", "to": "play"}),
    ] {
        let answer = ask(wrong).await;
        assert_eq!(answer.is(422).problem().0, "bad-program");
    }
}
