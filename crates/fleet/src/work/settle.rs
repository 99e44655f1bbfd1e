//! The effect of a response on a ticket.

use dobot_api::{JobPhase, JobView, Member, WorkMember};
use dobot_host::WITHDRAWN;

use super::engine::{Ask, What};
use super::ticket::{Before, Offer, Place, Refused, Ticket};

/// Whether a request for the ticket is still necessary.
pub(crate) fn is_open(ticket: &Ticket) -> bool {
    !ticket.phase().is_over() || ticket.before.iter().any(|earlier| !earlier.is_settled)
}

/// Returns the requests that the ticket needs.
pub(crate) fn asks(ticket: &Ticket) -> Vec<Ask> {
    let ask = |offer: &Offer, what| Ask {
        ticket: ticket.id.clone(),
        member: offer.member.clone(),
        key: offer.key.clone(),
        what,
    };
    let withdrawn = ticket.before.iter().filter(|earlier| !earlier.is_settled);
    let mut asks: Vec<_> = withdrawn
        .map(|earlier| ask(&earlier.offer, What::Withdraw))
        .collect();
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

/// Returns the ids of the stations that may be working on it.
pub(crate) fn members_of(ticket: &Ticket) -> Vec<String> {
    let now = ticket.offer().filter(|_| ticket.is_out());
    let before = ticket.before.iter().filter(|earlier| !earlier.is_settled);
    let offers = now.into_iter().chain(before.map(|earlier| &earlier.offer));
    offers.map(|offer| offer.member.id.clone()).collect()
}

/// Handles a taken ticket.
pub(crate) fn settle_taken(ticket: &mut Ticket, ask: &Ask, job: Box<JobView>) {
    if let Some(before) = before(ticket, ask) {
        before.is_settled = job.phase.is_over();
        before.job = Some(job);
        return;
    }
    let Some(offer) = current(ticket, ask) else {
        return;
    };
    if !offer.is_withdrawn
        && was_withdrawn(&job)
        && let Some(reason) = offer.recalled
    {
        let member = offer.member;
        ticket.returned = Some(Refused { member, reason });
        ticket.at = Place::Waiting;
        return;
    }
    ticket.at = place_of(offer, job);
}

fn place_of(offer: Offer, job: Box<JobView>) -> Place {
    // A job that began before it could be recalled stays there.
    let recalled = offer.recalled.filter(|_| job.phase == JobPhase::Queued);
    let offer = Offer { recalled, ..offer };
    let never_begun = job.phase == JobPhase::Stopped && job.completed == 0;
    if offer.is_withdrawn && never_begun {
        Place::Cancelled
    } else if job.phase.is_over() {
        Place::Over { offer, job }
    } else {
        Place::Taken { offer, job }
    }
}

/// Handles a final refusal under this key.
pub(crate) fn settle_refused(ticket: &mut Ticket, ask: &Ask, reason: &str, busy: bool) {
    if let Some(before) = before(ticket, ask) {
        before.is_settled = true;
        return;
    }
    // A station cannot refuse what it has taken.
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

/// Whether a job was withdrawn before its arm began it.
fn was_withdrawn(job: &JobView) -> bool {
    let reason = job.reason.as_deref().unwrap_or_default();
    job.phase == JobPhase::Stopped && job.completed == 0 && reason.starts_with(WITHDRAWN)
}

fn current(ticket: &Ticket, ask: &Ask) -> Option<Offer> {
    let offer = ticket.offer().filter(|_| ticket.is_out());
    offer.filter(|offer| offer.key == ask.key).cloned()
}

fn before<'a>(ticket: &'a mut Ticket, ask: &Ask) -> Option<&'a mut Before> {
    let mut before = ticket.before.iter_mut();
    before.find(|earlier| earlier.offer.key == ask.key)
}

/// Whether the difference must survive a crash; the progress of a job need not, since its station
/// reports it again.
pub(crate) fn is_other(one: &Ticket, other: &Ticket) -> bool {
    let still = |ticket: &Ticket| {
        let mut ticket = ticket.clone();
        if let Place::Taken { job, .. } = &mut ticket.at {
            rest(job);
        }
        let jobs = ticket
            .before
            .iter_mut()
            .filter_map(|earlier| earlier.job.as_mut());
        jobs.for_each(|job| rest(job));
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
