//! What others see of the work.

use std::sync::Arc;

use dobot_api::{Member, Presence, Problem, WorkView};

use super::Work;
use crate::work::choose::suits;
use crate::work::ticket::{Place, Ticket, drawn};

impl Work {
    /// All of it, in the order in which it came.
    pub(crate) fn views(&self) -> Vec<WorkView> {
        let mut tickets: Vec<_> = self.tickets.values().collect();
        tickets.sort_by_key(|it| it.number);
        tickets.into_iter().map(|it| self.view(it)).collect()
    }

    /// One of it.
    pub(crate) fn one(&self, id: &str) -> Result<WorkView, Problem> {
        self.find(id).map(|it| self.view(it))
    }

    pub(super) fn view(&self, ticket: &Ticket) -> WorkView {
        let mut view = ticket.view(self.doubt(ticket));
        if ticket.at == Place::Waiting {
            let reasons = [
                self.held.clone(),
                view.reason.or_else(|| self.lacking(ticket)),
            ];
            let reasons: Vec<_> = reasons.into_iter().flatten().collect();
            view.reason = Some(reasons.join("; ")).filter(|it| !it.is_empty());
        }
        view
    }

    /// What the stations that are there do not have.
    fn lacking(&self, ticket: &Ticket) -> Option<String> {
        let is_there = |it: &&Arc<Member>| it.presence == Presence::Present;
        let takes = |it: &Member| it.about.as_ref().is_some_and(|it| it.takes_work.is_some());
        let mut there = self.members.iter().filter(is_there);
        if there.any(|it| takes(it) && suits(ticket, it)) {
            return None;
        }
        let needs = ticket.needs.join(", ");
        let what = if needs.is_empty() {
            String::new()
        } else {
            format!(" and has {needs}")
        };
        Some(format!(
            "no station that takes work{what} is there now; `dobot up --takes-work --offers ...` makes one"
        ))
    }

    /// Why nobody knows what becomes of a ticket, if so.
    pub(super) fn doubt(&self, ticket: &Ticket) -> Option<String> {
        let offer = ticket.offer().filter(|_| ticket.is_out())?;
        let name = &offer.member.name;
        let drawn = drawn(ticket.job(), false);
        if !self.is_present(&offer.member) {
            return Some(format!("{name} cannot be reached; {drawn}"));
        }
        let why = self.unclear.get(&offer.key)?;
        Some(format!(
            "{name} does not say what has become of it ({why}); {drawn}"
        ))
    }
}
