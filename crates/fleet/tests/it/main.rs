//! Stations with virtual arms that join over real sockets of this machine.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod stops;
mod strangers;
mod together;
mod virtual_arms;

use std::net::TcpListener;
use std::path::{Path, PathBuf};
use std::sync::{LazyLock, Mutex};
use std::time::{Duration, Instant};

use dobot_api::{
    ApiRequest, FleetView, Folders, Member, MemberAbout, MemberAnswer, Presence, Role,
};
use dobot_fleet::{Credentials, Fleet, FleetConfig, FleetSession, Router, own_id};
use dobot_motion::LASER_OFF;
use dobot_session::Address;
use dobot_station::{Config, Station, Tokens};
use serde_json::{Value, json};
use tokio::time::{interval, timeout};
use zenoh::handlers::FifoChannelHandler;
use zenoh::qos::Priority;
use zenoh::query::Reply;

/// A station and its membership.
struct Desk {
    station: Station,
    session: FleetSession,
    fleet: Fleet,
    name: String,
    folder: tempfile::TempDir,
}

/// The timeout of any operation on a busy machine.
const PATIENCE: Duration = Duration::from_secs(180);

/// The local authority of the user who runs these tests.
static OWN: LazyLock<tempfile::TempDir> = LazyLock::new(|| tempfile::tempdir().unwrap());

fn own_authority() -> PathBuf {
    OWN.path().join("fleet-authority")
}

/// Local credentials.
fn of_this_machine(name: &str) -> Credentials {
    Credentials::local(&own_authority(), name).unwrap()
}

/// A port that nothing listens on.
fn free_port() -> u16 {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    listener.local_addr().unwrap().port()
}

fn station_config(folder: &Path) -> Config {
    Config {
        arm: Some(Address::Virtual),
        http: "127.0.0.1:0".parse().unwrap(),
        raw: None,
        ..Config::new(Folders::at(folder))
    }
}

fn fleet_config(name: &str) -> FleetConfig {
    FleetConfig {
        name: name.into(),
        about: MemberAbout {
            groups: vec!["room-1".into()],
            ..MemberAbout::default()
        },
        ..FleetConfig::default()
    }
}

impl Desk {
    async fn up(name: &str, connect: &str, credentials: Option<Credentials>) -> Self {
        let folder = tempfile::tempdir().unwrap();
        Self::in_folder(name, connect, credentials, folder).await
    }

    async fn in_folder(
        name: &str,
        connect: &str,
        credentials: Option<Credentials>,
        folder: tempfile::TempDir,
    ) -> Self {
        Self::joining(fleet_config(name), connect, credentials, folder).await
    }

    async fn joining(
        config: FleetConfig,
        connect: &str,
        credentials: Option<Credentials>,
        folder: tempfile::TempDir,
    ) -> Self {
        let station = Station::start(station_config(folder.path()));
        let station = station.await.unwrap();
        let credentials = credentials.unwrap_or_else(|| of_this_machine(&config.name));
        let session = FleetSession::open(&[connect.into()], &credentials)
            .await
            .unwrap();
        let id = own_id(&Folders::at(folder.path()).fleet_id()).unwrap();
        let fleet = Fleet::join(&session, &config, &id, station.api())
            .await
            .unwrap();
        Self {
            station,
            session,
            fleet,
            name: config.name,
            folder,
        }
    }

    async fn ask(&self, method: &str, path: &str, body: Option<Value>) -> (u16, Value) {
        self.ask_as(Some(self.admin()), method, path, body).await
    }

    async fn ask_as(
        &self,
        token: Option<String>,
        method: &str,
        path: &str,
        body: Option<Value>,
    ) -> (u16, Value) {
        let request = ApiRequest {
            method: method.into(),
            path: path.into(),
            token,
            body,
            ..ApiRequest::default()
        };
        let answer = self.station.api().call(&request).await;
        (answer.status, answer.body)
    }

    /// A token that only this station accepts.
    fn admin(&self) -> String {
        let file = self.folder.path().join("admin.txt");
        if let Ok(known) = std::fs::read_to_string(&file) {
            return known;
        }
        let mut tokens = Tokens::open(&Folders::at(self.folder.path()).tokens()).unwrap();
        let token = tokens.add(Role::Admin, "test").unwrap();
        std::fs::write(&file, token.secret()).unwrap();
        token.secret().into()
    }

    async fn members(&self) -> Vec<Member> {
        let (status, body) = self.ask("GET", "/api/v1/fleet", None).await;
        assert_eq!(status, 200, "{body}");
        serde_json::from_value::<FleetView>(body).unwrap().members
    }

    /// Waits until the members, as this station sees them, meet the condition.
    async fn sees(&self, what: &str, is_so: impl Fn(&[Member]) -> bool) {
        let mut looks = interval(Duration::from_millis(50));
        let looking = async {
            while !is_so(&self.members().await) {
                looks.tick().await;
            }
        };
        let looked = timeout(PATIENCE, looking).await;
        let members = self.members().await;
        assert!(
            looked.is_ok(),
            "{} does not see {what}: {members:#?}",
            self.name
        );
    }

    /// Sends a request to several stations, with an optional token.
    async fn all_as(&self, token: Option<String>, body: Value) -> Vec<MemberAnswer> {
        let path = "/api/v1/fleet/requests";
        let (status, body) = self.ask_as(token, "POST", path, Some(body)).await;
        assert_eq!(status, 200, "{body}");
        serde_json::from_value(body).unwrap()
    }

    async fn stop_all(&self) -> Vec<MemberAnswer> {
        let (status, body) = self.ask("POST", "/api/v1/fleet/stop", None).await;
        assert_eq!(status, 200, "{body}");
        serde_json::from_value(body).unwrap()
    }

    /// Ends the station; its data remain.
    async fn left(self) -> tempfile::TempDir {
        self.fleet.leave().await;
        self.station.end().await.unwrap();
        self.folder
    }

    async fn end(self) {
        drop(self.left().await);
    }
}

fn present(names: &[&str]) -> impl Fn(&[Member]) -> bool {
    let names: Vec<String> = names.iter().map(|&name| name.into()).collect();
    move |members| {
        let there: Vec<_> = members
            .iter()
            .filter(|member| member.presence == Presence::Present && member.state.is_some())
            .map(|member| member.name.clone())
            .collect();
        there == names
    }
}

fn is_away(name: &str) -> impl Fn(&[Member]) -> bool {
    move |members| {
        let member = members.iter().find(|member| member.name == name);
        member.is_some_and(|member| member.presence == Presence::Away)
    }
}

async fn router(port: u16) -> (Router, String) {
    let address = format!("quic/127.0.0.1:{port}");
    // A router that has ended frees its port a little later.
    let mut looks = interval(Duration::from_millis(10));
    while std::net::UdpSocket::bind(("127.0.0.1", port)).is_err() {
        looks.tick().await;
    }
    let router = Router::start(std::slice::from_ref(&address), &of_this_machine("router")).await;
    (router.unwrap(), address)
}

async fn two_desks(at: &str) -> [Desk; 2] {
    let one = Desk::up("desk-1", at, None).await;
    let two = Desk::up("desk-2", at, None).await;
    one.sees("both", present(&["desk-1", "desk-2"])).await;
    [one, two]
}

#[tokio::test(flavor = "multi_thread")]
async fn stations_see_each_other_and_one_that_left_is_away() {
    let (router, at) = router(free_port()).await;
    let [one, two] = two_desks(&at).await;
    two.sees("both", present(&["desk-1", "desk-2"])).await;
    let group = r#"{"group": "room-1"}"#;
    let to: Value = serde_json::from_str(group).unwrap();
    let answers = one
        .all_as(None, json!({"to": to, "method": "GET", "path": "/healthz"}))
        .await;
    assert_eq!(answers.len(), 2);
    assert!(
        answers
            .iter()
            .all(|answer| answer.answer.body == json!("ok\n")),
        "{answers:?}"
    );
    two.end().await;
    one.sees("that desk-2 is away", is_away("desk-2")).await;
    let answers = one
        .all_as(
            None,
            json!({"to": {"members": ["desk-2"]}, "method": "GET", "path": "/healthz"}),
        )
        .await;
    assert_eq!(answers[0].answer.status, 503);
    one.end().await;
    router.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_stop_of_all_switches_every_laser_off() {
    let (router, at) = router(free_port()).await;
    let [one, two] = two_desks(&at).await;
    let mut packets = [&one, &two].map(|arm| arm.station.handle().passed());
    let answers = one.stop_all().await;
    assert!(
        answers.iter().all(|answer| answer.answer.is_success()),
        "{answers:?}"
    );
    for packets in &mut packets {
        let laser_off = async {
            loop {
                let packet = packets.recv().await.unwrap();
                if packet.to_arm && packet.bytes == LASER_OFF.emit(&dialect()).to_bytes() {
                    return;
                }
            }
        };
        timeout(PATIENCE, laser_off).await.unwrap();
    }
    for desk in [&one, &two] {
        let (_, state) = desk.ask("GET", "/api/v1/state", None).await;
        assert!(state["stop"].is_object(), "{state}");
    }
    for desk in [one, two] {
        desk.end().await;
    }
    router.end().await;
}

fn dialect() -> dobot_wire::Dialect {
    dobot_wire::Dialect::SPECIFICATION
}

#[tokio::test(flavor = "multi_thread")]
async fn each_station_checks_its_own_tokens() {
    let (router, at) = router(free_port()).await;
    let [one, two] = two_desks(&at).await;
    let lease = json!({"to": "all", "method": "POST", "path": "/api/v1/lease"});
    let answers = one.all_as(Some(one.admin()), lease).await;
    let statuses: Vec<_> = answers.iter().map(|answer| answer.answer.status).collect();
    // The token is one of desk-1.
    assert_eq!(statuses, [200, 401]);
    let (_, state) = two.ask("GET", "/api/v1/state", None).await;
    assert!(state["lease"].is_null(), "{state}");
    // Accepted by both, it opens both.
    let token = dobot_station::Token::of_secret(&one.admin()).unwrap();
    let mut tokens = Tokens::open(&Folders::at(two.folder.path()).tokens()).unwrap();
    tokens.accept(Role::Control, "teacher", &token).unwrap();
    let lease = json!({"to": {"members": ["desk-2"]}, "method": "POST", "path": "/api/v1/lease"});
    let answers = one.all_as(Some(one.admin()), lease).await;
    assert_eq!(answers[0].answer.status, 200, "{answers:?}");
    for desk in [one, two] {
        desk.end().await;
    }
    router.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn time_slots_are_set_for_a_group_and_outlive_their_station() {
    let (router, at) = router(free_port()).await;
    let [one, two] = two_desks(&at).await;
    let token = dobot_station::Token::of_secret(&one.admin()).unwrap();
    let mut tokens = Tokens::open(&Folders::at(two.folder.path()).tokens()).unwrap();
    tokens.accept(Role::Admin, "teacher", &token).unwrap();
    let anna = tokens.add(Role::Control, "Anna").unwrap();
    let ben = tokens.add(Role::Control, "Ben").unwrap();
    let slots = json!({"slots": [{"student": "anna", "starts_in_s": 0, "ends_in_s": 900},
        {"student": "Ben", "group": "red", "starts_in_s": 900, "ends_in_s": 1800}]});
    let wanted =
        json!({"to": {"group": "room-1"}, "method": "PUT", "path": "/api/v1/slots", "body": slots});
    let answers = one.all_as(Some(one.admin()), wanted).await;
    assert_eq!(answers.len(), 2);
    assert!(
        answers.iter().all(|answer| answer.answer.is_success()),
        "{answers:?}"
    );
    let is_annas_time = |members: &[Member]| {
        let now = |member: &Member| {
            Some(
                member
                    .state
                    .as_ref()?
                    .slots
                    .as_ref()?
                    .now
                    .as_ref()?
                    .student
                    .clone(),
            )
        };
        members
            .iter()
            .all(|member| now(member).as_deref() == Some("anna"))
    };
    one.sees("whose time it is at both", is_annas_time).await;
    let folder = two.left().await;
    let two = Desk::in_folder("desk-2", &at, None, folder).await;
    let lease = |who: &dobot_station::Token| {
        let token = Some(who.secret().to_owned());
        // The name that the client gives makes no difference.
        two.ask_as(
            token,
            "POST",
            "/api/v1/lease",
            Some(json!({"name": "Anna"})),
        )
    };
    let (status, problem) = lease(&ben).await;
    assert_eq!(
        (status, &problem["type"]),
        (409, &json!("/api/v1/problems/slot"))
    );
    let detail = problem["detail"].as_str().unwrap();
    assert!(
        detail.starts_with("the arm is reserved for anna for another 1"),
        "{detail}"
    );
    assert_eq!(lease(&anna).await.0, 200);
    for desk in [one, two] {
        desk.end().await;
    }
    router.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn without_its_router_a_station_continues_and_finds_the_others_again() {
    let port = free_port();
    let at = format!("quic/127.0.0.1:{port}");
    let one = Desk::up("desk-1", &at, None).await;
    one.sees("itself, before there is a router", present(&["desk-1"]))
        .await;
    let answers = one.stop_all().await;
    assert!(answers[0].answer.is_success(), "{answers:?}");
    let (first, at) = router(port).await;
    let two = Desk::up("desk-2", &at, None).await;
    one.sees("both", present(&["desk-1", "desk-2"])).await;
    first.end().await;
    one.sees("that desk-2 is away", is_away("desk-2")).await;
    let answers = one.stop_all().await;
    let stopped = |name: &str| {
        let of = answers.iter().find(|answer| answer.member == name).unwrap();
        of.answer.is_success()
    };
    assert!(stopped("desk-1") && !stopped("desk-2"), "{answers:?}");
    let (status, _) = two.ask("POST", "/api/v1/stop", None).await;
    assert_eq!(status, 200, "its own stop needs no network");
    let (again, _) = router(port).await;
    one.sees("both again", present(&["desk-1", "desk-2"])).await;
    two.sees("both again", present(&["desk-1", "desk-2"])).await;
    for desk in [one, two] {
        desk.end().await;
    }
    again.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn two_stations_of_one_name_are_reported_and_both_can_be_stopped() {
    let (router, at) = router(free_port()).await;
    let one = Desk::up("desk-1", &at, None).await;
    let twins = [
        Desk::up("desk-2", &at, None).await,
        Desk::up("desk-2", &at, None).await,
    ];
    let refused = |members: &[Member]| {
        let refused = |member: &&Member| matches!(member.presence, Presence::Refused { .. });
        members.iter().filter(refused).count() == 2
    };
    one.sees("that both are refused", refused).await;
    let answers = one
        .all_as(
            None,
            json!({"to": {"members": ["desk-2"]}, "method": "GET", "path": "/healthz"}),
        )
        .await;
    let refused = |member_answer: &MemberAnswer| member_answer.answer.status == 409;
    assert!(
        answers.len() == 2 && answers.iter().all(refused),
        "{answers:?}"
    );
    let answers = one.stop_all().await;
    assert!(
        answers.len() == 3 && answers.iter().all(|answer| answer.answer.is_success()),
        "{answers:?}"
    );
    for desk in twins {
        desk.end().await;
    }
    one.sees("that they left", is_away("desk-2")).await;
    one.end().await;
    router.end().await;
}

fn certificates(folder: &Path) -> Vec<Credentials> {
    let holders = ["router=127.0.0.1", "desk-1", "desk-2"].map(|name| name.parse().unwrap());
    Credentials::make(folder, &holders).unwrap()
}

#[tokio::test(flavor = "multi_thread")]
async fn only_those_with_a_certificate_of_the_fleet_belong_to_it() {
    let folders = [tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap()];
    let [ours, strange] = folders.each_ref().map(|folder| certificates(folder.path()));
    let at = format!("quic/127.0.0.1:{}", free_port());
    let router = Router::start(std::slice::from_ref(&at), &ours[0]).await;
    let router = router.unwrap();
    let stranger = Desk::up("desk-1", &at, Some(strange[1].clone())).await;
    let one = Desk::up("desk-1", &at, Some(ours[1].clone())).await;
    let two = Desk::up("desk-2", &at, Some(ours[2].clone())).await;
    one.sees("desk-2 and no stranger", present(&["desk-1", "desk-2"]))
        .await;
    let seen = stranger.members().await;
    assert_eq!(seen.len(), 1, "{seen:?}");
    for desk in [one, two, stranger] {
        desk.end().await;
    }
    router.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn an_invalid_request_is_answered_with_its_error() {
    let (router, at) = router(free_port()).await;
    let one = Desk::up("desk-1", &at, None).await;
    let stranger = stranger_who_sees("desk-1", &at).await;
    for (payload, status) in [
        (&b"\xff\x00"[..], 400),
        (b"{}", 400),
        (
            br#"{"method": "POST", "path": "/api/v1/lease", "power": 9000}"#,
            400,
        ),
        (br#"{"method": "POST", "path": "/api/v1/lease"}"#, 403),
        (br#"{"method": "POST", "path": "/api/v1/stop"}"#, 200),
    ] {
        let replies = stranger.get("dobot/2/desk-1/*/api").payload(payload).await;
        let answer = answer_of(&replies.unwrap()).await;
        assert_eq!(answer["status"], status, "{answer}");
    }
    // A state under an unknown name is ignored.
    stranger.put("dobot/2/ghost/00/state", "{}").await.unwrap();
    let token = "dobot/alive/9/9.9.9/future/00112233445566778899aabbccddeeff";
    let _token = stranger.liveliness().declare_token(token).await.unwrap();
    let versions = |members: &[Member]| {
        members.iter().any(|member| match &member.presence {
            Presence::Refused { problem } => {
                member.name == "future" && problem.detail.contains("dobot 9.9.9")
            }
            _ => false,
        })
    };
    one.sees("a station of another version", versions).await;
    one.end().await;
    stranger.close().await.unwrap();
    router.end().await;
}

/// A Zenoh client that belongs to the fleet, as any local program does.
async fn stranger(at: &str) -> zenoh::Session {
    static NUMBER: Mutex<u32> = Mutex::new(0);
    let folder = {
        let mut number = NUMBER.lock().unwrap();
        *number += 1;
        // The authority exists before it issues this certificate.
        drop(of_this_machine("stranger"));
        let name = format!("stranger-{number}");
        let holder = [name.parse().unwrap()];
        Credentials::make(&own_authority(), &holder).unwrap();
        own_authority().join(name)
    };
    let mut config = zenoh::Config::default();
    config.insert_json5("mode", "\"client\"").unwrap();
    let endpoints = format!("[\"{at}\"]");
    config
        .insert_json5("connect/endpoints", &endpoints)
        .unwrap();
    for (key, file) in [
        ("root_ca_certificate", "authority.pem"),
        ("connect_certificate", "certificate.pem"),
        ("connect_private_key", "key.pem"),
    ] {
        let path = json!(folder.join(file)).to_string();
        let key = format!("transport/link/tls/{key}");
        config.insert_json5(&key, &path).unwrap();
    }
    config
        .insert_json5("transport/link/tls/enable_mtls", "true")
        .unwrap();
    zenoh::open(config).await.unwrap()
}

/// A stranger that has discovered a station.
async fn stranger_who_sees(name: &str, at: &str) -> zenoh::Session {
    let stranger = stranger(at).await;
    is_there(&stranger, name).await;
    stranger
}

/// Waits until a station is present: it declares its resources first.
async fn is_there(stranger: &zenoh::Session, name: &str) {
    let key = format!("dobot/alive/*/*/{name}/**");
    let alive = stranger.liveliness().declare_subscriber(key).history(true);
    let alive = alive.await.unwrap();
    let arrived = timeout(PATIENCE, alive.recv_async()).await;
    arrived.unwrap().unwrap();
}

async fn stop_by(stranger: &zenoh::Session, name: &str) -> Value {
    let stop = br#"{"method": "POST", "path": "/api/v1/stop"}"#;
    let key = format!("dobot/2/{name}/*/api");
    // With the priority that stations use for stops.
    let asked = stranger.get(key).payload(&stop[..]).timeout(PATIENCE);
    let asked = asked.priority(Priority::RealTime).express(true);
    answer_of(&asked.await.unwrap()).await
}

async fn answer_of(replies: &FifoChannelHandler<Reply>) -> Value {
    let reply = timeout(PATIENCE, replies.recv_async()).await;
    let reply = reply.unwrap().unwrap();
    let answer = reply.result().unwrap().payload().to_bytes();
    serde_json::from_slice(&answer).unwrap()
}

#[tokio::test(flavor = "multi_thread")]
async fn a_station_that_waits_for_reports_of_the_others_is_stopped_meanwhile() {
    let (router, at) = router(free_port()).await;
    let stranger = stranger(&at).await;
    // A station that does not answer state queries.
    let silent = "dobot/2/silent/00112233445566778899aabbccddeeff/state";
    let silent = stranger.declare_queryable(silent).await.unwrap();
    let is_stopped_first = async || {
        let one = Desk::up("desk-1", &at, None).await;
        // Without a network it answers immediately from its own knowledge.
        is_there(&stranger, "desk-1").await;
        let stops = async {
            let _asked = silent.recv_async().await.unwrap();
            let answer = stop_by(&stranger, "desk-1").await;
            assert_eq!(answer["status"], 200, "{answer}");
        };
        let is_first = tokio::select! {
            biased;
            () = stops => true,
            _ = one.members() => false,
        };
        one.end().await;
        is_first
    };
    // A busy machine may delay a stop longer than the timeout of the silent station, but not each
    // time.
    let mut tries = 0;
    while !is_stopped_first().await {
        tries += 1;
        assert!(tries < 20, "no stop is answered while all are asked");
    }
    stranger.close().await.unwrap();
    router.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_large_request_that_is_not_sealed_is_refused_and_a_stop_works_after_it() {
    let (router, at) = router(free_port()).await;
    let one = Desk::up("desk-1", &at, None).await;
    let stranger = stranger_who_sees("desk-1", &at).await;
    let large = json!({
        "method": "POST", "path": "/api/v1/jobs", "token": one.admin(),
        "body": {"title": "x".repeat(8 << 20)},
    });
    let large = serde_json::to_vec(&large).unwrap();
    let asked = stranger.get("dobot/2/desk-1/*/api").payload(large);
    let replies = asked.timeout(PATIENCE).await.unwrap();
    assert_eq!(answer_of(&replies).await["status"], 403);
    assert_eq!(stop_by(&stranger, "desk-1").await["status"], 200);
    one.end().await;
    stranger.close().await.unwrap();
    router.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_message_for_an_unknown_station_reaches_none_and_a_stop_works_after_it() {
    let (router, at) = router(free_port()).await;
    let one = Desk::up("desk-1", &at, None).await;
    let stranger = stranger_who_sees("desk-1", &at).await;
    // More than the router and the stations accept in total.
    let flood = stranger
        .get("dobot/2/desk-1/*/api")
        .payload(vec![b' '; 90 << 20]);
    let replies = flood.timeout(PATIENCE).await.unwrap();
    let other = stranger_who_sees("desk-1", &at).await;
    assert_eq!(stop_by(&other, "desk-1").await["status"], 200);
    let answered = replies.try_recv().ok().flatten();
    let answered = answered.is_some_and(|reply| reply.result().is_ok());
    assert!(!answered, "it was taken");
    one.end().await;
    other.close().await.unwrap();
    router.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_removed_stolen_token_no_longer_moves_an_arm_even_with_control_taken_before() {
    let (router, at) = router(free_port()).await;
    let [one, two] = two_desks(&at).await;
    let mut tokens = Tokens::open(&Folders::at(two.folder.path()).tokens()).unwrap();
    let stolen = tokens.add(Role::Control, "anna").unwrap();
    let mut others = Tokens::open(&Folders::at(one.folder.path()).tokens()).unwrap();
    others.accept(Role::Control, "anna", &stolen).unwrap();
    let thief = |method: &str, path: &str, body: Value| {
        let asked =
            json!({"to": {"members": ["desk-2"]}, "method": method, "path": path, "body": body});
        one.all_as(Some(stolen.secret().to_owned()), asked)
    };
    let answers = thief("POST", "/api/v1/lease", Value::Null).await;
    let lease = answers[0].answer.body["token"].as_str().unwrap().to_owned();
    tokens.remove("anna").unwrap();
    // It is forgotten within 0.2 s.
    let until = Instant::now() + PATIENCE;
    while thief("POST", "/api/v1/lease", Value::Null).await[0]
        .answer
        .status
        != 401
    {
        assert!(Instant::now() < until, "the token is still known");
    }
    let mut packets = two.station.handle().passed();
    let jog = json!({"jog": {"frame": "linear", "axis": "x_plus", "speed_percent": 50}});
    let asked = json!({"to": {"members": ["desk-2"]}, "method": "POST", "path": "/api/v1/jog", "body": jog, "lease": lease});
    let answers = one.all_as(Some(stolen.secret().to_owned()), asked).await;
    assert_eq!(answers[0].answer.status, 401, "{answers:?}");
    let answers = thief("POST", "/api/v1/lease", Value::Null).await;
    assert_eq!(answers[0].answer.status, 401, "{answers:?}");
    // The stop that follows is the first packet of a motion that the arm receives.
    assert!(
        one.stop_all()
            .await
            .iter()
            .all(|answer| answer.answer.is_success())
    );
    let first = async {
        loop {
            let packet = packets.recv().await.unwrap();
            if packet.to_arm {
                return packet.bytes;
            }
        }
    };
    let first = timeout(PATIENCE, first).await.unwrap();
    assert_eq!(first, LASER_OFF.emit(&dialect()).to_bytes());
    for desk in [one, two] {
        desk.end().await;
    }
    router.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_stop_works_during_a_flood_of_requests() {
    let (router, at) = router(free_port()).await;
    let one = Desk::up("desk-1", &at, None).await;
    let stranger = stranger_who_sees("desk-1", &at).await;
    let mut flood = Vec::new();
    for _ in 0..2000 {
        let state = br#"{"method": "GET", "path": "/api/v1/state"}"#;
        let asked = stranger.get("dobot/2/desk-1/*/api").payload(&state[..]);
        flood.push(asked.timeout(PATIENCE).await.unwrap());
    }
    let mut packets = one.station.handle().passed();
    assert_eq!(stop_by(&stranger, "desk-1").await["status"], 200);
    let laser_off = LASER_OFF.emit(&dialect()).to_bytes();
    let dark = async { while packets.recv().await.unwrap().bytes != laser_off {} };
    timeout(PATIENCE, dark).await.unwrap();
    // A busy network may lose some; answered requesters get a response.
    for replies in flood {
        let Ok(Ok(reply)) = timeout(PATIENCE, replies.recv_async()).await else {
            continue;
        };
        if let Ok(sample) = reply.result() {
            let answer: Value = serde_json::from_slice(&sample.payload().to_bytes()).unwrap();
            let status = answer["status"].as_u64();
            assert!(matches!(status, Some(200 | 429)), "{answer}");
        }
    }
    one.end().await;
    stranger.close().await.unwrap();
    router.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_watcher_is_notified_of_changes_elsewhere() {
    let (router, at) = router(free_port()).await;
    let [one, two] = two_desks(&at).await;
    two.ask("POST", "/api/v1/stop", None).await;
    let stopped = |members: &[Member]| {
        let state = members
            .iter()
            .find(|member| member.name == "desk-2")
            .unwrap();
        state.state.as_ref().unwrap().stop.is_some()
    };
    one.sees("that desk-2 is stopped", stopped).await;
    for desk in [one, two] {
        desk.end().await;
    }
    router.end().await;
}
