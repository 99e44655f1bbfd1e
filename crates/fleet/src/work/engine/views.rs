//! The public view of the tickets.

use std::sync::Arc;

use dobot_api::{Member, Presence, Problem, WorkView};

use super::Work;
use crate::work::choose::suits;
use crate::work::ticket::{Place, Ticket, drawn};

impl Work {
    /// Returns all tickets, in the order of their submission.
    pub(crate) fn views(&self) -> Vec<WorkView> {
        let mut tickets: Vec<_> = self.tickets.values().collect();
        tickets.sort_by_key(|ticket| ticket.number);
        tickets
            .into_iter()
            .map(|ticket| self.view(ticket))
            .collect()
    }

    /// Returns one ticket.
    pub(crate) fn one(&self, id: &str) -> Result<WorkView, Problem> {
        self.find(id).map(|ticket| self.view(ticket))
    }

    pub(super) fn view(&self, ticket: &Ticket) -> WorkView {
        let mut view = ticket.view(self.doubt(ticket));
        if ticket.at == Place::Waiting {
            let reasons = [
                self.held.clone(),
                view.reason.or_else(|| self.lacking(ticket)),
            ];
            let reasons: Vec<_> = reasons.into_iter().flatten().collect();
            view.reason = Some(reasons.join("; ")).filter(|text| !text.is_empty());
        }
        view
    }

    /// Returns the requirement that no present station meets.
    fn lacking(&self, ticket: &Ticket) -> Option<String> {
        let is_there = |member: &&Arc<Member>| member.presence == Presence::Present;
        let takes = |member: &Member| {
            member
                .about
                .as_ref()
                .is_some_and(|about| about.takes_work.is_some())
        };
        let mut there = self.members.iter().filter(is_there);
        if there.any(|member| takes(member) && suits(ticket, member)) {
            return None;
        }
        let needs = ticket.needs.join(", ");
        let what = if needs.is_empty() {
            String::new()
        } else {
            format!(" and has {needs}")
        };
        Some(format!(
            "no station that accepts jobs{what} is online; start one with `dobot up --takes-work --offers ...`"
        ))
    }

    /// Returns why the fate of a ticket is unknown, if so.
    pub(super) fn doubt(&self, ticket: &Ticket) -> Option<String> {
        let offer = ticket.offer().filter(|_| ticket.is_out())?;
        let name = &offer.member.name;
        let drawn = drawn(ticket.job(), false);
        if !self.is_present(&offer.member) {
            return Some(format!("{name} cannot be reached; {drawn}"));
        }
        let why = self.unclear.get(&offer.key)?;
        Some(format!(
            "{name} does not report the state of the job ({why}); {drawn}"
        ))
    }
}
