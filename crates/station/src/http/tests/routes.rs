//! The effect of each route, and its problems.

use std::collections::BTreeSet;

use axum::body::Body;
use axum::http::HeaderValue;
use dobot_api::{Button, ClientId, News, Request};
use dobot_wire::{Command, Dialect, JointJogAxis};
use tower::ServiceExt;

use super::Harness;
use crate::sample::{notice, state};

const MOVE: &str = r#"{"type": "move_to", "x_mm": 200, "y_mm": 0, "z_mm": 50, "rotation_deg": 0,
    "suction": false, "mode": "jump", "gripper_deg": 0, "pause_s": 0}"#;

#[tokio::test]
async fn the_state_is_the_last_reported_one() {
    let harness = Harness::near();
    harness.publisher.ends.publish_state(state(7.5));
    let answer = harness.get("/api/v1/state").await;
    assert_eq!(
        answer.is(200).value(),
        serde_json::to_value(state(7.5)).unwrap()
    );
    assert_eq!(answer.headers["content-type"], "application/json");
}

#[tokio::test]
async fn notices_are_kept_for_later_requests() {
    let harness = Harness::near();
    for number in 1..=300 {
        harness
            .publisher
            .ends
            .publish_notice(notice(number, News::LinkUp, "the link came up"));
    }
    let notices = harness.get("/api/v1/notices").await.is(200).value();
    let numbers: Vec<_> = notices
        .as_array()
        .unwrap()
        .iter()
        .map(|job| job["number"].as_u64().unwrap())
        .collect();
    assert_eq!(numbers, (101..=300).collect::<Vec<_>>());
    assert_eq!(notices[0]["type"], "link_up");
}

#[tokio::test]
async fn a_command_waits_for_its_turn() {
    let harness = Harness::near();
    let answer = harness
        .json(
            "POST",
            "/api/v1/commands",
            format!(r#"{{"command": {MOVE}}}"#),
        )
        .await;
    assert_eq!(answer.is(202).value()["command"], 12);
    assert!(
        matches!(&harness.asked()[..], [Request::Command { command: Command::MoveTo(to) }] if to.x_mm == 200.0)
    );
}

#[tokio::test]
async fn a_step_names_its_button_and_its_distance() {
    let harness = Harness::near();
    let step = |body: &str| harness.json("POST", "/api/v1/jog/step", body.to_owned());
    let body = r#"{"button": {"frame": "joint", "axis": "rear_minus"}, "by": 0.1}"#;
    step(body).await.is(200);
    let button = Button::Joint(JointJogAxis::RearMinus);
    assert_eq!(harness.asked(), [Request::Step { button, by: 0.1 }]);
    let other = r#"{"button": {"frame": "joint", "axis": "x_minus"}, "by": 0.1}"#;
    step(other).await.is(422);
}

#[tokio::test]
async fn a_waiting_client_learns_whether_the_arm_has_arrived() {
    for (news, status) in [
        (News::CommandDone { command: 12 }, 200),
        (News::CommandFailed { command: 12 }, 409),
    ] {
        let harness = Harness::near();
        let body = format!(r#"{{"command": {MOVE}, "wait": true}}"#);
        let publishing = async {
            while harness.asked().is_empty() {
                tokio::task::yield_now().await;
            }
            harness.publisher.ends.publish_notice(notice(
                1,
                News::CommandDone { command: 11 },
                "another",
            ));
            harness
                .publisher
                .ends
                .publish_notice(notice(2, news, "it stopped at a limit"));
        };
        let (answer, ()) = tokio::join!(harness.json("POST", "/api/v1/commands", body), publishing);
        answer.is(status);
        if status == 409 {
            assert_eq!(
                answer.problem(),
                ("not-reached".into(), "it stopped at a limit".into())
            );
        }
    }
}

#[tokio::test]
async fn each_route_sends_its_request_to_the_driver() {
    let harness = Harness::near();
    for (method, path, body) in [
        ("POST", "/api/v1/stop", r#"{"reason": "hot"}"#),
        ("DELETE", "/api/v1/stop", ""),
        ("POST", "/api/v1/lease/grant", r#"{"to": 3}"#),
        ("POST", "/api/v1/lock", r#"{"message": "eyes on me"}"#),
        ("DELETE", "/api/v1/lock", ""),
        ("POST", "/api/v1/message", r#"{"text": "well done"}"#),
        ("POST", "/api/v1/laser", r#"{"for_s": 60}"#),
        ("DELETE", "/api/v1/laser", ""),
        ("POST", "/api/v1/pose/confirm", "{}"),
        ("PUT", "/api/v1/dialect", r#"{"dialect": "specification"}"#),
        ("POST", "/api/v1/dialect/detect", ""),
        ("POST", "/api/v1/jobs/5/start", ""),
        ("POST", "/api/v1/jobs/5/step", ""),
        ("POST", "/api/v1/jobs/5/again", ""),
        ("PUT", "/api/v1/jobs/5/place", r#"{"before": 3}"#),
        ("PUT", "/api/v1/jobs/5/place", "{}"),
        ("POST", "/api/v1/jobs/5/forget", ""),
        ("POST", "/api/v1/jobs/pause", ""),
        ("DELETE", "/api/v1/jobs/5", ""),
        ("POST", "/api/v1/jog/release", ""),
    ] {
        let is_new = path.ends_with("/again");
        let status = if is_new { 201 } else { 200 };
        harness.json(method, path, body).await.is(status);
    }
    let dialect = Dialect::SPECIFICATION;
    let expected = [
        Request::Stop {
            reason: Some("hot".into()),
        },
        Request::ResetStop,
        Request::GrantLease { to: ClientId(3) },
        Request::Lock {
            message: Some("eyes on me".into()),
        },
        Request::Unlock,
        Request::Message {
            text: "well done".into(),
        },
        Request::ArmLaser { for_s: 60.0 },
        Request::DisarmLaser,
        Request::ConfirmPose,
        Request::SetDialect { dialect },
        Request::Detect,
        Request::StartJob { job: 5 },
        Request::StepJob { job: 5 },
        Request::QueueAgain { job: 5, key: None },
        Request::MoveJob {
            job: 5,
            before: Some(3),
        },
        Request::MoveJob {
            job: 5,
            before: None,
        },
        Request::ForgetJob { job: 5 },
        Request::PauseJob,
        Request::CancelJob { job: 5 },
        Request::Release,
    ];
    assert_eq!(harness.asked(), expected);
}

#[tokio::test]
async fn a_button_is_held() {
    let harness = Harness::near();
    let body = r#"{"jog": {"frame": "joint", "axis": "base_plus", "speed_percent": 50}}"#;
    harness.json("POST", "/api/v1/jog", body).await.is(200);
    assert!(matches!(harness.asked()[..], [Request::Jog { .. }]));
}

#[tokio::test]
async fn jobs_are_listed_shown_and_queued() {
    let harness = Harness::near();
    assert_eq!(
        harness.get("/api/v1/jobs").await.is(200).value()[0]["job"],
        7
    );
    assert_eq!(
        harness.get("/api/v1/jobs/7").await.is(200).value()["title"],
        "a house"
    );
    harness
        .get("/api/v1/jobs/8")
        .await
        .is(404)
        .is_problem("no-such-job");
    harness
        .get("/api/v1/jobs/seven")
        .await
        .is(400)
        .is_problem("malformed");
    harness
        .get("/api/v1/jobs/%FF")
        .await
        .is(400)
        .is_problem("malformed");
    let body = format!(r#"{{"title": "x", "kind": "program", "commands": [{MOVE}]}}"#);
    harness.json("POST", "/api/v1/jobs", body).await.is(201);
    harness
        .bare("POST", "/api/v1/jobs/404/start")
        .await
        .is(404)
        .is_problem("no-such-job");
}

#[tokio::test]
async fn a_request_that_queues_a_job_passes_its_key_on_and_names_the_job() {
    let harness = Harness::near();
    let body = format!(r#"{{"title": "x", "kind": "program", "commands": [{MOVE}]}}"#);
    for (path, body) in [
        ("/api/v1/jobs", body),
        ("/api/v1/jobs/5/again", String::new()),
    ] {
        let request = harness.request("POST", path);
        let request = request
            .header("content-type", "application/json")
            .header("idempotency-key", "7f3a");
        let answer = harness.send(request.body(body.into()).unwrap()).await;
        assert_eq!(answer.is(201).headers["location"], "/api/v1/jobs/8");
    }
    let keys = harness.asked().into_iter().map(|request| match request {
        Request::SubmitJob { key, .. } | Request::QueueAgain { key, .. } => key,
        other => panic!("{other:?}"),
    });
    assert_eq!(
        keys.collect::<Vec<_>>(),
        [Some("7f3a".to_owned()), Some("7f3a".to_owned())]
    );
}

#[tokio::test]
async fn an_invalid_page_is_refused_with_what_is_allowed() {
    let harness = Harness::near();
    for (query, status, kind) in [
        ("limit=0", 422, "out-of-range"),
        ("limit=1001", 422, "out-of-range"),
        ("limit=few", 400, "malformed"),
        ("after=9", 422, "out-of-range"),
        ("page=2", 400, "malformed"),
    ] {
        let answer = harness.get(&format!("/api/v1/jobs?{query}")).await;
        answer.is(status).is_problem(kind);
    }
    let last = harness.get("/api/v1/jobs?limit=1&after=7").await;
    assert_eq!(last.is(200).value(), serde_json::json!([]));
    assert!(!last.headers.contains_key("link"));
}

#[tokio::test]
async fn a_job_may_be_larger_than_other_bodies() {
    let harness = Harness::near();
    let commands = vec![MOVE; 10_000].join(",");
    let body = format!(r#"{{"title": "x", "kind": "program", "commands": [{commands}]}}"#);
    harness
        .json("POST", "/api/v1/jobs", body.clone())
        .await
        .is(201);
    harness
        .json("POST", "/api/v1/commands", body)
        .await
        .is(413)
        .is_problem("too-large");
}

#[tokio::test]
async fn policy_problems_page_and_document_are_there() {
    let harness = Harness::near();
    assert_eq!(
        harness.get("/api/v1/policy").await.is(200).value()["jog"]["dead_man_s"],
        0.15
    );
    let kind = harness
        .get("/api/v1/problems/no-lease")
        .await
        .is(200)
        .value();
    assert_eq!(kind["status"], 409);
    assert!(kind["explanation"].as_str().unwrap().contains("control"));
    harness
        .get("/api/v1/problems/nonsense")
        .await
        .is(404)
        .is_problem("unknown-path");
    for file in dobot_page::FILES {
        let answer = harness.get(file.path).await;
        let found = &answer.is(200).headers["content-type"];
        assert_eq!(found, file.content_type, "{}", file.path);
        let found = answer.body.as_bytes();
        assert_eq!(found, file.content().unwrap(), "{}", file.path);
    }
}

#[tokio::test]
async fn a_large_file_of_the_page_is_sent_compressed_to_a_client_that_accepts_it() {
    let harness = Harness::near();
    let path = &format!("/{}/vendor/three/three.js", dobot_page::VERSION);
    for (accepted, is_gzip) in [
        ("gzip, deflate, br, zstd", true),
        ("br, GZIP;q=0.5", true),
        ("gzip;q=0", false),
        ("identity", false),
    ] {
        let request = harness
            .request("GET", path)
            .header("accept-encoding", accepted)
            .extension(harness.peer.clone())
            .body(Body::empty());
        let response = harness.router.clone().oneshot(request.unwrap()).await;
        let response = response.unwrap();
        let headers = response.headers();
        let encoding = headers.get("content-encoding").map(HeaderValue::as_bytes);
        assert_eq!(encoding, is_gzip.then_some(&b"gzip"[..]), "{accepted}");
        assert_eq!(headers["vary"], "accept-encoding");
        assert_eq!(headers["content-type"], "text/javascript; charset=utf-8");
    }
}

#[tokio::test]
async fn the_page_and_its_modules_name_nothing_that_is_not_served() {
    let harness = Harness::near();
    let mut waiting = vec!["/".to_owned()];
    let mut seen = BTreeSet::new();
    while let Some(path) = waiting.pop() {
        if seen.insert(path.clone()) {
            let answer = harness.get(&path).await;
            waiting.extend(files_in(&path, &answer.is(200).body));
        }
    }
    // The files of the panel for drawings: it is loaded by the page, its worker by the panel.
    for file in [
        "preview/preview.js",
        "preview/reader.js",
        "stage/scene_3d.js",
    ] {
        let path = format!("/{}/{file}", dobot_page::VERSION);
        assert!(seen.contains(&path), "{path}");
    }
}

#[tokio::test]
async fn a_second_visit_gets_only_what_has_changed_and_a_first_one_compressed_files() {
    let harness = Harness::near();
    let get = async |path: &str, name: &str, value: &str| {
        let request = harness.request("GET", path).header(name, value);
        let mut request = request.body(Body::empty()).unwrap();
        request.extensions_mut().insert(harness.peer.clone());
        let answer = tower::ServiceExt::oneshot(harness.router.clone(), request);
        let (parts, body) = answer.await.unwrap().into_parts();
        let body = axum::body::to_bytes(body, usize::MAX).await.unwrap();
        (parts, body)
    };
    let page = harness.get("/").await;
    assert_eq!(page.is(200).headers["cache-control"], "no-cache");
    let tag = page.headers["etag"].to_str().unwrap();
    let (again, body) = get("/", "if-none-match", tag).await;
    assert_eq!((again.status.as_u16(), body.len()), (304, 0));
    let (other, _) = get("/", "if-none-match", "W/\"other\"").await;
    assert_eq!(other.status.as_u16(), 200);
    let app = format!("/{}/app.js", dobot_page::VERSION);
    let (kept, small) = get(&app, "accept-encoding", "br, gzip").await;
    let keep = kept.headers["cache-control"].to_str().unwrap();
    assert!(keep.contains("immutable"), "{keep}");
    assert_eq!(kept.headers["content-encoding"], "gzip");
    assert!(small.starts_with(&[0x1f, 0x8b]));
    let (plain, large) = get(&app, "accept-encoding", "identity").await;
    assert!(!plain.headers.contains_key("content-encoding"));
    assert!(
        small.len() * 2 < large.len(),
        "{} {}",
        small.len(),
        large.len()
    );
    // What the arm reports is never kept.
    let state = harness.get("/api/v1/state").await;
    assert_eq!(state.headers["cache-control"], "no-store");
}

/// Returns the scripts and styles that a file refers to, resolved from its path.
fn files_in(path: &str, text: &str) -> Vec<String> {
    let ours = |file: &&str| {
        let named = matches!(file.rsplit_once('.'), Some((_, "js" | "css")));
        named && !file.contains([' ', '(', ':'])
    };
    // The service worker is at a fixed path, and optional parts are served once they are installed.
    let is_module = |file: &&str| !["offline.js", "${files}hands.js"].contains(file);
    let quoted = text
        .split(['"', '\'', '`', '\n'])
        .filter(ours)
        .filter(is_module);
    let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
    quoted.map(|file| resolve(folder, file)).collect()
}

fn resolve(folder: &str, name: &str) -> String {
    let mut parts: Vec<&str> = folder.split('/').filter(|part| !part.is_empty()).collect();
    for part in name.split('/') {
        match part {
            "." => {}
            ".." => drop(parts.pop()),
            part => parts.push(part),
        }
    }
    format!("/{}", parts.join("/"))
}

#[tokio::test]
async fn unknown_paths_and_methods_are_reported() {
    let harness = Harness::near();
    harness
        .get("/api/v2/state")
        .await
        .is(404)
        .is_problem("unknown-path");
    let answer = harness.bare("PATCH", "/api/v1/lease").await;
    answer.is(405).is_problem("method");
    let allowed = answer.headers["allow"].to_str().unwrap();
    assert!(
        allowed.contains("POST") && allowed.contains("DELETE"),
        "{allowed}"
    );
    harness
        .bare("OPTIONS", "/api/v1/stop")
        .await
        .is(405)
        .is_problem("method");
    harness
        .get("/api/v1/ws")
        .await
        .is(426)
        .is_problem("upgrade");
}

#[tokio::test]
async fn bodies_are_json_of_bounded_size() {
    let harness = Harness::near();
    let request = harness
        .request("POST", "/api/v1/stop")
        .body(Body::from("reason=x"))
        .unwrap();
    harness.send(request).await.is(415).is_problem("media-type");
    let request = harness
        .request("POST", "/api/v1/stop")
        .header("content-type", "text/plain");
    harness
        .send(request.body(Body::from("{}")).unwrap())
        .await
        .is(415);
    let long = format!(r#"{{"reason": "{}"}}"#, "x".repeat(70_000));
    harness
        .json("POST", "/api/v1/stop", long)
        .await
        .is(413)
        .is_problem("too-large");
    let request = harness
        .request("POST", "/api/v1/stop")
        .header("content-type", "application/json; charset=utf-8");
    harness
        .send(request.body(Body::from("{}")).unwrap())
        .await
        .is(200);
    assert_eq!(harness.asked().len(), 1);
}

#[tokio::test(start_paused = true)]
async fn a_body_that_never_arrives_times_out() {
    let harness = Harness::near();
    let never = Body::from_stream(futures_util::stream::pending::<
        Result<String, std::io::Error>,
    >());
    harness
        .json("POST", "/api/v1/stop", never)
        .await
        .is(408)
        .is_problem("timeout");
}

#[tokio::test]
async fn a_station_that_ends_reports_it() {
    let harness = Harness::near();
    harness.app.handle.end().await;
    harness
        .bare("POST", "/api/v1/stop")
        .await
        .is(503)
        .is_problem("ending");
    harness
        .get("/api/v1/jobs")
        .await
        .is(503)
        .is_problem("ending");
    harness.get("/api/v1/state").await.is(200);
}
