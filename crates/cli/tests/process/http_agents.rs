//! Agents that come to a station over HTTP, with the client of the protocol's own library.

use std::path::Path;

use rmcp::ServiceExt;
use rmcp::model::ProtocolVersion;
use rmcp::service::{ClientLifecycleMode, ClientServiceExt};
use rmcp::transport::StreamableHttpClientTransport;
use rmcp::transport::streamable_http_client::StreamableHttpClientTransportConfig;
use serde_json::json;
use tempfile::TempDir;
use tokio::io::copy_bidirectional;
use tokio::net::{TcpStream, UnixListener};
use tokio::task::{JoinHandle, JoinSet};

use crate::agents::{Agent, Desk, is_motion, only_queues, square, stopped};
use crate::support::up::Up;

/// The way of an agent to a station: the library's client speaks over a socket of Unix without TLS, and what it says is
/// carried on to the station's port. When it is cut, both ends see what they see of a program that is killed.
struct Way {
    folder: TempDir,
    carrying: JoinHandle<()>,
}

impl Way {
    fn new(up: &Up) -> Self {
        let folder = tempfile::tempdir().expect("there is room");
        let listener = UnixListener::bind(folder.path().join("way")).expect("there is room");
        let to = up.page.trim_start_matches("http://").to_owned();
        let carrying = tokio::spawn(async move {
            // All of them end with this one.
            let mut connections = JoinSet::new();
            while let Ok((mut near, _)) = listener.accept().await {
                let mut far = TcpStream::connect(&to).await.expect("the station listens");
                connections.spawn(async move { copy_bidirectional(&mut near, &mut far).await });
            }
        });
        Self { folder, carrying }
    }

    fn socket(&self) -> String {
        let path: &Path = self.folder.path();
        path.join("way").to_str().expect("it is text").to_owned()
    }

    fn cut(self) {
        self.carrying.abort();
    }
}

/// How an agent's program begins: with a session, or with all that is needed in each request.
#[derive(Clone, Copy)]
enum Manner {
    Session,
    EachRequest,
}

const MANNERS: [Manner; 2] = [Manner::Session, Manner::EachRequest];

/// An agent whose token lets it move the arm.
async fn moving_agent(up: &Up, way: &Way, manner: Manner) -> Agent {
    let name = match manner {
        Manner::Session => "session",
        Manner::EachRequest => "requests",
    };
    let token = up.dobot(&["token", "add", "control", name]).succeeds();
    agent(up, way, manner, Some(token.stdout.trim())).await
}

async fn agent(up: &Up, way: &Way, manner: Manner, token: Option<&str>) -> Agent {
    let mut config = StreamableHttpClientTransportConfig::with_uri(format!("{}/mcp", up.page));
    if let Some(token) = token {
        config = config.auth_header(token);
    }
    let socket = way.socket();
    let transport = StreamableHttpClientTransport::from_unix_socket_with_config(&socket, config);
    let client = match manner {
        Manner::Session => ().serve(transport).await,
        Manner::EachRequest => {
            let lifecycle = ClientLifecycleMode::Discover {
                preferred_versions: vec![ProtocolVersion::V_2026_07_28],
            };
            ().serve_with_lifecycle(transport, lifecycle).await
        }
    };
    Agent(client.expect("it greets"))
}

#[tokio::test(flavor = "multi_thread")]
async fn an_agent_moves_the_arm_over_http_and_a_refused_move_does_not_reach_the_arm() {
    let desk = Desk::new();
    let way = Way::new(&desk.up);
    for (manner, y_mm) in MANNERS.into_iter().zip([-30.0, 30.0]) {
        let agent = moving_agent(&desk.up, &way, manner).await;
        let seen = Agent::done(agent.call("look", json!({})).await);
        assert_eq!(seen["alarms"], json!([]), "{seen}");
        let to = json!({"x_mm": 220, "y_mm": y_mm, "z_mm": 20, "path": "movj"});
        let moved = Agent::done(agent.call("move_to", to).await);
        let found_mm = moved["arm"]["y_mm"].as_f64().expect("a number");
        assert!((found_mm - y_mm).abs() < 0.1, "{moved}");
        assert!(desk.got().iter().any(is_motion));
        let into_the_table = json!({"x_mm": 220, "y_mm": 0, "z_mm": -90});
        let refused = agent.call("move_to", into_the_table).await;
        assert_eq!(Agent::refused(refused, "policy")["rule"], "table");
        assert!(!desk.got().iter().any(is_motion));
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn an_agent_over_http_that_is_killed_during_a_drawing_stops_the_arm() {
    for manner in MANNERS {
        let desk = Desk::new();
        let way = Way::new(&desk.up);
        let agent = moving_agent(&desk.up, &way, manner).await;
        let _drawing = agent.begins_to_draw(&desk).await;
        way.cut();
        stopped(&desk.up).await;
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_call_over_http_that_is_cancelled_stops_the_arm() {
    for manner in MANNERS {
        let desk = Desk::new();
        let way = Way::new(&desk.up);
        let agent = moving_agent(&desk.up, &way, manner).await;
        let drawing = agent.begins_to_draw(&desk).await;
        let why = Some("enough".to_owned());
        drawing.cancel(why).await.expect("it is sent");
        stopped(&desk.up).await;
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn over_http_each_agent_has_the_rights_of_its_own_token() {
    let desk = Desk::new();
    let way = Way::new(&desk.up);
    let with_token = async |role: &str| {
        let token = desk.up.dobot(&["token", "add", role, role]).succeeds();
        let token = token.stdout.trim().to_owned();
        agent(&desk.up, &way, Manner::Session, Some(&token)).await
    };
    only_queues(&desk, &with_token("queue").await).await;
    only_queues(&desk, &agent(&desk.up, &way, Manner::Session, None).await).await;
    let watcher = with_token("watch").await;
    let planned = watcher.plans(square()).await;
    let draw = json!({"drawing": planned["drawing"]});
    Agent::refused(watcher.call("draw", draw).await, "role");
    assert!(!desk.got().iter().any(is_motion));
    Agent::done(watcher.call("stop", json!({})).await);
}
