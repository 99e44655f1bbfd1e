//! Virtual arms for members without an arm.

use std::time::Duration;

use dobot_api::{Member, Role};
use dobot_fleet::{VirtualArms, VirtualArmsConfig};
use dobot_station::Tokens;
use serde_json::{Value, json};
use tokio::io::{AsyncBufReadExt, AsyncWriteExt, BufReader, Lines};
use tokio::net::TcpStream;
use tokio::time::{interval, timeout};

use super::{
    Desk, Folders, PATIENCE, fleet_config, free_port, is_away, present, router, station_config,
};

/// Longer than any test.
const HOUR: Duration = Duration::from_secs(3600);
const ARMS: &str = "/api/v1/fleet/virtual-arms";

/// A station that hosts this many arms.
async fn giving(at: &str, most: u16, unused: Duration) -> (Desk, VirtualArms) {
    let hall = Desk::up("hall", at, None).await;
    let config = VirtualArmsConfig {
        most,
        unused,
        station: station_config(hall.folder.path()),
        fleet: fleet_config("hall"),
        session: hall.session.clone(),
    };
    let arms = VirtualArms::start(config, hall.station.api());
    (hall, arms)
}

impl Desk {
    /// Sends a request to the station of this name, through the fleet.
    async fn of(&self, member: &str, method: &str, path: &str, body: Value) -> (u16, Value) {
        let asked =
            json!({"to": {"members": [member]}, "method": method, "path": path, "body": body});
        let answer = self
            .all_as(Some(self.admin()), asked)
            .await
            .remove(0)
            .answer;
        (answer.status, answer.body)
    }

    /// Returns the kind of a refusal.
    async fn refused(&self, method: &str, path: &str, body: Option<Value>) -> String {
        let (status, body) = self.ask(method, path, body).await;
        assert!(status >= 400, "{body}");
        let kind = body["type"].as_str().unwrap();
        kind.rsplit('/').next().unwrap().to_owned()
    }
}

/// A client of the fleet's event stream.
struct Board(Lines<BufReader<TcpStream>>);

impl Board {
    async fn open(desk: &Desk) -> Self {
        let address = desk.station.address();
        let mut stream = TcpStream::connect(address).await.unwrap();
        let head = format!("GET /api/v1/fleet/events HTTP/1.1\r\nHost: {address}\r\n\r\n");
        stream.write_all(head.as_bytes()).await.unwrap();
        Self(BufReader::new(stream).lines())
    }

    /// Waits for an event that contains this text.
    async fn wait_for(&mut self, event: &str, text: &str) {
        let event = format!("event: {event}");
        let waiting = async {
            loop {
                if self.0.next_line().await.unwrap().unwrap() == event
                    && self.0.next_line().await.unwrap().unwrap().contains(text)
                {
                    return;
                }
            }
        };
        timeout(PATIENCE, waiting).await.unwrap();
    }
}

fn is_unknown(name: &str) -> impl Fn(&[Member]) -> bool {
    move |members| members.iter().all(|member| member.name != name)
}

#[tokio::test(flavor = "multi_thread")]
async fn a_person_without_an_arm_gets_a_virtual_one_with_the_same_tokens_that_all_see() {
    let (router, at) = router(free_port()).await;
    let (hall, arms) = giving(&at, 2, HOUR).await;
    let desk = Desk::up("desk-1", &at, None).await;
    let (status, given) = hall.ask("POST", ARMS, Some(json!({"name": "anna"}))).await;
    assert_eq!(status, 200, "{given}");
    assert!(
        given["page"]
            .as_str()
            .unwrap()
            .starts_with("http://127.0.0.1:")
    );
    hall.sees("the arm", present(&["anna", "desk-1", "hall"]))
        .await;
    desk.sees("the arm", present(&["anna", "desk-1", "hall"]))
        .await;
    let anna = desk.members().await.remove(0);
    let about = anna.about.unwrap();
    assert_eq!(about.given_by.as_deref(), Some("hall"));
    assert_eq!(about.page.as_deref(), given["page"].as_str());
    // It is controlled with a token of the hosting station only.
    let lease = "/api/v1/lease";
    assert_eq!(hall.of("anna", "POST", lease, Value::Null).await.0, 200);
    assert_eq!(desk.of("anna", "POST", lease, Value::Null).await.0, 401);
    // A second request returns the same arm.
    let (_, again) = hall.ask("POST", ARMS, Some(json!({"name": "anna"}))).await;
    assert_eq!(again, given);
    let (_, listed) = hall.ask("GET", ARMS, None).await;
    assert_eq!(
        listed,
        json!({"most": 2, "unused_s": 3600, "arms": [given]})
    );
    // They end with the hosting station.
    arms.end().await;
    desk.sees("that it is gone", is_unknown("anna")).await;
    hall.end().await;
    desk.end().await;
    router.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn an_invalid_taken_or_excess_name_is_reported_and_nothing_is_started() {
    let (router, at) = router(free_port()).await;
    let (hall, arms) = giving(&at, 1, HOUR).await;
    let desk = Desk::up("desk-1", &at, None).await;
    hall.sees("both", present(&["desk-1", "hall"])).await;
    let wanted = |name: &str| Some(json!({"name": name}));
    for name in ["", "Anna", "an na", "../anna", "7", &"a".repeat(41)] {
        assert_eq!(
            hall.refused("POST", ARMS, wanted(name)).await,
            "invalid",
            "{name:?}"
        );
    }
    for name in ["desk-1", "hall"] {
        assert_eq!(hall.refused("POST", ARMS, wanted(name)).await, "name-taken");
    }
    assert_eq!(
        desk.refused("POST", ARMS, wanted("anna")).await,
        "gives-no-arms"
    );
    assert_eq!(desk.refused("GET", ARMS, None).await, "gives-no-arms");
    let unknown = format!("{ARMS}/anna");
    assert_eq!(hall.refused("DELETE", &unknown, None).await, "no-such-arm");
    let watching = {
        let mut tokens = Tokens::open(&Folders::at(hall.folder.path()).tokens()).unwrap();
        tokens
            .add(Role::Watch, "visitor")
            .unwrap()
            .secret()
            .to_owned()
    };
    let (status, _) = hall
        .ask_as(Some(watching), "POST", ARMS, wanted("anna"))
        .await;
    assert_eq!(status, 403);
    let (status, _) = hall.ask("POST", ARMS, wanted("anna")).await;
    assert_eq!(status, 200);
    assert_eq!(
        hall.refused("POST", ARMS, wanted("ben")).await,
        "all-arms-given"
    );
    let there: Vec<_> = hall.members().await;
    assert!(is_unknown("ben")(&there), "{there:#?}");
    // The name of a station that is away stays reserved.
    desk.end().await;
    hall.sees("that desk-1 is away", is_away("desk-1")).await;
    assert_eq!(
        hall.refused("POST", ARMS, wanted("desk-1")).await,
        "name-taken"
    );
    arms.end().await;
    hall.end().await;
    router.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn an_arm_is_created_again_while_the_last_one_of_its_name_is_still_ending() {
    let (router, at) = router(free_port()).await;
    let (hall, arms) = giving(&at, 1, HOUR).await;
    let wanted = || Some(json!({"name": "anna"}));
    assert_eq!(hall.ask("POST", ARMS, wanted()).await.0, 200);
    let (status, _) = hall.ask("DELETE", &format!("{ARMS}/anna"), None).await;
    assert_eq!(status, 200);
    let (status, again) = hall.ask("POST", ARMS, wanted()).await;
    assert_eq!(status, 200, "{again}");
    hall.sees("it again", present(&["anna", "hall"])).await;
    arms.end().await;
    hall.end().await;
    router.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn an_ended_arm_is_not_listed_and_has_its_jobs_when_it_is_created_again() {
    let (router, at) = router(free_port()).await;
    let (hall, arms) = giving(&at, 1, HOUR).await;
    let wanted = || Some(json!({"name": "anna"}));
    hall.ask("POST", ARMS, wanted()).await;
    hall.sees("it", present(&["anna", "hall"])).await;
    let anna = hall.members().await.remove(0).id;
    let mut board = Board::open(&hall).await;
    board.wait_for("member", "\"anna\"").await;
    let target = json!({"type": "move_to", "x_mm": 200, "y_mm": 0, "z_mm": 50, "rotation_deg": 0, "suction": false, "mode": "jump", "gripper_deg": 0, "pause_s": 0});
    let job = json!({"title": "first try", "kind": "program", "commands": [target]});
    let (status, submitted) = hall.of("anna", "POST", "/api/v1/jobs", job).await;
    assert_eq!(status, 201, "{submitted}");
    let (status, left) = hall.ask("DELETE", &format!("{ARMS}/anna"), None).await;
    assert_eq!((status, &left["arms"]), (200, &json!([])));
    hall.sees("that it is gone", is_unknown("anna")).await;
    board.wait_for("gone", &anna).await;
    let (status, again) = hall.ask("POST", ARMS, wanted()).await;
    assert_eq!(status, 200, "{again}");
    hall.sees("it again", present(&["anna", "hall"])).await;
    let (_, jobs) = hall.of("anna", "GET", "/api/v1/jobs", Value::Null).await;
    assert_eq!(jobs[0]["title"], "first try", "{jobs}");
    arms.end().await;
    hall.end().await;
    router.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn an_arm_without_watchers_ends_by_itself() {
    let (router, at) = router(free_port()).await;
    let (hall, arms) = giving(&at, 1, Duration::from_millis(50)).await;
    let (status, _) = hall.ask("POST", ARMS, Some(json!({"name": "anna"}))).await;
    assert_eq!(status, 200);
    let mut looks = interval(Duration::from_millis(20));
    let ends = async {
        while hall.ask("GET", ARMS, None).await.1["arms"] != json!([]) {
            looks.tick().await;
        }
    };
    timeout(PATIENCE, ends).await.unwrap();
    hall.sees("that it is gone", is_unknown("anna")).await;
    // There is space for another one.
    let (status, given) = hall.ask("POST", ARMS, Some(json!({"name": "ben"}))).await;
    assert_eq!(status, 200, "{given}");
    arms.end().await;
    hall.end().await;
    router.end().await;
}
