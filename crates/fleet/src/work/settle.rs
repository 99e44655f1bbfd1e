//! What an answer means for a ticket.

use dobot_api::{JobPhase, JobView, Member, WorkMember};
use dobot_host::WITHDRAWN;

use super::engine::{Ask, What};
use super::ticket::{Before, Offer, Place, Refused, Ticket};

/// Whether anybody has still to be asked about it.
pub(crate) fn is_open(ticket: &Ticket) -> bool {
    !ticket.phase().is_over() || ticket.before.iter().any(|it| !it.is_settled)
}

/// Whom to ask about it, and what.
pub(crate) fn asks(ticket: &Ticket) -> Vec<Ask> {
    let ask = |offer: &Offer, what| Ask {
        ticket: ticket.id.clone(),
        member: offer.member.clone(),
        key: offer.key.clone(),
        what,
    };
    let withdrawn = ticket.before.iter().filter(|it| !it.is_settled);
    let mut asks: Vec<_> = withdrawn.map(|it| ask(&it.offer, What::Withdraw)).collect();
    match &ticket.at {
        Place::Offered(offer) | Place::Taken { offer, .. } if offer.is_taken_back() => {
            asks.push(ask(offer, What::Withdraw));
        }
        Place::Offered(offer) => asks.push(ask(offer, What::Offer)),
        Place::Taken { offer, .. } => asks.push(ask(offer, What::Look)),
        Place::Waiting | Place::Over { .. } | Place::Cancelled => {}
    }
    asks
}

/// The stations that may be at it, by their numbers.
pub(crate) fn members_of(ticket: &Ticket) -> Vec<String> {
    let now = ticket.offer().filter(|_| ticket.is_out());
    let before = ticket.before.iter().filter(|it| !it.is_settled);
    let offers = now.into_iter().chain(before.map(|it| &it.offer));
    offers.map(|it| it.member.id.clone()).collect()
}

/// A station has it.
pub(crate) fn settle_taken(ticket: &mut Ticket, ask: &Ask, job: Box<JobView>) {
    if let Some(before) = before(ticket, ask) {
        before.is_settled = job.phase.is_over();
        before.job = Some(job);
        return;
    }
    let Some(offer) = current(ticket, ask) else {
        return;
    };
    let never_begun = job.phase == JobPhase::Stopped && job.completed == 0;
    if !offer.is_withdrawn
        && was_withdrawn(&job)
        && let Some(reason) = offer.recalled
    {
        let member = offer.member;
        ticket.returned = Some(Refused { member, reason });
        ticket.at = Place::Waiting;
        return;
    }
    // One that was begun before it could be taken back stays there.
    let recalled = offer.recalled.filter(|_| job.phase == JobPhase::Queued);
    let offer = Offer { recalled, ..offer };
    ticket.at = if offer.is_withdrawn && never_begun {
        Place::Cancelled
    } else if job.phase.is_over() {
        Place::Over { offer, job }
    } else {
        Place::Taken { offer, job }
    };
}

/// A station has refused it for good under this key.
pub(crate) fn settle_refused(ticket: &mut Ticket, ask: &Ask, reason: &str, busy: bool) {
    if let Some(before) = before(ticket, ask) {
        before.is_settled = true;
        return;
    }
    // What it has taken it cannot refuse.
    let Some(offer) = current(ticket, ask).filter(|_| matches!(ticket.at, Place::Offered(_)))
    else {
        return;
    };
    if offer.is_withdrawn {
        ticket.at = Place::Cancelled;
        return;
    }
    ticket.at = Place::Waiting;
    if !busy {
        ticket.refused.push(Refused {
            member: offer.member,
            reason: reason.to_owned(),
        });
    }
}

/// Whether a job was withdrawn before its arm had begun it.
fn was_withdrawn(job: &JobView) -> bool {
    let reason = job.reason.as_deref().unwrap_or_default();
    job.phase == JobPhase::Stopped && job.completed == 0 && reason.starts_with(WITHDRAWN)
}

fn current(ticket: &Ticket, ask: &Ask) -> Option<Offer> {
    let offer = ticket.offer().filter(|_| ticket.is_out());
    offer.filter(|it| it.key == ask.key).cloned()
}

fn before<'a>(ticket: &'a mut Ticket, ask: &Ask) -> Option<&'a mut Before> {
    let mut before = ticket.before.iter_mut();
    before.find(|it| it.offer.key == ask.key)
}

/// Whether a crash may not forget the difference: how far a job is, its station tells again.
pub(crate) fn is_other(one: &Ticket, other: &Ticket) -> bool {
    let still = |ticket: &Ticket| {
        let mut ticket = ticket.clone();
        if let Place::Taken { job, .. } = &mut ticket.at {
            rest(job);
        }
        let jobs = ticket.before.iter_mut().filter_map(|it| it.job.as_mut());
        jobs.for_each(|it| rest(it));
        ticket
    };
    still(one) != still(other)
}

fn rest(job: &mut JobView) {
    job.completed = 0;
    job.left_s = None;
    job.speed_percent = 100.0;
    job.height_mm = 0.0;
    job.program = None;
}

pub(crate) fn work_member(member: &Member) -> WorkMember {
    WorkMember {
        name: member.name.clone(),
        id: member.id.clone(),
    }
}
