//! What a station records, told live to Foxglove over its WebSocket protocol.

use std::collections::HashMap;
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use dobot_record::{About, Live, Record, Topic, topics};
use dobot_rules::{Handle, PassedPacket, Snapshot, notice_topic, state_topic};
use dobot_wire::Dialect;
use foxglove::{
    Context, FoxgloveError, PartialMetadata, RawChannel, Schema, WebSocketServerHandle,
};
use jiff::{SignedDuration, Timestamp};
use serde::Serialize;
use tokio::sync::broadcast::error::RecvError;

/// Where Foxglove comes and looks on: the topics are those of the recordings, so that one layout serves both.
///
/// It is on this machine only, for its protocol knows no passwords; and nothing can be asked of the arm here.
#[derive(Debug)]
pub struct FoxglovePort {
    server: WebSocketServerHandle,
    address: SocketAddr,
    context: Arc<Context>,
}

/// Why there is no port for Foxglove.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FoxglovePortError {
    /// Other machines could come.
    #[error(
        "the port for Foxglove is {found}; allowed are addresses of this machine alone, as 127.0.0.1, because its protocol knows no passwords: `ssh -L 8765:127.0.0.1:8765 HOST` brings it to another one"
    )]
    NotLoopback {
        /// What was asked for.
        found: SocketAddr,
    },
    /// It cannot be opened.
    #[error("cannot listen on the port for Foxglove {address}")]
    Listen {
        /// What was asked for.
        address: SocketAddr,
        /// Why.
        #[source]
        source: Box<FoxgloveError>,
    },
}

impl FoxglovePort {
    /// Listens there; port 0 is any that is free.
    ///
    /// # Errors
    ///
    /// [`FoxglovePortError`].
    pub async fn bind(address: SocketAddr) -> Result<Self, FoxglovePortError> {
        if !address.ip().is_loopback() {
            return Err(FoxglovePortError::NotLoopback { found: address });
        }
        let context = Context::new();
        let server = context
            .websocket_server()
            .name(concat!("dobot ", env!("CARGO_PKG_VERSION")))
            .bind(address.ip().to_string(), address.port());
        let server = server.start().await;
        let server = server.map_err(|source| FoxglovePortError::Listen {
            address,
            source: Box::new(source),
        })?;
        let address = SocketAddr::new(address.ip(), server.port());
        Ok(Self {
            server,
            address,
            context,
        })
    }

    /// Where Foxglove comes.
    #[must_use]
    pub const fn address(&self) -> SocketAddr {
        self.address
    }

    /// Tells what happens, until the station ends.
    ///
    /// # Errors
    ///
    /// A line where the clock of this machine is before 1970 or a channel cannot be made: nothing is told then.
    pub async fn serve(self, handle: &Handle) -> Result<(), String> {
        let mut teller = Teller::new(&self.context, &handle.state())?;
        let (mut passed, mut states, mut notices) =
            (handle.passed(), handle.states(), handle.notices());
        // The state that holds now is news to those who come.
        states.mark_changed();
        loop {
            tokio::select! {
                packet = passed.recv() => match packet {
                    Ok(packet) => teller.packet(&packet),
                    // Foxglove drops what comes too fast, too.
                    Err(RecvError::Lagged(_)) => {}
                    Err(RecvError::Closed) => break,
                },
                changed = states.changed() => match changed {
                    Ok(()) => {
                        let state = states.borrow_and_update().clone();
                        teller.state(&state);
                    }
                    Err(_) => break,
                },
                notice = notices.recv() => match notice {
                    Ok(notice) => teller.tell(notice.at_s, &teller.notices.clone(), &*notice),
                    Err(RecvError::Lagged(_)) => {}
                    Err(RecvError::Closed) => break,
                },
                () = handle.ended() => break,
            }
        }
        self.server.stop().wait().await;
        Ok(())
    }
}

/// Makes messages of what happens, and gives them to those who look on.
struct Teller {
    live: Live,
    channels: HashMap<String, Arc<RawChannel>>,
    states: Arc<Topic>,
    notices: Arc<Topic>,
    dialect: Option<Dialect>,
}

impl Teller {
    fn new(context: &Arc<Context>, now: &Snapshot) -> Result<Self, String> {
        let since = SignedDuration::from_secs_f64(now.state().at_s);
        let live = Live::new(Timestamp::now() - since).map_err(|error| error.to_string())?;
        let (states, notices) = (state_topic(), notice_topic());
        let of_station = [&*states, &*notices];
        let channel = |topic: &Topic| {
            let schema = topic.schema().as_bytes().to_vec();
            let channel = context
                .channel_builder(topic.name())
                .message_encoding("json")
                .schema(Schema::new(topic.schema_name(), "jsonschema", schema))
                .build_raw();
            let channel = channel.map_err(|error| error.to_string())?;
            Ok((topic.name().to_owned(), channel))
        };
        let channels = topics().iter().chain(of_station).map(channel);
        Ok(Self {
            live,
            channels: channels.collect::<Result<_, String>>()?,
            states,
            notices,
            dialect: None,
        })
    }

    fn packet(&mut self, packet: &PassedPacket) {
        if !self.channels.values().any(|it| it.has_sinks()) {
            // Nobody looks on.
            return;
        }
        let bytes = packet.bytes.to_vec();
        let record = if packet.to_arm {
            Record::ToArm(bytes)
        } else {
            Record::FromArm(bytes)
        };
        self.record(packet.at, &record);
    }

    fn state(&mut self, state: &Snapshot) {
        let state = state.state();
        if self.dialect != state.dialect {
            self.dialect = state.dialect;
            let about = About {
                dialect: state.dialect,
                ..About::default()
            };
            self.record(Duration::ZERO, &Record::About(Box::new(about)));
        }
        self.tell(state.at_s, &self.states.clone(), state);
    }

    /// Tells one of the station's own messages, where somebody wants it.
    fn tell(&mut self, at_s: f64, topic: &Arc<Topic>, value: &impl Serialize) {
        let is_wanted = self.channels.get(topic.name());
        if !is_wanted.is_some_and(|it| it.has_sinks()) {
            return;
        }
        let record = Record::Json {
            topic: topic.clone(),
            value: serde_json::to_value(value).unwrap_or_default(),
        };
        self.record(
            Duration::try_from_secs_f64(at_s).unwrap_or_default(),
            &record,
        );
    }

    fn record(&mut self, at: Duration, record: &Record) {
        for message in self.live.write(at, record) {
            if let Some(channel) = self.channels.get(message.topic.name()) {
                let log_time = PartialMetadata::with_log_time(message.at_ns);
                channel.log_with_meta(&message.json, log_time);
            }
        }
    }
}

#[cfg(test)]
mod tests;
