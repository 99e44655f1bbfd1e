//! Access to the tools for agents, and limits.

use axum::body::Body;
use axum::http::request::Builder;
use dobot_api::Role;

use super::{Answer, Harness};

const GREETING: &str = r#"{"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {
    "protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": {"name": "a", "version": "1"}}}"#;

fn says(harness: &Harness) -> Builder {
    harness
        .request("POST", "/mcp")
        .header("content-type", "application/json")
        .header("accept", "application/json, text/event-stream")
}

async fn greets(harness: &Harness, request: Builder) -> Answer {
    let request = request.body(Body::from(GREETING));
    harness.send(request.unwrap()).await
}

#[tokio::test]
async fn from_another_machine_an_agent_needs_a_token() {
    let harness = Harness::far();
    greets(&harness, says(&harness))
        .await
        .is(401)
        .is_problem("unauthorised");
    let wrong = says(&harness).header("authorization", "Bearer wrong");
    greets(&harness, wrong).await.is(401);
    let watcher = says(&harness).header("authorization", harness.bearer(Role::Watch));
    let answer = greets(&harness, watcher).await;
    assert!(answer.is(200).headers.contains_key("mcp-session-id"));
}

#[tokio::test]
async fn pages_of_other_sites_are_refused_as_agents() {
    let harness = Harness::near();
    let strange = says(&harness).header("origin", "http://evil.example");
    greets(&harness, strange)
        .await
        .is(403)
        .is_problem("forbidden-origin");
    let mut rebound = says(&harness);
    rebound
        .headers_mut()
        .unwrap()
        .insert("host", "evil.example:8642".parse().unwrap());
    greets(&harness, rebound)
        .await
        .is(403)
        .is_problem("forbidden-host");
}

#[tokio::test]
async fn the_size_of_agent_messages_is_limited() {
    let harness = Harness::near();
    let most = dobot_mcp::HttpAgents::MAX_BYTES;
    let request = says(&harness).body(Body::from(vec![b' '; most + 1]));
    harness
        .send(request.unwrap())
        .await
        .is(413)
        .is_problem("too-large");
}

#[tokio::test]
async fn the_number_of_sessions_is_limited_and_an_ended_one_makes_room() {
    let harness = Harness::near();
    let first = greets(&harness, says(&harness)).await;
    let mut sessions = 1;
    let refused = loop {
        let answer = greets(&harness, says(&harness)).await;
        if answer.status != 200 {
            break answer;
        }
        sessions += 1;
        assert!(sessions <= 1000, "there is no end to it");
    };
    refused.is(429).is_problem("too-many-clients");
    let ends = harness
        .request("DELETE", "/mcp")
        .header("mcp-session-id", &first.headers["mcp-session-id"]);
    harness
        .send(ends.body(Body::empty()).unwrap())
        .await
        .is(202);
    greets(&harness, says(&harness)).await.is(200);
}

#[tokio::test]
async fn an_invalid_message_is_answered_as_elsewhere() {
    let harness = Harness::near();
    let refused = harness.json("POST", "/mcp", GREETING).await;
    refused.is(400).is_problem("malformed");
    assert!(refused.body.contains("Accept"), "{refused:?}");
    let over = says(&harness).header("mcp-session-id", "gone");
    let over = over.body(Body::from(
        r#"{"jsonrpc": "2.0", "id": 2, "method": "ping"}"#,
    ));
    harness
        .send(over.unwrap())
        .await
        .is(404)
        .is_problem("unknown-path");
}
