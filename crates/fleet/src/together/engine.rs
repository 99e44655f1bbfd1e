//! The engine of a coordinated program: decides which parts start, wait and hold.

mod depends;
mod part_state;

use std::collections::{BTreeSet, VecDeque};
use std::time::Duration;

use serde::Serialize;

use self::depends::dependents;
use self::part_state::{At, PartState};
use super::barriers::Barriers;
use super::observation::Observation;

/// Keeps the parts in step. Knows no clock, no network and no rules of an arm.
///
/// A part is identified by its index.
#[derive(Debug)]
pub(super) struct Engine {
    parts: Vec<PartState>,
    news: VecDeque<EngineEvent>,
}

/// An action to carry out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Action {
    /// Start or resume the jobs of these parts simultaneously; report the results to
    /// [`Engine::handle_starts`].
    Start {
        /// The barrier at which they were, if all have met there.
        barrier: Option<String>,
        /// The parts.
        parts: Vec<usize>,
    },
    /// Pause the job of this part.
    Pause(usize),
}

/// The result of starting one part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Start {
    /// The job runs.
    Done,
    /// The station refused it for this reason; the job does not run.
    Refused(String),
    /// No response, for this reason; the job may run or not.
    Unclear(String),
    /// Not tried, since another part cannot be started.
    NotTried,
}

/// An event for the user.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum EngineEvent {
    /// A part has arrived at a barrier.
    Arrived {
        /// The part.
        part: usize,
        /// The barrier.
        barrier: String,
    },
    /// A part starts or resumes.
    SetOut {
        /// The part.
        part: usize,
    },
    /// A part waits for a person, with this message; the others continue to their barriers.
    WaitsForPerson {
        /// The part.
        part: usize,
        /// The message.
        message: String,
    },
    /// A part has finished.
    Done {
        /// The part.
        part: usize,
    },
    /// A part cannot continue, and the parts that depend on it hold.
    Held {
        /// The part.
        part: usize,
        /// The reason.
        why: String,
        /// The parts that hold with it.
        with: Vec<usize>,
    },
}

impl Engine {
    /// Returns an engine for parts whose jobs are queued. All are started simultaneously.
    pub(super) fn new(parts: Vec<Barriers>) -> Self {
        Self {
            parts: parts.into_iter().map(PartState::new).collect(),
            news: VecDeque::new(),
        }
    }

    /// Handles the observed state of a part.
    pub(super) fn handle_state(&mut self, now: Duration, part: usize, seen: &Observation) {
        self.parts[part].last_contact = now;
        self.parts[part].is_silent = false;
        if let Err(why) = self.parts[part].handle_observation(part, seen, &mut self.news) {
            self.trouble(part, &why);
        }
    }

    /// Handles a missing state of a part, for this reason.
    pub(super) fn handle_silent(&mut self, now: Duration, part: usize, why: &str) {
        let state = &mut self.parts[part];
        if state.at == At::Done || now.saturating_sub(state.last_contact) < CONTACT_WITHIN {
            return;
        }
        state.is_silent = true;
        self.trouble(part, &format!("no contact: {why}"));
    }

    /// Handles the results of starts.
    pub(super) fn handle_starts(&mut self, starts: &[(usize, Start)]) {
        let rests = |start: &Start| matches!(start, Start::NotTried | Start::Refused(_));
        let all_rest = starts.iter().all(|start| rests(&start.1));
        for (part, start) in starts {
            let state = &mut self.parts[*part];
            match start {
                Start::Done => state.set_out(*part, &mut self.news),
                Start::Unclear(_) => state.lose_sight(),
                // If others have started, it is late and is started alone.
                _ if all_rest => state.take_back(),
                _ => {}
            }
        }
        for (part, start) in starts {
            if let Start::Refused(why) | Start::Unclear(why) = start {
                self.trouble(*part, &format!("it does not start: {why}"));
            }
        }
    }

    /// Handles a failed pause, which is retried.
    pub(super) fn handle_not_paused(&mut self, part: usize) {
        self.parts[part].is_pausing = false;
    }

    /// Makes all parts hold on request of a person.
    pub(super) fn hold_all(&mut self, why: &str) {
        for part in 0..self.parts.len() {
            if !self.parts[part].is_over() {
                self.trouble(part, why);
            }
        }
    }

    /// Resumes the holding parts on request of a person. Returns the parts that cannot, with the
    /// reason; parts that depend on one of them keep holding.
    pub(super) fn resume(&mut self) -> Vec<(usize, String)> {
        let parts = self.parts.iter().enumerate();
        let hindered = parts.filter_map(|(part, state)| Some((part, state.obstacle()?)));
        let hindered: Vec<_> = hindered.collect();
        let ahead: Vec<_> = self.parts.iter().map(PartState::ahead).collect();
        let mut hold: BTreeSet<usize> = hindered.iter().map(|entry| entry.0).collect();
        for (part, _) in &hindered {
            hold.extend(dependents(&ahead, *part));
        }
        for (part, state) in self.parts.iter_mut().enumerate() {
            if !hold.contains(&part) {
                state.resume();
            }
        }
        hindered
    }

    /// Returns the next action.
    pub(super) fn poll_action(&mut self) -> Option<Action> {
        if let Some(part) = self.parts.iter().position(PartState::is_to_be_paused) {
            self.parts[part].is_pausing = true;
            return Some(Action::Pause(part));
        }
        let due: Vec<usize> = self.those(PartState::is_to_be_started);
        if !due.is_empty() {
            return Some(self.start(None, due));
        }
        let barrier = self.complete()?;
        let parts = self.those(|part| part.barriers.has(&barrier));
        Some(self.start(Some(barrier), parts))
    }

    /// Returns the next event for the user.
    pub(super) fn poll_news(&mut self) -> Option<EngineEvent> {
        self.news.pop_front()
    }

    /// Whether all parts have finished.
    pub(super) fn is_over(&self) -> bool {
        self.parts.iter().all(|part| part.at == At::Done)
    }

    /// Whether a part holds.
    #[cfg(test)]
    pub(super) fn is_held(&self, part: usize) -> bool {
        self.parts[part].is_held
    }

    /// Whether the holding parts are at rest, or without contact.
    pub(super) fn is_at_rest(&self) -> bool {
        let moves =
            |part_state: &PartState| part_state.is_held && part_state.runs && !part_state.is_silent;
        !self.parts.iter().any(moves)
    }

    /// Whether nothing continues without a person: each part has finished, or holds at rest or
    /// without contact.
    pub(super) fn all_hold(&self) -> bool {
        let rests = |part: &PartState| part.is_held && (part.is_silent || !part.runs);
        let mut parts = self.parts.iter();
        parts.all(|part| part.at == At::Done || rests(part))
    }

    fn start(&mut self, barrier: Option<String>, parts: Vec<usize>) -> Action {
        for &part in &parts {
            self.parts[part].release();
        }
        Action::Start { barrier, parts }
    }

    /// Returns a barrier at which all parts with it wait, and none of them holds.
    fn complete(&self) -> Option<String> {
        let waiting = self.parts.iter().filter_map(PartState::waits_at);
        let is_complete = |name: &&str| {
            let mut all = self.parts.iter().filter(|part| part.barriers.has(name));
            all.all(|part| !part.is_held && part.waits_at() == Some(*name))
        };
        waiting.into_iter().find(is_complete).map(str::to_owned)
    }

    /// Handles a problem of a part: all parts that depend on it hold.
    fn trouble(&mut self, part: usize, why: &str) {
        if self.parts[part].trouble.as_deref() == Some(why) {
            return;
        }
        self.parts[part].trouble = Some(why.to_owned());
        let ahead: Vec<_> = self.parts.iter().map(PartState::ahead).collect();
        let with = dependents(&ahead, part);
        for &index in with.iter().chain([&part]) {
            self.parts[index].is_held = true;
        }
        self.news.push_back(EngineEvent::Held {
            part,
            why: why.to_owned(),
            with,
        });
    }

    fn those(&self, is_so: impl Fn(&PartState) -> bool) -> Vec<usize> {
        let parts = self.parts.iter().enumerate();
        parts
            .filter(|entry| is_so(entry.1))
            .map(|entry| entry.0)
            .collect()
    }
}

/// The time without contact after which a part, and those that depend on it, hold.
const CONTACT_WITHIN: Duration = Duration::from_secs(3);
