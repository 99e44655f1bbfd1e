//! A minimal WebSocket client, with little overhead in the measurements.

use std::net::TcpStream;
use std::time::Duration;

use dobot_api::Request;
use serde_json::{Value, json};
use tokio_tungstenite::tungstenite::{Message, WebSocket as Socket, client};

/// A client that waits for each response.
pub(crate) struct WebSocket {
    socket: Socket<TcpStream>,
    id: u64,
}

impl WebSocket {
    /// Connects.
    pub(crate) fn connect(station: &str, query: &str) -> Self {
        let stream = TcpStream::connect(station).expect("the station listens");
        stream.set_nodelay(true).expect("it is TCP");
        let patience = Some(Duration::from_secs(30));
        stream.set_read_timeout(patience).expect("it is a time");
        let url = format!("ws://{station}/api/v1/ws?{query}");
        let (socket, _) = client(url, stream).expect("the station speaks WebSocket");
        Self { socket, id: 0 }
    }

    /// Returns a message for [`WebSocket::send`].
    pub(crate) fn message(&mut self, request: &Request) -> Message {
        self.id += 1;
        Message::text(json!({ "id": self.id, "request": request }).to_string())
    }

    /// Sends a message.
    pub(crate) fn send(&mut self, message: Message) {
        self.socket.send(message).expect("the station takes it");
    }

    /// Returns the response to the last request.
    pub(crate) fn answer(&mut self) -> Value {
        loop {
            let message = self.receive();
            if message["id"] == self.id {
                return message;
            }
        }
    }

    /// Sends a request that must be granted.
    pub(crate) fn ask(&mut self, request: &Request) -> Value {
        let answer = self.try_ask(request);
        assert!(answer["problem"].is_null(), "{request:?}: {answer}");
        answer
    }

    /// Sends a request.
    pub(crate) fn try_ask(&mut self, request: &Request) -> Value {
        let message = self.message(request);
        self.send(message);
        self.answer()
    }

    /// Waits for the arm, and takes control of it.
    pub(crate) fn take_control(&mut self) {
        self.wait(|message| message["state"]["link"]["phase"] == "up");
        self.ask(&Request::TakeLease);
        self.ask(&Request::ConfirmPose);
    }

    /// Waits for a state or notice that meets the condition.
    pub(crate) fn wait(&mut self, is_match: impl Fn(&Value) -> bool) -> Value {
        loop {
            let message = self.receive();
            if is_match(&message) {
                return message;
            }
        }
    }

    fn receive(&mut self) -> Value {
        loop {
            if let Message::Text(text) = self.socket.read().expect("the station is there") {
                return serde_json::from_str(&text).expect("the station speaks JSON");
            }
        }
    }
}
