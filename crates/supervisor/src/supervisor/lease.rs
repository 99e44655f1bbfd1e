//! The connected clients and the lease.

use std::collections::HashMap;
use std::time::Duration;

use dobot_api::{
    ClientId, ControlRequest, Device, LeaseView, LockView, Role, SlotsView, TimeSlot,
    is_same_person,
};

use super::slots::{SlotChange, Slots};
use crate::plain;
use crate::refusal::{Holder, Refusal};

/// The clients and the lease.
#[derive(Debug)]
pub(super) struct Leases {
    clients: HashMap<ClientId, LeaseClient>,
    next_client: u64,
    lease: Option<Lease>,
    /// The lock that reserves control for administrators.
    lock: Option<Lock>,
    slots: Slots,
}

/// A connected client.
#[derive(Debug)]
struct LeaseClient {
    name: String,
    /// The device of a page.
    device: Option<Device>,
    /// The person for time slots.
    person: String,
    role: Role,
    /// Whether it speaks the arm's own protocol, which has no lease requests.
    is_program: bool,
    /// The last modification of its packets.
    amended: Option<String>,
}

/// The lease.
#[derive(Debug)]
struct Lease {
    client: ClientId,
    since: Duration,
    asked_by: Vec<ClientId>,
}

/// A lock.
#[derive(Debug)]
struct Lock {
    by: String,
    message: Option<String>,
    at: Duration,
}

/// Control that was lost; the arm comes to rest.
#[derive(Debug)]
pub(super) struct LostControl {
    pub(super) why: String,
    pub(super) changes: Vec<Change>,
}

/// A change of the lease.
#[derive(Debug)]
pub(super) enum Change {
    /// The client lost control.
    Ended {
        client: ClientId,
        why: String,
    },
    Taken(ClientId),
    Asked(ClientId),
}

impl Leases {
    pub(super) fn new() -> Self {
        Self {
            clients: HashMap::new(),
            next_client: 1,
            lease: None,
            lock: None,
            slots: Slots::default(),
        }
    }

    /// Adds a client, with the person it counts as for time slots.
    pub(super) fn handle_client(&mut self, name: &str, role: Role, person: &str) -> ClientId {
        let client = ClientId(self.next_client);
        self.next_client += 1;
        self.clients.insert(
            client,
            LeaseClient {
                name: plain(name, NAME_LEN),
                device: None,
                person: plain(person, NAME_LEN),
                role,
                is_program: false,
                amended: None,
            },
        );
        client
    }

    /// Sets the device on which a client is open as a page.
    pub(super) fn set_device(&mut self, client: ClientId, device: Option<Device>) {
        if let Some(known) = self.clients.get_mut(&client) {
            known.device = device;
        }
    }

    /// Removes a client that disconnected, on purpose or not.
    pub(super) fn handle_left(&mut self, client: ClientId) -> Vec<Change> {
        let changes = if self.has(client) {
            self.end("the client with control has disconnected")
        } else {
            Vec::new()
        };
        if let Some(lease) = &mut self.lease {
            lease.asked_by.retain(|other| *other != client);
        }
        self.clients.remove(&client);
        changes
    }

    pub(super) fn take(&mut self, now: Duration, client: ClientId) -> Result<Vec<Change>, Refusal> {
        self.check_allowed(client)?;
        let mut changes = Vec::new();
        if self.holder_cannot_answer() && self.is_admin(client) && !self.is_program(client) {
            let name = self.name(client);
            changes = self.end(&format!("{name} took it from a program on the raw port"));
        }
        if self.lease.is_some() {
            self.check(client)?;
        } else {
            changes.push(self.assign(now, client));
        }
        Ok(changes)
    }

    pub(super) fn release(&mut self, client: ClientId) -> Result<Vec<Change>, Refusal> {
        self.check(client)?;
        Ok(self.end("control was released"))
    }

    /// Locks control for administrators: any other holder loses it.
    pub(super) fn lock(
        &mut self,
        now: Duration,
        client: ClientId,
        message: Option<String>,
    ) -> Vec<Change> {
        let by = self.name(client);
        let why = format!("{by} locked the arm");
        self.lock = Some(Lock {
            by,
            message,
            at: now,
        });
        let holder = self.lease.as_ref().map(|lease| lease.client);
        match holder {
            Some(holder) if !self.is_admin(holder) => self.end(&why),
            _ => Vec::new(),
        }
    }

    /// Removes the lock; returns whether there was one.
    pub(super) fn unlock(&mut self) -> bool {
        self.lock.take().is_some()
    }

    pub(super) fn lock_view(&self) -> Option<LockView> {
        self.lock.as_ref().map(|lock| LockView {
            by: lock.by.clone(),
            message: lock.message.clone(),
            at_s: lock.at.as_secs_f64(),
        })
    }

    /// Replaces the time slots.
    ///
    /// # Errors
    ///
    /// [`Refusal::BadSlots`]; the old slots stay.
    pub(super) fn set_slots(&mut self, now: Duration, slots: &[TimeSlot]) -> Result<(), Refusal> {
        self.slots.set(now, slots)
    }

    /// Advances the time: returns the changes of time slots and of control. A holder outside its
    /// slot loses control; consecutive slots of one student cause no notice.
    pub(super) fn handle_time(&mut self, now: Duration) -> (Vec<SlotChange>, Option<LostControl>) {
        let before = self.slots.student().map(str::to_owned);
        let turns: Vec<_> = std::iter::from_fn(|| self.slots.poll_change(now)).collect();
        if turns
            .iter()
            .all(|turn| matches!(turn, SlotChange::Ending { .. }))
        {
            return (turns, None);
        }
        let after = self.slots.student();
        let continues = before
            .iter()
            .zip(after)
            .any(|(one, other)| is_same_person(one, other));
        let holder = self.lease.as_ref().map(|lease| lease.client);
        if continues || holder.is_some_and(|holder| self.is_admin(holder) || self.has_time(holder))
        {
            return (turns, None);
        }
        let why = why_control_ends(before.as_deref(), after);
        let changes = self.end(&why);
        (turns, Some(LostControl { why, changes }))
    }

    /// Returns when the next change is due.
    pub(super) fn wakeup(&self) -> Option<Duration> {
        self.slots.wakeup()
    }

    /// Returns the current and upcoming time slots.
    pub(super) fn slots(&self, now: Duration) -> Vec<TimeSlot> {
        self.slots.upcoming(now)
    }

    pub(super) fn slots_view(&self) -> Option<SlotsView> {
        self.slots.view()
    }

    /// Checks that lock and time slots allow a client to have control.
    fn check_allowed(&self, client: ClientId) -> Result<(), Refusal> {
        if self.is_admin(client) {
            return Ok(());
        }
        if let Some(lock) = &self.lock {
            return Err(Refusal::Locked {
                by: lock.by.clone(),
                message: lock.message.clone(),
            });
        }
        match self.slots.other_slot(self.person(client)) {
            Some(others) => Err(Refusal::Slot {
                student: others.student.to_owned(),
                group: others.group.map(str::to_owned),
                left_s: others.left.as_secs_f64(),
                free_in_s: others.free_in.as_secs_f64(),
            }),
            None => Ok(()),
        }
    }

    /// Returns whether this client's slot is the current one.
    fn has_time(&self, client: ClientId) -> bool {
        let student = self.slots.student();
        student.is_some_and(|student| is_same_person(student, self.person(client)))
    }

    /// Returns the person a client counts as for time slots.
    fn person(&self, client: ClientId) -> &str {
        self.clients
            .get(&client)
            .map_or("", |client| &client.person)
    }

    pub(super) fn ask(&mut self, now: Duration, client: ClientId) -> Result<Vec<Change>, Refusal> {
        self.check_allowed(client)?;
        match &mut self.lease {
            None => self.take(now, client),
            Some(lease) if lease.client == client || lease.asked_by.contains(&client) => {
                Ok(Vec::new())
            }
            Some(lease) => {
                lease.asked_by.push(client);
                Ok(vec![Change::Asked(client)])
            }
        }
    }

    pub(super) fn grant(
        &mut self,
        now: Duration,
        client: ClientId,
        to: ClientId,
    ) -> Result<Vec<Change>, Refusal> {
        self.check(client)?;
        let asks = |lease: &Lease| lease.asked_by.contains(&to);
        if !self.lease.as_ref().is_some_and(asks) {
            return Err(Refusal::NotAsking(to.0));
        }
        self.check_allowed(to)?;
        let mut changes = self.end("control was granted to another client");
        changes.push(self.assign(now, to));
        Ok(changes)
    }

    pub(super) fn seize(&mut self, now: Duration, client: ClientId) -> Vec<Change> {
        if self.has(client) {
            return Vec::new();
        }
        let mut changes = self.end("an administrator took control");
        changes.push(self.assign(now, client));
        changes
    }

    /// Handles raw packets of a client. The first one takes the lease if it is free.
    pub(super) fn handle_program(&mut self, now: Duration, client: ClientId) -> Option<Change> {
        if let Some(known) = self.clients.get_mut(&client) {
            known.is_program = true;
        }
        let may_have = self.lease.is_none() && self.check_allowed(client).is_ok();
        may_have.then(|| self.assign(now, client))
    }

    /// Records a modification of a client's packets; returns whether it is new.
    pub(super) fn handle_amended(&mut self, client: ClientId, text: &str) -> bool {
        let known = self.clients.get_mut(&client);
        let Some(known) = known.filter(|known| known.amended.as_deref() != Some(text)) else {
            return false;
        };
        known.amended = Some(text.to_owned());
        true
    }

    pub(super) fn has(&self, client: ClientId) -> bool {
        self.lease
            .as_ref()
            .is_some_and(|lease| lease.client == client)
    }

    pub(super) const fn is_taken(&self) -> bool {
        self.lease.is_some()
    }

    /// Checks that a client has control.
    pub(super) fn check(&self, client: ClientId) -> Result<(), Refusal> {
        if self.has(client) {
            return Ok(());
        }
        self.check_allowed(client)?;
        let holder = self.lease.as_ref().map(|lease| Holder {
            name: self.name(lease.client),
            is_program: self.is_program(lease.client),
        });
        Err(Refusal::NoLease { holder })
    }

    /// Checks that a client may arm the laser: it has control, or is an administrator while a raw
    /// program, whose protocol cannot do this, has control.
    pub(super) fn check_arms_laser(&self, client: ClientId) -> Result<(), Refusal> {
        if self.holder_cannot_answer() && self.is_admin(client) {
            return Ok(());
        }
        self.check(client)
    }

    /// Checks that a client's role is sufficient.
    pub(super) fn check_role(&self, client: ClientId, needed: Role) -> Result<(), Refusal> {
        let found = self
            .clients
            .get(&client)
            .map_or(Role::Watch, |client| client.role);
        if found < needed {
            return Err(Refusal::Role { needed, found });
        }
        Ok(())
    }

    /// Returns whether a client speaks the arm's own protocol.
    pub(super) fn is_program(&self, client: ClientId) -> bool {
        self.clients
            .get(&client)
            .is_some_and(|client| client.is_program)
    }

    /// Returns a client's name, with the device of a page.
    pub(super) fn name(&self, client: ClientId) -> String {
        Device::named(&self.bare_name(client), self.device(client))
    }

    /// Returns a client's name alone.
    pub(super) fn bare_name(&self, client: ClientId) -> String {
        self.clients.get(&client).map_or_else(
            || format!("client {}", client.0),
            |client| client.name.clone(),
        )
    }

    /// Returns the device of a page.
    pub(super) fn device(&self, client: ClientId) -> Option<Device> {
        self.clients.get(&client).and_then(|client| client.device)
    }

    pub(super) fn clients(&self) -> usize {
        self.clients.len()
    }

    pub(super) fn view(&self) -> Option<LeaseView> {
        let asking = |&client: &ClientId| ControlRequest {
            client,
            name: self.bare_name(client),
            device: self.device(client),
        };
        self.lease.as_ref().map(|lease| LeaseView {
            client: lease.client,
            name: self.bare_name(lease.client),
            device: self.device(lease.client),
            person: self.person(lease.client).to_owned(),
            is_program: self.is_program(lease.client),
            since_s: lease.since.as_secs_f64(),
            asked_by: lease.asked_by.iter().map(asking).collect(),
        })
    }

    /// Returns whether a raw program has control, which cannot answer requests.
    fn holder_cannot_answer(&self) -> bool {
        let lease = self.lease.as_ref();
        lease.is_some_and(|lease| self.is_program(lease.client))
    }

    fn is_admin(&self, client: ClientId) -> bool {
        let known = self.clients.get(&client);
        known.is_some_and(|known| known.role == Role::Admin)
    }

    fn assign(&mut self, now: Duration, client: ClientId) -> Change {
        self.lease = Some(Lease {
            client,
            since: now,
            asked_by: Vec::new(),
        });
        Change::Taken(client)
    }

    fn end(&mut self, why: &str) -> Vec<Change> {
        let ended = self.lease.take().map(|lease| Change::Ended {
            client: lease.client,
            why: why.to_owned(),
        });
        ended.into_iter().collect()
    }
}

/// Returns why control ends when the time slot of one student is over and another's begins.
fn why_control_ends(before: Option<&str>, after: Option<&str>) -> String {
    match (after, before) {
        (Some(student), _) => format!("the time slot of {student} is active"),
        (None, Some(student)) => format!("the time slot of {student} is over"),
        (None, None) => "a time slot is over".to_owned(),
    }
}

/// Longer names are cut.
const NAME_LEN: usize = 60;
