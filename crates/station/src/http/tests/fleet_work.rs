//! Jobs for any arm of the fleet: submitted here, and offered to this station.

use axum::body::Body;
use dobot_api::{Role, TakesWork, WorkPhase, WorkView};
use serde_json::{Value, json};

use super::slots::is_time_of;
use super::{Answer, Harness};
use crate::{FleetChannels, FleetCommand, FleetPort, WorkCommand};

const OFFERS: &str = "/api/v1/fleet/offers";
const WORK: &str = "/api/v1/fleet/work";

/// A station of a fleet.
fn desk(takes_work: Option<TakesWork>) -> (Harness, FleetChannels) {
    joined(Harness::near(), takes_work)
}

fn joined(harness: Harness, takes_work: Option<TakesWork>) -> (Harness, FleetChannels) {
    let (port, end) = FleetPort::new("desk-2", "0123");
    harness.app.fleet.set(port.taking(takes_work)).unwrap();
    (harness, end)
}

fn job() -> Value {
    json!({"title": "a house", "kind": "drawing", "commands": [{"type": "move_to", "x_mm": 200, "y_mm": 0,
        "z_mm": 50, "rotation_deg": 0, "suction": false, "mode": "jump", "gripper_deg": 0, "pause_s": 0}]})
}

async fn offer(harness: &Harness, key: &str) -> Answer {
    let body = json!({"by": "desk-1", "student": "Anna", "job": job()});
    let request = harness
        .request("POST", OFFERS)
        .header("content-type", "application/json")
        .header("idempotency-key", key);
    harness
        .send(request.body(Body::from(body.to_string())).unwrap())
        .await
}

#[tokio::test]
async fn an_offer_is_accepted_once_and_the_next_one_finds_the_arm_busy() {
    let (harness, _end) = desk(Some(TakesWork::Queue));
    let first = offer(&harness, "a").await.is(200).value();
    assert_eq!(
        first["title"], "a house (Anna)",
        "who starts it knows whose it is"
    );
    assert_eq!(offer(&harness, "a").await.is(200).value(), first);
    let look = harness.get(&format!("{OFFERS}/a")).await;
    assert_eq!(look.is(200).value(), first);
    offer(&harness, "b").await.is(409).is_problem("arm-busy");
    offer(&harness, "b").await.is(409).is_problem("arm-busy");
}

#[tokio::test]
async fn in_the_slot_of_a_student_only_that_students_work_is_accepted() {
    let (harness, _end) = desk(Some(TakesWork::Queue));
    is_time_of(&harness, "Ben");
    let answer = offer(&harness, "a").await;
    let (kind, detail) = answer.is(409).problem();
    assert_eq!(
        (&*kind, &*detail),
        ("arm-busy", "it is the time of Ben at this arm")
    );
    is_time_of(&harness, "anna");
    offer(&harness, "b").await.is(200);
}

#[tokio::test]
async fn an_offer_withdrawn_before_it_arrives_is_refused_on_arrival() {
    let (harness, _end) = desk(Some(TakesWork::Queue));
    let path = format!("{OFFERS}/a");
    harness.get(&path).await.is(404).is_problem("no-such-work");
    let withdrawn = harness.bare("DELETE", &path).await;
    withdrawn.is(409).is_problem("work-refused");
    offer(&harness, "a")
        .await
        .is(409)
        .is_problem("work-refused");
}

#[tokio::test]
async fn a_station_accepts_no_work_unless_its_owner_has_enabled_it() {
    let (harness, _end) = desk(None);
    let answer = offer(&harness, "a").await;
    let (kind, detail) = answer.is(409).problem();
    assert_eq!(kind, "work-refused");
    assert!(detail.contains("`dobot up --takes-work`"), "{detail}");
    assert!(harness.asked().is_empty());
}

#[tokio::test]
async fn stations_of_the_fleet_may_offer_without_a_token_and_watchers_may_not() {
    let (mut harness, _end) = joined(Harness::far(), Some(TakesWork::Queue));
    let watcher = harness.bearer(Role::Watch);
    let request = harness.request("DELETE", &format!("{OFFERS}/a"));
    let request = request.header("authorization", watcher);
    let answer = harness.send(request.body(Body::empty()).unwrap()).await;
    answer.is(403).is_problem("role");
    harness.peer.by_fleet = true;
    offer(&harness, "a").await.is(200);
}

#[tokio::test]
async fn an_offer_without_a_key_or_with_two_jobs_is_refused_with_what_is_allowed() {
    let (harness, _end) = desk(Some(TakesWork::Queue));
    let body = json!({"by": "desk-1", "student": "Anna", "job": job()});
    let answer = harness.json("POST", OFFERS, body.to_string()).await;
    assert!(answer.is(400).problem().1.contains("Idempotency-Key"));
    for body in [
        json!({"by": "desk-1", "student": "Anna"}),
        json!({"by": "desk-1", "student": "Anna", "job": job(), "drawing": {}}),
        json!({"by": "desk-1", "student": "Anna", "job": job(), "made_for": [1.0]}),
    ] {
        let request = harness
            .request("POST", OFFERS)
            .header("content-type", "application/json")
            .header("idempotency-key", "a");
        let request = request.body(Body::from(body.to_string())).unwrap();
        harness.send(request).await.is(422).is_problem("invalid");
    }
    // None of it got a final response.
    offer(&harness, "a").await.is(200);
}

#[tokio::test]
async fn work_is_submitted_with_its_owner_and_its_needs() {
    let (harness, mut end) = desk(None);
    let body = json!({"job": job(), "needs": ["pen", "a5"], "student": "Anna", "group": "room-2"});
    let request = harness
        .request("POST", WORK)
        .header("content-type", "application/json")
        .header("idempotency-key", "7f3a");
    let request = request.body(Body::from(body.to_string())).unwrap();
    let answering = async {
        let Some(FleetCommand::Work(WorkCommand::Submit(work, reply))) = end.wishes.recv().await
        else {
            panic!("work is submitted");
        };
        reply.send(Ok(view(&work.title))).unwrap();
        work
    };
    let (answer, work) = tokio::join!(harness.send(request), answering);
    assert_eq!(answer.is(201).value()["title"], "a house");
    assert_eq!(
        (&*work.student, work.group.as_deref()),
        ("Anna", Some("room-2"))
    );
    assert_eq!(work.needs, ["pen", "a5"]);
    assert_eq!(work.key.as_deref(), Some("7f3a"));
    // The stored offer is what the other station accepts.
    assert_eq!(work.offer["by"], "desk-2");
    let (taker, _end) = desk(Some(TakesWork::Queue));
    let request = taker
        .request("POST", OFFERS)
        .header("content-type", "application/json")
        .header("idempotency-key", "a");
    let request = request.body(Body::from(work.offer.to_string())).unwrap();
    taker.send(request).await.is(200);
}

fn view(title: &str) -> WorkView {
    WorkView {
        id: "0".repeat(32),
        title: title.into(),
        student: "Anna".into(),
        group: None,
        needs: Vec::new(),
        submitted_ms: 0,
        phase: WorkPhase::Waiting,
        doubt: None,
        reason: None,
        member: None,
        job: None,
        before: Vec::new(),
    }
}

#[tokio::test]
async fn invalid_work_is_not_submitted() {
    let (harness, mut end) = desk(None);
    for (body, word) in [
        (json!({}), "a drawing or a job"),
        (json!({"job": job(), "drawing": {}}), "a drawing or a job"),
        (json!({"job": job(), "needs": ["A5 paper"]}), "as in a5"),
        (json!({"job": job(), "needs": vec!["pen"; 17]}), "up to 16"),
        (json!({"job": job(), "student": ""}), "1 to 60"),
        (json!({"job": job(), "group": "Room 2"}), "group"),
    ] {
        let answer = harness.json("POST", WORK, body.to_string()).await;
        let (kind, detail) = answer.is(422).problem();
        assert_eq!(kind, "invalid");
        assert!(detail.contains(word), "{detail}");
    }
    assert!(end.wishes.try_recv().is_err());
}

#[tokio::test]
async fn a_watcher_sees_the_work_and_changes_none() {
    let (harness, mut end) = joined(Harness::far(), None);
    let watcher = harness.bearer(Role::Watch);
    let body = json!({"job": job()}).to_string();
    let of = |method, path: &str, body: &str| {
        let request = harness.request(method, path);
        let request = request
            .header("authorization", &watcher)
            .header("content-type", "application/json");
        request.body(Body::from(body.to_owned())).unwrap()
    };
    for (method, path) in [
        ("POST", WORK),
        ("DELETE", "/api/v1/fleet/work/7"),
        ("POST", "/api/v1/fleet/work/7/give"),
    ] {
        let answer = harness.send(of(method, path, &body)).await;
        answer.is(403).is_problem("role");
    }
    let answering = async {
        let Some(FleetCommand::Work(WorkCommand::List(reply))) = end.wishes.recv().await else {
            panic!("the work is listed");
        };
        reply.send(Ok(vec![view("a house")])).unwrap();
    };
    let (answer, ()) = tokio::join!(harness.send(of("GET", WORK, "")), answering);
    assert_eq!(answer.is(200).value()[0]["title"], "a house");
}

#[tokio::test]
async fn a_station_without_a_fleet_explains_how_to_join_one() {
    let harness = Harness::near();
    for (method, path) in [("GET", WORK), ("DELETE", "/api/v1/fleet/work/7")] {
        harness
            .bare(method, path)
            .await
            .is(404)
            .is_problem("no-fleet");
    }
}
