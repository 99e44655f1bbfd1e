//! Anyone may stop the arm, and it stays stopped until a person resets that.

use std::time::Duration;

use dobot_api::{ClientId, News, Reply, StopView};

use super::Keeper;
use crate::Refusal;

/// A stop that holds the arm.
#[derive(Clone, Debug)]
pub(super) struct Stop {
    by: String,
    reason: Option<String>,
    at: Duration,
    rests_by: Duration,
    at_rest: bool,
}

impl Keeper {
    /// Stops: laser off first, buttons let go, nothing more is sent. The arm finishes the command
    /// that it is at, for its protocol knows no stop; a stop that is said again says it to the arm
    /// again.
    pub(super) fn stop(&mut self, client: ClientId, reason: Option<String>) -> Reply {
        let by = self.name(client);
        let rests_within = self.rests_within();
        self.halt_now();
        self.disarm_laser("the arm was stopped");
        let why = format!("the arm was stopped by {by}");
        self.bar(Refusal::LetGo(why.clone()));
        self.drop_waiting(&why);
        self.interrupt_run(&why);
        self.end_detection(&why);
        if self.stop.is_none() {
            let text = Refusal::Stopped {
                by: by.clone(),
                reason: reason.clone(),
            }
            .to_string();
            self.stop = Some(Stop {
                by,
                reason,
                at: self.now,
                rests_by: self.now + rests_within,
                at_rest: false,
            });
            self.tell(News::Stopped, text);
        }
        Reply::Stopping {
            rests_within_s: rests_within.as_secs_f64(),
        }
    }

    pub(super) fn reset_stop(&mut self, client: ClientId) -> Result<Reply, Refusal> {
        let Some(stop) = &self.stop else {
            return Ok(Reply::Done);
        };
        if !stop.at_rest && self.is_linked() {
            let within = stop.rests_by.saturating_sub(self.now).max(SOON);
            return Err(Refusal::StillMoving {
                within_s: within.as_secs_f64(),
            });
        }
        self.stop = None;
        self.halt = None;
        let text = format!("{} lets the arm move again", self.name(client));
        self.tell(News::StopReset, text);
        Ok(Reply::Done)
    }

    /// Whether no stop holds the arm.
    pub(super) fn check_stop(&self) -> Result<(), Refusal> {
        match &self.stop {
            None => Ok(()),
            Some(stop) => Err(Refusal::Stopped {
                by: stop.by.clone(),
                reason: stop.reason.clone(),
            }),
        }
    }

    pub(super) fn watch_stop(&mut self) {
        let rests = self.is_at_rest();
        if let Some(stop) = &mut self.stop
            && !stop.at_rest
            && rests
        {
            stop.at_rest = true;
            self.tell(News::AtRest, "the arm is at rest".into());
        }
    }

    pub(super) fn stop_view(&self) -> Option<StopView> {
        self.stop.as_ref().map(|it| StopView {
            by: it.by.clone(),
            reason: it.reason.clone(),
            at_s: it.at.as_secs_f64(),
            rests_by_s: it.rests_by.as_secs_f64(),
            at_rest: it.at_rest,
        })
    }
}

/// Three statuses.
const SOON: Duration = Duration::from_millis(240);
