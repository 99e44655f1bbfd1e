//! Attackers, which must not get in.

use axum::body::Body;
use axum::http::Request;
use dobot_api::Role;

use super::{Answer, Harness};

async fn stop(harness: &Harness, headers: &[(&str, &str)]) -> Answer {
    let request = Request::builder().method("POST").uri("/api/v1/stop");
    let request = headers.iter().fold(request, |request, (name, value)| {
        request.header(*name, *value)
    });
    harness.send(request.body(Body::empty()).unwrap()).await
}

#[tokio::test]
async fn the_station_answers_under_its_own_names_and_addresses_only() {
    let harness = Harness::near();
    for host in [
        "127.0.0.1:8642",
        "localhost:8642",
        "LOCALHOST:8642",
        "arm.local:8642",
    ] {
        stop(&harness, &[("host", host)]).await.is(200);
    }
    for host in [
        "evil.example:8642",
        "localhost",
        "localhost:80",
        "127.0.0.1:8643",
        "127.0.0.2:8642",
        "localhost.evil.example:8642",
        "[::1]:8642",
        "127.0.0.1.nip.io:8642",
        "0.0.0.0:8642",
    ] {
        stop(&harness, &[("host", host)])
            .await
            .is(403)
            .is_problem("forbidden-host");
    }
    for headers in [
        &[][..],
        &[("host", "localhost:8642"), ("host", "evil.example")],
        &[("host", "a@localhost:8642")],
    ] {
        stop(&harness, headers)
            .await
            .is(400)
            .is_problem("malformed");
    }
    assert_eq!(harness.asked().len(), 4);
}

#[tokio::test]
async fn an_address_in_the_request_line_must_match() {
    let harness = Harness::near();
    let request = harness
        .request("POST", "http://evil.example/api/v1/stop")
        .body(Body::empty())
        .unwrap();
    harness.send(request).await.is(400).is_problem("malformed");
}

#[tokio::test]
async fn pages_of_other_sites_are_refused() {
    let harness = Harness::near();
    let host = ("host", "127.0.0.1:8642");
    stop(&harness, &[host, ("origin", "http://127.0.0.1:8642")])
        .await
        .is(200);
    for origin in [
        "http://evil.example",
        "null",
        "https://127.0.0.1:8642",
        "http://127.0.0.1:8643",
        "http://localhost:8642",
        "http://127.0.0.1:8642.evil.example",
    ] {
        stop(&harness, &[host, ("origin", origin)])
            .await
            .is(403)
            .is_problem("forbidden-origin");
    }
    stop(
        &harness,
        &[
            host,
            ("sec-fetch-site", "cross-site"),
            ("sec-fetch-mode", "no-cors"),
        ],
    )
    .await
    .is(403);
    stop(
        &harness,
        &[
            host,
            ("sec-fetch-site", "same-site"),
            ("sec-fetch-mode", "cors"),
        ],
    )
    .await
    .is(403);
    assert_eq!(harness.asked().len(), 1);
}

#[tokio::test]
async fn other_sites_cannot_ask_for_the_allowed_methods() {
    let harness = Harness::near();
    let request = harness
        .request("OPTIONS", "/api/v1/stop")
        .header("origin", "http://evil.example");
    let request = request
        .header("access-control-request-method", "POST")
        .body(Body::empty())
        .unwrap();
    let answer = harness.send(request).await;
    answer.is(403);
    assert!(
        answer
            .headers
            .keys()
            .all(|name| !name.as_str().starts_with("access-control"))
    );
}

#[tokio::test]
async fn on_a_network_nothing_works_without_a_token() {
    let harness = Harness::far();
    for path in [
        "/api/v1/state",
        "/api/v1/jobs",
        "/api/v1/ws",
        "/api/v1/nonsense",
    ] {
        let answer = harness.get(path).await;
        answer.is(401).is_problem("unauthorised");
        assert_eq!(answer.headers["www-authenticate"], "Bearer realm=\"dobot\"");
    }
    harness.bare("POST", "/api/v1/stop").await.is(401);
    let page = dobot_page::FILES.iter().map(|file| file.path);
    let others = ["/api/v1/openapi.json", "/api/v1/problems/policy"];
    for path in page.chain(others) {
        harness.get(path).await.is(200);
    }
    assert!(harness.asked().is_empty());
}

#[tokio::test]
async fn a_page_loaded_ten_times_over_the_network_arrives_complete_each_time() {
    let harness = Harness::far();
    for _ in 0..10 {
        for file in dobot_page::FILES {
            harness.get(file.path).await.is(200);
        }
    }
}

#[tokio::test]
async fn the_token_determines_the_role() {
    let harness = Harness::far();
    for role in Role::ALL {
        let bearer = harness.bearer(role);
        stop(
            &harness,
            &[("host", "192.168.7.5:8642"), ("authorization", &bearer)],
        )
        .await
        .is(200);
        let body = Body::empty();
        let request = harness
            .request("POST", "/api/v1/lease")
            .header("authorization", bearer)
            .body(body)
            .unwrap();
        harness.send(request).await.is(200);
    }
    assert_eq!(harness.asked().len(), 2 * Role::ALL.len());
}

#[tokio::test]
async fn wrong_tokens_are_refused_even_if_none_is_needed() {
    for harness in [Harness::near(), Harness::far()] {
        let host = harness.peer.to.to_string();
        for wrong in ["Bearer ", "Bearer 00", "Basic dTpw", "Bearer", "bearer x y"] {
            stop(&harness, &[("host", &host), ("authorization", wrong)])
                .await
                .is(401)
                .is_problem("unauthorised");
        }
        assert!(harness.asked().is_empty());
    }
}

#[tokio::test]
async fn a_browser_sends_its_token_as_a_subprotocol() {
    let harness = Harness::far();
    let secret = harness.tokens[0].secret();
    let request = harness.request("GET", "/api/v1/state");
    let request = request.header(
        "sec-websocket-protocol",
        format!("dobot, dobot.token.{secret}"),
    );
    harness
        .send(request.body(Body::empty()).unwrap())
        .await
        .is(200);
    let request = harness.request("GET", &format!("/api/v1/state?token={secret}"));
    harness
        .send(request.body(Body::empty()).unwrap())
        .await
        .is(401);
}

#[tokio::test(start_paused = true)]
async fn a_flood_of_requests_must_wait_but_a_stop_never_does() {
    let harness = Harness::far();
    let get = || {
        harness
            .request("GET", "/api/v1/state")
            .header("authorization", harness.bearer(Role::Watch))
    };
    let mut answer = harness.send(get().body(Body::empty()).unwrap()).await;
    let mut sent = 1;
    while answer.status == 200 {
        answer = harness.send(get().body(Body::empty()).unwrap()).await;
        sent += 1;
    }
    assert_eq!(sent, 201);
    answer.is(429).is_problem("too-many-requests");
    assert_eq!(answer.headers["retry-after"], "1");
    let bearer = harness.bearer(Role::Watch);
    stop(
        &harness,
        &[("host", "192.168.7.5:8642"), ("authorization", &bearer)],
    )
    .await
    .is(200);
    tokio::time::advance(std::time::Duration::from_secs(1)).await;
    harness
        .send(get().body(Body::empty()).unwrap())
        .await
        .is(200);
}

#[tokio::test(start_paused = true)]
async fn a_client_that_guesses_tokens_is_soon_blocked() {
    let harness = Harness::far();
    let host = ("host", "192.168.7.5:8642");
    for _ in 0..10 {
        stop(&harness, &[host, ("authorization", "Bearer 00")])
            .await
            .is(401);
    }
    stop(&harness, &[host, ("authorization", "Bearer 00")])
        .await
        .is(429);
    harness.get("/").await.is(429);
}

#[tokio::test]
async fn every_answer_has_the_headers_that_protect_browsers() {
    let harness = Harness::near();
    for path in [
        "/",
        "/preview.js",
        "/reader.js",
        "/api/v1/state",
        "/nonsense",
        "/api/v1/ws",
    ] {
        let answer = harness.get(path).await;
        let policy = answer.headers["content-security-policy"].to_str().unwrap();
        assert!(policy.contains("default-src 'none'") && policy.contains("frame-ancestors 'none'"));
        assert!(!policy.contains("unsafe"), "{policy}");
        assert_eq!(answer.headers["x-content-type-options"], "nosniff");
        let allowed = answer.headers["permissions-policy"].to_str().unwrap();
        assert!(
            allowed.starts_with("camera=(self), microphone=(self), geolocation=()"),
            "{allowed}"
        );
        assert_eq!(answer.headers["referrer-policy"], "no-referrer");
        assert_eq!(
            answer.headers["cross-origin-resource-policy"],
            "same-origin"
        );
    }
    let request = Request::builder()
        .uri("/")
        .header("host", "evil.example")
        .body(Body::empty())
        .unwrap();
    assert!(
        harness
            .send(request)
            .await
            .headers
            .contains_key("content-security-policy")
    );
}
