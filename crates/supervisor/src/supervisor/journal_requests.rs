//! What the journal is to keep, and what it did and did not take.

use std::collections::VecDeque;
use std::time::Duration;

use super::run::Effect;
use crate::refusal::Refusal;

/// What goes to the journal.
#[derive(Debug, Default)]
pub(super) struct JournalRequests {
    effects: VecDeque<Effect>,
    /// The last phase of a job that was to be kept.
    kept: Option<Effect>,
    unsaved: Option<Unsaved>,
}

/// A phase of a job that the journal did not take: it is asked again until it does.
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

    /// Has the journal keep in which phase a job is; what was to be kept before counts no more.
    pub(super) fn keep_phase(&mut self, effect: Effect) {
        if let Some(unsaved) = &mut self.unsaved {
            unsaved.effect = effect.clone();
        }
        self.kept = Some(effect.clone());
        self.ask(effect);
    }

    /// Takes that the journal has this; says whether it had refused it before.
    pub(super) fn handle_written(&mut self, effect: &Effect) -> bool {
        self.unsaved.take_if(|it| it.effect == *effect).is_some()
    }

    /// Takes that the journal does not take this; says whether that is news.
    pub(super) fn handle_not_written(&mut self, now: Duration, effect: &Effect, why: &str) -> bool {
        let is_news = self.unsaved.is_none();
        if self.kept.as_ref() == Some(effect) {
            self.unsaved = Some(Unsaved {
                effect: effect.clone(),
                why: why.to_owned(),
                next: now + AGAIN,
            });
        }
        is_news
    }

    /// Asks the journal again for what it did not take.
    pub(super) fn handle_time(&mut self, now: Duration) {
        if let Some(unsaved) = &mut self.unsaved
            && unsaved.next <= now
        {
            unsaved.next = now + AGAIN;
            self.effects.push_back(unsaved.effect.clone());
        }
    }

    /// When it asks again.
    pub(super) fn next(&self) -> Option<Duration> {
        self.unsaved.as_ref().map(|it| it.next)
    }

    /// Whether the journal has taken everything: what it does not know it cannot bring back.
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

/// Making room takes a person longer.
const AGAIN: Duration = Duration::from_secs(1);
