//! Work for any arm, at the station where it was submitted: an engine without a disk, a network or a clock.
//!
//! Three rules make that each ticket is done once:
//!
//! 1. To whom a ticket is offered, and under which key, is on the disk before that station is asked.
//! 2. A ticket that was offered is offered to no other station before the first one has refused it for good, or a person
//!    says so. Whatever else is answered, or nothing, the same question is asked again.
//! 3. What a station has answered under a key it answers for ever (the journal's `take`, `refuse` and `withdraw`).

mod showing;

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

/// All work that was submitted to this station.
pub(crate) struct Work {
    tickets: BTreeMap<String, Ticket>,
    /// The number of the one that came last.
    last_number: u64,
    /// Changes that are not on the disk yet.
    unkept: BTreeSet<String>,
    keeping: Option<Keeping>,
    /// When the disk is tried again.
    disk_due: Duration,
    members: Members,
    /// The keys about which somebody is being asked.
    asking: HashSet<String>,
    /// When is asked next, by key.
    due: HashMap<String, Duration>,
    /// Why the last question about a key was not answered.
    unclear: HashMap<String, String>,
    /// Since when jobs that their stations start by themselves have been queued there, by key.
    queued: HashMap<String, Duration>,
    /// Why nothing is offered now, if so.
    held: Option<String>,
    /// Until when stations are let alone that had other work, and for how long that was.
    resting: HashMap<String, (Duration, Duration)>,
    /// Makes the keys of offers, if it can.
    new_key: Box<dyn FnMut() -> Option<String> + Send>,
}

/// What is being written.
#[derive(Debug)]
struct Keeping {
    id: String,
    /// It has changed again since.
    is_old: bool,
}

/// What the engine wants.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Wish {
    /// Write it, for good, and say how that went. Nothing else is wanted until then.
    Keep(Box<Ticket>),
    /// Remove it from the disk.
    Forget(String),
    /// Ask a station.
    Ask(Ask),
}

/// What a station is to be asked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Ask {
    pub(crate) ticket: String,
    pub(crate) member: WorkMember,
    pub(crate) key: String,
    pub(crate) what: What,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum What {
    /// To take it.
    Offer,
    /// What has become of it.
    Look,
    /// To let it be, where it has not begun.
    Withdraw,
}

/// What a station answers.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Answer {
    /// It has it: the job as it is now.
    Taken(Box<JobView>),
    /// It has refused it for good under this key.
    Refused { reason: String, busy: bool },
    /// It has never heard of it.
    Unknown,
    /// Nobody knows: it did not answer, or not so that it would be clear.
    Unclear(String),
}

/// How many tickets may be under way.
const MOST: usize = 5000;
/// How many are kept that are over.
const KEPT: usize = 500;
/// How often a station is asked that has a ticket.
const ASK_EVERY: Duration = Duration::from_secs(2);
/// A station that starts work by itself does so within this.
const STARTS_WITHIN: Duration = Duration::from_secs(10);
/// How long a station is let alone that had other work, at first and at the most.
const REST: [Duration; 2] = [Duration::from_secs(2), Duration::from_secs(60)];

impl Work {
    /// The work that was on the disk.
    pub(crate) fn new(
        kept: Vec<Ticket>,
        new_key: impl FnMut() -> Option<String> + Send + 'static,
    ) -> Self {
        Self {
            last_number: kept.iter().map(|it| it.number).max().unwrap_or_default(),
            tickets: kept.into_iter().map(|it| (it.id.clone(), it)).collect(),
            unkept: BTreeSet::new(),
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

    /// Whether a ticket is on the disk as it is now.
    pub(crate) fn is_kept(&self, id: &str) -> bool {
        !self.unkept.contains(id)
    }

    /// Whether it has to be known what the other stations do.
    pub(crate) fn needs_members(&self) -> bool {
        self.tickets.values().any(is_open)
    }

    /// The stations are so now. While `held` says why not, nothing is offered.
    pub(crate) fn see(&mut self, members: &Members, held: Option<String>) {
        self.members = members.clone();
        self.held = held;
    }

    /// Whether a request of this key was for a ticket that is there.
    pub(crate) fn asked_before(&self, student: &str, key: &str) -> Option<WorkView> {
        let same = |it: &&Ticket| it.student == student && it.key.as_deref() == Some(key);
        self.tickets.values().find(same).map(|it| self.view(it))
    }

    /// The number of the next ticket.
    pub(crate) const fn next_number(&mut self) -> u64 {
        self.last_number += 1;
        self.last_number
    }

    /// Whether there is room for one more.
    pub(crate) fn check_room(&self) -> Result<(), Problem> {
        let open = self.tickets.values().filter(|it| is_open(it)).count();
        if open < MOST {
            return Ok(());
        }
        let many = format!(
            "{open} drawings and programs are under way already, and more than {MOST} may not"
        );
        Err(TOO_MANY.hinted(many, "wait until some are done, or cancel some"))
    }

    /// Takes a ticket that is on the disk.
    pub(crate) fn submitted(&mut self, ticket: Ticket) -> WorkView {
        let view = self.view(&ticket);
        self.tickets.insert(ticket.id.clone(), ticket);
        view
    }

    /// A person does not want it any more.
    pub(crate) fn cancel(&mut self, id: &str) -> Result<WorkView, Problem> {
        let phase = self.find(id)?.phase();
        let ticket = self.ticket(id);
        match &mut ticket.at {
            Place::Waiting => ticket.at = Place::Cancelled,
            Place::Offered(offer) | Place::Taken { offer, .. } => offer.is_withdrawn = true,
            Place::Over { .. } | Place::Cancelled => {
                return Err(WORK_PHASE.problem(format!(
                    "it is {phase:?}; what is waiting, offered or taken can be cancelled"
                )));
            }
        }
        if let Some(key) = ticket.offer().map(|it| it.key.clone()) {
            self.due.remove(&key);
        }
        self.change(id);
        self.one(id)
    }

    /// A person decides that another arm is to do it, whatever has become of it.
    pub(crate) fn give(&mut self, id: &str) -> Result<WorkView, Problem> {
        let ticket = self.find(id)?;
        let phase = ticket.phase();
        let may = self.doubt(ticket).is_some() || phase == WorkPhase::Failed;
        let (Some(offer), true) = (ticket.offer().cloned(), may) else {
            return Err(WORK_PHASE.hinted(
                format!("it is {phase:?}, and not in doubt"),
                "what is in doubt or has failed can be given to another arm",
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

    /// What is on the disk, or not.
    pub(crate) fn handle_kept(&mut self, now: Duration, is_kept: bool) {
        let Some(keeping) = self.keeping.take() else {
            return;
        };
        if !is_kept {
            self.disk_due = now + ASK_EVERY;
        } else if !keeping.is_old {
            self.unkept.remove(&keeping.id);
        }
    }

    /// What a station answered, or that it did not.
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
            Answer::Unknown => {
                let name = &ask.member.name;
                let text =
                    format!("{name} does not know it any more: its journal was lost or replaced");
                self.unclear.insert(ask.key.clone(), text);
            }
            Answer::Unclear(why) => drop(self.unclear.insert(ask.key.clone(), why)),
        }
        let ticket = &self.tickets[&ask.ticket];
        if matches!(&ticket.at, Place::Taken { job, .. } if job.phase != JobPhase::Queued) {
            self.resting.remove(&ask.member.id);
        }
        if !is_open(ticket) {
            self.due.remove(&ask.key);
        }
        if is_other(&before, ticket) {
            self.change(&ask.ticket);
        }
    }

    /// What is wanted next.
    pub(crate) fn poll_wish(&mut self, now: Duration) -> Option<Wish> {
        if self.keeping.is_some() {
            return None;
        }
        self.recall_hindered(now);
        if self.held.is_none() {
            self.offer_waiting(now);
        }
        if let Some(id) = self.unkept.first().cloned() {
            if now < self.disk_due {
                return None;
            }
            let ticket = self.tickets[&id].clone();
            self.keeping = Some(Keeping { id, is_old: false });
            return Some(Wish::Keep(Box::new(ticket)));
        }
        if let Some(old) = self.old() {
            self.tickets.remove(&old);
            return Some(Wish::Forget(old));
        }
        let ask = self.next_ask(now)?;
        self.asking.insert(ask.key.clone());
        Some(Wish::Ask(ask))
    }

    /// Gives waiting tickets to free arms, as far as there are some.
    fn offer_waiting(&mut self, now: Duration) {
        let waiting = self.tickets.values().filter(|it| it.at == Place::Waiting);
        let mut waiting: Vec<&Ticket> = waiting.collect();
        if waiting.is_empty() {
            return;
        }
        let is_ours = |it: &&Ticket| it.is_out() || it.before.iter().any(|it| !it.is_settled);
        let ours = self.tickets.values().filter(is_ours);
        let mut taken: HashSet<String> = ours.flat_map(members_of).collect();
        let mut shares = Shares::new(self.tickets.values());
        let mut given = Vec::new();
        for member in self.members.iter().filter(|it| is_free(it)) {
            let rests = self.resting.get(&member.id).is_some_and(|it| now < it.0);
            if rests || taken.contains(&member.id) {
                continue;
            }
            let Some(id) = next(&waiting, &shares, member).map(str::to_owned) else {
                continue;
            };
            taken.insert(member.id.clone());
            shares.send_out(&self.tickets[&id]);
            waiting.retain(|it| it.id != id);
            given.push((id, work_member(member)));
        }
        for (id, member) in given {
            // Without chance there are no keys; the computer has some later.
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

    /// Takes tickets back from stations that start work by themselves and cannot start these.
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
            if let Some(why) = self.hurdle(&offer.member, is_late) {
                recalled.push((ticket.id.clone(), offer.clone(), why));
            }
        }
        self.queued = queued;
        for (id, offer, why) in recalled {
            self.due.remove(&offer.key);
            self.rest(now, &offer.member.id);
            if let Place::Taken { offer, .. } = &mut self.ticket(&id).at {
                offer.recalled = Some(why);
            }
            self.change(&id);
        }
    }

    /// Why a station that is there and starts work by itself cannot start what is queued there. A stop or a lock counts at
    /// once; all else may pass, and counts when it is late.
    fn hurdle(&self, member: &WorkMember, is_late: bool) -> Option<String> {
        let member = self.present(member)?;
        let (about, state) = (member.about.as_ref()?, member.state.as_ref()?);
        let takes_work = about.takes_work.filter(|it| *it == TakesWork::Start)?;
        let hurdle = work_hurdle(state, takes_work);
        if state.stop.is_some() || state.lock.is_some() {
            return hurdle;
        }
        let within_s = STARTS_WITHIN.as_secs();
        let late = || format!("its station did not start it within {within_s} s");
        is_late.then(|| hurdle.unwrap_or_else(late))
    }

    fn next_ask(&self, now: Duration) -> Option<Ask> {
        let open = self.tickets.values().filter(|it| is_open(it));
        open.flat_map(asks).find(|ask| {
            let is_due = self.due.get(&ask.key).is_none_or(|it| *it <= now);
            let is_held = ask.what == What::Offer && self.held.is_some();
            is_due && !is_held && !self.asking.contains(&ask.key) && self.is_present(&ask.member)
        })
    }

    /// The oldest that is over, where there are more than are kept.
    fn old(&self) -> Option<String> {
        if self.tickets.len() <= KEPT {
            return None;
        }
        let over: Vec<_> = self.tickets.values().filter(|it| !is_open(it)).collect();
        let oldest = over.iter().min_by_key(|it| it.number)?;
        (over.len() > KEPT).then(|| oldest.id.clone())
    }

    fn rest(&mut self, now: Duration, member: &str) {
        let [first, most] = REST;
        let last = self.resting.get(member).map(|it| it.1);
        let span = last.map_or(first, |it| (it * 2).min(most));
        self.resting.insert(member.into(), (now + span, span));
    }

    fn is_present(&self, member: &WorkMember) -> bool {
        self.present(member).is_some()
    }

    /// A station, if it can be reached.
    fn present(&self, member: &WorkMember) -> Option<&Member> {
        let same = |it: &&std::sync::Arc<Member>| it.id == member.id && it.name == member.name;
        let seen = self.members.iter().find(same).map(|it| &**it);
        seen.filter(|it| it.presence == Presence::Present)
    }

    fn change(&mut self, id: &str) {
        self.unkept.insert(id.to_owned());
        if let Some(keeping) = self.keeping.as_mut().filter(|it| it.id == id) {
            keeping.is_old = true;
        }
    }

    fn find(&self, id: &str) -> Result<&Ticket, Problem> {
        self.tickets.get(id).ok_or_else(|| {
            let id: String = id.chars().take(40).collect();
            NO_SUCH_WORK.problem(format!("nothing of the number {id:?} was submitted here"))
        })
    }

    fn ticket(&mut self, id: &str) -> &mut Ticket {
        self.tickets.get_mut(id).expect("it was found before")
    }
}
