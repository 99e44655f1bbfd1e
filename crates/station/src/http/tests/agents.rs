//! Access to the tools for agents, and limits.

use axum::body::Body;
use axum::http::request::Builder;
use dobot_api::Role;

use super::{Answer, Harness};

const GREETING: &str = r#"{"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {
    "protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": {"name": "a", "version": "1"}}}"#;

fn mcp_request(harness: &Harness) -> Builder {
    harness
        .request("POST", "/mcp")
        .header("content-type", "application/json")
        .header("accept", "application/json, text/event-stream")
}

async fn initialize(harness: &Harness, request: Builder) -> Answer {
    let request = request.body(Body::from(GREETING));
    harness.send(request.unwrap()).await
}

#[tokio::test]
async fn from_another_machine_an_agent_needs_a_token() {
    let harness = Harness::far();
    initialize(&harness, mcp_request(&harness))
        .await
        .is(401)
        .is_problem("unauthorised");
    let wrong = mcp_request(&harness).header("authorization", "Bearer wrong");
    initialize(&harness, wrong).await.is(401);
    let watcher = mcp_request(&harness).header("authorization", harness.bearer(Role::Watch));
    let answer = initialize(&harness, watcher).await;
    assert!(answer.is(200).headers.contains_key("mcp-session-id"));
}

#[tokio::test]
async fn pages_of_other_sites_are_refused_as_agents() {
    let harness = Harness::near();
    let strange = mcp_request(&harness).header("origin", "http://evil.example");
    initialize(&harness, strange)
        .await
        .is(403)
        .is_problem("forbidden-origin");
    let mut rebound = mcp_request(&harness);
    rebound
        .headers_mut()
        .unwrap()
        .insert("host", "evil.example:8642".parse().unwrap());
    initialize(&harness, rebound)
        .await
        .is(403)
        .is_problem("forbidden-host");
}

#[tokio::test]
async fn the_size_of_agent_messages_is_limited() {
    let harness = Harness::near();
    let most = dobot_mcp::HttpAgents::MAX_BYTES;
    let request = mcp_request(&harness).body(Body::from(vec![b' '; most + 1]));
    harness
        .send(request.unwrap())
        .await
        .is(413)
        .is_problem("too-large");
}

#[tokio::test]
async fn the_number_of_sessions_is_limited_and_an_ended_one_makes_room() {
    let harness = Harness::near();
    let first = initialize(&harness, mcp_request(&harness)).await;
    let mut sessions = 1;
    let refused = loop {
        let answer = initialize(&harness, mcp_request(&harness)).await;
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
    initialize(&harness, mcp_request(&harness)).await.is(200);
}

#[tokio::test]
async fn an_invalid_message_is_answered_as_elsewhere() {
    let harness = Harness::near();
    let refused = harness.json("POST", "/mcp", GREETING).await;
    refused.is(400).is_problem("malformed");
    assert!(refused.body.contains("Accept"), "{refused:?}");
    let over = mcp_request(&harness).header("mcp-session-id", "gone");
    let over = over.body(Body::from(
        r#"{"jsonrpc": "2.0", "id": 2, "method": "ping"}"#,
    ));
    harness
        .send(over.unwrap())
        .await
        .is(404)
        .is_problem("unknown-path");
}
