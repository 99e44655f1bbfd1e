//! The engine: which part waits where, when all go on, and who holds when one does not.

mod depends;
mod part_state;

use std::collections::{BTreeSet, VecDeque};
use std::time::Duration;

use serde::Serialize;

use self::depends::dependents;
use self::part_state::{At, PartState};
use super::barriers::Barriers;
use super::seen::Seen;

/// Keeps the parts in step, and decides nothing else: no clock, no network, no rules of an arm.
///
/// A part is known by its number, in the order in which they were given.
#[derive(Debug)]
pub(super) struct Engine {
    parts: Vec<PartState>,
    news: VecDeque<News>,
}

/// What is to be done.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Wish {
    /// The jobs of these parts are to be started, or gone on with, at the same time; [`Engine::handle_starts`] takes what has
    /// become of it.
    Start {
        /// At which barrier they were, if it is one at which all were waited for.
        barrier: Option<String>,
        /// Which.
        parts: Vec<usize>,
    },
    /// The job of this part is to be paused.
    Pause(usize),
}

/// What became of the start of one part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Start {
    /// Its job runs.
    Done,
    /// Its station has refused it, for this reason: its job does not run.
    Refused(String),
    /// No answer came, for this reason: its job may run or not.
    Unclear(String),
    /// It was not tried, since another one cannot be started.
    NotTried,
}

/// What a person wants to know.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum News {
    /// A part has come to a barrier.
    Arrived {
        /// Which.
        part: usize,
        /// The barrier.
        barrier: String,
    },
    /// A part goes on, or begins.
    SetOut {
        /// Which.
        part: usize,
    },
    /// A part waits for a person, with this text; the others go on as far as their barriers.
    WaitsForPerson {
        /// Which.
        part: usize,
        /// The text.
        message: String,
    },
    /// A part is through.
    Done {
        /// Which.
        part: usize,
    },
    /// A part does not go on, and those that depend on it hold.
    Held {
        /// Which.
        part: usize,
        /// Why.
        why: String,
        /// Those that hold with it.
        with: Vec<usize>,
    },
}

impl Engine {
    /// Parts whose jobs are queued. They are all started together.
    pub(super) fn new(parts: Vec<Barriers>) -> Self {
        Self {
            parts: parts.into_iter().map(PartState::new).collect(),
            news: VecDeque::new(),
        }
    }

    /// Takes what is seen of a part.
    pub(super) fn handle_seen(&mut self, now: Duration, part: usize, seen: &Seen) {
        self.parts[part].heard = now;
        self.parts[part].is_silent = false;
        if let Err(why) = self.parts[part].see(part, seen, &mut self.news) {
            self.trouble(part, &why);
        }
    }

    /// Takes that a part is not heard of, for this reason.
    pub(super) fn handle_silent(&mut self, now: Duration, part: usize, why: &str) {
        let it = &mut self.parts[part];
        if it.at == At::Through || now.saturating_sub(it.heard) < HEARD_WITHIN {
            return;
        }
        it.is_silent = true;
        self.trouble(part, &format!("it is not heard of: {why}"));
    }

    /// Takes what became of the starts of a wish.
    pub(super) fn handle_starts(&mut self, starts: &[(usize, Start)]) {
        let rests = |it: &Start| matches!(it, Start::NotTried | Start::Refused(_));
        let all_rest = starts.iter().all(|it| rests(&it.1));
        for (part, start) in starts {
            let it = &mut self.parts[*part];
            match start {
                Start::Done => it.set_out(*part, &mut self.news),
                Start::Unclear(_) => it.lose_sight(),
                // Where others have set out it is behind them, and is started by itself.
                _ if all_rest => it.take_back(),
                _ => {}
            }
        }
        for (part, start) in starts {
            if let Start::Refused(why) | Start::Unclear(why) = start {
                self.trouble(*part, &format!("it does not start: {why}"));
            }
        }
    }

    /// Takes that a part could not be paused; that is tried again.
    pub(super) fn handle_not_paused(&mut self, part: usize) {
        self.parts[part].is_pausing = false;
    }

    /// Has all parts hold, because a person wants it.
    pub(super) fn hold_all(&mut self, why: &str) {
        for part in 0..self.parts.len() {
            if !self.parts[part].is_over() {
                self.trouble(part, why);
            }
        }
    }

    /// Has those parts go on that hold, because a person has decided so. Gives the parts that cannot, and why: those that
    /// depend on one of them hold on.
    pub(super) fn go_on(&mut self) -> Vec<(usize, String)> {
        let parts = self.parts.iter().enumerate();
        let hindered = parts.filter_map(|(part, it)| Some((part, it.hindrance()?)));
        let hindered: Vec<_> = hindered.collect();
        let ahead: Vec<_> = self.parts.iter().map(PartState::ahead).collect();
        let mut hold: BTreeSet<usize> = hindered.iter().map(|it| it.0).collect();
        for (part, _) in &hindered {
            hold.extend(dependents(&ahead, *part));
        }
        for (part, it) in self.parts.iter_mut().enumerate() {
            if !hold.contains(&part) {
                it.go_on();
            }
        }
        hindered
    }

    /// What is to be done next.
    pub(super) fn poll_wish(&mut self) -> Option<Wish> {
        if let Some(part) = self.parts.iter().position(PartState::is_to_be_paused) {
            self.parts[part].is_pausing = true;
            return Some(Wish::Pause(part));
        }
        let due: Vec<usize> = self.those(PartState::is_to_be_started);
        if !due.is_empty() {
            return Some(self.start(None, due));
        }
        let barrier = self.complete()?;
        let parts = self.those(|it| it.barriers.has(&barrier));
        Some(self.start(Some(barrier), parts))
    }

    /// What a person wants to know next.
    pub(super) fn poll_news(&mut self) -> Option<News> {
        self.news.pop_front()
    }

    /// Whether all parts are through.
    pub(super) fn is_over(&self) -> bool {
        self.parts.iter().all(|it| it.at == At::Through)
    }

    /// Whether a part holds.
    #[cfg(test)]
    pub(super) fn is_held(&self, part: usize) -> bool {
        self.parts[part].is_held
    }

    /// Whether those that hold are at rest, or not heard of.
    pub(super) fn is_at_rest(&self) -> bool {
        let moves = |it: &PartState| it.is_held && it.runs && !it.is_silent;
        !self.parts.iter().any(moves)
    }

    /// Whether nothing goes on any more without a person: each part is over, or holds and is at rest or not heard of.
    pub(super) fn all_hold(&self) -> bool {
        let rests = |it: &PartState| it.is_held && (it.is_silent || !it.runs);
        let mut parts = self.parts.iter();
        parts.all(|it| it.at == At::Through || rests(it))
    }

    fn start(&mut self, barrier: Option<String>, parts: Vec<usize>) -> Wish {
        for &part in &parts {
            self.parts[part].release();
        }
        Wish::Start { barrier, parts }
    }

    /// A barrier at which all wait that have it, and none of them holds.
    fn complete(&self) -> Option<String> {
        let waiting = self.parts.iter().filter_map(PartState::waits_at);
        let is_complete = |name: &&str| {
            let mut all = self.parts.iter().filter(|it| it.barriers.has(name));
            all.all(|it| !it.is_held && it.waits_at() == Some(*name))
        };
        waiting.into_iter().find(is_complete).map(str::to_owned)
    }

    /// A part does not go on: all that depend on it hold.
    fn trouble(&mut self, part: usize, why: &str) {
        if self.parts[part].trouble.as_deref() == Some(why) {
            return;
        }
        self.parts[part].trouble = Some(why.to_owned());
        let ahead: Vec<_> = self.parts.iter().map(PartState::ahead).collect();
        let with = dependents(&ahead, part);
        for &it in with.iter().chain([&part]) {
            self.parts[it].is_held = true;
        }
        self.news.push_back(News::Held {
            part,
            why: why.to_owned(),
            with,
        });
    }

    fn those(&self, is_so: impl Fn(&PartState) -> bool) -> Vec<usize> {
        let parts = self.parts.iter().enumerate();
        parts.filter(|it| is_so(it.1)).map(|it| it.0).collect()
    }
}

/// A part that was not heard of for so long holds all that depend on it.
const HEARD_WITHIN: Duration = Duration::from_secs(3);
