//! Tokens over HTTP, for administrators.

use dobot_api::Role;
use serde_json::json;

use super::Harness;
use crate::http::access::tokens::digest;

#[tokio::test]
async fn an_administrator_creates_and_removes_tokens_whose_secrets_are_shown_once() {
    let harness = Harness::near();
    let body = json!({"name": "phone", "role": "control"}).to_string();
    let made = harness.json("POST", "/api/v1/tokens", body.clone()).await;
    let secret = made.is(201).value()["secret"].as_str().unwrap().to_owned();
    assert_eq!(
        harness.app.holder(&digest(&secret)),
        Some(("phone".into(), Role::Control))
    );
    let list = harness.get("/api/v1/tokens").await;
    assert!(list.is(200).body.contains("phone") && !list.body.contains(&secret));
    harness
        .json("POST", "/api/v1/tokens", body)
        .await
        .is(409)
        .is_problem("token-taken");
    harness.bare("DELETE", "/api/v1/tokens/phone").await.is(200);
    assert_eq!(harness.app.holder(&digest(&secret)), None);
    harness
        .bare("DELETE", "/api/v1/tokens/phone")
        .await
        .is(404)
        .is_problem("no-such-token");
}

#[tokio::test]
async fn only_an_administrator_sees_or_creates_tokens() {
    let harness = Harness::far();
    for role in [Role::Watch, Role::Queue, Role::Control] {
        for (method, path) in [
            ("GET", "/api/v1/tokens"),
            ("DELETE", "/api/v1/tokens/admin"),
        ] {
            let request = harness
                .request(method, path)
                .header("authorization", harness.bearer(role));
            let answer = harness
                .send(request.body(axum::body::Body::empty()).unwrap())
                .await;
            answer.is(403).is_problem("role");
        }
    }
}
