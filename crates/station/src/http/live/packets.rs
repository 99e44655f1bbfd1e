//! The stream of all packets between the station and the arm.

use std::convert::Infallible;
use std::sync::Arc;

use axum::Extension;
use axum::extract::State;
use axum::response::sse::{Event, KeepAlive, Sse};
use data_encoding::HEXLOWER;
use dobot_host::PassedPacket;
use dobot_wire::{Command, Dialect, Frame, Packet, Status};
use futures_util::Stream;
use schemars::JsonSchema;
use serde::Serialize;
use tokio::sync::OwnedSemaphorePermit;
use tokio::sync::broadcast::Receiver;
use tokio::sync::broadcast::error::RecvError;

use crate::http::app::{App, Caller, Stay};
use crate::http::exchange::responses::RequestFailed;
use crate::http::live::events::ALIVE_EVERY;

/// A packet between the station and the arm.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(tag = "direction", rename_all = "snake_case")]
pub(crate) enum PacketView {
    /// Sent to the arm.
    ToArm {
        /// The time, in seconds since the station started.
        at_s: f64,
        /// Its 42 bytes, in hexadecimal digits.
        bytes: String,
        /// The command, by the dialect of the arm; absent if it is invalid.
        command: Option<Command>,
        /// The reason why it is invalid.
        problem: Option<String>,
    },
    /// Received from the arm.
    FromArm {
        /// The time, in seconds since the station started.
        at_s: f64,
        /// Its 42 bytes, in hexadecimal digits.
        bytes: String,
        /// The status.
        status: Option<Status>,
    },
}

/// The number of packets dropped because the client was too slow.
#[derive(Debug, Serialize)]
struct Lost {
    lost: u64,
}

/// A packet stream, until its client leaves or the station ends.
struct Listening {
    packets: Receiver<PassedPacket>,
    stay: Stay,
    _place: OwnedSemaphorePermit,
}

/// Streams the packets as they pass.
pub(crate) async fn packets(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
) -> Result<Sse<impl Stream<Item = Result<Event, Infallible>>>, RequestFailed> {
    let listening = Listening {
        _place: app.place()?,
        packets: app.handle.passed(),
        stay: Stay { app, caller },
    };
    let stream = futures_util::stream::unfold(listening, |mut stream| async move {
        let event = stream.next().await?;
        Some((Ok(event), stream))
    });
    Ok(Sse::new(stream).keep_alive(KeepAlive::new().interval(ALIVE_EVERY)))
}

impl Listening {
    async fn next(&mut self) -> Option<Event> {
        tokio::select! {
            passed = self.packets.recv() => match passed {
                Ok(packet) => {
                    let dialect = self.stay.app.handle.state().state().dialect;
                    Some(event("packet", &view(&packet, dialect.unwrap_or(Dialect::SPECIFICATION))))
                }
                Err(RecvError::Lagged(lost)) => Some(event("lost", &Lost { lost })),
                Err(RecvError::Closed) => None,
            },
            () = self.stay.is_over() => None,
        }
    }
}

fn view(packet: &PassedPacket, dialect: Dialect) -> PacketView {
    let at_s = packet.at.as_secs_f64();
    let bytes = HEXLOWER.encode(&packet.bytes);
    if !packet.to_arm {
        let frame = Frame::from_bytes(&packet.bytes);
        let status = frame.and_then(|frame| Status::parse(&frame).ok());
        return PacketView::FromArm {
            at_s,
            bytes,
            status,
        };
    }
    let parsed = match Packet::from_bytes(&packet.bytes) {
        Some(packet) => Command::parse(&packet, &dialect).map_err(|error| error.to_string()),
        None => Err("the header or trailer of the packet is invalid".to_owned()),
    };
    let problem = parsed.as_ref().err().cloned();
    PacketView::ToArm {
        at_s,
        bytes,
        command: parsed.ok(),
        problem,
    }
}

fn event(name: &str, data: &impl Serialize) -> Event {
    let text = serde_json::to_string(data).expect("structures with text keys are JSON");
    Event::default().event(name).data(text)
}
