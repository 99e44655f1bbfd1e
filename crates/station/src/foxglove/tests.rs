use std::net::Ipv4Addr;

use dobot_wire::Status;
use futures_util::{SinkExt, StreamExt};
use serde_json::{Value, json};
use tokio::net::TcpStream;
use tokio_tungstenite::tungstenite::client::IntoClientRequest;
use tokio_tungstenite::tungstenite::{Error, Message};
use tokio_tungstenite::{MaybeTlsStream, WebSocketStream, connect_async};

use super::*;
use crate::fake::FakeDriver;

/// A client of the published protocol.
struct FoxgloveClient {
    socket: Socket,
    /// The channel id of each topic.
    channels: HashMap<String, u64>,
    advertised: Vec<Value>,
}

impl FoxgloveClient {
    async fn come(address: SocketAddr) -> Self {
        let socket = connect(address, None).await.expect("it listens");
        let (channels, advertised) = (HashMap::new(), Vec::new());
        let mut client = Self {
            socket,
            channels,
            advertised,
        };
        while client.channels.is_empty() {
            let text = client.next_text().await;
            let advertised = text
                .as_ref()
                .and_then(|message| message["channels"].as_array());
            for channel in advertised.into_iter().flatten() {
                let name = channel["topic"]
                    .as_str()
                    .expect("a topic has a name")
                    .to_owned();
                let id = channel["id"].as_u64().expect("a channel has a number");
                client.channels.insert(name, id);
                client.advertised.push(channel.clone());
            }
        }
        client
    }

    /// Returns the next text message, if the message is text.
    async fn next_text(&mut self) -> Option<Value> {
        match self.socket.next().await?.expect("it is open") {
            Message::Text(text) => Some(serde_json::from_str(&text).expect("it is JSON")),
            _ => None,
        }
    }

    /// Subscribes to a topic, with the channel's id as subscription id.
    async fn want(&mut self, topic: &str) {
        let id = self.channels[topic];
        let words = json!({ "op": "subscribe", "subscriptions": [{ "id": id, "channelId": id }] });
        let words = Message::text(words.to_string());
        self.socket.send(words).await.expect("it is open");
    }

    /// Returns the next message of a topic with its time, in nanoseconds since 1970. `again` is
    /// repeated until it arrives, since a subscription is only effective after the station has read
    /// it.
    async fn message(&mut self, topic: &str, mut again: impl FnMut()) -> (u64, Value) {
        let id = self.channels[topic];
        loop {
            again();
            let next = tokio::time::timeout(Duration::from_millis(20), self.socket.next()).await;
            let Ok(Some(message)) = next else {
                continue;
            };
            let Message::Binary(bytes) = message.expect("it is open") else {
                continue;
            };
            // One, the subscription, the time, the message.
            assert_eq!(bytes[0], 1);
            let number = u32::from_le_bytes(bytes[1..5].try_into().expect("four bytes"));
            let at_ns = u64::from_le_bytes(bytes[5..13].try_into().expect("eight bytes"));
            if u64::from(number) == id {
                return (
                    at_ns,
                    serde_json::from_slice(&bytes[13..]).expect("it is JSON"),
                );
            }
        }
    }
}

type Socket = WebSocketStream<MaybeTlsStream<TcpStream>>;

/// Opens a socket like a page of this origin, or like a program without one.
async fn connect(address: SocketAddr, origin: Option<&str>) -> Result<Socket, Error> {
    let mut request = format!("ws://{address}").into_client_request()?;
    let headers = [
        ("sec-websocket-protocol", Some("foxglove.sdk.v1")),
        ("origin", origin),
    ];
    for (name, value) in headers {
        if let Some(value) = value {
            let value = value.parse().expect("it is a header");
            request.headers_mut().insert(name, value);
        }
    }
    connect_async(request).await.map(|(socket, _)| socket)
}

/// A station with a scripted arm.
async fn served() -> (FakeDriver, SocketAddr) {
    let (handle, driver) = FakeDriver::new(16);
    let port = FoxglovePort::bind(SocketAddr::from((Ipv4Addr::LOCALHOST, 0))).await;
    let port = port.expect("a port is free");
    let address = port.address();
    tokio::spawn(async move { port.serve(&handle).await });
    (driver, address)
}

/// The arm at zero with its base turned: rear arm upright, forearm level, the tool 215.07 mm from
/// the axis.
fn turned(base_deg: f32) -> PassedPacket {
    let (sine, cosine) = base_deg.to_radians().sin_cos();
    let status = Status {
        x_mm: OUT_MM * cosine,
        y_mm: OUT_MM * sine,
        base_deg,
        rotation_deg: base_deg,
        ..Status::AT_ZERO
    };
    PassedPacket {
        at: Duration::from_secs(7),
        to_arm: false,
        bytes: status.emit().to_bytes(),
        pen_below_mm: None,
    }
}

/// The length of forearm and tool, from the axis of the base.
const OUT_MM: f32 = 215.07;

#[tokio::test]
async fn foxglove_is_offered_the_topics_of_the_recordings_with_their_schemas() {
    let (_driver, address) = served().await;
    let client = FoxgloveClient::come(address).await;
    let mut names: Vec<_> = client.channels.keys().map(String::as_str).collect();
    names.sort_unstable();
    let recorded = [
        "/arm/ink",
        "/arm/joints",
        "/arm/pose",
        "/arm/target",
        "/recorder",
        "/station/notices",
        "/station/state",
        "/tf",
        "/wire/from_arm",
        "/wire/to_arm",
    ];
    assert_eq!(names, recorded);
    let transform = client
        .advertised
        .iter()
        .find(|channel| channel["topic"] == "/tf");
    let transform = transform.expect("it is offered");
    assert_eq!(transform["schemaName"], "foxglove.FrameTransforms");
    assert_eq!(transform["encoding"], "json");
    let schema: Value = serde_json::from_str(transform["schema"].as_str().expect("it is text"))
        .expect("it is JSON");
    assert_eq!(schema["type"], "object");
    for topic in ["/arm/ink", "/arm/target"] {
        let scene = client
            .advertised
            .iter()
            .find(|channel| channel["topic"] == topic);
        let scene = scene.expect("it is offered");
        assert_eq!(scene["schemaName"], "foxglove.SceneUpdate");
    }
}

#[tokio::test]
async fn pages_of_other_sites_are_refused() {
    let (_driver, address) = served().await;
    for origin in [
        "https://app.foxglove.dev",
        "http://localhost:8080",
        "http://127.0.0.1:8642",
        "http://[::1]:80",
        "file://",
    ] {
        let met = connect(address, Some(origin)).await;
        assert!(met.is_ok(), "{origin}: {met:?}");
    }
    for origin in [
        "http://evil.example",
        "https://foxglove.dev.evil.example",
        "https://evilfoxglove.dev",
        "http://app.foxglove.dev",
        "http://localhost.evil.example",
        "null",
        "",
    ] {
        match connect(address, Some(origin)).await {
            Err(Error::Http(answer)) => assert_eq!(answer.status(), 403, "{origin}"),
            met => panic!("{origin}: {met:?}"),
        }
    }
}

#[tokio::test]
async fn foxglove_gets_the_place_of_the_tool_as_the_arm_reports_it() {
    let (driver, address) = served().await;
    let mut client = FoxgloveClient::come(address).await;
    client.want("/tf").await;
    let mut base_deg = 30.0;
    let again = || {
        // Each status has another angle, until one is published.
        base_deg += 0.25;
        driver.publish_packet(turned(base_deg));
    };
    let (_, message) = client.message("/tf", again).await;
    // The turret turns with the base only: rear arm upright, forearm level.
    let turret = &message["transforms"][0];
    assert_eq!(turret["parent_frame_id"], "base");
    assert_eq!(turret["child_frame_id"], "turret");
    let part = |name: &str| turret["rotation"][name].as_f64().expect("it is a number");
    let turned_deg = 2.0 * part("z").atan2(part("w")).to_degrees();
    assert!(
        (30.0..=f64::from(base_deg) + 1e-3).contains(&turned_deg),
        "{turned_deg}"
    );
}

#[tokio::test]
async fn foxglove_gets_the_state_of_the_station_at_its_time() {
    let (driver, address) = served().await;
    let mut client = FoxgloveClient::come(address).await;
    client.want("/station/state").await;
    let begun = Timestamp::now().as_nanosecond();
    let (at_ns, state) = client
        .message("/station/state", || {
            driver.publish_state(crate::sample::state(60.0));
        })
        .await;
    assert_eq!(state["at_s"], 60.0);
    // The sample station has run for a minute by then: the time is that of the state, not that of
    // the message.
    let ahead_s = (i128::from(at_ns) - begun) / 1_000_000_000;
    assert!((50..=60).contains(&ahead_s), "{ahead_s}");
}

#[tokio::test]
async fn other_machines_on_the_network_cannot_watch() {
    let everywhere = SocketAddr::from((Ipv4Addr::UNSPECIFIED, 0));
    let refused = FoxglovePort::bind(everywhere)
        .await
        .expect_err("it has no passwords");
    assert!(refused.to_string().contains("ssh -L"), "{refused}");
}

#[tokio::test]
async fn a_port_in_use_by_another_program_is_reported() {
    let (_driver, address) = served().await;
    let refused = FoxglovePort::bind(address).await.expect_err("it is taken");
    assert!(
        matches!(refused, FoxglovePortError::Listen { address: refused, .. } if refused == address)
    );
}
