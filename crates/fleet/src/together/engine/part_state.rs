//! The state of one part in the engine.

use std::collections::{BTreeSet, VecDeque};
use std::time::Duration;

use super::EngineEvent;
use crate::together::barriers::Barriers;
use crate::together::observation::Observation;

/// The state of one part in the engine.
#[expect(
    clippy::struct_excessive_bools,
    reason = "place, hold and requests change independently"
)]
#[derive(Debug)]
pub(super) struct PartState {
    pub(super) barriers: Barriers,
    /// The number of barriers passed.
    passed: u64,
    pub(super) at: At,
    /// The progress of its job at the last barrier reached.
    arrived: Option<(u64, usize)>,
    /// Whether its job ran at the last observation.
    pub(super) runs: bool,
    /// Released from its barrier, but not yet seen to have started.
    is_released: bool,
    /// The others continued without it.
    was_left: bool,
    /// It has to be started alone.
    start_is_due: bool,
    /// The response to its start is missing, and it was not observed since.
    is_unknown: bool,
    /// The time of the last contact.
    pub(super) last_contact: Duration,
    /// Without contact for too long.
    pub(super) is_silent: bool,
    /// The reason why it does not continue.
    pub(super) trouble: Option<String>,
    /// It must not continue before a person decides so.
    pub(super) is_held: bool,
    /// A pause was requested since it holds.
    pub(super) is_pausing: bool,
}

/// The place of a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum At {
    /// Before its first step.
    Queued,
    Running,
    /// At the next barrier.
    Waiting,
    /// Its program waits for a person.
    Person(String),
    Paused,
    Done,
    /// It cannot be resumed, for this reason.
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
            was_left: false,
            start_is_due: true,
            is_unknown: false,
            last_contact: Duration::ZERO,
            is_silent: false,
            trouble: None,
            is_held: false,
            is_pausing: false,
        }
    }

    /// Handles an observed state.
    ///
    /// # Errors
    ///
    /// The reason why it does not continue, or cannot any more.
    pub(super) fn handle_observation(
        &mut self,
        part: usize,
        seen: &Observation,
        news: &mut VecDeque<EngineEvent>,
    ) -> Result<(), String> {
        self.runs = *seen == Observation::Running;
        self.is_unknown = false;
        if self.is_over() {
            return Ok(());
        }
        if self.is_further(seen) {
            if !self.is_released {
                return self.broken("its job was started before the others had arrived");
            }
            // The response to its start was lost.
            self.set_out(part, news);
        }
        match seen {
            Observation::Queued => Ok(()),
            Observation::Running => {
                self.go(At::Running);
                Ok(())
            }
            Observation::AtBarrier { progress, .. } if self.arrived >= Some(*progress) => Ok(()),
            Observation::AtBarrier { name, progress } => self.arrive(part, name, *progress, news),
            Observation::AtPerson(message) => {
                self.wait_for_person(part, message, news);
                Ok(())
            }
            Observation::Paused(reason) | Observation::Hindered(reason) => self.pause(reason),
            Observation::Done => self.finish(part, news),
            Observation::Ended(reason) => self.broken(reason),
        }
    }

    /// Handles a started job.
    pub(super) fn set_out(&mut self, part: usize, news: &mut VecDeque<EngineEvent>) {
        self.passed += u64::from(self.at == At::Waiting);
        self.go(At::Running);
        self.runs = true;
        self.is_pausing = false;
        news.push_back(EngineEvent::SetOut { part });
    }

    /// Handles a missing response to its start.
    pub(super) const fn lose_sight(&mut self) {
        self.is_unknown = true;
    }

    /// Marks it as about to be started.
    pub(super) fn release(&mut self) {
        self.was_left = self.start_is_due && self.at == At::Waiting;
        self.start_is_due = false;
        self.is_released = true;
    }

    /// Handles a start that was not carried out.
    pub(super) fn take_back(&mut self) {
        self.is_released = self.was_left;
        // At a barrier it keeps waiting with the others.
        self.start_is_due = self.was_left || self.at != At::Waiting;
    }

    /// Resumes on request of a person.
    pub(super) fn resume(&mut self) {
        if !self.is_held {
            return;
        }
        let is_waiting = matches!(self.at, At::Queued | At::Paused);
        self.start_is_due = is_waiting || self.is_released;
        self.trouble = None;
        self.is_held = false;
        self.is_pausing = false;
    }

    /// Returns the reason why it cannot be resumed at all.
    pub(super) fn obstacle(&self) -> Option<String> {
        match &self.at {
            At::Broken(why) => Some(why.clone()),
            _ if self.is_silent => self.trouble.clone(),
            _ => None,
        }
    }

    /// Returns the barrier at which it waits unreleased.
    pub(super) fn waits_at(&self) -> Option<&str> {
        let waits = self.at == At::Waiting && !self.is_released;
        let barrier = self.barriers.at(self.passed).filter(|_| waits);
        barrier.map(|barrier| &*barrier.name)
    }

    /// Returns the names of its remaining barriers.
    pub(super) fn ahead(&self) -> BTreeSet<&str> {
        if self.at == At::Done {
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
        matches!(self.at, At::Done | At::Broken(_))
    }

    /// Changes its place by itself: a due start is dropped.
    fn go(&mut self, to: At) {
        self.at = to;
        self.is_released = false;
        self.start_is_due = false;
    }

    /// Whether its job is past the barrier at which it should wait.
    fn is_further(&self, seen: &Observation) -> bool {
        if !matches!(self.at, At::Queued | At::Waiting) {
            return false;
        }
        match seen {
            Observation::AtBarrier { progress, .. } => self.arrived < Some(*progress),
            Observation::Queued | Observation::Hindered(_) | Observation::Ended(_) => false,
            Observation::Running
            | Observation::Paused(_)
            | Observation::AtPerson(_)
            | Observation::Done => true,
        }
    }

    fn arrive(
        &mut self,
        part: usize,
        name: &str,
        progress: (u64, usize),
        news: &mut VecDeque<EngineEvent>,
    ) -> Result<(), String> {
        let next = self.barriers.at(self.passed).map(|at| at.name.clone());
        if next.as_deref() != Some(name) {
            let next = next.map_or("none".to_owned(), |name| format!("{name:?}"));
            return self.broken(&format!(
                "it waits at the barrier {name:?}, but the next one of its program is {next}"
            ));
        }
        self.go(At::Waiting);
        self.arrived = Some(progress);
        news.push_back(EngineEvent::Arrived {
            part,
            barrier: name.to_owned(),
        });
        Ok(())
    }

    fn wait_for_person(&mut self, part: usize, message: &str, news: &mut VecDeque<EngineEvent>) {
        let at = At::Person(message.to_owned());
        if self.at != at {
            let message = message.to_owned();
            news.push_back(EngineEvent::WaitsForPerson { part, message });
        }
        self.go(at);
    }

    /// Handles a pause: holding explains it, and a pending start stays pending.
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

    fn finish(&mut self, part: usize, news: &mut VecDeque<EngineEvent>) -> Result<(), String> {
        if let Some(next) = self.barriers.at(self.passed) {
            let next = next.name.clone();
            return self.broken(&format!("it finished before the barrier {next:?}"));
        }
        self.at = At::Done;
        self.is_held = false;
        news.push_back(EngineEvent::Done { part });
        Ok(())
    }

    fn broken(&mut self, why: &str) -> Result<(), String> {
        self.at = At::Broken(why.to_owned());
        Err(why.to_owned())
    }
}
