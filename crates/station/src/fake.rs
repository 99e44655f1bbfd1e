//! A scripted driver for tests.

mod harness;

use dobot_api::{ClientId, Role};
#[cfg(feature = "full")]
use dobot_host::PassedPacket;
use dobot_host::{DriverChannels, Message, Rules, StationHandle};
use dobot_supervisor::Refusal;
use dobot_wire::{Command, Dialect, JointJog, JointJogAxis, PACKET_LEN, Packet};
use tokio::sync::oneshot;

pub(crate) use self::harness::Harness;
use crate::sample::state;

/// A scripted driver for tests.
pub(crate) struct FakeDriver {
    ends: DriverChannels,
    clients: u64,
}

impl FakeDriver {
    /// Returns a driver and its handle; slow receivers can lag by `kept` statuses.
    pub(crate) fn new(kept: usize) -> (StationHandle, Self) {
        let rules = Rules::of(&dobot_safety::Policy::default());
        let (handle, ends) = StationHandle::with_packets(state(0.0), rules, kept);
        (handle, Self { ends, clients: 0 })
    }

    /// Admits the next client and returns its name and role.
    pub(crate) async fn admit(&mut self) -> (ClientId, String, Role) {
        match self.next().await {
            Message::Came {
                name, role, reply, ..
            } => {
                self.clients += 1;
                let id = ClientId(self.clients);
                reply.send(id).expect("it waits");
                (id, name, role)
            }
            other => panic!("{other:?}"),
        }
    }

    /// Returns the next packet and the channel for its reply.
    pub(crate) async fn asked(
        &mut self,
    ) -> (ClientId, Packet, oneshot::Sender<Result<(), Refusal>>) {
        match self.next().await {
            Message::Raw {
                client,
                packet,
                reply,
            } => (client, packet, reply),
            other => panic!("{other:?}"),
        }
    }

    /// Returns the next packet and grants it.
    pub(crate) async fn grant(&mut self) -> [u8; PACKET_LEN] {
        self.answer(Ok(())).await
    }

    /// Returns the next packet and replies to it.
    pub(crate) async fn answer(&mut self, answer: Result<(), Refusal>) -> [u8; PACKET_LEN] {
        let (_, packet, reply) = self.asked().await;
        // The program may have left.
        let _ = reply.send(answer);
        packet.to_bytes()
    }

    /// Returns the next packet and replies to it, unless its program has left.
    pub(crate) async fn answer_unless_left(
        &mut self,
        answer: Result<(), Refusal>,
    ) -> Option<[u8; PACKET_LEN]> {
        match self.next().await {
            Message::Raw { packet, reply, .. } => {
                // The program may have left.
                let _ = reply.send(answer);
                Some(packet.to_bytes())
            }
            Message::Left(_) => None,
            other => panic!("{other:?}"),
        }
    }

    /// Returns the next client that leaves.
    pub(crate) async fn left(&mut self) -> ClientId {
        match self.next().await {
            Message::Left(id) => id,
            other => panic!("{other:?}"),
        }
    }

    /// Whether there is no unanswered request.
    pub(crate) fn idle(&mut self) -> bool {
        self.ends.messages.try_recv().is_err()
    }

    /// Publishes a state.
    #[cfg(feature = "full")]
    pub(crate) fn publish_state(&self, state: dobot_api::State) {
        self.ends.publish_state(state);
    }

    /// Publishes a passed packet.
    #[cfg(feature = "full")]
    pub(crate) fn publish_packet(&self, packet: PassedPacket) {
        self.ends.publish_packet(packet);
    }

    /// Sends a status to all receivers.
    pub(crate) fn send_status(&self, status: [u8; PACKET_LEN]) {
        self.ends.pass_on(status);
    }

    async fn next(&mut self) -> Message {
        self.ends
            .messages
            .recv()
            .await
            .expect("the handle is there")
    }
}

/// Returns a packet that is identified by its speed.
pub(crate) fn packet(speed_percent: u8) -> [u8; PACKET_LEN] {
    let jog = JointJog::new(JointJogAxis::BasePlus, speed_percent.into());
    let frame = Command::from(jog).emit(&Dialect::FIRMWARE_1_1);
    frame.to_bytes()
}
