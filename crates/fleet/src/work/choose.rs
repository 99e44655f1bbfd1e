//! Chooses the arm for a job.

use std::collections::HashMap;

use dobot_api::{JobPhase, Member, Presence, is_same_person};
use dobot_station::work_hurdle;

use super::ticket::Ticket;

/// Whether a station could accept a job of the fleet now, according to its state.
pub(crate) fn is_free(member: &Member) -> bool {
    let (Presence::Present, Some(about), Some(state)) =
        (&member.presence, &member.about, &member.state)
    else {
        return false;
    };
    let is_at_work = |phase: JobPhase| !phase.is_over();
    about
        .takes_work
        .is_some_and(|setting| work_hurdle(state, setting).is_none())
        && !state.job.as_ref().is_some_and(|job| is_at_work(job.phase))
}

/// Whether a ticket may be offered to a station: it has all required features, has not refused the
/// ticket, and nobody has taken the ticket away from it.
pub(crate) fn suits(ticket: &Ticket, member: &Member) -> bool {
    let offers = member.about.as_ref().map(|offers| &offers.offers);
    let has = |need: &String| offers.is_some_and(|offers| offers.contains(need));
    ticket.needs.iter().all(has)
        && ticket
            .refused
            .iter()
            .all(|refusal| refusal.member.id != member.id)
        && ticket
            .before
            .iter()
            .all(|earlier| earlier.offer.member.id != member.id)
}

/// Whether no other student's time slot is active there: in a slot an arm accepts only its
/// student's jobs.
fn is_in_time(ticket: &Ticket, member: &Member) -> bool {
    let slots = member.state.as_ref().and_then(|state| state.slots.as_ref());
    slots
        .and_then(|slot| slot.now.as_ref())
        .is_none_or(|now| is_same_person(&now.student, &ticket.student))
}

/// Returns the next ticket for this arm: of the student who has used the least arm time so far, and
/// the first of those.
pub(crate) fn next<'a>(
    tickets: &'a [&Ticket],
    shares: &Shares,
    member: &Member,
) -> Option<&'a str> {
    tickets
        .iter()
        .filter(|ticket| suits(ticket, member) && is_in_time(ticket, member))
        .min_by(|one, other| {
            let [(one_s, one_out), (other_s, other_out)] =
                [one, other].map(|ticket| shares.of(ticket));
            one_s
                .total_cmp(&other_s)
                .then(one_out.cmp(&other_out))
                .then(one.number.cmp(&other.number))
        })
        .map(|ticket| ticket.id.as_str())
}

/// The arm time used by each student.
#[derive(Debug, Default)]
pub(crate) struct Shares(HashMap<(String, Option<String>), (f64, usize)>);

impl Shares {
    pub(crate) fn new<'a>(tickets: impl Iterator<Item = &'a Ticket>) -> Self {
        let mut shares = Self::default();
        tickets.for_each(|ticket| shares.add(ticket));
        shares
    }

    fn add(&mut self, ticket: &Ticket) {
        let share = self.0.entry(student(ticket)).or_default();
        share.0 += ticket.arm_s();
        share.1 += usize::from(ticket.is_out());
    }

    /// Counts one more ticket in progress.
    pub(crate) fn send_out(&mut self, ticket: &Ticket) {
        self.0.entry(student(ticket)).or_default().1 += 1;
    }

    /// Returns the time in seconds, and the number of tickets in progress.
    fn of(&self, ticket: &Ticket) -> (f64, usize) {
        self.0.get(&student(ticket)).copied().unwrap_or_default()
    }
}

fn student(ticket: &Ticket) -> (String, Option<String>) {
    (ticket.student.clone(), ticket.group.clone())
}
