//! The jobs for any arm that were submitted to this station: an engine without disk, network and
//! clock.
//!
//! Three rules ensure that each ticket runs at most once:
//!
//! 1. The station and the key of an offer are on the disk before the offer is sent.
//! 2. An offered ticket is offered to no other station before the first one has refused it for
//!    good, or a person decides so. After any other response, or none, the same request is sent again.
//! 3. The response of a station to a key is final (the journal's `take`, `refuse` and `withdraw`).

mod views;

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use std::time::Duration;

use dobot_api::problem_kinds::{NO_SUCH_WORK, TOO_MANY, WORK_PHASE};
use dobot_api::{
    JobPhase, JobView, Member, Presence, Problem, TakesWork, WorkMember, WorkPhase, WorkView,
};
use dobot_station::{Members, work_hurdle};

use super::choose::{Shares, is_free, next};
use super::settle::{
    asks, is_open, is_other, members_of, settle_refused, settle_taken, work_member,
};
use super::ticket::{Before, Offer, Place, Ticket};

/// All jobs that were submitted to this station.
pub(crate) struct Work {
    tickets: BTreeMap<String, Ticket>,
    /// The number of the last ticket.
    last_number: u64,
    /// Tickets with changes that are not on the disk yet.
    unwritten: BTreeSet<String>,
    keeping: Option<PendingWrite>,
    /// When writing to the disk is retried.
    disk_due: Duration,
    members: Members,
    /// The keys with a request in flight.
    asking: HashSet<String>,
    /// The time of the next request, by key.
    due: HashMap<String, Duration>,
    /// Why the last request for a key had no clear response.
    unclear: HashMap<String, String>,
    /// Since when jobs that their stations start automatically have been queued there, by key.
    queued: HashMap<String, Duration>,
    /// The reason why nothing is offered now, if any.
    held: Option<String>,
    /// Until when stations that had other jobs are not tried, and the length of that time.
    resting: HashMap<String, (Duration, Duration)>,
    /// Creates the keys of offers; may fail.
    new_key: Box<dyn FnMut() -> Option<String> + Send>,
}

/// A pending write.
#[derive(Debug)]
struct PendingWrite {
    id: String,
    /// Whether the ticket has changed since.
    is_old: bool,
}

/// An action to carry out.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Action {
    /// Write the ticket durably and report the result. There are no other actions until then.
    Write(Box<Ticket>),
    /// Remove the ticket from the disk.
    Forget(String),
    /// Send a request to a station.
    Ask(Ask),
}

/// A request to a station.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Ask {
    pub(crate) ticket: String,
    pub(crate) member: WorkMember,
    pub(crate) key: String,
    pub(crate) what: What,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum What {
    /// Offer the ticket.
    Offer,
    /// Query the state of its job.
    Look,
    /// Withdraw the ticket, unless it has begun.
    Withdraw,
}

/// The response of a station.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Answer {
    /// It has taken the ticket: the job as it is now.
    Taken(Box<JobView>),
    /// It has refused the ticket for good under this key.
    Refused { reason: String, busy: bool },
    /// It does not know the key.
    Unknown,
    /// No response, or an unclear one.
    Unclear(String),
}

/// The maximum number of open tickets.
const MAX_TICKETS: usize = 5000;
/// The maximum number of finished tickets that are kept.
const KEPT: usize = 500;
/// The interval of queries to a station that has a ticket.
const ASK_EVERY: Duration = Duration::from_secs(2);
/// The time within which a station with automatic starts begins a job.
const STARTS_WITHIN: Duration = Duration::from_secs(10);
/// The time for which a busy station is not tried, initially and at most.
const REST: [Duration; 2] = [Duration::from_secs(2), Duration::from_secs(60)];

impl Work {
    /// Restores the tickets from the disk.
    pub(crate) fn new(
        kept: Vec<Ticket>,
        new_key: impl FnMut() -> Option<String> + Send + 'static,
    ) -> Self {
        let numbers = kept.iter().map(|ticket| ticket.number);
        Self {
            last_number: numbers.max().unwrap_or_default(),
            tickets: kept
                .into_iter()
                .map(|ticket| (ticket.id.clone(), ticket))
                .collect(),
            unwritten: BTreeSet::new(),
            keeping: None,
            disk_due: Duration::ZERO,
            members: Members::default(),
            asking: HashSet::new(),
            due: HashMap::new(),
            unclear: HashMap::new(),
            queued: HashMap::new(),
            held: None,
            resting: HashMap::new(),
            new_key: Box::new(new_key),
        }
    }

    /// Whether the current state of a ticket is on the disk.
    pub(crate) fn is_kept(&self, id: &str) -> bool {
        !self.unwritten.contains(id)
    }

    /// Whether the states of the other stations are needed.
    pub(crate) fn needs_members(&self) -> bool {
        self.tickets.values().any(is_open)
    }

    /// Updates the members. While `held` gives a reason, nothing is offered.
    pub(crate) fn update_members(&mut self, members: &Members, held: Option<String>) {
        self.members = members.clone();
        self.held = held;
    }

    /// Returns the ticket of an earlier request with this key.
    pub(crate) fn asked_before(&self, student: &str, key: &str) -> Option<WorkView> {
        let same =
            |ticket: &&Ticket| ticket.student == student && ticket.key.as_deref() == Some(key);
        self.tickets
            .values()
            .find(same)
            .map(|ticket| self.view(ticket))
    }

    /// Returns the number of the next ticket.
    pub(crate) const fn next_number(&mut self) -> u64 {
        self.last_number += 1;
        self.last_number
    }

    /// Checks that there is space for one more ticket.
    pub(crate) fn check_room(&self) -> Result<(), Problem> {
        let open = self
            .tickets
            .values()
            .filter(|ticket| is_open(ticket))
            .count();
        if open < MAX_TICKETS {
            return Ok(());
        }
        let many = format!("{open} jobs are open; at most {MAX_TICKETS} are allowed");
        Err(TOO_MANY.hinted(many, "wait until some are done, or cancel some"))
    }

    /// Adds a ticket that is on the disk.
    pub(crate) fn submitted(&mut self, ticket: Ticket) -> WorkView {
        let view = self.view(&ticket);
        self.tickets.insert(ticket.id.clone(), ticket);
        view
    }

    /// Cancels a ticket on request of a person.
    pub(crate) fn cancel(&mut self, id: &str) -> Result<WorkView, Problem> {
        let phase = self.find(id)?.phase();
        let ticket = self.ticket(id);
        match &mut ticket.at {
            Place::Waiting => ticket.at = Place::Cancelled,
            Place::Offered(offer) | Place::Taken { offer, .. } => offer.is_withdrawn = true,
            Place::Over { .. } | Place::Cancelled => {
                return Err(WORK_PHASE.problem(format!(
                    "the job is {phase:?}; only a waiting, offered or taken job can be cancelled"
                )));
            }
        }
        if let Some(key) = ticket.offer().map(|offer| offer.key.clone()) {
            self.due.remove(&key);
        }
        self.change(id);
        self.one(id)
    }

    /// Moves a ticket to another arm on request of a person, whatever has become of it.
    pub(crate) fn give(&mut self, id: &str) -> Result<WorkView, Problem> {
        let ticket = self.find(id)?;
        let phase = ticket.phase();
        let may = self.doubt(ticket).is_some() || phase == WorkPhase::Failed;
        let (Some(offer), true) = (ticket.offer().cloned(), may) else {
            return Err(WORK_PHASE.hinted(
                format!("the job is {phase:?} and not in doubt"),
                "only a job that is in doubt or has failed can be moved to another arm",
            ));
        };
        let before = Before {
            is_settled: matches!(ticket.at, Place::Over { .. }),
            job: ticket.job().cloned().map(Box::new),
            offer,
        };
        let ticket = self.ticket(id);
        ticket.before.push(before);
        ticket.at = Place::Waiting;
        self.change(id);
        self.one(id)
    }

    /// Handles the result of a write.
    pub(crate) fn handle_written(&mut self, now: Duration, is_kept: bool) {
        let Some(keeping) = self.keeping.take() else {
            return;
        };
        if !is_kept {
            self.disk_due = now + ASK_EVERY;
        } else if !keeping.is_old {
            self.unwritten.remove(&keeping.id);
        }
    }

    /// Handles the response of a station, or a missing one.
    pub(crate) fn handle_answer(&mut self, now: Duration, ask: &Ask, answer: Answer) {
        self.asking.remove(&ask.key);
        self.unclear.remove(&ask.key);
        self.due.insert(ask.key.clone(), now + ASK_EVERY);
        let Some(ticket) = self.tickets.get_mut(&ask.ticket) else {
            return;
        };
        let before = ticket.clone();
        match answer {
            Answer::Taken(job) => settle_taken(ticket, ask, job),
            Answer::Refused { reason, busy } => {
                settle_refused(ticket, ask, &reason, busy);
                if busy {
                    self.rest(now, &ask.member.id);
                }
            }
            Answer::Unknown => drop(self.unclear.insert(ask.key.clone(), lost_by(&ask.member))),
            Answer::Unclear(why) => drop(self.unclear.insert(ask.key.clone(), why)),
        }
        self.note_settled(ask, &before);
    }

    /// Ends what the ticket no longer needs, and keeps it if it differs from `before`.
    fn note_settled(&mut self, ask: &Ask, before: &Ticket) {
        let ticket = &self.tickets[&ask.ticket];
        if matches!(&ticket.at, Place::Taken { job, .. } if job.phase != JobPhase::Queued) {
            self.resting.remove(&ask.member.id);
        }
        if !is_open(ticket) {
            self.due.remove(&ask.key);
        }
        if is_other(before, ticket) {
            self.change(&ask.ticket);
        }
    }

    /// Returns the next action.
    pub(crate) fn poll_action(&mut self, now: Duration) -> Option<Action> {
        if self.keeping.is_some() {
            return None;
        }
        self.recall_hindered(now);
        if self.held.is_none() {
            self.offer_waiting(now);
        }
        if let Some(id) = self.unwritten.first().cloned() {
            if now < self.disk_due {
                return None;
            }
            let ticket = self.tickets[&id].clone();
            self.keeping = Some(PendingWrite { id, is_old: false });
            return Some(Action::Write(Box::new(ticket)));
        }
        if let Some(old) = self.old() {
            self.tickets.remove(&old);
            return Some(Action::Forget(old));
        }
        let ask = self.next_ask(now)?;
        self.asking.insert(ask.key.clone());
        Some(Action::Ask(ask))
    }

    /// Offers waiting tickets to free arms.
    fn offer_waiting(&mut self, now: Duration) {
        let waiting = self
            .tickets
            .values()
            .filter(|value| value.at == Place::Waiting);
        let mut waiting: Vec<&Ticket> = waiting.collect();
        if waiting.is_empty() {
            return;
        }
        let is_ours = |ticket: &&Ticket| {
            ticket.is_out() || ticket.before.iter().any(|earlier| !earlier.is_settled)
        };
        let ours = self.tickets.values().filter(is_ours);
        let mut taken: HashSet<String> = ours.flat_map(members_of).collect();
        let mut shares = Shares::new(self.tickets.values());
        let mut given = Vec::new();
        for member in self.members.iter().filter(|member| is_free(member)) {
            let rests = self
                .resting
                .get(&member.id)
                .is_some_and(|rest| now < rest.0);
            if rests || taken.contains(&member.id) {
                continue;
            }
            let Some(id) = next(&waiting, &shares, member).map(str::to_owned) else {
                continue;
            };
            taken.insert(member.id.clone());
            shares.send_out(&self.tickets[&id]);
            waiting.retain(|waiting| waiting.id != id);
            given.push((id, work_member(member)));
        }
        for (id, member) in given {
            // Keys need random numbers; retry later.
            let Some(key) = (self.new_key)() else {
                return;
            };
            let offer = Offer {
                member,
                key,
                is_withdrawn: false,
                recalled: None,
            };
            let ticket = self.ticket(&id);
            ticket.at = Place::Offered(offer);
            ticket.returned = None;
            self.change(&id);
        }
    }

    /// Recalls tickets from stations with automatic starts that cannot start them.
    fn recall_hindered(&mut self, now: Duration) {
        let mut queued = HashMap::new();
        let mut recalled = Vec::new();
        for ticket in self.tickets.values() {
            let Place::Taken { offer, job } = &ticket.at else {
                continue;
            };
            if job.phase != JobPhase::Queued || offer.is_taken_back() {
                continue;
            }
            let since = *self.queued.get(&offer.key).unwrap_or(&now);
            queued.insert(offer.key.clone(), since);
            let is_late = now.saturating_sub(since) >= STARTS_WITHIN;
            if let Some(why) = self.obstacle(&offer.member, is_late) {
                recalled.push((ticket.id.clone(), offer.clone(), why));
            }
        }
        self.queued = queued;
        for (id, offer, why) in recalled {
            self.recall(now, &id, &offer, why);
        }
    }

    fn recall(&mut self, now: Duration, id: &str, offer: &Offer, why: String) {
        self.due.remove(&offer.key);
        self.rest(now, &offer.member.id);
        if let Place::Taken { offer, .. } = &mut self.ticket(id).at {
            offer.recalled = Some(why);
        }
        self.change(id);
    }

    /// Returns why a station with automatic starts cannot start a queued job. A stop or a lock
    /// counts immediately; other reasons may pass, and count when the job is late.
    fn obstacle(&self, member: &WorkMember, is_late: bool) -> Option<String> {
        let member = self.present(member)?;
        let (about, state) = (member.about.as_ref()?, member.state.as_ref()?);
        let takes_work = about
            .takes_work
            .filter(|setting| *setting == TakesWork::Start)?;
        let obstacle = work_hurdle(state, takes_work);
        if state.stop.is_some() || state.lock.is_some() {
            return obstacle;
        }
        let within_s = STARTS_WITHIN.as_secs();
        let late = || format!("its station did not start the job within {within_s} s");
        is_late.then(|| obstacle.unwrap_or_else(late))
    }

    fn next_ask(&self, now: Duration) -> Option<Ask> {
        let open = self.tickets.values().filter(|ticket| is_open(ticket));
        open.flat_map(asks).find(|ask| {
            let is_due = self.due.get(&ask.key).is_none_or(|at| *at <= now);
            let is_held = ask.what == What::Offer && self.held.is_some();
            is_due && !is_held && !self.asking.contains(&ask.key) && self.is_present(&ask.member)
        })
    }

    /// Returns the oldest finished ticket beyond the number that is kept.
    fn old(&self) -> Option<String> {
        if self.tickets.len() <= KEPT {
            return None;
        }
        let over: Vec<_> = self
            .tickets
            .values()
            .filter(|ticket| !is_open(ticket))
            .collect();
        let oldest = over.iter().min_by_key(|ticket| ticket.number)?;
        (over.len() > KEPT).then(|| oldest.id.clone())
    }

    fn rest(&mut self, now: Duration, member: &str) {
        let [first, most] = REST;
        let last = self.resting.get(member).map(|rest| rest.1);
        let span = last.map_or(first, |rest| (rest * 2).min(most));
        self.resting.insert(member.into(), (now + span, span));
    }

    fn is_present(&self, member: &WorkMember) -> bool {
        self.present(member).is_some()
    }

    /// Returns a station if it can be reached.
    fn present(&self, member: &WorkMember) -> Option<&Member> {
        let same =
            |known: &&std::sync::Arc<Member>| known.id == member.id && known.name == member.name;
        let seen = self.members.iter().find(same).map(|member| &**member);
        seen.filter(|known| known.presence == Presence::Present)
    }

    fn change(&mut self, id: &str) {
        self.unwritten.insert(id.to_owned());
        if let Some(keeping) = self.keeping.as_mut().filter(|keeping| keeping.id == id) {
            keeping.is_old = true;
        }
    }

    fn find(&self, id: &str) -> Result<&Ticket, Problem> {
        self.tickets.get(id).ok_or_else(|| {
            let id: String = id.chars().take(40).collect();
            NO_SUCH_WORK.problem(format!("no job with the id {id:?} was submitted here"))
        })
    }

    fn ticket(&mut self, id: &str) -> &mut Ticket {
        self.tickets.get_mut(id).expect("found above")
    }
}

fn lost_by(member: &WorkMember) -> String {
    let name = &member.name;
    format!("{name} does not know the job any more: its journal was lost or replaced")
}
