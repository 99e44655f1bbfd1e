//! What the journal did and did not take.

use std::time::Duration;

use dobot_api::News;

use super::Keeper;
use super::run::{Effect, Run};
use crate::Refusal;

/// A phase of a job that the journal did not take: it is asked again until it does.
#[derive(Clone, Debug)]
pub(super) struct Unsaved {
    effect: Effect,
    why: String,
    next: Duration,
}

impl Unsaved {
    pub(super) const fn next(&self) -> Duration {
        self.next
    }
}

impl Keeper {
    /// Takes what came of an [`Effect`]: it is on the disk, or why it is not. No more of a job is
    /// sent then until somebody goes on with it.
    pub fn handle_written(&mut self, now: Duration, effect: &Effect, outcome: Result<(), String>) {
        self.handle_time(now);
        match outcome {
            Ok(()) => self.written(effect),
            Err(why) => self.not_written(effect, &why),
        }
        self.pump();
    }

    fn written(&mut self, effect: &Effect) {
        match effect {
            Effect::Give { job, upto, .. } => {
                if let Some(run) = self.run.as_mut().filter(|it| it.job() == *job) {
                    run.given_for_good(*upto);
                }
            }
            Effect::Adjust { job, adjustment } => {
                if let Some(run) = self.run.as_mut().filter(|it| it.job() == *job) {
                    run.adjusted(adjustment);
                }
            }
            Effect::Phase { .. } => {
                if self.unsaved.take_if(|it| it.effect == *effect).is_some() {
                    let text = "the journal of jobs can be written again".to_owned();
                    self.tell(News::Trouble, text);
                }
            }
        }
    }

    fn not_written(&mut self, effect: &Effect, why: &str) {
        let again = self.unsaved.is_some();
        if self.kept.as_ref() == Some(effect) {
            self.unsaved = Some(Unsaved {
                effect: effect.clone(),
                why: why.to_owned(),
                next: self.now + AGAIN,
            });
        }
        let why = format!("the journal of jobs cannot be written: {why}");
        if self.run.as_ref().is_some_and(Run::has_the_arm) {
            self.part_from_laser();
            self.drop_waiting(&why);
            self.interrupt_run(&why);
        }
        if !again {
            self.tell(News::Trouble, why);
        }
    }

    /// Has the journal keep in which phase a job is; what was to be kept before counts no more.
    pub(super) fn keep_phase(&mut self, effect: Effect) {
        if let Some(unsaved) = &mut self.unsaved {
            unsaved.effect = effect.clone();
        }
        self.kept = Some(effect.clone());
        self.effects.push_back(effect);
    }

    /// Asks the journal again for what it did not take.
    pub(super) fn repeat_unsaved(&mut self) {
        if let Some(unsaved) = &mut self.unsaved
            && unsaved.next <= self.now
        {
            unsaved.next = self.now + AGAIN;
            self.effects.push_back(unsaved.effect.clone());
        }
    }

    /// Whether the journal has taken everything: what it does not know it cannot bring back.
    pub(super) fn check_saved(&self) -> Result<(), Refusal> {
        match &self.unsaved {
            None => Ok(()),
            Some(unsaved) => Err(Refusal::Journal(unsaved.why.clone())),
        }
    }
}

/// Making room takes a person longer.
const AGAIN: Duration = Duration::from_secs(1);
