//! The client of a station against hand-made ones.

use dobot_api::{
    ConnectError, Remote, RemoteError, Reply, Request, State, StationAddress, StationEvent, fetch,
    is_station,
};
use futures_util::{SinkExt, StreamExt};
use serde_json::{Value, json};
use tokio::io::{AsyncRead, AsyncReadExt, AsyncWrite, AsyncWriteExt};
use tokio::net::{TcpListener, TcpStream};
use tokio_tungstenite::tungstenite::Message;
use tokio_tungstenite::tungstenite::handshake::server;
use tokio_tungstenite::tungstenite::protocol::CloseFrame;
use tokio_tungstenite::tungstenite::protocol::frame::coding::CloseCode;
use tokio_tungstenite::{WebSocketStream, accept_hdr_async};

/// A station that sends the messages of a test.
pub(crate) struct Fake<S = TcpStream>(WebSocketStream<S>);

impl<S: AsyncRead + AsyncWrite + Unpin> Fake<S> {
    /// Accepts a client and greets it; returns its request.
    pub(crate) async fn welcome(stream: S) -> (Self, String) {
        let mut asked = String::new();
        let note = |request: &server::Request, answer: server::Response| {
            asked = request.uri().to_string();
            if let Some(token) = request.headers().get("Authorization") {
                asked += " ";
                asked += token.to_str().unwrap();
            }
            Ok(answer)
        };
        let mut fake = Self(accept_hdr_async(stream, note).await.unwrap());
        fake.send(json!({"hello": {
            "client": 3, "role": "control", "version": "0.1.0", "dead_man_s": 0.15,
        }}))
        .await;
        (fake, asked)
    }

    async fn send(&mut self, message: Value) {
        let sent = self.0.send(Message::text(message.to_string())).await;
        sent.unwrap();
    }

    pub(crate) async fn receive(&mut self) -> Value {
        let message = self.0.next().await.unwrap().unwrap();
        serde_json::from_str(message.to_text().unwrap()).unwrap()
    }
}

async fn listen() -> (TcpListener, StationAddress) {
    let listener = TcpListener::bind("127.0.0.1:0").await.unwrap();
    let address = format!("http://{}", listener.local_addr().unwrap());
    (listener, StationAddress::new(&address).unwrap())
}

/// A client and the hand-made station that it is connected with.
async fn pair() -> (Remote, Fake) {
    let (listener, address) = listen().await;
    let serve = async { Fake::welcome(listener.accept().await.unwrap().0).await.0 };
    let (remote, fake) = tokio::join!(Remote::connect(&address, "test"), serve);
    (remote.unwrap(), fake)
}

fn state(at_s: f64) -> Value {
    json!({"state": State { at_s, ..State::sample() }})
}

fn notice(number: u64, news: &Value, text: &str) -> Value {
    let mut notice = json!({"number": number, "at_s": 1.0, "text": text});
    let fields = notice.as_object_mut().unwrap();
    fields.extend(news.as_object().unwrap().clone());
    json!({"notice": notice})
}

#[tokio::test]
async fn the_name_and_the_token_reach_the_station() {
    let (listener, mut address) = listen().await;
    address.token = Some("abc".into());
    let serve = async { Fake::welcome(listener.accept().await.unwrap().0).await.1 };
    let (remote, asked) = tokio::join!(Remote::connect(&address, "dobot move & co"), serve);
    assert_eq!(remote.unwrap().hello().client.0, 3);
    assert_eq!(
        asked,
        "/api/v1/ws?states=200&name=dobot%20move%20%26%20co Bearer abc"
    );
}

#[tokio::test]
async fn an_answer_is_distinguished_from_earlier_messages_and_none_of_them_is_lost() {
    let (mut remote, mut fake) = pair().await;
    let serve = async {
        let asked = fake.receive().await;
        assert_eq!(asked["request"], json!({"type": "take_lease"}));
        fake.send(state(1.0)).await;
        fake.send(notice(1, &json!({"type": "link_up"}), "here"))
            .await;
        fake.send(state(2.0)).await;
        let answer = json!({"id": asked["id"], "reply": {"type": "lease", "lease": null}});
        fake.send(answer).await;
    };
    let (reply, ()) = tokio::join!(remote.request(Request::TakeLease), serve);
    assert_eq!(reply.unwrap(), Reply::Lease { lease: None });
    assert_eq!(next_text(&mut remote).await, "here");
    assert_eq!(next_at_s(&mut remote).await, 2.0);
}

/// Waits until the client has received everything, without a request.
async fn is_received(fake: &mut Fake) {
    fake.0.send(Message::Ping("there?".into())).await.unwrap();
    let answer = fake.0.next().await.unwrap().unwrap();
    assert_eq!(answer, Message::Pong("there?".into()));
}

async fn next_text(remote: &mut Remote) -> String {
    match remote.next().await.unwrap() {
        StationEvent::Notice(notice) => notice.text,
        other @ StationEvent::State(_) => panic!("{other:?}"),
    }
}

async fn next_at_s(remote: &mut Remote) -> f64 {
    match remote.next().await.unwrap() {
        StationEvent::State(state) => state.at_s,
        other @ StationEvent::Notice(_) => panic!("{other:?}"),
    }
}

#[tokio::test]
async fn a_client_that_waits_for_a_person_stays_connected_and_then_gets_the_last_state() {
    let (mut remote, mut fake) = pair().await;
    fake.send(notice(1, &json!({"type": "link_up"}), "here"))
        .await;
    for second in 1..=17 {
        fake.send(state(second.into())).await;
    }
    is_received(&mut fake).await;
    assert_eq!(next_text(&mut remote).await, "here");
    assert_eq!(next_at_s(&mut remote).await, 17.0);
}

#[tokio::test]
async fn states_that_arrive_in_a_burst_are_all_delivered() {
    let (mut remote, mut fake) = pair().await;
    for second in 1..=16 {
        fake.send(state(second.into())).await;
    }
    is_received(&mut fake).await;
    for second in 1..=16 {
        assert_eq!(next_at_s(&mut remote).await, f64::from(second));
    }
}

#[tokio::test]
async fn a_request_is_followed_by_no_state_older_than_the_last_one() {
    let (mut remote, mut fake) = pair().await;
    for second in 1..=9 {
        fake.send(state(second.into())).await;
    }
    is_received(&mut fake).await;
    let serve = async {
        let asked = fake.receive().await;
        fake.send(json!({"id": asked["id"], "reply": {"type": "done"}}))
            .await;
    };
    let (reply, ()) = tokio::join!(remote.request(Request::PauseJob), serve);
    assert_eq!(reply.unwrap(), Reply::Done);
    assert_eq!(next_at_s(&mut remote).await, 9.0);
}

#[tokio::test]
async fn a_client_that_returns_to_an_ended_station_gets_the_reason() {
    let (mut remote, mut fake) = pair().await;
    fake.send(notice(1, &json!({"type": "link_up"}), "here"))
        .await;
    let close = CloseFrame {
        code: CloseCode::Away,
        reason: "the station is shutting down".into(),
    };
    fake.0.close(Some(close)).await.unwrap();
    let refused = remote.request(Request::TakeLease).await.unwrap_err();
    let text = refused.to_string();
    assert!(text.ends_with(": the station is shutting down"), "{text}");
    let event = remote.next().await.unwrap();
    assert!(matches!(event, StationEvent::Notice(_)), "{event:?}");
    let over = remote.next().await.unwrap_err();
    assert!(matches!(over, RemoteError::Closed(None)), "{over:?}");
}

#[tokio::test]
async fn an_answer_that_arrives_too_late_is_not_mistaken_for_another_one() {
    let (mut remote, mut fake) = pair().await;
    let given_up = tokio::select! {
        biased;
        asked = fake.receive() => asked,
        reply = remote.request(Request::TakeLease) => panic!("{reply:?}"),
    };
    let answer = |asked: &Value, reply: Value| json!({"id": asked["id"], "reply": reply});
    let serve = async {
        let asked = fake.receive().await;
        fake.send(answer(&given_up, json!({"type": "lease", "lease": null})))
            .await;
        fake.send(answer(&asked, json!({"type": "done"}))).await;
    };
    let (reply, ()) = tokio::join!(remote.request(Request::PauseJob), serve);
    assert_eq!(reply.unwrap(), Reply::Done);
}

#[tokio::test]
async fn a_refusal_has_its_text_its_kind_and_its_hint() {
    let (mut remote, mut fake) = pair().await;
    let serve = async {
        let asked = fake.receive().await;
        let problem = json!({
            "type": "/api/v1/problems/no-lease", "title": "no control", "status": 409,
            "detail": "the page has control", "hint": "ask",
        });
        fake.send(json!({"id": asked["id"], "problem": problem}))
            .await;
    };
    let (reply, ()) = tokio::join!(remote.request(Request::PauseJob), serve);
    let error = reply.unwrap_err();
    assert_eq!(error.to_string(), "the page has control");
    assert_eq!(error.kind(), Some("no-lease"));
    assert_eq!(error.hint().as_deref(), Some("ask"));
}

#[tokio::test]
async fn a_station_that_ends_is_reported() {
    let (mut remote, fake) = pair().await;
    drop(fake);
    let error = remote.next().await.unwrap_err();
    assert!(
        matches!(error, RemoteError::Closed(_) | RemoteError::Broken(_)),
        "{error:?}"
    );
}

#[tokio::test]
async fn an_unknown_message_is_reported_and_nothing_panics() {
    for text in ["", "{", "{}", "[]", "{\"state\":{}}", "{\"id\":1}", "null"] {
        let (mut remote, mut fake) = pair().await;
        fake.0.send(Message::text(text)).await.unwrap();
        let error = remote.next().await.unwrap_err();
        assert!(matches!(error, RemoteError::Garbled(_)), "{text}: {error}");
    }
}

#[tokio::test]
async fn without_a_listener_there_is_no_station() {
    let (listener, address) = listen().await;
    drop(listener);
    let error = Remote::connect(&address, "test").await.unwrap_err();
    assert!(error.is_not_running(), "{error:?}");
    assert!(error.hint().unwrap().contains("dobot up"));
}

/// Answers any one request over HTTP.
async fn answer(listener: TcpListener, answer: String) -> String {
    let (mut stream, _) = listener.accept().await.unwrap();
    let mut question = vec![0; 2000];
    let len = stream.read(&mut question).await.unwrap();
    stream.write_all(answer.as_bytes()).await.unwrap();
    String::from_utf8(question[..len].to_vec()).unwrap()
}

#[tokio::test]
async fn a_station_that_refuses_a_client_gives_the_reason() {
    let problem = json!({
        "type": "/api/v1/problems/unauthorized", "title": "unknown", "status": 401,
        "detail": "the token is not known", "hint": "dobot token add",
    })
    .to_string();
    let len = problem.len();
    let (listener, address) = listen().await;
    let refusal = format!("HTTP/1.1 401 Unauthorized\r\nContent-Length: {len}\r\n\r\n{problem}");
    let (result, _) = tokio::join!(Remote::connect(&address, "test"), answer(listener, refusal));
    let error = result.unwrap_err();
    assert_eq!(error.to_string(), "the token is not known");
    assert_eq!(error.hint().as_deref(), Some("dobot token add"));
}

#[tokio::test]
async fn a_server_that_is_not_a_station_is_reported() {
    for text in [
        "SSH-2.0-OpenSSH_9.2\r\n",
        "HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\nhi",
        "HTTP/1.1 404 Not Found\r\nContent-Length: 2\r\n\r\nhi",
    ] {
        let (listener, address) = listen().await;
        let (result, _) = tokio::join!(
            Remote::connect(&address, "test"),
            answer(listener, text.into())
        );
        let error = result.unwrap_err();
        assert!(
            matches!(error, ConnectError::NoStation { .. }),
            "{text}: {error:?}"
        );
        let (listener, address) = listen().await;
        let (found, _) = tokio::join!(is_station(&address), answer(listener, text.into()));
        assert!(!found, "{text}");
    }
}

#[tokio::test]
async fn a_document_is_fetched_with_the_token() {
    let (listener, mut address) = listen().await;
    address.token = Some("abc".into());
    let text = "HTTP/1.1 200 OK\r\nContent-Type: application/json\r\n\r\n[1,2]";
    let (fetched, question) = tokio::join!(
        fetch::<Vec<u8>>(&address, "/api/v1/jobs"),
        answer(listener, text.into())
    );
    assert_eq!(fetched.unwrap(), [1, 2]);
    assert!(question.starts_with("GET /api/v1/jobs HTTP/1.0\r\n"));
    assert!(question.contains("\r\nAuthorization: Bearer abc\r\n"));
}
