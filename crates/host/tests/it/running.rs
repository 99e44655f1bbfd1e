//! The client of a station that runs, against a hand-made one.

use dobot_api::StationAddress;
use dobot_host::StationClient;
use futures_util::SinkExt;
use serde_json::{Value, json};
use tokio::net::{TcpListener, TcpStream};
use tokio_tungstenite::tungstenite::Message;
use tokio_tungstenite::{WebSocketStream, accept_async};

/// A station that sends the packets of a test.
struct Fake(WebSocketStream<TcpStream>);

impl Fake {
    async fn welcome(stream: TcpStream) -> Self {
        let mut fake = Self(accept_async(stream).await.unwrap());
        fake.send(json!({"hello": {
            "client": 3, "role": "control", "version": "0.1.0", "dead_man_s": 0.15,
        }}))
        .await;
        fake
    }

    async fn send(&mut self, message: Value) {
        let sent = self.0.send(Message::text(message.to_string())).await;
        sent.unwrap();
    }
}

/// A client and the hand-made station that it is connected with.
async fn pair() -> (StationClient, Fake) {
    let listener = TcpListener::bind("127.0.0.1:0").await.unwrap();
    let address = format!("http://{}", listener.local_addr().unwrap());
    let address = StationAddress::new(&address).unwrap();
    let serve = async { Fake::welcome(listener.accept().await.unwrap().0).await };
    let (client, fake) = tokio::join!(StationClient::connect(&address, "test"), serve);
    (client.unwrap(), fake)
}

fn notice(number: u64, news: &Value, text: &str) -> Value {
    let mut notice = json!({"number": number, "at_s": 1.0, "text": text});
    let fields = notice.as_object_mut().unwrap();
    fields.extend(news.as_object().unwrap().clone());
    json!({"notice": notice})
}

#[tokio::test]
async fn a_command_is_over_when_its_own_notice_arrives() {
    let (mut remote, mut fake) = pair().await;
    let done = |command| json!({"type": "command_done", "command": command});
    let failed = json!({"type": "command_failed", "command": 8});
    fake.send(notice(1, &done(6), "over")).await;
    fake.send(notice(2, &done(7), "over")).await;
    fake.send(notice(3, &failed, "the arm stalled")).await;
    remote.finished(7).await.unwrap();
    let error = remote.finished(8).await.unwrap_err();
    assert_eq!(error.to_string(), "the arm stalled");
}
