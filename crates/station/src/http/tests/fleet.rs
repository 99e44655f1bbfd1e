//! The fleet, with a fake implementation.

use std::sync::Arc;

use dobot_api::{
    ApiAnswer, ApiRequest, Member, MemberAbout, MemberAnswer, Presence, Request, Role,
};
use serde_json::json;

use super::Harness;
use crate::http::StationApi;
use crate::{FleetChannels, FleetCommand, FleetPort, Members};

fn member(name: &str, group: &str) -> Arc<Member> {
    Arc::new(Member {
        name: name.into(),
        id: "0".repeat(32),
        here: name == "desk-1",
        presence: Presence::Present,
        heard_at_s: 1.0,
        about: Some(MemberAbout {
            groups: vec![group.into()],
            ..MemberAbout::default()
        }),
        state: None,
    })
}

/// A station that has joined: every member responds with its own request.
fn joined(harness: &Harness) -> tokio::task::JoinHandle<Vec<ApiRequest>> {
    let (port, end) = FleetPort::new("desk-1", "0123");
    harness.app.fleet.set(port).unwrap();
    let members: Members = [
        member("desk-1", "room-1"),
        member("desk-2", "room-2"),
        member("desk-3", "room-2"),
    ]
    .into();
    end.members.send_replace(members);
    tokio::spawn(stand_in(end))
}

fn answer(member: &Arc<Member>) -> MemberAnswer {
    MemberAnswer {
        member: member.name.clone(),
        id: member.id.clone(),
        answer: ApiAnswer {
            status: 200,
            body: json!({}),
        },
        took_ms: 1.0,
    }
}

async fn stand_in(mut end: FleetChannels) -> Vec<ApiRequest> {
    let mut asked = Vec::new();
    while let Some(wish) = end.wishes.recv().await {
        match wish {
            FleetCommand::Look(seen) => drop(seen.send(())),
            FleetCommand::Ask(ask) => {
                drop(ask.answers.send(ask.to.iter().map(answer).collect()));
                asked.push(ask.request);
            }
            FleetCommand::SendStops(to, answers) => {
                drop(answers.send(to.iter().map(answer).collect()));
            }
            FleetCommand::Work(wish) => panic!("no test submits work here: {wish:?}"),
        }
    }
    asked
}

#[tokio::test]
async fn a_station_without_a_fleet_explains_how_to_join_one() {
    let harness = Harness::near();
    for (method, path) in [
        ("GET", "/api/v1/fleet"),
        ("GET", "/api/v1/fleet/events"),
        ("POST", "/api/v1/fleet/stop"),
    ] {
        harness
            .bare(method, path)
            .await
            .is(404)
            .is_problem("no-fleet");
    }
}

#[tokio::test]
async fn a_request_reaches_the_stations_of_a_group_with_the_token_of_its_sender() {
    let harness = Harness::far();
    let stand_in = joined(&harness);
    let body = r#"{"to": {"group": "room-2"}, "method": "POST", "path": "/api/v1/jobs/pause"}"#;
    let request = harness
        .request("POST", "/api/v1/fleet/requests")
        .header("content-type", "application/json")
        .header("authorization", harness.bearer(Role::Control));
    let answer = harness.send(request.body(body.into()).unwrap()).await;
    let answered = answer.is(200).value();
    let names: Vec<_> = answered
        .as_array()
        .unwrap()
        .iter()
        .map(|answer| answer["member"].clone())
        .collect();
    assert_eq!(names, ["desk-2", "desk-3"]);
    let secret = harness.tokens[Role::Control as usize].secret().to_owned();
    drop(harness);
    let asked = stand_in.await.unwrap();
    assert_eq!(asked[0].token, Some(secret));
    assert_eq!(
        (&*asked[0].method, &*asked[0].path),
        ("POST", "/api/v1/jobs/pause")
    );
}

#[tokio::test]
async fn anyone_may_stop_all_stations_even_with_an_unknown_token() {
    let harness = Harness::far();
    let stand_in = joined(&harness);
    let request = harness
        .request("POST", "/api/v1/fleet/stop")
        .header("content-type", "application/json")
        .header("authorization", harness.bearer(Role::Watch));
    let body = r#"{"reason": "smoke"}"#;
    let answer = harness.send(request.body(body.into()).unwrap()).await;
    assert_eq!(answer.is(200).value().as_array().unwrap().len(), 3);
    drop(harness);
    let asked = stand_in.await.unwrap();
    assert_eq!(asked[0].token, None);
    assert_eq!(asked[0].path, "/api/v1/stop");
    // A stop of all is a stop of the fleet, which each station keeps.
    let body = asked[0].body.clone().unwrap();
    assert_eq!(body["reason"], "smoke");
    assert_eq!(body["fleet"]["origin"], "0123");
    assert_eq!(body["fleet"]["by"], "watch at desk-1");
}

#[tokio::test]
async fn a_stop_of_a_group_is_not_a_stop_of_the_fleet() {
    let harness = Harness::far();
    let stand_in = joined(&harness);
    let body = r#"{"to": {"group": "room-2"}, "reason": "smoke"}"#;
    harness
        .json("POST", "/api/v1/fleet/stop", body.to_owned())
        .await;
    drop(harness);
    let asked = stand_in.await.unwrap();
    assert!(
        asked
            .iter()
            .all(|answer| answer.body.as_ref().unwrap()["fleet"].is_null())
    );
}

#[tokio::test]
async fn the_fleet_is_reset_only_by_a_client_with_a_control_token() {
    let harness = Harness::near();
    let stand_in = joined(&harness);
    // The rights of local programs are not valid at other stations.
    let bare = harness.bare("DELETE", "/api/v1/fleet/stop").await;
    bare.is(401).is_problem("unauthorised");
    for (role, status) in [(Role::Watch, 403), (Role::Queue, 403), (Role::Control, 200)] {
        let request = harness
            .request("DELETE", "/api/v1/fleet/stop")
            .header("authorization", harness.bearer(role));
        harness
            .send(request.body("".into()).unwrap())
            .await
            .is(status);
    }
    let resets = harness.publisher.resets.lock().unwrap().clone();
    assert_eq!(resets, ["control at desk-1"]);
    drop(harness);
    stand_in.await.unwrap();
}

#[tokio::test]
async fn a_stop_over_http_concerns_this_arm_only_even_if_it_names_the_fleet() {
    let harness = Harness::near();
    let fleet = json!({"origin": "0123", "count": 9, "by": "Anna"});
    let body = json!({"fleet": fleet}).to_string();
    harness.json("POST", "/api/v1/stop", body).await.is(200);
    assert_eq!(harness.asked(), [Request::Stop { reason: None }]);
}

#[tokio::test]
async fn an_unknown_station_is_reported_and_no_station_is_asked() {
    let harness = Harness::near();
    let stand_in = joined(&harness);
    for to in [
        r#"{"members": ["desk-2", "desk-9"]}"#,
        r#"{"group": "room-9"}"#,
    ] {
        let body = format!(r#"{{"to": {to}, "method": "POST", "path": "/api/v1/stop"}}"#);
        let answer = harness.json("POST", "/api/v1/fleet/requests", body).await;
        answer.is(404).is_problem("no-such-member");
    }
    drop(harness);
    assert!(stand_in.await.unwrap().is_empty());
}

fn api(harness: &Harness) -> StationApi {
    StationApi::new(harness.app.clone(), harness.peer.to)
}

fn stop() -> ApiRequest {
    ApiRequest {
        method: "POST".into(),
        path: "/api/v1/stop".into(),
        ..ApiRequest::default()
    }
}

#[tokio::test]
async fn a_fleet_client_without_a_token_may_watch_and_stop_only() {
    // Over HTTP on this machine everyone has all rights; through the fleet no client is local.
    let harness = Harness::near();
    let api = api(&harness);
    assert_eq!(api.call(&stop()).await.status, 200);
    let tokens = ApiRequest {
        method: "GET".into(),
        path: "/api/v1/tokens".into(),
        ..ApiRequest::default()
    };
    let refused = api.call(&tokens).await;
    assert_eq!(
        (refused.status, &refused.body["title"]),
        (403, &json!("the role does not allow this"))
    );
    let with_token = ApiRequest {
        token: Some(harness.tokens[Role::Admin as usize].secret().into()),
        ..tokens
    };
    assert_eq!(api.call(&with_token).await.status, 200);
    assert_eq!(harness.asked(), [Request::Stop { reason: None }]);
}

#[tokio::test]
async fn a_stolen_token_that_was_removed_grants_no_access() {
    let harness = Harness::near();
    let api = api(&harness);
    let request = ApiRequest {
        path: "/api/v1/lease".into(),
        token: Some(harness.tokens[Role::Control as usize].secret().into()),
        ..stop()
    };
    harness.app.tokens().remove("control").unwrap();
    assert_eq!(api.call(&request).await.status, 401);
    assert!(harness.asked().is_empty());
}

#[tokio::test]
async fn endless_answers_and_invalid_requests_are_refused_as_such() {
    let harness = Harness::near();
    let api = api(&harness);
    let get = |path: &str| ApiRequest {
        method: "GET".into(),
        path: path.into(),
        ..ApiRequest::default()
    };
    for (request, status) in [
        (get("/api/v1/events"), 422),
        (get("/api/v1/packets"), 422),
        (get("/api/v1/ws"), 426),
        (get("no path"), 400),
        (get("http://elsewhere/api/v1/state"), 400),
        (
            ApiRequest {
                method: "G E T".into(),
                ..get("/api/v1/state")
            },
            422,
        ),
        (
            ApiRequest {
                token: Some("a\nb".into()),
                ..get("/api/v1/state")
            },
            422,
        ),
    ] {
        let answer = api.call(&request).await;
        assert_eq!(answer.status, status, "{request:?}: {answer:?}");
        assert!(answer.body["detail"].is_string(), "{answer:?}");
    }
}
