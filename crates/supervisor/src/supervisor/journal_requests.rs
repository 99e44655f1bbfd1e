//! Requests to the journal and the outcome of the writes.

use std::collections::VecDeque;
use std::time::Duration;

use super::run::Effect;
use crate::refusal::Refusal;

/// The requests to the journal.
#[derive(Debug, Default)]
pub(super) struct JournalRequests {
    effects: VecDeque<Effect>,
    /// The last requested phase of a job.
    kept: Option<Effect>,
    unsaved: Option<Unsaved>,
}

/// A phase of a job that the journal failed to write; the request is repeated.
#[derive(Debug)]
struct Unsaved {
    effect: Effect,
    why: String,
    next: Duration,
}

impl JournalRequests {
    pub(super) fn ask(&mut self, effect: Effect) {
        self.effects.push_back(effect);
    }

    /// Requests to write the phase of a job; replaces an earlier failed request.
    pub(super) fn keep_phase(&mut self, effect: Effect) {
        if let Some(unsaved) = &mut self.unsaved {
            unsaved.effect = effect.clone();
        }
        self.kept = Some(effect.clone());
        self.ask(effect);
    }

    /// Handles a completed write; returns whether it had failed before.
    pub(super) fn handle_written(&mut self, effect: &Effect) -> bool {
        self.unsaved
            .take_if(|unsaved| unsaved.effect == *effect)
            .is_some()
    }

    /// Handles a failed write; returns whether this is news.
    pub(super) fn handle_not_written(&mut self, now: Duration, effect: &Effect, why: &str) -> bool {
        let is_news = self.unsaved.is_none();
        if self.kept.as_ref() == Some(effect) {
            self.unsaved = Some(Unsaved {
                effect: effect.clone(),
                why: why.to_owned(),
                next: now + RETRY_DELAY,
            });
        }
        is_news
    }

    /// Repeats the failed request when due.
    pub(super) fn handle_time(&mut self, now: Duration) {
        if let Some(unsaved) = &mut self.unsaved
            && unsaved.next <= now
        {
            unsaved.next = now + RETRY_DELAY;
            self.effects.push_back(unsaved.effect.clone());
        }
    }

    /// Returns when the failed request is repeated.
    pub(super) fn next(&self) -> Option<Duration> {
        self.unsaved.as_ref().map(|unsaved| unsaved.next)
    }

    /// Checks that nothing is unwritten: the journal cannot restore what it does not have.
    pub(super) fn check(&self) -> Result<(), Refusal> {
        match &self.unsaved {
            None => Ok(()),
            Some(unsaved) => Err(Refusal::Journal(unsaved.why.clone())),
        }
    }

    pub(super) fn poll_effect(&mut self) -> Option<Effect> {
        self.effects.pop_front()
    }
}

/// A person takes longer than this to free disk space.
const RETRY_DELAY: Duration = Duration::from_secs(1);
