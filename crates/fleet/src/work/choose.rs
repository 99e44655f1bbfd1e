//! Which work goes to which arm.

use std::collections::HashMap;

use dobot_api::{JobPhase, Member, Presence, is_same_person};
use dobot_station::work_hurdle;

use super::ticket::Ticket;

/// Whether a station could be at work of the fleet now, as far as it tells.
pub(crate) fn is_free(member: &Member) -> bool {
    let (Presence::Present, Some(about), Some(state)) =
        (&member.presence, &member.about, &member.state)
    else {
        return false;
    };
    let is_at_work = |phase: JobPhase| !phase.is_over();
    about
        .takes_work
        .is_some_and(|it| work_hurdle(state, it).is_none())
        && !state.job.as_ref().is_some_and(|it| is_at_work(it.phase))
}

/// Whether a station may be offered a ticket: it has all that is needed, has not refused it, and nobody has taken it away
/// from there.
pub(crate) fn suits(ticket: &Ticket, member: &Member) -> bool {
    let offers = member.about.as_ref().map(|it| &it.offers);
    let has = |need: &String| offers.is_some_and(|it| it.contains(need));
    ticket.needs.iter().all(has)
        && ticket.refused.iter().all(|it| it.member.id != member.id)
        && ticket
            .before
            .iter()
            .all(|it| it.offer.member.id != member.id)
}

/// Whether it is nobody else's time there: in a time slot an arm takes only its student's work.
fn is_in_time(ticket: &Ticket, member: &Member) -> bool {
    let slots = member.state.as_ref().and_then(|it| it.slots.as_ref());
    slots
        .and_then(|it| it.now.as_ref())
        .is_none_or(|now| is_same_person(&now.student, &ticket.student))
}

/// The ticket that goes next to this arm: of whoever has had the least time of arms so far, and of several the one that
/// came first.
pub(crate) fn next<'a>(
    tickets: &'a [&Ticket],
    shares: &Shares,
    member: &Member,
) -> Option<&'a str> {
    tickets
        .iter()
        .filter(|it| suits(it, member) && is_in_time(it, member))
        .min_by(|one, other| {
            let [(one_s, one_out), (other_s, other_out)] = [one, other].map(|it| shares.of(it));
            one_s
                .total_cmp(&other_s)
                .then(one_out.cmp(&other_out))
                .then(one.number.cmp(&other.number))
        })
        .map(|it| it.id.as_str())
}

/// How much of the arms' time each student has had.
#[derive(Debug, Default)]
pub(crate) struct Shares(HashMap<(String, Option<String>), (f64, usize)>);

impl Shares {
    pub(crate) fn new<'a>(tickets: impl Iterator<Item = &'a Ticket>) -> Self {
        let mut shares = Self::default();
        tickets.for_each(|it| shares.add(it));
        shares
    }

    fn add(&mut self, ticket: &Ticket) {
        let share = self.0.entry(student(ticket)).or_default();
        share.0 += ticket.arm_s();
        share.1 += usize::from(ticket.is_out());
    }

    /// One more is out.
    pub(crate) fn send_out(&mut self, ticket: &Ticket) {
        self.0.entry(student(ticket)).or_default().1 += 1;
    }

    /// Time in seconds, and how many are out.
    fn of(&self, ticket: &Ticket) -> (f64, usize) {
        self.0.get(&student(ticket)).copied().unwrap_or_default()
    }
}

fn student(ticket: &Ticket) -> (String, Option<String>) {
    (ticket.student.clone(), ticket.group.clone())
}
