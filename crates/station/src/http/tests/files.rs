//! Stored files over HTTP.

use dobot_api::{JobPhase, News, Request, Role};
use serde_json::{Value, json};

use super::{Answer, Harness};
use crate::sample::notice;

const SVG: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="40mm" viewBox="0 0 40 40"><path d="M5 20H35" stroke="red" fill="none"/></svg>"#;

fn body(name: &str, content: &str, more: &Value) -> String {
    let content = data_encoding::BASE64.encode(content.as_bytes());
    let mut body = json!({"name": name, "content": content});
    let fields = more.as_object().unwrap().clone();
    body.as_object_mut().unwrap().extend(fields);
    body.to_string()
}

async fn put(harness: &Harness, name: &str, content: &str, more: Value) -> Answer {
    let body = body(name, content, &more);
    harness.json("POST", "/api/v1/files", body).await
}

/// Waits for the picture of a file.
async fn sketch(harness: &Harness, file: u64) -> Value {
    loop {
        let view = harness.get(&format!("/api/v1/files/{file}")).await.value();
        if view["has_sketch"] == true || view["problem"].is_string() {
            let path = format!("/api/v1/files/{file}/sketch");
            return harness.get(&path).await.is(200).value();
        }
        tokio::task::yield_now().await;
    }
}

#[tokio::test]
async fn a_file_is_stored_found_shown_and_deleted() {
    let harness = Harness::near();
    let answer = put(&harness, "Häfen.svg", SVG, json!({})).await;
    assert_eq!(answer.is(201).headers["location"], "/api/v1/files/1");
    put(&harness, "loop.toml", "[[steps]]\npause = 1\n", json!({}))
        .await
        .is(201);
    let list = harness.get("/api/v1/files").await.is(200).value();
    assert_eq!(list["files"][0]["kind"], "drawing");
    assert_eq!(list["files"][1]["kind"], "program");
    assert_eq!(list["used_bytes"], SVG.len() + 20);
    let found = harness
        .get("/api/v1/files?search=h%C3%84F")
        .await
        .is(200)
        .value();
    assert_eq!(found["files"].as_array().unwrap().len(), 1);
    harness
        .get("/api/v1/files?find=x")
        .await
        .is(400)
        .is_problem("malformed");
    let content = harness.get("/api/v1/files/1/content").await;
    assert_eq!(content.is(200).body, SVG);
    assert_eq!(content.headers["content-disposition"], "attachment");
    let sketch = sketch(&harness, 1).await;
    // One line from left to right, fitted to the paper.
    assert_eq!(
        sketch["path"].as_str().unwrap().matches('M').count(),
        1,
        "{sketch}"
    );
    assert!(sketch["view_mm"][2].as_f64().unwrap() > 30.0, "{sketch}");
    harness.bare("DELETE", "/api/v1/files/1").await.is(204);
    for path in [
        "/api/v1/files/1",
        "/api/v1/files/1/content",
        "/api/v1/files/1/sketch",
    ] {
        harness.get(path).await.is(404).is_problem("no-such-file");
    }
}

#[tokio::test]
async fn a_name_that_is_taken_is_a_question_with_three_answers() {
    let harness = Harness::near();
    put(&harness, "a.svg", SVG, json!({})).await.is(201);
    // The same content again is no question.
    assert_eq!(
        put(&harness, "a.svg", SVG, json!({})).await.is(200).value()["file"],
        1
    );
    let other = SVG.replace("red", "blue");
    let refused = put(&harness, "a.svg", &other, json!({})).await;
    refused.is(409).is_problem("file-exists");
    let both = put(&harness, "a.svg", &other, json!({"existing": "keep_both"})).await;
    assert_eq!(both.is(201).value()["name"], "a (2).svg");
    let replaced = put(&harness, "a.svg", &other, json!({"existing": "replace"})).await;
    let replaced = replaced.is(201).value();
    assert_eq!(
        (&replaced["file"], &replaced["revision"]),
        (&json!(1), &json!(2))
    );
    assert_eq!(harness.get("/api/v1/files/1/content").await.body, other);
}

#[tokio::test]
async fn the_second_of_two_pages_that_change_a_file_is_refused_and_loses_nothing() {
    let harness = Harness::near();
    put(&harness, "a.svg", SVG, json!({})).await.is(201);
    let change = |body: Value| harness.json("PUT", "/api/v1/files/1", body.to_string());
    let place = |x: f64| json!({"revision": 1, "options": {"place": {"at": [x, 0]}}});
    assert_eq!(change(place(200.0)).await.is(200).value()["revision"], 2);
    let refused = change(place(220.0)).await;
    refused.is(409).is_problem("file-changed");
    let view = harness.get("/api/v1/files/1").await.value();
    assert_eq!(view["options"]["place"]["at"][0], 200.0);
    let renamed = change(json!({"revision": 2, "name": "b.svg"})).await;
    assert_eq!(renamed.is(200).value()["name"], "b.svg");
}

#[tokio::test]
async fn names_contents_and_options_that_are_not_allowed_are_refused() {
    let harness = Harness::near();
    for name in [
        "../../tokens.toml",
        "a/b.svg",
        "..",
        "a\u{202e}b.svg",
        "a.exe",
        "",
        "a\0.svg",
    ] {
        let answer = put(&harness, name, SVG, json!({})).await;
        answer.is(422).is_problem("file-name");
    }
    let options = json!({"options": {"way": {"tolerance": -1}}});
    put(&harness, "a.svg", SVG, options)
        .await
        .is(422)
        .is_problem("bad-drawing");
    let text = r#"{"name": "a.svg", "content": "no Base64!"}"#.to_owned();
    harness
        .json("POST", "/api/v1/files", text)
        .await
        .is(422)
        .is_problem("invalid");
    put(&harness, "b.svg", SVG, json!({})).await.is(201);
    put(&harness, "c.svg", "other", json!({})).await.is(201);
    let taken = json!({"revision": 1, "name": "c.svg"}).to_string();
    let taken = harness.json("PUT", "/api/v1/files/1", taken).await;
    taken.is(409).is_problem("file-exists");
    let bad = json!({"revision": 1, "name": "../c.svg"}).to_string();
    let bad = harness.json("PUT", "/api/v1/files/1", bad).await;
    bad.is(422).is_problem("file-name");
    // Only the folder of the files has changed.
    let names = std::fs::read_dir(harness.folder.path()).unwrap();
    let names: Vec<_> = names.map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(names.len(), 2, "{names:?}");
}

#[tokio::test]
async fn a_file_that_is_no_drawing_is_stored_with_the_reason() {
    let harness = Harness::near();
    put(&harness, "letter.svg", "Dear all,", json!({}))
        .await
        .is(201);
    assert_eq!(sketch(&harness, 1).await, Value::Null);
    let view = harness.get("/api/v1/files/1").await.value();
    assert!(view["problem"].as_str().unwrap().contains("XML"), "{view}");
}

#[tokio::test]
async fn everyone_may_read_files_and_those_who_queue_jobs_may_change_them() {
    let harness = Harness::far();
    let ask = async |role, method: &str, path: &str, body: String| {
        let request = harness
            .request(method, path)
            .header("authorization", harness.bearer(role))
            .header("content-type", "application/json");
        harness.send(request.body(body.into()).unwrap()).await
    };
    let new = body("a.svg", SVG, &json!({}));
    let refused = ask(Role::Watch, "POST", "/api/v1/files", new.clone()).await;
    refused.is(403).is_problem("role");
    ask(Role::Queue, "POST", "/api/v1/files", new).await.is(201);
    ask(Role::Watch, "GET", "/api/v1/files/1/content", String::new())
        .await
        .is(200);
    let change = r#"{"revision": 1, "name": "b.svg"}"#.to_owned();
    ask(Role::Watch, "PUT", "/api/v1/files/1", change)
        .await
        .is(403)
        .is_problem("role");
    let refused = ask(Role::Watch, "DELETE", "/api/v1/files/1", String::new()).await;
    refused.is(403).is_problem("role");
    harness.get("/api/v1/files").await.is(401);
}

#[tokio::test]
async fn a_stored_file_is_drawn_and_remembers_placement_and_job() {
    let harness = Harness::near();
    put(&harness, "a.svg", SVG, json!({})).await.is(201);
    let options = json!({"place": {"at": [200.0, 30.0], "pen_down": -30.0}});
    let drawing = json!({"stored": 1, "options": options}).to_string();
    let drawing = harness.json("POST", "/api/v1/drawings", drawing).await;
    let number = drawing.is(202).value()["drawing"].clone();
    let path = format!("/api/v1/drawings/{number}");
    while harness.get(&path).await.is(200).value()["phase"] != "planned" {}
    harness.bare("POST", &format!("{path}/jobs")).await.is(201);
    assert!(
        matches!(&harness.asked()[..], [Request::SubmitJob { job, .. }] if job.title == "a.svg")
    );
    let view = harness.get("/api/v1/files/1").await.value();
    assert_eq!(view["options"]["place"]["at"], json!([200.0, 30.0]));
    assert_eq!(view["last_job"]["job"], 8, "{view}");
    let following = tokio::spawn(
        harness
            .app
            .clone()
            .follow_jobs(harness.app.handle.notices()),
    );
    let phase = JobPhase::Stopped;
    let news = News::Job { job: 8, phase };
    harness
        .publisher
        .ends
        .publish_notice(notice(1, news, "job 8 was stopped"));
    while harness.get("/api/v1/files/1").await.value()["last_job"]["phase"] != "stopped" {
        tokio::task::yield_now().await;
    }
    following.abort();
    let both = json!({"stored": 1, "name": "b.svg", "file": ""}).to_string();
    let both = harness.json("POST", "/api/v1/drawings", both).await;
    both.is(422).is_problem("bad-drawing");
    let missing = json!({"stored": 2}).to_string();
    let missing = harness.json("POST", "/api/v1/drawings", missing).await;
    missing.is(404).is_problem("no-such-file");
}

#[tokio::test]
async fn a_job_has_a_picture() {
    let harness = Harness::near();
    assert_eq!(
        harness.get("/api/v1/jobs/7/sketch").await.is(200).value(),
        Value::Null
    );
    harness
        .get("/api/v1/jobs/9/sketch")
        .await
        .is(404)
        .is_problem("no-such-job");
}
