//! Anyone may stop the arm, and it stays stopped until a person resets that.

use std::time::Duration;

use dobot_api::StopView;

use super::still_moving;
use crate::refusal::Refusal;

/// The stop that holds the arm, if one does.
#[derive(Debug, Default)]
pub(super) struct Stop {
    holding: Option<Holding>,
}

#[derive(Debug)]
struct Holding {
    by: String,
    reason: Option<String>,
    at: Duration,
    rests_by: Duration,
    at_rest: bool,
    delivered: bool,
    /// When people are told again that it was not delivered.
    again: Duration,
}

impl Stop {
    /// Takes that somebody stops the arm; says what is to be told, unless it is stopped already.
    pub(super) fn handle_stop(
        &mut self,
        now: Duration,
        by: String,
        reason: Option<String>,
        rests_within: Duration,
        delivered: bool,
    ) -> Option<String> {
        if let Some(stop) = &mut self.holding {
            stop.delivered |= delivered;
            return None;
        }
        self.holding = Some(Holding {
            by,
            reason,
            at: now,
            rests_by: now + rests_within,
            at_rest: false,
            delivered,
            again: now + EVERY,
        });
        self.check().err().map(|it| it.to_string())
    }

    /// Takes a stop that held before the station was started.
    pub(super) fn handle_kept(&mut self, now: Duration, by: String, reason: Option<String>) {
        self.holding = Some(Holding {
            by,
            reason,
            at: now,
            rests_by: now,
            at_rest: false,
            // The first packet to an arm that is found switches its laser off.
            delivered: true,
            again: now,
        });
    }

    /// Takes that the packets which stop the arm leave this computer now; says whether people waited for that.
    pub(super) fn handle_delivered(&mut self) -> bool {
        let waits = self.holding.as_mut().filter(|it| !it.delivered);
        waits.map(|it| it.delivered = true).is_some()
    }

    /// When people are told again that it was not delivered.
    pub(super) fn wakeup(&self) -> Option<Duration> {
        let waits = self.holding.as_ref().filter(|it| !it.delivered);
        waits.map(|it| it.again)
    }

    /// Whether people are told now that it was not delivered.
    pub(super) fn is_due(&mut self, now: Duration) -> bool {
        let waits = self.holding.as_mut().filter(|it| !it.delivered);
        let due = waits.filter(|it| it.again <= now);
        due.map(|it| it.again = now + EVERY).is_some()
    }

    /// Lets go; says whether there was a stop. The arm has to have been seen at rest.
    pub(super) fn reset(&mut self, now: Duration, is_linked: bool) -> Result<bool, Refusal> {
        if let Some(stop) = self.holding.as_ref().filter(|it| !it.at_rest) {
            if !is_linked {
                let why = "whether it rests cannot be seen, so the stop holds";
                return Err(Refusal::NoLink(why.to_owned()));
            }
            let within = stop.rests_by.saturating_sub(now).max(SOON);
            return Err(still_moving(within));
        }
        Ok(self.holding.take().is_some())
    }

    /// Whether no stop holds the arm.
    pub(super) fn check(&self) -> Result<(), Refusal> {
        match &self.holding {
            None => Ok(()),
            Some(stop) => Err(Refusal::Stopped {
                by: stop.by.clone(),
                reason: stop.reason.clone(),
            }),
        }
    }

    pub(super) const fn holds(&self) -> bool {
        self.holding.is_some()
    }

    /// With each status: says whether the arm has come to rest now.
    pub(super) fn handle_status(&mut self, rests: bool) -> bool {
        let moving = self.holding.as_mut().filter(|it| !it.at_rest && rests);
        moving.map(|it| it.at_rest = true).is_some()
    }

    pub(super) fn view(&self) -> Option<StopView> {
        self.holding.as_ref().map(|it| StopView {
            by: it.by.clone(),
            reason: it.reason.clone(),
            at_s: it.at.as_secs_f64(),
            rests_by_s: it.rests_by.as_secs_f64(),
            at_rest: it.at_rest,
            delivered: it.delivered,
        })
    }
}

/// How often people are told that a stop was not delivered.
const EVERY: Duration = Duration::from_secs(1);
/// Three statuses.
const SOON: Duration = Duration::from_millis(240);
