//! Live data for Foxglove over its WebSocket protocol.

use std::collections::HashMap;
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use dobot_host::{PassedPacket, Snapshot, StationHandle, notice_topic, state_topic, tools_of};
use dobot_record::{About, INK, Live, Record, Topic, topics};
use dobot_safety::{Policy, ToolLengths};
use dobot_wire::Dialect;
use foxglove::websocket::{ChannelView, Client, ServerListener};
use foxglove::{
    Context, FoxgloveError, PartialMetadata, RawChannel, Schema, SinkId, WebSocketServerHandle,
};
use jiff::{SignedDuration, Timestamp};
use serde::Serialize;
use tokio::net::TcpListener;
use tokio::sync::broadcast::error::RecvError;
use tokio::sync::mpsc;
use tokio::task::JoinSet;

/// The port for Foxglove. Its topics are those of the recordings, so that one layout serves both.
///
/// It is reachable on this machine only, since its protocol has no authentication, and it accepts
/// no commands. Pages of other sites are refused by their `Origin`.
#[derive(Debug)]
pub struct FoxglovePort {
    server: WebSocketServerHandle,
    address: SocketAddr,
    context: Arc<Context>,
    /// New subscribers of the drawn ink.
    late: mpsc::UnboundedReceiver<SinkId>,
    /// Checks the origin of connections; ends with the port.
    front: JoinSet<()>,
}

/// The error returned when the port for Foxglove cannot be opened.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FoxglovePortError {
    /// The address is reachable from other machines.
    #[error(
        "the port for Foxglove is {found}; allowed are loopback addresses such as 127.0.0.1, because its protocol has no authentication; forward it to another machine with `ssh -L 8765:127.0.0.1:8765 HOST`"
    )]
    NotLoopback {
        /// The requested address.
        found: SocketAddr,
    },
    /// The port cannot be opened.
    #[error("cannot listen on the port for Foxglove {address}")]
    Listen {
        /// The requested address.
        address: SocketAddr,
        /// The cause.
        #[source]
        source: Box<FoxgloveError>,
    },
}

impl FoxglovePort {
    /// Listens on an address; port 0 selects a free one.
    ///
    /// # Errors
    ///
    /// [`FoxglovePortError`].
    pub async fn bind(address: SocketAddr) -> Result<Self, FoxglovePortError> {
        if !address.ip().is_loopback() {
            return Err(FoxglovePortError::NotLoopback { found: address });
        }
        let context = Context::new();
        let (sender, late) = mpsc::unbounded_channel();
        let failed = |source| FoxglovePortError::Listen {
            address,
            source: Box::new(source),
        };
        let listener = TcpListener::bind(address).await;
        let listener = listener.map_err(|error| failed(FoxgloveError::Bind(error)))?;
        let inner = front::hidden_address().map_err(|error| failed(FoxgloveError::Bind(error)))?;
        let server = context
            .websocket_server()
            .listener(Arc::new(InkSubscribers(sender)))
            .name(concat!("dobot ", env!("CARGO_PKG_VERSION")))
            .bind(inner.to_string(), 0);
        let server = server.start().await.map_err(failed)?;
        let address = listener.local_addr();
        let address = address.map_err(|error| failed(FoxgloveError::Bind(error)))?;
        let inner = SocketAddr::from((inner, server.port()));
        let mut front = JoinSet::new();
        front.spawn(front::serve(listener, inner));
        Ok(Self {
            server,
            address,
            context,
            late,
            front,
        })
    }

    /// Returns the address of the port.
    #[must_use]
    pub const fn address(&self) -> SocketAddr {
        self.address
    }

    /// Publishes live data until the station ends.
    ///
    /// # Errors
    ///
    /// A message if the clock of this machine is before 1970 or a channel cannot be created; then
    /// nothing is published.
    pub async fn serve(mut self, handle: &StationHandle) -> Result<(), String> {
        let mut publisher = Publisher::new(&self.context, &handle.state())?;
        let (mut passed, mut states, mut notices) =
            (handle.passed(), handle.states(), handle.notices());
        // The current state is new to subscribers.
        states.mark_changed();
        loop {
            tokio::select! {
                // The dialect and the tool lengths are published before the packets that depend on
                // them.
                biased;
                changed = states.changed() => match changed {
                    Ok(()) => {
                        let state = states.borrow_and_update().clone();
                        publisher.policy(&handle.rules().policy);
                        publisher.state(&state);
                    }
                    Err(_) => break,
                },
                Some(who) = self.late.recv() => publisher.ink_so_far(who),
                packet = passed.recv() => match packet {
                    Ok(packet) => publisher.packet(&packet),
                    // Foxglove also drops data that arrive too fast.
                    Err(RecvError::Lagged(_)) => {}
                    Err(RecvError::Closed) => break,
                },
                notice = notices.recv() => match notice {
                    Ok(notice) => publisher.publish(notice.at_s, &publisher.notices.clone(), &*notice),
                    Err(RecvError::Lagged(_)) => {}
                    Err(RecvError::Closed) => break,
                },
                () = handle.ended() => break,
            }
        }
        self.front.shutdown().await;
        self.server.stop().wait().await;
        Ok(())
    }
}

/// Reports new subscribers of the ink, which get what was drawn before.
struct InkSubscribers(mpsc::UnboundedSender<SinkId>);

impl ServerListener for InkSubscribers {
    fn on_subscribe(&self, client: Client, channel: ChannelView) {
        if let Some(sink) = client.sink_id().filter(|_| channel.topic() == INK) {
            // The receiver is gone when the station ends.
            let _ = self.0.send(sink);
        }
    }
}

/// Converts events to messages and publishes them to subscribers.
struct Publisher {
    live: Live,
    channels: HashMap<String, Arc<RawChannel>>,
    states: Arc<Topic>,
    notices: Arc<Topic>,
    dialect: Option<Dialect>,
    /// The last published tool lengths.
    tools: Option<ToolLengths>,
    /// The last published height below which a pen draws.
    pen_below_mm: Option<f64>,
    /// The time of the last packet.
    now: Duration,
}

impl Publisher {
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
            tools: None,
            pen_below_mm: None,
            now: Duration::ZERO,
        })
    }

    fn packet(&mut self, packet: &PassedPacket) {
        self.now = packet.at;
        if packet.pen_below_mm != self.pen_below_mm {
            self.pen_below_mm = packet.pen_below_mm;
            let below_mm = packet.pen_below_mm;
            self.live.follow(packet.at, &Record::Pen { below_mm });
        }
        let bytes = packet.bytes.to_vec();
        let record = if packet.to_arm {
            Record::ToArm(bytes)
        } else {
            Record::FromArm(bytes)
        };
        if self.channels.values().any(|channel| channel.has_sinks()) {
            self.record(packet.at, &record);
        } else {
            // No subscribers.
            self.live.follow(packet.at, &record);
        }
    }

    fn policy(&mut self, policy: &Policy) {
        if self.tools != Some(policy.tool_length) {
            self.tools = Some(policy.tool_length);
            let tools = Record::Tools(tools_of(policy));
            self.live.follow(self.now, &tools);
        }
    }

    /// Sends a new subscriber what was drawn before.
    fn ink_so_far(&self, who: SinkId) {
        for message in self.live.ink_so_far(self.now) {
            if let Some(channel) = self.channels.get(message.topic.name()) {
                let log_time = PartialMetadata::with_log_time(message.at_ns);
                channel.log_with_meta_to_sink(&message.json, log_time, Some(who));
            }
        }
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
        self.publish(state.at_s, &self.states.clone(), state);
    }

    /// Publishes one of the station's own messages, if it has subscribers.
    fn publish(&mut self, at_s: f64, topic: &Arc<Topic>, value: &impl Serialize) {
        let is_wanted = self.channels.get(topic.name());
        if !is_wanted.is_some_and(|channel| channel.has_sinks()) {
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

mod front;

#[cfg(test)]
mod tests;
