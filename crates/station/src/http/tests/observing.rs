//! Health, metrics and events, for monitoring.

use std::time::Duration;

use axum::body::Body;
use dobot_api::{News, Role};
use dobot_host::PassedPacket;
use dobot_wire::{Command, Dialect, Status};
use futures_util::StreamExt;
use serde_json::Value;
use tower::ServiceExt;

use super::Harness;
use crate::sample::{notice, state};

#[tokio::test]
async fn health_is_public_and_metrics_are_for_watchers() {
    let harness = Harness::far();
    assert_eq!(harness.get("/healthz").await.is(200).body, "ok\n");
    harness.get("/metrics").await.is(401);
    let bearer = harness.bearer(Role::Watch);
    let request = harness
        .request("GET", "/metrics")
        .header("authorization", bearer);
    harness
        .send(request.body(Body::empty()).unwrap())
        .await
        .is(200);
}

#[tokio::test]
async fn the_metrics_are_those_of_the_state_each_explained_once() {
    let harness = Harness::near();
    let reported = state(7.5);
    harness.publisher.ends.publish_state(reported.clone());
    let answer = harness.get("/metrics").await;
    let text = &answer.is(200).body;
    let figure = |name: &str| {
        let line = text
            .lines()
            .find(|line| line.starts_with(&format!("{name} ")));
        line.unwrap_or_else(|| panic!("{name} in {text}"))[name.len()..]
            .trim()
            .parse::<f64>()
            .unwrap()
    };
    let same = |name: &str, value: f64| {
        let found = figure(name);
        assert!(
            (found - value).abs() < 1e-9,
            "{name} is {found}, not {value}"
        );
    };
    same("dobot_link_up", 1.0);
    same("dobot_statuses_per_second", reported.link.statuses_per_s);
    same("dobot_queue_ahead_seconds", reported.queue.ahead_s);
    let status = reported.arm.unwrap().status;
    same(
        "dobot_arm_position_millimetres{axis=\"x\"}",
        f64::from(status.x_mm),
    );
    same(
        "dobot_arm_joint_degrees{joint=\"fore\"}",
        f64::from(status.fore_deg),
    );
    // Prometheus requires that a sample follows the help and the type of its name.
    let mut known = Vec::new();
    for line in text.lines() {
        if let Some(rest) = line.strip_prefix("# TYPE ") {
            let name = rest.split(' ').next().unwrap();
            assert!(!known.contains(&name), "{name} twice");
            known.push(name);
        } else if !line.starts_with("# HELP ") {
            let name = line.split(['{', ' ']).next().unwrap();
            assert_eq!(known.last(), Some(&name), "{line}");
        }
    }
}

/// Returns the events of a text, as pairs of name and data.
fn events(text: &str) -> Vec<(String, Value)> {
    let blocks = text.split("\n\n").filter(|part| !part.is_empty());
    let field = |block: &str, name: &str| {
        let line = block.lines().find_map(|line| line.strip_prefix(name));
        line.unwrap_or_default().trim().to_owned()
    };
    blocks
        .map(|block| {
            let data = serde_json::from_str(&field(block, "data:")).unwrap();
            (field(block, "event:"), data)
        })
        .collect()
}

#[tokio::test]
async fn events_begin_with_the_state_and_the_missed_notices() {
    let harness = Harness::near();
    harness.publisher.ends.publish_state(state(7.5));
    for number in 1..=4 {
        let notice = notice(number, News::LinkUp, "the link came up");
        harness.publisher.ends.publish_notice(notice);
    }
    let request = harness
        .request("GET", "/api/v1/events")
        .header("last-event-id", "2");
    let answer = harness.send(request.body(Body::empty()).unwrap()).await;
    let found = events(&answer.is(200).body);
    assert_eq!(found[0].0, "state");
    assert_eq!(found[0].1["state"]["at_s"], 7.5);
    let numbers: Vec<_> = found[1..]
        .iter()
        .map(|(name, data)| (name.as_str(), data["notice"]["number"].as_u64().unwrap()))
        .collect();
    assert_eq!(numbers, [("notice", 3), ("notice", 4)]);
    assert_eq!(answer.headers["content-type"], "text/event-stream");
}

#[tokio::test]
async fn only_the_selected_events_are_sent() {
    let harness = Harness::near();
    let answer = harness.get("/api/v1/events?states=0").await;
    assert_eq!(answer.is(200).body, "");
    for wrong in ["states=-1", "name=me", "colour=red"] {
        harness
            .get(&format!("/api/v1/events?{wrong}"))
            .await
            .is(400)
            .is_problem("malformed");
    }
    let request = harness
        .request("GET", "/api/v1/events")
        .header("last-event-id", "yesterday");
    harness
        .send(request.body(Body::empty()).unwrap())
        .await
        .is(400)
        .is_problem("malformed");
}

#[tokio::test]
async fn packets_are_reported_in_both_directions_and_decoded_and_dropped_ones_are_counted() {
    let harness = Harness::near();
    let request = harness.request("GET", "/api/v1/packets");
    let mut request = request.body(Body::empty()).unwrap();
    request.extensions_mut().insert(harness.peer.clone());
    let answer = harness.router.clone().oneshot(request).await.unwrap();
    assert_eq!(answer.headers()["content-type"], "text/event-stream");
    let mut body = answer.into_body().into_data_stream();
    let mut next = async || {
        let piece = body.next().await.unwrap().unwrap();
        events(std::str::from_utf8(&piece).unwrap()).remove(0)
    };
    let publish = |to_arm: bool, bytes: [u8; 42]| {
        let at = Duration::from_millis(1_500);
        let ends = &harness.publisher.ends;
        ends.publish_packet(PassedPacket {
            at,
            to_arm,
            bytes,
            pen_below_mm: None,
        });
    };
    publish(false, Status::AT_ZERO.emit().to_bytes());
    let (name, packet) = next().await;
    assert_eq!(
        (name.as_str(), &packet["direction"]),
        ("packet", &"from_arm".into())
    );
    assert_eq!(packet["at_s"], 1.5);
    assert_eq!(packet["status"]["z_mm"], 135.0);

    let text = r#"{"type": "move_to", "x_mm": 200, "y_mm": 0, "z_mm": 50, "rotation_deg": 0, "suction": false, "mode": "jump", "gripper_deg": 0, "pause_s": 0}"#;
    let command: Command = serde_json::from_str(text).unwrap();
    publish(true, command.emit(&Dialect::FIRMWARE_1_1).to_bytes());
    let (_, packet) = next().await;
    assert_eq!(packet["direction"], "to_arm");
    assert_eq!(packet["command"]["x_mm"], 200.0);
    assert_eq!(packet["bytes"].as_str().unwrap().len(), 84);

    publish(true, [0xA5; 42]);
    let (_, packet) = next().await;
    assert!(
        packet["command"].is_null() && packet["problem"].is_string(),
        "{packet}"
    );

    for _ in 0..1_030 {
        publish(false, Status::AT_ZERO.emit().to_bytes());
    }
    let (name, lost) = next().await;
    assert_eq!((name.as_str(), &lost["lost"]), ("lost", &6.into()));
}
