//! How the rest of the station talks to the one who owns the arm.

use std::sync::Arc;

use dobot_wire::Packet;
use tokio::sync::{broadcast, mpsc, oneshot, watch};

use crate::words::{ClientId, Notice, Refusal, Reply, Request, Role, State};

/// How the rest of the station talks to the [`Owner`](crate::Owner) of the arm; clones share it.
#[derive(Clone, Debug)]
pub struct Handle {
    pub(crate) messages: mpsc::Sender<Message>,
    pub(crate) states: watch::Receiver<Arc<Snapshot>>,
    pub(crate) notices: broadcast::Sender<Arc<Notice>>,
    pub(crate) packets: broadcast::Sender<[u8; 42]>,
}

/// A state, and its JSON, written once for all who watch.
#[derive(Debug)]
pub struct Snapshot {
    /// The state.
    pub state: State,
    /// The state as JSON.
    pub json: Arc<str>,
}

/// A client of the station; it leaves when this is dropped, and its lease ends with it.
#[derive(Debug)]
pub struct Client {
    id: ClientId,
    role: Role,
    handle: Handle,
}

/// What reaches the owner.
#[derive(Debug)]
pub(crate) enum Message {
    /// A client came.
    Came {
        name: String,
        role: Role,
        reply: oneshot::Sender<ClientId>,
    },
    /// A client left.
    Left(ClientId),
    /// A client asks for something.
    Asked {
        client: ClientId,
        request: Request,
        reply: oneshot::Sender<Result<Reply, Refusal>>,
    },
    /// A raw program sent a packet.
    Raw {
        client: ClientId,
        packet: Packet,
        reply: oneshot::Sender<Result<(), Refusal>>,
    },
    /// End: laser off, and no more.
    End,
}

impl Handle {
    /// Makes a client known under a name, with what it may do.
    ///
    /// # Errors
    ///
    /// [`Refusal::Ending`].
    pub async fn client(&self, name: &str, role: Role) -> Result<Client, Refusal> {
        let (reply, answer) = oneshot::channel();
        let name = name.to_owned();
        self.send(Message::Came { name, role, reply }).await?;
        let id = answer.await.map_err(|_| Refusal::Ending)?;
        Ok(Client {
            id,
            role,
            handle: self.clone(),
        })
    }

    /// What the station knows now.
    #[must_use]
    pub fn state(&self) -> Arc<Snapshot> {
        self.states.borrow().clone()
    }

    /// The state, whenever it changes: with each status of the arm, and with each event.
    #[must_use]
    pub fn states(&self) -> watch::Receiver<Arc<Snapshot>> {
        self.states.clone()
    }

    /// What happens, from now on.
    #[must_use]
    pub fn notices(&self) -> broadcast::Receiver<Arc<Notice>> {
        self.notices.subscribe()
    }

    /// The status packets of the arm, from now on, for raw programs: each one is a permit.
    #[must_use]
    pub fn packets(&self) -> broadcast::Receiver<[u8; 42]> {
        self.packets.subscribe()
    }

    /// Ends the station: the laser goes off, and the port is closed.
    pub async fn end(&self) {
        // It may have ended already.
        let _ = self.send(Message::End).await;
    }

    async fn send(&self, message: Message) -> Result<(), Refusal> {
        let sent = self.messages.send(message).await;
        sent.map_err(|_| Refusal::Ending)
    }
}

impl Client {
    /// Its number.
    #[must_use]
    pub const fn id(&self) -> ClientId {
        self.id
    }

    /// What it may do.
    #[must_use]
    pub const fn role(&self) -> Role {
        self.role
    }

    /// The station.
    #[must_use]
    pub const fn handle(&self) -> &Handle {
        &self.handle
    }

    /// Asks for something.
    ///
    /// # Errors
    ///
    /// [`Refusal`]; nothing has changed then.
    pub async fn request(&self, request: Request) -> Result<Reply, Refusal> {
        let (reply, answer) = oneshot::channel();
        let client = self.id;
        self.handle
            .send(Message::Asked {
                client,
                request,
                reply,
            })
            .await?;
        answer.await.map_err(|_| Refusal::Ending)?
    }

    /// Passes on a packet of a raw program, which speaks the arm's own protocol. The first one
    /// takes the lease if nobody has it.
    ///
    /// # Errors
    ///
    /// [`Refusal`]; the packet is not sent then.
    pub async fn raw(&self, packet: Packet) -> Result<(), Refusal> {
        let (reply, answer) = oneshot::channel();
        let client = self.id;
        self.handle
            .send(Message::Raw {
                client,
                packet,
                reply,
            })
            .await?;
        answer.await.map_err(|_| Refusal::Ending)?
    }
}

impl Drop for Client {
    fn drop(&mut self) {
        let (messages, left) = (self.handle.messages.clone(), Message::Left(self.id));
        if let Err(mpsc::error::TrySendError::Full(left)) = messages.try_send(left) {
            // The owner has much to do; it must hear of this all the same.
            if let Ok(runtime) = tokio::runtime::Handle::try_current() {
                runtime.spawn(async move { messages.send(left).await });
            }
        }
    }
}
