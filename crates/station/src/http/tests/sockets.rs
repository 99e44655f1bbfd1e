//! WebSockets on a real address.

use dobot_api::{ClientId, Folders, News, Request, Role, StationAddress, fetch};
use futures_util::{SinkExt, StreamExt};
use serde_json::{Value, json};
use tokio::net::TcpStream;
use tokio_tungstenite::tungstenite::client::IntoClientRequest;
use tokio_tungstenite::tungstenite::http::HeaderValue;
use tokio_tungstenite::tungstenite::{Error, Message};
use tokio_tungstenite::{MaybeTlsStream, WebSocketStream, connect_async};

use crate::http::fake::{Asked, FakeNews, driver};
use crate::sample::{notice, state};
use crate::{Served, Token, Tokens, Web, serve};

struct Station {
    served: Served,
    publisher: std::sync::Arc<FakeNews>,
    asked: Asked,
    handle: dobot_host::StationHandle,
    folder: tempfile::TempDir,
}

type Socket = WebSocketStream<MaybeTlsStream<TcpStream>>;

impl Station {
    async fn start() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let (handle, publisher, asked) = driver();
        let web = Web::new("127.0.0.1:0".parse().unwrap(), Folders::at(folder.path()));
        Self {
            served: serve(&web, handle.clone()).await.unwrap(),
            publisher,
            asked,
            handle,
            folder,
        }
    }

    async fn connect(&self, query: &str) -> Socket {
        self.try_connect(query, &[]).await.unwrap()
    }

    async fn try_connect(
        &self,
        query: &str,
        headers: &[(&'static str, &str)],
    ) -> Result<Socket, Error> {
        let url = format!("ws://{}/api/v1/ws{query}", self.served.address());
        let mut request = url.into_client_request().unwrap();
        for (name, value) in headers {
            request
                .headers_mut()
                .insert(*name, HeaderValue::from_str(value).unwrap());
        }
        connect_async(request).await.map(|(socket, _)| socket)
    }

    /// Returns the clients that left, after the driver has received all requests.
    async fn gone(&self) -> Vec<ClientId> {
        self.handle.jobs().await.unwrap();
        self.publisher.gone.lock().unwrap().clone()
    }
}

/// Returns the next text message.
async fn next(socket: &mut Socket) -> Value {
    loop {
        match socket.next().await.unwrap().unwrap() {
            Message::Text(text) => return serde_json::from_str(&text).unwrap(),
            Message::Ping(_) => {}
            other => panic!("{other:?}"),
        }
    }
}

async fn send(socket: &mut Socket, message: &Value) {
    socket
        .send(Message::text(message.to_string()))
        .await
        .unwrap();
}

fn status(error: &Error) -> u16 {
    match error {
        Error::Http(response) => response.status().as_u16(),
        other => panic!("{other}"),
    }
}

#[tokio::test]
async fn a_client_is_greeted_and_receives_the_state_and_the_events() {
    let station = Station::start().await;
    let mut socket = station.connect("?name=test").await;
    let hello = next(&mut socket).await;
    assert_eq!(hello["hello"]["client"], 1);
    assert_eq!(hello["hello"]["role"], "admin");
    assert_eq!(hello["hello"]["dead_man_s"], 0.15);
    assert_eq!(next(&mut socket).await, json!({"state": state(0.0)}));
    station.publisher.ends.publish_state(state(1.0));
    assert_eq!(next(&mut socket).await, json!({"state": state(1.0)}));
    station
        .publisher
        .ends
        .publish_notice(notice(4, News::LinkLost, "the link is lost"));
    assert_eq!(
        next(&mut socket).await["notice"]["text"],
        "the link is lost"
    );
}

#[tokio::test]
async fn requests_are_answered_with_their_numbers_and_in_their_order() {
    let station = Station::start().await;
    let mut socket = station.connect("?states=0&notices=false").await;
    next(&mut socket).await;
    for id in 0..50 {
        send(
            &mut socket,
            &json!({"id": id, "request": {"type": "start_job", "job": id}}),
        )
        .await;
    }
    let mut ids = Vec::new();
    for _ in 0..50 {
        let answer = next(&mut socket).await;
        assert_eq!(answer["reply"]["type"], "job");
        ids.push(answer["id"].as_u64().unwrap());
    }
    ids.sort_unstable();
    assert_eq!(ids, (0..50).collect::<Vec<_>>());
    let jobs: Vec<_> = (0..50).map(|job| Request::StartJob { job }).collect();
    assert_eq!(station.asked.requests(), jobs);
}

#[tokio::test]
async fn refused_and_invalid_messages_are_answered_with_a_problem() {
    let station = Station::start().await;
    let mut socket = station.connect("?states=0").await;
    next(&mut socket).await;
    send(
        &mut socket,
        &json!({"id": 1, "request": {"type": "start_job", "job": 404}}),
    )
    .await;
    let answer = next(&mut socket).await;
    assert_eq!(
        (&answer["id"], &answer["problem"]["status"]),
        (&json!(1), &json!(404))
    );
    send(&mut socket, &json!({"id": 2, "request": {"type": "fly"}})).await;
    let answer = next(&mut socket).await;
    assert_eq!(
        (&answer["id"], &answer["problem"]["status"]),
        (&json!(2), &json!(422))
    );
    socket.send(Message::text("{oops")).await.unwrap();
    let answer = next(&mut socket).await;
    assert_eq!(
        (answer.get("id"), &answer["problem"]["status"]),
        (None, &json!(400))
    );
    socket.send(Message::binary(vec![0xa5; 43])).await.unwrap();
    assert_eq!(next(&mut socket).await["problem"]["status"], 422);
    assert_eq!(station.asked.requests(), [Request::StartJob { job: 404 }]);
}

#[tokio::test]
async fn the_lease_of_a_client_ends_with_its_connection() {
    let station = Station::start().await;
    let mut polite = station.connect("?states=0").await;
    next(&mut polite).await;
    let mut rude = station.connect("?states=0").await;
    next(&mut rude).await;
    polite.close(None).await.unwrap();
    drop(rude);
    let mut gone = station.gone().await;
    while gone.len() < 2 {
        tokio::task::yield_now().await;
        gone = station.gone().await;
    }
    gone.sort();
    assert_eq!(gone, [1, 2].map(ClientId));
}

#[tokio::test]
async fn invalid_parameters_are_refused_before_the_upgrade() {
    let station = Station::start().await;
    for query in [
        "?states=-1",
        "?states=NaN",
        "?states=inf",
        "?states=x",
        "?notices=7",
        "?name=",
        "?name=%0A",
        "?token=abc",
    ] {
        let error = station.try_connect(query, &[]).await.unwrap_err();
        assert_eq!(status(&error), 400, "{query}");
    }
}

#[tokio::test]
async fn sockets_from_pages_of_other_sites_are_refused() {
    let station = Station::start().await;
    for (name, value) in [
        ("origin", "http://evil.example"),
        ("origin", "null"),
        ("host", "evil.example"),
        ("host", "evil.example:8642"),
    ] {
        let error = station.try_connect("", &[(name, value)]).await.unwrap_err();
        assert_eq!(status(&error), 403, "{name}: {value}");
    }
    let own = format!("http://{}", station.served.address());
    station.try_connect("", &[("origin", &own)]).await.unwrap();
}

#[tokio::test]
async fn a_token_in_the_subprotocol_is_checked_and_not_echoed() {
    let station = Station::start().await;
    let wrong = [("sec-websocket-protocol", "dobot, dobot.token.00")];
    assert_eq!(
        status(&station.try_connect("", &wrong).await.unwrap_err()),
        401
    );
    let url = format!("ws://{}/api/v1/ws", station.served.address());
    let mut request = url.into_client_request().unwrap();
    request
        .headers_mut()
        .insert("sec-websocket-protocol", HeaderValue::from_static("dobot"));
    let (_, response) = connect_async(request).await.unwrap();
    assert_eq!(response.headers()["sec-websocket-protocol"], "dobot");
}

#[tokio::test]
async fn a_client_that_floods_is_closed_and_others_are_notified() {
    let station = Station::start().await;
    let mut socket = station.connect("?states=0&notices=false&name=flood").await;
    next(&mut socket).await;
    let (mut writer, mut reader) = socket.split();
    let flooding = tokio::spawn(async move {
        // The station closes the connection at some point.
        while writer.send(Message::text("x")).await.is_ok() {}
    });
    let mut farewell = None;
    while let Some(Ok(message)) = reader.next().await {
        if let Message::Close(Some(frame)) = message {
            farewell = Some((u16::from(frame.code), frame.reason.to_string()));
            break;
        }
    }
    flooding.abort();
    let (code, reason) = farewell.unwrap();
    assert_eq!(code, 1008);
    assert!(reason.contains("1000 messages"), "{reason}");
    let trouble = station.publisher.trouble.lock().unwrap().clone();
    assert!(
        matches!(&trouble[..], [one] if one.starts_with("client 1 (flood) was dropped")),
        "{trouble:?}"
    );
}

#[tokio::test]
async fn all_clients_are_notified_when_the_station_ends() {
    let station = Station::start().await;
    let mut socket = station.connect("?states=0").await;
    next(&mut socket).await;
    let (ended, code) = tokio::join!(station.served.end(), async {
        loop {
            match socket.next().await {
                Some(Ok(Message::Close(Some(frame)))) => break u16::from(frame.code),
                Some(Ok(_)) => {}
                other => panic!("{other:?}"),
            }
        }
    });
    ended.unwrap();
    assert_eq!(code, 1001);
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_hundred_watchers_miss_nothing() {
    const WATCHERS: usize = 100;
    const STATES: u32 = 50;
    let station = Station::start().await;
    let mut watching = Vec::new();
    for _ in 0..WATCHERS {
        let mut socket = station.connect("?notices=false").await;
        next(&mut socket).await;
        next(&mut socket).await;
        watching.push(tokio::spawn(async move {
            for n in 1..=STATES {
                assert_eq!(next(&mut socket).await["state"]["at_s"], f64::from(n));
            }
        }));
    }
    for n in 1..=STATES {
        station.publisher.ends.publish_state(state(f64::from(n)));
    }
    for watcher in watching {
        watcher.await.unwrap();
    }
}

impl Station {
    /// Opens a socket with a token.
    async fn connect_with(&self, token: &Token) -> Socket {
        let protocols = format!("dobot, dobot.token.{}", token.secret());
        let headers = [("sec-websocket-protocol", &*protocols)];
        self.try_connect("", &headers).await.unwrap()
    }

    fn tokens(&self) -> Tokens {
        Tokens::open(&self.folder.path().join("tokens.toml")).unwrap()
    }
}

/// Waits until the station closes a socket, and returns the reason.
async fn closed(socket: &mut Socket) -> String {
    loop {
        if let Message::Close(frame) = socket.next().await.unwrap().unwrap() {
            return frame.unwrap().reason.to_string();
        }
    }
}

#[tokio::test]
async fn a_socket_whose_token_is_removed_is_closed_and_its_client_leaves_at_once() {
    let station = Station::start().await;
    let mut tokens = station.tokens();
    let kept = tokens.add(Role::Control, "ben").unwrap();
    let removed = tokens.add(Role::Control, "anna").unwrap();
    let mut anna = station.connect_with(&removed).await;
    let mut ben = station.connect_with(&kept).await;
    next(&mut anna).await;
    next(&mut ben).await;
    tokens.remove("anna").unwrap();
    assert!(closed(&mut anna).await.contains("token was removed"));
    assert_eq!(station.gone().await.len(), 1);
    // Other clients are unaffected.
    send(
        &mut ben,
        &json!({"id": 1, "request": {"type": "take_lease"}}),
    )
    .await;
    loop {
        let answer = next(&mut ben).await;
        if answer["id"] == 1 {
            assert!(answer["reply"].is_object(), "{answer}");
            break;
        }
    }
}

#[tokio::test]
async fn a_socket_whose_token_loses_rights_is_closed() {
    let station = Station::start().await;
    let mut tokens = station.tokens();
    let token = tokens.add(Role::Control, "anna").unwrap();
    let mut anna = station.connect_with(&token).await;
    next(&mut anna).await;
    let file = station.folder.path().join("tokens.toml");
    let text = std::fs::read_to_string(&file).unwrap();
    let less = text.replace("role = \"control\"", "role = \"watch\"");
    assert_ne!(less, text);
    std::fs::write(&file, less).unwrap();
    assert!(closed(&mut anna).await.contains("role was reduced"));
    assert_eq!(station.gone().await.len(), 1);
}

#[tokio::test]
async fn what_is_said_on_a_page_reaches_a_listener_and_is_refused_without_one() {
    let station = Station::start().await;
    let mut page = station.connect("?states=0&notices=false").await;
    next(&mut page).await;
    page.send(Message::binary(vec![1, 2])).await.unwrap();
    let refused = next(&mut page).await;
    assert!(
        refused["problem"]["type"]
            .as_str()
            .unwrap()
            .ends_with("/no-listener"),
        "{refused}"
    );
    let address = format!("http://{}", station.served.address());
    let address = StationAddress::new(&address).unwrap();
    let get = async |path: &str| fetch::<Value>(&address, path).await.unwrap();
    assert_eq!(get("/api/v1/talk").await, json!({"listens": false}));
    let (audio, ()) = tokio::join!(get("/api/v1/talk/audio"), async {
        while get("/api/v1/talk").await == json!({"listens": false}) {}
        page.send(Message::binary(vec![1, 2])).await.unwrap();
    });
    assert_eq!(audio, json!([{"client": 1, "pcm": "AQI="}]));
}

#[tokio::test]
async fn only_those_who_may_move_the_arm_may_speak() {
    let station = Station::start().await;
    let token = station.tokens().add(Role::Queue, "anna").unwrap();
    let mut page = station.connect_with(&token).await;
    page.send(Message::binary(vec![1, 2])).await.unwrap();
    let refused = loop {
        let message = next(&mut page).await;
        if let Some(kind) = message["problem"]["type"].as_str() {
            break kind.to_owned();
        }
    };
    assert!(refused.ends_with("/role"), "{refused}");
}
