//! Recordings over HTTP: list, download, states.

use std::time::Duration;

use dobot_record::{About, Limits, Record, Recorder};
use dobot_wire::Status;

use super::Harness;

const NAME: &str = "dobot-2026-11-21T12-30-00Z.mcap";

/// A station with a recording: at rest for a second, then moving along X.
fn recorded() -> Harness {
    let harness = Harness::near();
    let folder = harness.folder.path().join("recordings");
    let start = "2026-11-21T12:30:00Z".parse().unwrap();
    let recorder = Recorder::start(&folder, Limits::DEFAULT, About::default(), start).unwrap();
    for n in 0..100_u16 {
        let base_deg = f32::from(n.saturating_sub(12)) / 10.0;
        let status = Status {
            base_deg,
            ..at_base(base_deg)
        };
        let at = Duration::from_millis(80) * n.into();
        recorder.record(at, Record::FromArm(status.emit().to_bytes().to_vec()));
    }
    assert_eq!(recorder.finish().lost, 0);
    harness
}

/// A status of an arm that has only turned its base.
fn at_base(base_deg: f32) -> Status {
    let reach_mm = Status::AT_ZERO.x_mm;
    let (sin, cos) = base_deg.to_radians().sin_cos();
    Status {
        x_mm: reach_mm * cos,
        y_mm: reach_mm * sin,
        base_deg,
        rotation_deg: base_deg,
        ..Status::AT_ZERO
    }
}

#[tokio::test]
async fn recordings_are_listed_and_served_unchanged() {
    let harness = recorded();
    let listed = harness.get("/api/v1/recordings").await.is(200).value();
    assert_eq!(listed[0]["name"], NAME);
    assert_eq!(listed[0]["begin_ms"], 1_795_264_200_000_u64);
    assert_eq!(listed[0]["being_written"], false);
    let path = harness.folder.path().join("recordings").join(NAME);
    let file = std::fs::read(path).unwrap();
    assert_eq!(listed[0]["bytes"], file.len());
    let request = harness.request("GET", &format!("/api/v1/recordings/{NAME}"));
    let mut request = request.body(axum::body::Body::empty()).unwrap();
    request.extensions_mut().insert(harness.peer.clone());
    let answer = tower::ServiceExt::oneshot(harness.router.clone(), request);
    let answer = answer.await.unwrap();
    assert_eq!(answer.headers()["content-length"], file.len().to_string());
    let body = axum::body::to_bytes(answer.into_body(), usize::MAX);
    assert_eq!(body.await.unwrap(), file);
}

#[tokio::test]
async fn the_states_of_a_recording_give_the_places_of_the_arm() {
    let harness = recorded();
    let path = format!("/api/v1/recordings/{NAME}/states");
    let found = harness.get(&path).await.is(200).value();
    assert_eq!(found["begin_ms"], 1_795_264_200_000_u64);
    assert_eq!(found["spacing_s"], 0.0);
    let samples = found["samples"].as_array().unwrap();
    let reported: Vec<_> = samples
        .iter()
        .map(|sample| {
            (
                sample["at_s"].as_f64().unwrap(),
                sample["base_deg"].as_f64().unwrap(),
            )
        })
        .collect();
    assert_eq!(
        reported[..2],
        [(0.0, 0.0), (0.96, 0.0)],
        "a rest has two ends"
    );
    assert_eq!(reported.len(), 2 + 87);
    assert!((reported[88].1 - 8.7).abs() < 1e-4, "{:?}", reported[88]);
    let part = harness
        .get(&format!("{path}?from_s=2&to_s=4&most=10"))
        .await;
    let samples = part.is(200).value()["samples"].as_array().unwrap().clone();
    assert!((2..=10).contains(&samples.len()), "{samples:?}");
    for sample in samples {
        assert!((2.0..=4.0).contains(&sample["at_s"].as_f64().unwrap()));
    }
}

#[tokio::test]
async fn a_file_that_is_not_a_recording_of_the_station_is_not_read() {
    let harness = recorded();
    std::fs::write(harness.folder.path().join("recordings/notes.txt"), "x").unwrap();
    for name in ["notes.txt", "..%2Ftokens.toml", "dobot.mcap"] {
        for path in [name.to_owned(), format!("{name}/states")] {
            let answer = harness.get(&format!("/api/v1/recordings/{path}")).await;
            answer.is(404).is_problem("no-such-recording");
        }
    }
    for query in ["most=1", "most=5001", "from_s=-1", "from_s=3&to_s=2"] {
        let path = format!("/api/v1/recordings/{NAME}/states?{query}");
        harness.get(&path).await.is(422).is_problem("out-of-range");
    }
    let path = format!("/api/v1/recordings/{NAME}/states?form_s=1");
    harness.get(&path).await.is(400).is_problem("malformed");
}
