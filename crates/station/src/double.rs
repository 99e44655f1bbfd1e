//! An owner of the arm that does what a test tells it.

use dobot_wire::{Dialect, PACKET_LEN, Packet};
use tokio::sync::{broadcast, mpsc, oneshot, watch};

use crate::handle::{Message, Rules};
use crate::words::{
    ClientId, LaserView, LinkPhase, LinkView, Notice, QueueView, Refusal, Role, State, TrustView,
};
use crate::{Handle, Snapshot};

/// An owner of the arm that does what a test tells it.
pub(crate) struct Double {
    messages: mpsc::Receiver<Message>,
    statuses: broadcast::Sender<[u8; PACKET_LEN]>,
    _states: watch::Sender<std::sync::Arc<Snapshot>>,
    _notices: broadcast::Receiver<std::sync::Arc<Notice>>,
    clients: u64,
}

impl Double {
    /// An owner, and the way to it; it keeps `kept` statuses for whoever is slow.
    pub(crate) fn new(kept: usize) -> (Handle, Self) {
        let (messages, received) = mpsc::channel(16);
        let (statuses, _) = broadcast::channel(kept);
        let (notices, told) = broadcast::channel(16);
        let state = snapshot();
        let (states, state) = watch::channel(state.into());
        let handle = Handle {
            messages,
            states: state,
            notices,
            packets: statuses.clone(),
            every: broadcast::Sender::new(16),
            recent: std::sync::Arc::default(),
            rules: Rules::of(&dobot_safety::Policy::default()).into(),
        };
        let double = Self {
            messages: received,
            statuses,
            _states: states,
            _notices: told,
            clients: 0,
        };
        (handle, double)
    }

    /// Lets the next client in, and tells its name and role.
    pub(crate) async fn admit(&mut self) -> (ClientId, String, Role) {
        match self.next().await {
            Message::Came { name, role, reply } => {
                self.clients += 1;
                let id = ClientId(self.clients);
                reply.send(id).expect("it waits");
                (id, name, role)
            }
            other => panic!("{other:?}"),
        }
    }

    /// The next packet, and the way to answer it.
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

    /// The next packet, which is granted.
    pub(crate) async fn grant(&mut self) -> [u8; PACKET_LEN] {
        self.answer(Ok(())).await
    }

    /// The next packet, which is answered so.
    pub(crate) async fn answer(&mut self, answer: Result<(), Refusal>) -> [u8; PACKET_LEN] {
        let (_, packet, reply) = self.asked().await;
        // The program may have left meanwhile.
        let _ = reply.send(answer);
        packet.to_bytes()
    }

    /// The next packet, which is granted, unless its program has left.
    pub(crate) async fn grant_unless_left(&mut self) -> Option<[u8; PACKET_LEN]> {
        match self.next().await {
            Message::Raw { packet, reply, .. } => {
                let _ = reply.send(Ok(()));
                Some(packet.to_bytes())
            }
            Message::Left(_) => None,
            other => panic!("{other:?}"),
        }
    }

    /// The next to leave.
    pub(crate) async fn left(&mut self) -> ClientId {
        match self.next().await {
            Message::Left(id) => id,
            other => panic!("{other:?}"),
        }
    }

    /// What was asked and not answered yet, if anything was.
    pub(crate) fn idle(&mut self) -> bool {
        self.messages.try_recv().is_err()
    }

    /// Sends a status to all who listen.
    pub(crate) fn send_status(&self, status: [u8; PACKET_LEN]) {
        self.statuses.send(status).expect("somebody listens");
    }

    async fn next(&mut self) -> Message {
        self.messages.recv().await.expect("the handle is there")
    }
}

fn snapshot() -> Snapshot {
    Snapshot::new(State {
        at_s: 0.0,
        link: LinkView {
            address: None,
            phase: LinkPhase::Searching,
            problem: None,
            statuses_per_s: 0.0,
            lost_statuses: 0,
            damaged_bytes: 0,
            latency_ms: None,
        },
        arm: None,
        dialect: Some(Dialect::FIRMWARE_1_1),
        trust: TrustView {
            trusted: false,
            reason: None,
        },
        queue: QueueView {
            waiting: 0,
            under_way: 0,
            ahead_s: 0.0,
        },
        lease: None,
        stop: None,
        laser: LaserView {
            armed_for_s: 0.0,
            on: false,
        },
        job: None,
        clients: 0,
    })
}
