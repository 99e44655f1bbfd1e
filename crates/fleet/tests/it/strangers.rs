//! Current and former members that try to get data that are not theirs.

use std::sync::Arc;

use zenoh::query::Query;

use super::*;

/// A key, and the request received there.
type ReceivedRequest = (String, Vec<u8>);

/// A member that answers for all others and records its requests.
struct Thief {
    session: zenoh::Session,
    received: Arc<Mutex<Vec<ReceivedRequest>>>,
}

impl Thief {
    async fn come(at: &str) -> Self {
        let session = stranger_who_sees("desk-2", at).await;
        let received = Arc::<Mutex<Vec<_>>>::default();
        let requests = received.clone();
        let answers = move |query: Query| {
            let payload = query
                .payload()
                .map(|payload| payload.to_bytes().into_owned());
            let key = query.key_expr().as_str().to_owned();
            requests
                .lock()
                .unwrap()
                .push((key, payload.unwrap_or_default()));
            let forged = json!({"status": 200, "body": "forged"}).to_string();
            // With an invalid signature.
            let reply = query.reply(query.key_expr(), forged).attachment([0; 64]);
            zenoh::Wait::wait(reply).unwrap();
        };
        for key in ["dobot/**/api", "dobot/**/sealed"] {
            let answers = session.declare_queryable(key).callback(answers.clone());
            answers.background().await.unwrap();
        }
        Self { session, received }
    }

    /// Waits until it receives a request to desk-2; its responses are ignored.
    async fn wait_for_request(&self, one: &Desk) {
        let waiting = async {
            while self.received().is_empty() {
                let answers = one.all_as(None, to_two("GET", "/healthz")).await;
                assert_eq!(answers[0].answer.body, json!("ok\n"), "{answers:?}");
            }
        };
        timeout(PATIENCE, waiting).await.unwrap();
    }

    fn received(&self) -> Vec<ReceivedRequest> {
        self.received.lock().unwrap().clone()
    }
}

fn to_two(method: &str, path: &str) -> Value {
    json!({"to": {"members": ["desk-2"]}, "method": method, "path": path})
}

/// Makes a desk accept the token of another.
fn accept(one: &Desk, two: &Desk) -> String {
    let token = dobot_station::Token::of_secret(&one.admin()).unwrap();
    let mut tokens = Tokens::open(&Folders::at(two.folder.path()).tokens()).unwrap();
    tokens.accept(Role::Admin, "teacher", &token).unwrap();
    token.secret().to_owned()
}

#[tokio::test(flavor = "multi_thread")]
async fn a_member_that_answers_for_others_reads_no_token_and_its_answers_do_not_count() {
    let (router, at) = router(free_port()).await;
    let [one, two] = two_desks(&at).await;
    let token = accept(&one, &two);
    let thief = Thief::come(&at).await;
    thief.wait_for_request(&one).await;
    let lease = to_two("POST", "/api/v1/lease");
    let answers = one.all_as(Some(token.clone()), lease).await;
    assert_eq!(answers[0].answer.status, 200, "{answers:?}");
    let control = answers[0].answer.body["token"].as_str().unwrap().to_owned();
    let stopped = one.stop_all().await;
    assert!(
        stopped.iter().all(|answer| answer.answer.is_success()),
        "{stopped:?}"
    );
    assert!(
        stopped
            .iter()
            .all(|answer| answer.answer.body != json!("forged")),
        "{stopped:?}"
    );
    let received = thief.received();
    assert!(
        received.iter().any(|(key, _)| key.ends_with("/sealed")),
        "{received:?}"
    );
    for secret in [&token, &control] {
        let reads = |text: &[u8]| {
            text.windows(secret.len())
                .any(|window| window == secret.as_bytes())
        };
        assert!(!received.iter().any(|(_, payload)| reads(payload)));
    }
    // A replayed request has no effect.
    for (key, payload) in received
        .into_iter()
        .filter(|(_, payload)| payload.len() > 32)
    {
        if !key.ends_with("/sealed") {
            continue;
        }
        let again = thief.session.get(&key).payload(payload);
        let replies = again.timeout(Duration::from_secs(5)).await.unwrap();
        while let Ok(reply) = replies.recv_async().await {
            if let Ok(sample) = reply.result() {
                let answer = sample.payload().to_bytes();
                assert!(answer.ends_with(b"\"forged\"}"), "{answer:?}");
            }
        }
    }
    for desk in [one, two] {
        desk.end().await;
    }
    thief.session.close().await.unwrap();
    router.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_station_is_not_reported_as_stopped_if_only_another_member_answers() {
    let (router, at) = router(free_port()).await;
    let [one, two] = two_desks(&at).await;
    let thief = Thief::come(&at).await;
    thief.wait_for_request(&one).await;
    two.end().await;
    one.sees("that desk-2 is away", is_away("desk-2")).await;
    let stopped = one.stop_all().await;
    let two = stopped
        .iter()
        .find(|answer| answer.member == "desk-2")
        .unwrap();
    assert_eq!(two.answer.status, 503, "{stopped:?}");
    let detail = two.answer.body["detail"].as_str().unwrap();
    assert!(detail.contains("forged responses were ignored"), "{detail}");
    one.end().await;
    thief.session.close().await.unwrap();
    router.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_report_in_the_name_of_another_member_is_not_shown() {
    let (router, at) = router(free_port()).await;
    let [one, two] = two_desks(&at).await;
    let members = one.members().await;
    let desk = members
        .iter()
        .find(|member| member.name == "desk-2")
        .unwrap();
    let key = format!("dobot/2/desk-2/{}/state", desk.id);
    let mut about = desk.about.clone().unwrap();
    about.groups = vec!["forged".into()];
    about.page = Some("javascript:alert(1)".into());
    let forged = json!({"about": about, "state": desk.state}).to_string();
    let stranger = stranger_who_sees("desk-2", &at).await;
    let (as_two, answer) = (key.clone(), forged.clone());
    let answers = move |query: Query| {
        let reply = query.reply(&as_two, answer.clone());
        drop(zenoh::Wait::wait(reply.attachment([1; 72])));
    };
    let answers = stranger.declare_queryable(&key).callback(answers);
    answers.background().await.unwrap();
    for _ in 0..20 {
        let sent = stranger.put(&key, forged.as_str()).attachment([1; 72]);
        sent.await.unwrap();
        let members = one.members().await;
        assert!(!format!("{members:?}").contains("forged"), "{members:#?}");
    }
    two.ask("POST", "/api/v1/stop", None).await;
    let is_stopped = |members: &[Member]| {
        let desk = members
            .iter()
            .find(|member| member.name == "desk-2")
            .unwrap();
        desk.state.as_ref().unwrap().stop.is_some()
    };
    one.sees("that desk-2 is stopped", is_stopped).await;
    for desk in [one, two] {
        desk.end().await;
    }
    stranger.close().await.unwrap();
    router.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_thousand_fake_stations_prevent_no_request_and_no_stop() {
    let (router, at) = router(free_port()).await;
    let [one, two] = two_desks(&at).await;
    let stranger = stranger_who_sees("desk-2", &at).await;
    // Among them one with the name of desk-2, without a signature.
    let fakes = (0..1000)
        .map(|number| format!("fake-{number}"))
        .chain(["desk-2".into()]);
    let mut tokens = Vec::new();
    for name in fakes {
        let key = format!("dobot/alive/2/0.1.0/{name}/{}/9/AAAA", "f".repeat(32));
        tokens.push(stranger.liveliness().declare_token(key).await.unwrap());
    }
    // The token of another version follows them: all have been received.
    let last = format!("dobot/alive/9/9.9.9/last/{}", "e".repeat(32));
    tokens.push(stranger.liveliness().declare_token(last).await.unwrap());
    let has_last = |members: &[Member]| members.iter().any(|member| member.name == "last");
    one.sees("the last one", has_last).await;
    let names: Vec<_> = one
        .members()
        .await
        .into_iter()
        .map(|member| member.name)
        .collect();
    assert_eq!(names, ["desk-1", "desk-2", "last"]);
    let asked = json!({"to": {"members": ["desk-2"]}, "method": "GET", "path": "/healthz"});
    let answers = one.all_as(None, asked).await;
    assert_eq!(answers.len(), 1);
    assert_eq!(answers[0].answer.status, 200, "{answers:?}");
    let stopped = one.stop_all().await;
    let has_stopped = |name: &str| {
        let answer = stopped.iter().find(|answer| answer.member == name).unwrap();
        answer.answer.is_success()
    };
    assert!(
        has_stopped("desk-1") && has_stopped("desk-2"),
        "{stopped:?}"
    );
    for desk in [one, two] {
        desk.end().await;
    }
    stranger.close().await.unwrap();
    router.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_member_with_a_revoked_certificate_neither_sees_nor_stops_any_station() {
    let folder = tempfile::tempdir().unwrap();
    let at = format!("quic/127.0.0.1:{}", free_port());
    // A copy on a lost stick.
    let stick = certificates(folder.path()).remove(2);
    Credentials::revoke(folder.path(), "desk-2").unwrap();
    let again = Credentials::make(folder.path(), &["desk-2".parse().unwrap()]).unwrap();
    let of = |name: &str| Credentials::read(&folder.path().join(name)).unwrap();
    let router = Router::start(std::slice::from_ref(&at), &of("router")).await;
    let router = router.unwrap();
    let one = Desk::up("desk-1", &at, Some(of("desk-1"))).await;
    let lost = Desk::up("desk-2", &at, Some(stick)).await;
    let two = Desk::up("desk-2", &at, Some(again[0].clone())).await;
    one.sees("the new desk-2 only", present(&["desk-1", "desk-2"]))
        .await;
    let seen = lost.members().await;
    assert_eq!(seen.len(), 1, "{seen:?}");
    let stopped = lost.stop_all().await;
    assert_eq!(stopped.len(), 1, "{stopped:?}");
    let (_, state) = two.ask("GET", "/api/v1/state", None).await;
    assert!(state["stop"].is_null(), "{state}");
    for desk in [one, two, lost] {
        desk.end().await;
    }
    router.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_certificate_revoked_while_all_run_is_no_longer_valid() {
    let folder = tempfile::tempdir().unwrap();
    let at = format!("quic/127.0.0.1:{}", free_port());
    drop(certificates(folder.path()));
    let of = |name: &str| Credentials::read(&folder.path().join(name)).unwrap();
    let router = Router::start(std::slice::from_ref(&at), &of("router")).await;
    let router = router.unwrap();
    let one = Desk::up("desk-1", &at, Some(of("desk-1"))).await;
    let lost = Desk::up("desk-2", &at, Some(of("desk-2"))).await;
    one.sees("desk-2", present(&["desk-1", "desk-2"])).await;
    lost.sees("desk-1", present(&["desk-1", "desk-2"])).await;
    Credentials::revoke(folder.path(), "desk-2").unwrap();
    one.sees("desk-2 no longer", present(&["desk-1"])).await;
    let lease = json!({"to": {"members": ["desk-1"]}, "method": "POST", "path": "/api/v1/lease"});
    let answers = lost.all_as(Some(lost.admin()), lease).await;
    let problem = answers[0].answer.body["detail"].as_str().unwrap();
    assert!(problem.contains("it is revoked"), "{answers:?}");
    for desk in [one, lost] {
        desk.end().await;
    }
    router.end().await;
}
