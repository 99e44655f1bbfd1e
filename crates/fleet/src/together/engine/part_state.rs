//! One part, as the engine knows it.

use std::collections::{BTreeSet, VecDeque};
use std::time::Duration;

use super::News;
use crate::together::barriers::Barriers;
use crate::together::seen::Seen;

/// One part, as the engine knows it.
#[expect(
    clippy::struct_excessive_bools,
    reason = "where it is, whether it holds and what it was asked for change apart from each other"
)]
#[derive(Debug)]
pub(super) struct PartState {
    pub(super) barriers: Barriers,
    /// How many of them are passed.
    passed: u64,
    pub(super) at: At,
    /// How far its job was at the last barrier to which it has come.
    arrived: Option<(u64, usize)>,
    /// Whether its arm was at it when it was seen last.
    pub(super) runs: bool,
    /// It was let go on from where it waits, and is not known to have set out.
    is_released: bool,
    /// The others have gone on without it.
    is_behind: bool,
    /// It is to be started by itself.
    start_is_due: bool,
    /// The answer to its start did not come, and it was not seen since.
    is_unknown: bool,
    /// When it was heard of last.
    pub(super) heard: Duration,
    /// It was not heard of for too long.
    pub(super) is_silent: bool,
    /// Why it does not go on.
    pub(super) trouble: Option<String>,
    /// It is not to go on before a person has decided so.
    pub(super) is_held: bool,
    /// It was asked to pause since it holds.
    pub(super) is_pausing: bool,
}

/// Where a part is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum At {
    /// Before its first step.
    Queued,
    Running,
    /// At the barrier that comes next.
    Waiting,
    /// Its program waits for a person.
    Person(String),
    Paused,
    Through,
    /// It cannot be gone on with, for this reason.
    Broken(String),
}

impl PartState {
    pub(super) const fn new(barriers: Barriers) -> Self {
        Self {
            barriers,
            passed: 0,
            at: At::Queued,
            arrived: None,
            runs: false,
            is_released: false,
            is_behind: false,
            start_is_due: true,
            is_unknown: false,
            heard: Duration::ZERO,
            is_silent: false,
            trouble: None,
            is_held: false,
            is_pausing: false,
        }
    }

    /// Takes what is seen of it.
    ///
    /// # Errors
    ///
    /// Why it does not go on, or cannot any more.
    pub(super) fn see(
        &mut self,
        part: usize,
        seen: &Seen,
        news: &mut VecDeque<News>,
    ) -> Result<(), String> {
        self.runs = *seen == Seen::Running;
        self.is_unknown = false;
        if self.is_over() {
            return Ok(());
        }
        if self.is_further(seen) {
            if !self.is_released {
                return self.broken("somebody started its job before the others were there");
            }
            // The answer to its start was lost.
            self.set_out(part, news);
        }
        match seen {
            Seen::Queued => Ok(()),
            Seen::Running => {
                self.go(At::Running);
                Ok(())
            }
            Seen::AtBarrier { progress, .. } if self.arrived >= Some(*progress) => Ok(()),
            Seen::AtBarrier { name, progress } => self.arrive(part, name, *progress, news),
            Seen::AtPerson(message) => {
                self.wait_for_person(part, message, news);
                Ok(())
            }
            Seen::Paused(reason) | Seen::Hindered(reason) => self.pause(reason),
            Seen::Done => self.finish(part, news),
            Seen::Ended(reason) => self.broken(reason),
        }
    }

    /// Its job runs.
    pub(super) fn set_out(&mut self, part: usize, news: &mut VecDeque<News>) {
        self.passed += u64::from(self.at == At::Waiting);
        self.go(At::Running);
        self.runs = true;
        self.is_pausing = false;
        news.push_back(News::SetOut { part });
    }

    /// The answer to its start did not come.
    pub(super) const fn lose_sight(&mut self) {
        self.is_unknown = true;
    }

    /// It is about to be started.
    pub(super) fn release(&mut self) {
        self.is_behind = self.start_is_due && self.at == At::Waiting;
        self.start_is_due = false;
        self.is_released = true;
    }

    /// It was not started after all.
    pub(super) fn take_back(&mut self) {
        self.is_released = self.is_behind;
        // At a barrier it waits on, with the others.
        self.start_is_due = self.is_behind || self.at != At::Waiting;
    }

    /// A person has decided that it goes on.
    pub(super) fn go_on(&mut self) {
        if !self.is_held {
            return;
        }
        let stands = matches!(self.at, At::Queued | At::Paused);
        self.start_is_due = stands || self.is_released;
        self.trouble = None;
        self.is_held = false;
        self.is_pausing = false;
    }

    /// Why it cannot go on, whatever a person decides.
    pub(super) fn hindrance(&self) -> Option<String> {
        match &self.at {
            At::Broken(why) => Some(why.clone()),
            _ if self.is_silent => self.trouble.clone(),
            _ => None,
        }
    }

    /// Where it waits for the others, and is not let go on yet.
    pub(super) fn waits_at(&self) -> Option<&str> {
        let waits = self.at == At::Waiting && !self.is_released;
        let barrier = self.barriers.at(self.passed).filter(|_| waits);
        barrier.map(|it| &*it.name)
    }

    /// The barriers that are still before it.
    pub(super) fn ahead(&self) -> BTreeSet<&str> {
        if self.at == At::Through {
            return BTreeSet::new();
        }
        let released = self.is_released && self.at == At::Waiting;
        self.barriers.ahead(self.passed + u64::from(released))
    }

    pub(super) fn is_to_be_paused(&self) -> bool {
        self.is_held && !self.is_pausing && !self.is_silent && self.runs
    }

    pub(super) const fn is_to_be_started(&self) -> bool {
        self.start_is_due && !self.is_held && !self.is_unknown
    }

    pub(super) const fn is_over(&self) -> bool {
        matches!(self.at, At::Through | At::Broken(_))
    }

    /// It is somewhere by itself: a start that was due is not any more.
    fn go(&mut self, to: At) {
        self.at = to;
        self.is_released = false;
        self.start_is_due = false;
    }

    /// Whether its job is further than where it is believed to wait.
    fn is_further(&self, seen: &Seen) -> bool {
        if !matches!(self.at, At::Queued | At::Waiting) {
            return false;
        }
        match seen {
            Seen::AtBarrier { progress, .. } => self.arrived < Some(*progress),
            Seen::Queued | Seen::Hindered(_) | Seen::Ended(_) => false,
            Seen::Running | Seen::Paused(_) | Seen::AtPerson(_) | Seen::Done => true,
        }
    }

    fn arrive(
        &mut self,
        part: usize,
        name: &str,
        progress: (u64, usize),
        news: &mut VecDeque<News>,
    ) -> Result<(), String> {
        let next = self.barriers.at(self.passed).map(|it| it.name.clone());
        if next.as_deref() != Some(name) {
            let next = next.map_or("none".to_owned(), |it| format!("{it:?}"));
            return self.broken(&format!(
                "it waits at the barrier {name:?}, and by its program {next} comes next"
            ));
        }
        self.go(At::Waiting);
        self.arrived = Some(progress);
        news.push_back(News::Arrived {
            part,
            barrier: name.to_owned(),
        });
        Ok(())
    }

    fn wait_for_person(&mut self, part: usize, message: &str, news: &mut VecDeque<News>) {
        let at = At::Person(message.to_owned());
        if self.at != at {
            let message = message.to_owned();
            news.push_back(News::WaitsForPerson { part, message });
        }
        self.go(at);
    }

    /// One that holds is paused because of that, and one that is about to be started still is.
    fn pause(&mut self, reason: &str) -> Result<(), String> {
        let is_starting = self.start_is_due && self.at == At::Paused;
        let was_asked = self.is_held && self.is_pausing || is_starting;
        if matches!(self.at, At::Running | At::Person(_)) {
            self.at = At::Paused;
        }
        if was_asked {
            Ok(())
        } else {
            Err(reason.to_owned())
        }
    }

    fn finish(&mut self, part: usize, news: &mut VecDeque<News>) -> Result<(), String> {
        if let Some(next) = self.barriers.at(self.passed) {
            let next = next.name.clone();
            return self.broken(&format!("it is done before the barrier {next:?}"));
        }
        self.at = At::Through;
        self.is_held = false;
        news.push_back(News::Done { part });
        Ok(())
    }

    fn broken(&mut self, why: &str) -> Result<(), String> {
        self.at = At::Broken(why.to_owned());
        Err(why.to_owned())
    }
}
