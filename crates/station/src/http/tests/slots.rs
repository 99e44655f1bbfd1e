//! Time slots: requests to the driver, and the names of people.

use axum::body::Body;
use dobot_api::{Request, Role, SlotView, SlotsView, State, TimeSlot};
use serde_json::json;

use super::Harness;

fn anna() -> TimeSlot {
    TimeSlot {
        student: "Anna".into(),
        group: Some("red".into()),
        starts_in_s: 0.0,
        ends_in_s: 900.0,
    }
}

#[tokio::test]
async fn slots_are_set_shown_and_cleared() {
    let harness = Harness::near();
    let body = json!({"slots": [anna()]}).to_string();
    harness.json("PUT", "/api/v1/slots", body).await.is(200);
    harness.get("/api/v1/slots").await.is(200);
    harness.bare("DELETE", "/api/v1/slots").await.is(200);
    let expected = [
        Request::SetSlots {
            slots: vec![anna()],
        },
        Request::ShowSlots,
        Request::SetSlots { slots: Vec::new() },
    ];
    assert_eq!(harness.asked(), expected);
    assert_eq!(
        expected.map(|expected| expected.role()),
        [Role::Admin, Role::Watch, Role::Admin]
    );
}

#[tokio::test]
async fn an_invalid_list_of_slots_is_refused() {
    let harness = Harness::near();
    for body in [
        "{}",
        r#"{"slots": [{"student": "Anna"}]}"#,
        r#"{"slots": [{"student": "Anna", "starts_in_s": 0, "ends_in_s": "soon"}]}"#,
        r#"{"slots": [{"student": "Anna", "starts_in_s": 0, "ends_in_s": 9, "at": 12}]}"#,
        r#"{"slots": [{"student": "Anna", "starts_in_s": 0, "ends_in_s": 1e999}]}"#,
        r#"{"slots": [{"student": "Anna", "starts_in_s": NaN, "ends_in_s": 9}]}"#,
    ] {
        let answer = harness.json("PUT", "/api/v1/slots", body).await;
        assert!(matches!(answer.status, 400 | 422), "{body}: {answer:?}");
    }
    assert!(harness.asked().is_empty());
}

#[tokio::test]
async fn a_token_identifies_its_holder_unless_it_is_for_several_people() {
    let harness = Harness::far();
    let takes = async || {
        let request = harness
            .request("POST", "/api/v1/lease")
            .header("authorization", harness.bearer(Role::Control))
            .header("content-type", "application/json");
        let request = request.body(Body::from(r#"{"name": "Ben"}"#)).unwrap();
        harness.send(request).await.is(200);
    };
    takes().await;
    harness.app.tokens().share("control").unwrap();
    takes().await;
    let connected = harness.publisher.connected.lock().unwrap().clone();
    let expected = [("Ben", "control"), ("Ben", "Ben")];
    assert_eq!(
        connected,
        expected.map(|(name, person)| (name.into(), person.into()))
    );
}

#[tokio::test]
async fn a_token_for_a_class_is_created_and_listed_as_such() {
    let harness = Harness::near();
    let body = json!({"name": "class", "role": "control", "shared": true}).to_string();
    harness.json("POST", "/api/v1/tokens", body).await.is(201);
    let list = harness.get("/api/v1/tokens").await.is(200).value();
    let shared = |name: &str| {
        let all = list.as_array().unwrap();
        all.iter().find(|token| token["name"] == name).unwrap()["shared"].clone()
    };
    assert_eq!(
        (shared("class"), shared("control")),
        (true.into(), false.into())
    );
}

/// Publishes a state with an active time slot of a student.
pub(super) fn is_time_of(harness: &Harness, student: &str) {
    let slot = SlotView {
        student: student.into(),
        group: None,
        starts_s: 0.0,
        ends_s: 900.0,
    };
    let slots = SlotsView {
        now: Some(slot),
        next: None,
        free_s: Some(900.0),
    };
    harness.publisher.ends.publish_state(State {
        slots: Some(slots),
        ..crate::sample::state(1.0)
    });
}
