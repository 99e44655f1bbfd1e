//! One client has control.

use std::time::Duration;

use dobot_api::{Asking, ClientId, LeaseView, News, Reply, Role};

use super::{Keeper, Known};
use crate::{Holder, Refusal, plain};

/// Who has control.
#[derive(Clone, Debug)]
pub(super) struct Lease {
    pub(super) client: ClientId,
    pub(super) since: Duration,
    pub(super) asked_by: Vec<ClientId>,
}

impl Keeper {
    /// Takes that a client came.
    pub fn handle_client(&mut self, now: Duration, name: &str, role: Role) -> ClientId {
        self.handle_time(now);
        let client = ClientId(self.next_client);
        self.next_client += 1;
        self.clients.insert(
            client,
            Known {
                name: plain(name, NAME_LEN),
                role,
                is_program: false,
                amended: None,
            },
        );
        self.changed = true;
        client
    }

    /// Takes that a client left, wanted or not: its lease ends, and what it held is let go.
    pub fn handle_left(&mut self, now: Duration, client: ClientId) {
        self.handle_time(now);
        if self.has_lease(client) {
            self.end_lease("the client that had control is gone");
        }
        if let Some(lease) = &mut self.lease {
            lease.asked_by.retain(|it| *it != client);
        }
        self.clients.remove(&client);
        self.changed = true;
    }

    pub(super) fn has_lease(&self, client: ClientId) -> bool {
        self.lease.as_ref().is_some_and(|it| it.client == client)
    }

    /// Whether a client has control.
    pub(super) fn check_lease(&self, client: ClientId) -> Result<(), Refusal> {
        if self.has_lease(client) {
            return Ok(());
        }
        let holder = self.lease.as_ref().map(|it| Holder {
            name: self.name(it.client),
            is_program: self.is_program(it.client),
        });
        Err(Refusal::NoLease { holder })
    }

    pub(super) fn take_lease(&mut self, client: ClientId) -> Result<Reply, Refusal> {
        if self.holder_cannot_answer() && self.is_admin(client) && !self.is_program(client) {
            let why = format!(
                "{} took it from a program on the raw port",
                self.name(client)
            );
            self.end_lease(&why);
        }
        if self.lease.is_some() {
            self.check_lease(client)?;
        } else {
            self.give_lease(client);
        }
        Ok(self.lease_reply())
    }

    /// Whether a raw program has control: nobody can ask it for that.
    fn holder_cannot_answer(&self) -> bool {
        let lease = self.lease.as_ref();
        lease.is_some_and(|it| self.is_program(it.client))
    }

    pub(super) fn is_program(&self, client: ClientId) -> bool {
        self.clients.get(&client).is_some_and(|it| it.is_program)
    }

    fn is_admin(&self, client: ClientId) -> bool {
        let known = self.clients.get(&client);
        known.is_some_and(|it| it.role == Role::Admin)
    }

    /// Whether a client may arm the laser: one that has control, or an administrator for a raw program
    /// that has it, whose protocol has no words for that.
    pub(super) fn check_arms_laser(&self, client: ClientId) -> Result<(), Refusal> {
        if self.holder_cannot_answer() && self.is_admin(client) {
            return Ok(());
        }
        self.check_lease(client)
    }

    pub(super) fn release_lease(&mut self, client: ClientId) -> Result<Reply, Refusal> {
        self.check_lease(client)?;
        self.end_lease("control was given back");
        Ok(self.lease_reply())
    }

    pub(super) fn ask_lease(&mut self, client: ClientId) -> Result<Reply, Refusal> {
        match &mut self.lease {
            None => return self.take_lease(client),
            Some(lease) if lease.client == client || lease.asked_by.contains(&client) => {}
            Some(lease) => {
                lease.asked_by.push(client);
                let text = format!("{} asks for control", self.name(client));
                self.tell(News::LeaseAsked { client }, text);
            }
        }
        Ok(self.lease_reply())
    }

    pub(super) fn grant_lease(&mut self, client: ClientId, to: ClientId) -> Result<Reply, Refusal> {
        self.check_lease(client)?;
        let asks = |it: &Lease| it.asked_by.contains(&to);
        if !self.lease.as_ref().is_some_and(asks) {
            return Err(Refusal::NotAsking(to.0));
        }
        self.end_lease("control was given to another client");
        self.give_lease(to);
        Ok(self.lease_reply())
    }

    pub(super) fn seize_lease(&mut self, client: ClientId) -> Reply {
        if self.lease.is_some() && !self.has_lease(client) {
            self.end_lease("control was taken by an administrator");
        }
        if self.lease.is_none() {
            self.give_lease(client);
        }
        self.lease_reply()
    }

    pub(super) fn lease_view(&self) -> Option<LeaseView> {
        self.lease.as_ref().map(|it| LeaseView {
            client: it.client,
            name: self.name(it.client),
            is_program: self.is_program(it.client),
            since_s: it.since.as_secs_f64(),
            asked_by: it
                .asked_by
                .iter()
                .map(|&client| Asking {
                    client,
                    name: self.name(client),
                })
                .collect(),
        })
    }

    pub(super) fn give_lease(&mut self, client: ClientId) {
        self.lease = Some(Lease {
            client,
            since: self.now,
            asked_by: Vec::new(),
        });
        let text = format!("{} has control", self.name(client));
        self.tell(News::LeaseTaken { client }, text);
    }

    /// Nobody moves the arm who has no control: buttons are let go, what waits is forgotten, and
    /// the laser goes off. A drawing with a pen goes on; it is the station's.
    fn end_lease(&mut self, why: &str) {
        if let Some(lease) = self.lease.take() {
            self.part_from_laser();
            self.disarm_laser(why);
            self.let_go();
            self.end_detection(why);
            self.drop_pending_of(lease.client, why);
            self.tell(News::LeaseFree, format!("nobody has control: {why}"));
        }
    }

    fn drop_pending_of(&mut self, client: ClientId, why: &str) {
        if self.pending.values().any(|it| *it == client) {
            self.drop_waiting(why);
        }
    }

    fn lease_reply(&self) -> Reply {
        Reply::Lease {
            lease: self.lease_view(),
        }
    }
}

/// A longer name is cut.
const NAME_LEN: usize = 60;
