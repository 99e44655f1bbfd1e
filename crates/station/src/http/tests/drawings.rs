//! Drawings over HTTP: planned, shown, cancelled, converted to jobs.

use std::time::Duration;

use axum::body::Body;
use dobot_api::{Request, Role};
use serde_json::{Value, json};

use super::{Answer, Harness};

const SVG: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="40mm" viewBox="0 0 40 40"><path d="M5 20H35" stroke="red" fill="none"/><path d="M20 5V35" stroke="blue" fill="none"/></svg>"#;

async fn begin(harness: &Harness, body: Value) -> Answer {
    let answer = harness
        .json("POST", "/api/v1/drawings", body.to_string())
        .await;
    let number = answer.is(202).value()["drawing"].clone();
    assert_eq!(
        answer.headers["location"],
        format!("/api/v1/drawings/{number}")
    );
    answer
}

fn file(name: &str, bytes: &[u8], place: &Value) -> Value {
    let file = data_encoding::BASE64.encode(bytes);
    json!({"name": name, "file": file, "options": {"what": {"layers": "color"}, "place": place}})
}

/// Plans a drawing, and waits for the end.
async fn planned(harness: &Harness, body: Value) -> Value {
    let number = begin(harness, body).await.value()["drawing"].clone();
    loop {
        let path = format!("/api/v1/drawings/{number}");
        let view = harness.bare("GET", &path).await.is(200).value();
        if view["phase"] != "waiting" && view["phase"] != "planning" {
            return view;
        }
    }
}

#[tokio::test]
async fn a_file_becomes_a_plan_with_its_layers_its_time_and_its_path() {
    let harness = Harness::near();
    let place = json!({"at": [200, 30], "pen_down": -30});
    let view = planned(&harness, file("cross.svg", SVG.as_bytes(), &place)).await;
    assert_eq!(view["phase"], "planned", "{view}");
    assert_eq!(view["title"], "cross.svg");
    let plan = &view["plan"];
    assert_eq!(plan["timeline"]["passes"].as_array().unwrap().len(), 2);
    assert_eq!(plan["pauses"].as_array().unwrap().len(), 1);
    assert_eq!(plan["refused"], Value::Null);
    assert!(plan["timeline"]["duration_s"].as_f64().unwrap() > 1.0);
    let bounds = &plan["timeline"]["bounds_mm"];
    assert!(
        (bounds[1][0].as_f64().unwrap() - 15.0).abs() < 0.1,
        "{bounds}"
    );
    assert!(
        (bounds[1][1].as_f64().unwrap() - 45.0).abs() < 0.1,
        "{bounds}"
    );
    assert_eq!(harness.asked(), []);
}

#[tokio::test]
async fn a_title_contains_no_terminal_control_characters() {
    let harness = Harness::near();
    let place = json!({"at": [200, 30], "pen_down": -30});
    let name = "\u{1b}[2Ja\u{7} cross\u{202e}";
    let view = planned(&harness, file(name, SVG.as_bytes(), &place)).await;
    assert_eq!(view["title"], "[2Ja cross");
}

#[tokio::test(start_paused = true)]
async fn a_plan_is_kept_for_half_an_hour_and_then_forgotten() {
    let harness = Harness::near();
    let place = json!({"at": [200, 30], "pen_down": -30});
    let view = planned(&harness, file("cross.svg", SVG.as_bytes(), &place)).await;
    let path = format!("/api/v1/drawings/{}", view["drawing"]);
    tokio::time::sleep(Duration::from_secs(29 * 60)).await;
    assert_eq!(harness.bare("GET", &path).await.value()["phase"], "planned");
    tokio::time::sleep(Duration::from_secs(2 * 60)).await;
    let view = harness.bare("GET", &path).await.value();
    assert_eq!(view["phase"], "failed", "{view}");
    assert_eq!(view["problem"]["hint"], "plan it again", "{view}");
}

#[tokio::test]
async fn a_text_is_placed_below_the_file_sent_with_it() {
    let harness = Harness::near();
    let place = json!({"at": [200, 30], "pen_down": -30});
    let alone = planned(&harness, file("cross.svg", SVG.as_bytes(), &place)).await;
    let mut both = file("cross.svg", SVG.as_bytes(), &place);
    both["options"]["what"] = json!({"layers": "color", "text": "Cross"});
    let both = planned(&harness, both).await;
    assert_eq!(both["phase"], "planned", "{both}");
    assert_eq!(both["title"], "cross.svg");
    let passes = |view: &Value| view["plan"]["timeline"]["passes"].as_array().unwrap().len();
    // The colours of the file, and the text.
    assert_eq!([passes(&alone), passes(&both)], [2, 3]);
    let high_mm = |view: &Value| {
        let bounds = &view["plan"]["timeline"]["bounds_mm"];
        bounds[1][0].as_f64().unwrap() - bounds[0][0].as_f64().unwrap()
    };
    assert!(high_mm(&both) > high_mm(&alone) + 3.0, "{both}");
}

#[tokio::test]
async fn a_job_is_made_from_a_plan_and_another_from_its_frame() {
    let harness = Harness::near();
    let text = json!({"options": {"what": {"text": "Hi"}, "place": {"pen_down": -30}}});
    let number = planned(&harness, text).await["drawing"].clone();
    let jobs = format!("/api/v1/drawings/{number}/jobs");
    harness.bare("POST", &jobs).await.is(201);
    let frame = json!({"part": "frame"}).to_string();
    harness.json("POST", &jobs, frame).await.is(201);
    let titles: Vec<String> = harness.asked().into_iter().map(title).collect();
    assert_eq!(titles, ["Hi", "frame of Hi"]);
}

fn title(request: Request) -> String {
    match request {
        Request::SubmitJob { job, .. } => job.title,
        other => panic!("{other:?}"),
    }
}

#[tokio::test]
async fn an_invalid_option_is_refused_at_once_with_its_field() {
    let harness = Harness::near();
    for (options, detail) in [
        (
            json!({"tool": {"laser": "cardboard-cut", "kerf": 7}}),
            "tool.kerf is 7 mm; it takes -5 to 5 mm",
        ),
        (
            json!({"way": {"tolerance": 0.001}}),
            "way.tolerance is 0.001 mm; it takes 0.02 to 10 mm",
        ),
        (
            json!({"place": {"fit": true, "scale": 2}}),
            "place.fit and place.scale exclude each other; use only one",
        ),
    ] {
        let body = json!({"options": options}).to_string();
        let refused = harness.json("POST", "/api/v1/drawings", body).await;
        let problem = refused.is(422).value();
        assert_eq!(problem["detail"], detail);
    }
    harness.bare("GET", "/api/v1/drawings/1").await.is(404);
}

#[tokio::test]
async fn an_undrawable_file_is_reported_and_no_job_is_made_of_it() {
    let harness = Harness::near();
    for (body, expected) in [
        (file("a.svg", b"no svg", &json!({})), "xml"),
        (file("a.xyz", b"\0\0\0\0", &json!({})), "a.xyz"),
        (
            file("far.svg", SVG.as_bytes(), &json!({"at": [900, 0]})),
            "900",
        ),
        (json!({"file": "%%%"}), "Base64"),
        (json!({}), "options.what.text"),
        (
            json!({"options": {"what": {"text": "a"}, "tool": {"pen": "quill"}}}),
            "quill",
        ),
    ] {
        let view = planned(&harness, body).await;
        assert_eq!(view["phase"], "failed", "{view}");
        let detail = view["problem"]["detail"].as_str().unwrap().to_lowercase();
        assert!(detail.contains(&expected.to_lowercase()), "{detail}");
        let jobs = format!("/api/v1/drawings/{}/jobs", view["drawing"]);
        harness.bare("POST", &jobs).await.is(422);
    }
    assert_eq!(harness.asked(), []);
}

#[tokio::test]
async fn a_plan_in_progress_is_cancelled_and_the_next_one_is_made() {
    let harness = Harness::near();
    let dots: Vec<String> = (0..20_000)
        .map(|n| format!("<path d=\"M{} {}h.3\" stroke=\"red\"/>", n % 141, n / 141))
        .collect();
    let dots = dots.concat();
    let long = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 150 150">{dots}</svg>"#
    );
    let number = begin(&harness, file("long.svg", long.as_bytes(), &json!({})))
        .await
        .value()["drawing"]
        .clone();
    let path = format!("/api/v1/drawings/{number}");
    harness.bare("DELETE", &path).await.is(204);
    harness.bare("GET", &path).await.is(404);
    harness.bare("DELETE", &path).await.is(404);
    let text = json!({"options": {"what": {"text": "Hi"}}});
    assert_eq!(planned(&harness, text).await["phase"], "planned");
}

#[tokio::test]
async fn the_latest_drawings_are_kept_and_the_oldest_deleted() {
    let harness = Harness::near();
    for _ in 0..17 {
        planned(&harness, json!({"file": "%"})).await;
    }
    harness.bare("GET", "/api/v1/drawings/1").await.is(404);
    harness.bare("GET", "/api/v1/drawings/2").await.is(200);
}

#[tokio::test]
async fn a_file_announced_as_too_large_is_not_read() {
    let harness = Harness::near();
    let endless = futures_util::stream::pending::<Result<Vec<u8>, std::io::Error>>();
    let request = harness
        .request("POST", "/api/v1/drawings")
        .header("content-type", "application/json")
        .body(axum::body::Body::new(AnnouncedBody(
            axum::body::Body::from_stream(endless),
        )))
        .unwrap();
    harness.send(request).await.is(413);
}

/// A body that never arrives, with a declared size of 100 MB.
struct AnnouncedBody(axum::body::Body);

impl axum::body::HttpBody for AnnouncedBody {
    type Data = axum::body::Bytes;
    type Error = axum::Error;

    fn poll_frame(
        mut self: std::pin::Pin<&mut Self>,
        cx: &mut std::task::Context<'_>,
    ) -> std::task::Poll<Option<Result<hyper::body::Frame<Self::Data>, Self::Error>>> {
        std::pin::Pin::new(&mut self.0).poll_frame(cx)
    }

    fn size_hint(&self) -> hyper::body::SizeHint {
        hyper::body::SizeHint::with_exact(100_000_000)
    }
}

#[tokio::test]
async fn the_pens_and_materials_are_listed_by_name() {
    let all = Harness::near()
        .bare("GET", "/api/v1/materials")
        .await
        .is(200)
        .value();
    let pen = json!({"name": "fineliner", "tool": "pen"});
    assert!(all.as_array().unwrap().contains(&pen), "{all}");
}

#[tokio::test]
async fn the_formats_are_listed_with_their_extensions_and_mime_types() {
    let all = Harness::near()
        .bare("GET", "/api/v1/formats")
        .await
        .is(200)
        .value();
    let dxf = json!({
        "name": "DXF", "extensions": ["dxf"], "mime_type": "image/vnd.dxf", "contents": "shapes",
    });
    assert!(all.as_array().unwrap().contains(&dxf), "{all}");
}

#[tokio::test]
async fn clients_that_may_queue_jobs_can_plan_drawings_and_watchers_cannot() {
    let harness = Harness::far();
    let body = json!({"options": {"what": {"text": "Hi"}, "place": {"pen_down": -30}}});
    let begin = async |role| {
        let request = harness
            .request("POST", "/api/v1/drawings")
            .header("authorization", harness.bearer(role))
            .header("content-type", "application/json")
            .body(Body::from(body.to_string()));
        harness.send(request.unwrap()).await
    };
    begin(Role::Watch).await.is(403).is_problem("role");
    let number = begin(Role::Queue).await.is(202).value()["drawing"].clone();
    let forget = harness
        .request("DELETE", &format!("/api/v1/drawings/{number}"))
        .header("authorization", harness.bearer(Role::Queue))
        .body(Body::empty());
    harness.send(forget.unwrap()).await.is(204);
}
