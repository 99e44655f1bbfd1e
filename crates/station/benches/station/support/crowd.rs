//! Many watching clients in one thread.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use futures_util::StreamExt;
use tokio::net::TcpStream;
use tokio::sync::watch;
use tokio::task::JoinSet;
use tokio_tungstenite::tungstenite::Message;
use tokio_tungstenite::tungstenite::protocol::WebSocketConfig;
use tokio_tungstenite::{WebSocketStream, client_async_with_config};

/// Many watching clients in one thread.
#[derive(Debug)]
pub(crate) struct Crowd {
    thread: JoinHandle<Vec<Watched>>,
    over: watch::Sender<bool>,
}

/// The data that one client received.
#[derive(Debug, Default)]
pub(crate) struct Watched {
    /// The arrival times of states, with the numbers of their statuses.
    pub(crate) states: Vec<(Instant, u32)>,
    /// Whether the station closed the connection.
    pub(crate) dropped: bool,
}

impl Crowd {
    /// Connects this many clients.
    pub(crate) fn gather(size: usize, station: &str, query: &str) -> Self {
        let url = format!("ws://{station}/api/v1/ws?{query}");
        let station = station.to_owned();
        let (over, until) = watch::channel(false);
        let here = Arc::new(AtomicUsize::new(0));
        let arrived = here.clone();
        let thread = std::thread::spawn(move || {
            let runtime = tokio::runtime::Builder::new_current_thread()
                .enable_all()
                .build()
                .expect("descriptors");
            runtime.block_on(async {
                let mut clients = JoinSet::new();
                for _ in 0..size {
                    let stream = TcpStream::connect(&station).await.expect("it listens");
                    stream.set_nodelay(true).expect("it is TCP");
                    let lean = WebSocketConfig::default().read_buffer_size(4 * 1024);
                    let connected = client_async_with_config(&url, stream, Some(lean)).await;
                    let (socket, _) = connected.expect("a WebSocket");
                    clients.spawn(look(socket, until.clone()));
                    arrived.fetch_add(1, Ordering::Relaxed);
                }
                clients.join_all().await
            })
        });
        while here.load(Ordering::Relaxed) < size {
            assert!(!thread.is_finished(), "the crowd found no station");
            std::thread::sleep(Duration::from_millis(10));
        }
        Self { thread, over }
    }

    /// Disconnects all clients.
    pub(crate) fn leave(self) -> Vec<Watched> {
        let _ = self.over.send(true);
        self.thread.join().expect("nobody panics")
    }
}

async fn look(mut socket: WebSocketStream<TcpStream>, mut over: watch::Receiver<bool>) -> Watched {
    let mut watched = Watched::default();
    loop {
        let message = tokio::select! {
            message = socket.next() => message,
            _ = over.changed() => return watched,
        };
        match message {
            Some(Ok(Message::Text(text))) if text.starts_with("{\"state\"") => {
                let number = number(&text).unwrap_or(u32::MAX);
                watched.states.push((Instant::now(), number));
            }
            Some(Ok(_)) => {}
            Some(Err(_)) | None => {
                watched.dropped = true;
                return watched;
            }
        }
    }
}

/// Returns the number of a status, sent as the gripper angle.
fn number(text: &str) -> Option<u32> {
    let (_, rest) = text.split_once("\"gripper_deg\":")?;
    let (digits, _) = rest.split_once(['.', ',', '}'])?;
    digits.parse().ok()
}
