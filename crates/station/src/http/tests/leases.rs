//! Control over plain HTTP.

use std::time::Duration;

use axum::body::Body;
use dobot_api::{ClientId, Request, Role};

use super::{Answer, Harness};

async fn with_lease(harness: &Harness, method: &str, path: &str, token: &str) -> Answer {
    let request = harness.request(method, path).header("dobot-lease", token);
    harness.send(request.body(Body::empty()).unwrap()).await
}

fn token(answer: &Answer) -> String {
    answer.is(200).value()["token"].as_str().unwrap().to_owned()
}

/// Returns the clients that left, after all requests have been received.
async fn gone(harness: &Harness) -> Vec<ClientId> {
    harness.app.handle.jobs().await.unwrap();
    harness.publisher.gone.lock().unwrap().clone()
}

#[tokio::test(start_paused = true)]
async fn requests_with_a_lease_token_come_from_one_client_and_others_from_many() {
    let harness = Harness::near();
    let taken = harness
        .json("POST", "/api/v1/lease", r#"{"name": "script"}"#)
        .await;
    let token = token(&taken);
    assert_eq!(taken.value()["lease"]["client"], 1);
    with_lease(&harness, "POST", "/api/v1/jog/release", &token)
        .await
        .is(200);
    with_lease(&harness, "POST", "/api/v1/lease", &token)
        .await
        .is(200);
    harness.bare("POST", "/api/v1/jog/release").await.is(200);
    assert_eq!(harness.asked.clients(), [1, 1, 1, 2].map(ClientId));
    assert_eq!(gone(&harness).await, [ClientId(2)]);
}

#[tokio::test(start_paused = true)]
async fn a_lease_that_is_not_used_for_ten_seconds_expires() {
    let harness = Harness::near();
    let token = token(&harness.bare("POST", "/api/v1/lease").await);
    for _ in 0..3 {
        tokio::time::advance(Duration::from_millis(9900)).await;
        with_lease(&harness, "POST", "/api/v1/lease", &token)
            .await
            .is(200);
    }
    tokio::time::advance(Duration::from_millis(10_100)).await;
    harness.app.http_leases.sweep(harness.app.now());
    assert_eq!(gone(&harness).await, [ClientId(1)]);
    with_lease(&harness, "POST", "/api/v1/jog/release", &token)
        .await
        .is(409)
        .is_problem("lease-gone");
}

#[tokio::test(start_paused = true)]
async fn a_lease_that_is_returned_ends_at_once() {
    let harness = Harness::near();
    let token = token(&harness.bare("POST", "/api/v1/lease").await);
    with_lease(&harness, "DELETE", "/api/v1/lease", &token)
        .await
        .is(200);
    assert_eq!(harness.asked(), [Request::TakeLease, Request::ReleaseLease]);
    assert_eq!(gone(&harness).await, [ClientId(1)]);
    with_lease(&harness, "DELETE", "/api/v1/lease", &token)
        .await
        .is(409)
        .is_problem("lease-gone");
    harness
        .bare("DELETE", "/api/v1/lease")
        .await
        .is(409)
        .is_problem("no-lease");
}

#[tokio::test(start_paused = true)]
async fn a_request_for_control_stays_until_it_is_granted() {
    let harness = Harness::near();
    let token = token(&harness.bare("POST", "/api/v1/lease/ask").await);
    with_lease(&harness, "POST", "/api/v1/jog/release", &token)
        .await
        .is(200);
    assert_eq!(harness.asked.clients(), [1, 1].map(ClientId));
}

#[tokio::test(start_paused = true)]
async fn a_client_whose_request_is_refused_is_not_kept() {
    let harness = Harness::near();
    let answer = harness
        .json("POST", "/api/v1/lease", r#"{"name": "refused"}"#)
        .await;
    answer.is(409).is_problem("laser-disarmed");
    assert_eq!(gone(&harness).await, [ClientId(1)]);
}

#[tokio::test(start_paused = true)]
async fn a_lease_token_is_useless_to_a_client_that_may_only_watch() {
    let harness = Harness::far();
    let request = |role, path| {
        harness
            .request("POST", path)
            .header("authorization", harness.bearer(role))
    };
    let taken = harness
        .send(
            request(Role::Control, "/api/v1/lease")
                .body(Body::empty())
                .unwrap(),
        )
        .await;
    let stolen = request(Role::Watch, "/api/v1/jog/release").header("dobot-lease", token(&taken));
    harness
        .send(stolen.body(Body::empty()).unwrap())
        .await
        .is(403)
        .is_problem("role");
}

#[tokio::test(start_paused = true)]
async fn the_number_of_pending_lease_requests_is_limited() {
    let harness = Harness::near();
    for _ in 0..64 {
        harness.bare("POST", "/api/v1/lease/ask").await.is(200);
    }
    harness
        .bare("POST", "/api/v1/lease/ask")
        .await
        .is(429)
        .is_problem("too-many-clients");
}

#[tokio::test(start_paused = true)]
async fn names_are_short_and_can_be_printed() {
    let harness = Harness::near();
    for name in ["", "a\\nb", &"x".repeat(61)] {
        let answer = harness
            .json("POST", "/api/v1/lease", format!(r#"{{"name": "{name}"}}"#))
            .await;
        answer.is(422).is_problem("invalid");
    }
    assert!(harness.asked().is_empty());
}
