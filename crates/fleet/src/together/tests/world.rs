//! Simulated stations whose jobs go from barrier to barrier.

use std::collections::BTreeSet;
use std::time::Duration;

use dobot_geometry::Random;

use super::barriers;
use crate::together::engine::{Action, Engine, EngineEvent, Start};
use crate::together::observation::Observation;

/// The kinds of faults.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Faults {
    None,
    /// Persons pause.
    Pauses,
    /// Persons pause, stations fall silent or refuse to start, and responses are lost.
    All,
}

/// Stations with their jobs, and the engine.
pub(super) struct World {
    desks: Vec<Desk>,
    engine: Engine,
    random: Random,
    faults: Faults,
    now: Duration,
    /// The parts that have to hold now.
    expected: BTreeSet<usize>,
}

/// A station with its job.
#[derive(Debug)]
struct Desk {
    script: Vec<u8>,
    /// The number of barriers passed.
    passed: usize,
    is: Is,
    /// The end of its silence.
    silent_until: Duration,
    /// The number of barriers passed when the engine last knew.
    known: usize,
    refuses_next: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Is {
    Queued,
    Running,
    AtBarrier,
    Paused,
    Done,
}

impl World {
    pub(super) fn new(scripts: Vec<Vec<u8>>, seed: u64, faults: Faults) -> Self {
        let engine = Engine::new(
            scripts
                .iter()
                .map(|script| barriers(script, &[], Some(0)))
                .collect(),
        );
        let desks = scripts.into_iter().map(|script| Desk {
            script,
            passed: 0,
            is: Is::Queued,
            silent_until: Duration::ZERO,
            known: 0,
            refuses_next: false,
        });
        Self {
            desks: desks.collect(),
            engine,
            random: Random::new(seed),
            faults,
            now: Duration::ZERO,
            expected: BTreeSet::new(),
        }
    }

    /// Runs until all parts have finished; after some time there are no more faults.
    pub(super) fn come_through(&mut self) {
        for round in 0..20_000 {
            if self.engine.is_over() {
                return;
            }
            if round == 300 {
                self.faults = Faults::None;
            }
            self.move_on();
            self.round();
            if self.engine.all_hold() {
                self.resume();
            }
        }
        panic!("they do not finish: {:?} {:?}", self.desks, self.engine);
    }

    /// Starts all parts for the first time.
    pub(super) fn start(&mut self) {
        self.round();
    }

    pub(super) fn run_to_barrier(&mut self, part: usize) {
        assert_eq!(self.desks[part].is, Is::Running);
        self.desks[part].is = Is::AtBarrier;
        self.round();
    }

    /// A person starts the job where it waits.
    pub(super) fn start_by_hand(&mut self, part: usize) {
        assert_eq!(self.desks[part].is, Is::AtBarrier);
        self.desks[part].passed += 1;
        self.desks[part].is = Is::Running;
        self.round();
        self.round();
    }

    pub(super) fn refuse_next_start(&mut self, part: usize) {
        self.desks[part].refuses_next = true;
    }

    /// Silences a station; returns the parts that hold after that, and not before three seconds
    /// have passed.
    pub(super) fn silent_until_held(&mut self, part: usize) -> Vec<usize> {
        let since = self.now;
        self.desks[part].silent_until = Duration::MAX;
        while self.held().is_empty() {
            self.round();
            assert!(self.now < since + Duration::from_secs(5), "no part holds");
        }
        let took = self.now.saturating_sub(since);
        assert!(took >= Duration::from_secs(3), "{took:?}");
        self.held()
    }

    pub(super) fn held(&self) -> Vec<usize> {
        (0..self.desks.len())
            .filter(|item| self.engine.is_held(*item))
            .collect()
    }

    pub(super) fn is_paused(&self, part: usize) -> bool {
        self.desks[part].is == Is::Paused
    }

    pub(super) fn is_queued(&self, part: usize) -> bool {
        self.desks[part].is == Is::Queued
    }

    pub(super) fn resume(&mut self) -> Vec<(usize, String)> {
        self.expected.clear();
        let hindered = self.engine.resume();
        if self.faults == Faults::Pauses {
            assert!(hindered.is_empty(), "{hindered:?}");
        }
        hindered
    }

    /// Advances the arms.
    fn move_on(&mut self) {
        for part in 0..self.desks.len() {
            let (moves, goes_wrong) = (self.random.chance(30.0), self.random.chance(4.0));
            let desk = &mut self.desks[part];
            if desk.is == Is::Running && moves {
                let is_through = desk.passed == desk.script.len();
                desk.is = if is_through { Is::Done } else { Is::AtBarrier };
            } else if desk.is == Is::Running && goes_wrong && self.faults != Faults::None {
                desk.is = Is::Paused;
            } else if goes_wrong && self.faults == Faults::All {
                desk.silent_until =
                    self.now + Duration::from_millis(self.random.below(8_000).into());
            }
        }
    }

    fn round(&mut self) {
        self.now += Duration::from_millis(200);
        for part in 0..self.desks.len() {
            if self.desks[part].silent_until > self.now {
                self.engine
                    .handle_silent(self.now, part, "the network is gone");
            } else {
                let seen = self.desks[part].seen();
                self.desks[part].known = self.desks[part].passed;
                self.engine.handle_state(self.now, part, &seen);
            }
            self.follow();
        }
        let actions: Vec<Action> = std::iter::from_fn(|| self.engine.poll_action()).collect();
        for action in actions {
            match action {
                Action::Pause(part) => self.pause(part),
                Action::Start { parts, .. } => self.start_all(&parts),
            }
        }
        self.follow();
        self.check_held();
    }

    fn pause(&mut self, part: usize) {
        let desk = &mut self.desks[part];
        if desk.silent_until > self.now {
            self.engine.handle_not_paused(part);
        } else if desk.is == Is::Running {
            desk.is = Is::Paused;
        }
    }

    /// If one part is refused from the outset, none is started.
    fn start_all(&mut self, parts: &[usize]) {
        let refuses = |index: &usize| self.desks[*index].refuses_next;
        if let Some(refusing) = parts.iter().copied().find(refuses) {
            self.desks[refusing].refuses_next = false;
            let start = |index: usize| {
                if index == refusing {
                    Start::Refused("the arm is not there".into())
                } else {
                    Start::NotTried
                }
            };
            let starts: Vec<_> = parts.iter().map(|index| (*index, start(*index))).collect();
            return self.engine.handle_starts(&starts);
        }
        let mut starts = Vec::new();
        for &part in parts {
            starts.push((part, self.start_one(part)));
        }
        self.engine.handle_starts(&starts);
    }

    fn start_one(&mut self, part: usize) -> Start {
        let fate = match self.faults {
            Faults::All => self.random.below(30),
            _ => 10,
        };
        match fate {
            0 => return Start::Refused("the arm still moves".into()),
            1 => return Start::Unclear("the request was lost".into()),
            _ => {}
        }
        self.check_is_released(part);
        let desk = &mut self.desks[part];
        desk.passed += usize::from(desk.is == Is::AtBarrier);
        desk.is = Is::Running;
        if fate == 2 {
            return Start::Unclear("the response was lost".into());
        }
        desk.known = desk.passed;
        Start::Done
    }

    /// Checks that a part passes a barrier only after all have reached it.
    fn check_is_released(&self, part: usize) {
        let desk = &self.desks[part];
        if desk.is != Is::AtBarrier {
            return;
        }
        let name = desk.script[desk.passed];
        let time = desk.arrivals(name);
        for (other, desk) in self.desks.iter().enumerate() {
            if desk.script.contains(&name) {
                let arrivals = desk.arrivals(name);
                assert!(
                    arrivals >= time,
                    "{part} passes {name} before {other} has arrived"
                );
            }
        }
    }

    fn follow(&mut self) {
        while let Some(news) = self.engine.poll_news() {
            if let EngineEvent::Held { part, with, .. } = news
                && self.faults == Faults::Pauses
            {
                let expected = self.depend_on(part);
                assert_eq!(with.into_iter().collect::<BTreeSet<_>>(), expected);
                self.expected.extend(expected);
                self.expected.insert(part);
            }
        }
    }

    /// Checks that no other part holds.
    fn check_held(&self) {
        if self.faults == Faults::Pauses {
            let held: BTreeSet<usize> = self.held().into_iter().collect();
            let open = |index: &&usize| self.desks[**index].is != Is::Done;
            let expected = self.expected.iter().filter(open).copied().collect();
            let held = held.iter().filter(open).copied().collect::<BTreeSet<_>>();
            assert_eq!(held, expected);
        }
    }

    /// Returns the parts that share a remaining barrier with a part, directly or through others.
    fn depend_on(&self, part: usize) -> BTreeSet<usize> {
        let ahead = |index: &Desk| -> BTreeSet<u8> {
            index.script[index.known..].iter().copied().collect()
        };
        let mut names = ahead(&self.desks[part]);
        for _ in 0..self.desks.len() {
            let near = self
                .desks
                .iter()
                .map(ahead)
                .filter(|ahead| !ahead.is_disjoint(&names));
            names = near.flatten().chain(names.clone()).collect();
        }
        let depends =
            |index: &usize| *index != part && !ahead(&self.desks[*index]).is_disjoint(&names);
        (0..self.desks.len()).filter(depends).collect()
    }
}

impl Desk {
    fn seen(&self) -> Observation {
        match self.is {
            Is::Queued => Observation::Queued,
            Is::Running => Observation::Running,
            Is::AtBarrier => Observation::AtBarrier {
                name: self.script[self.passed].to_string(),
                progress: (0, self.passed + 1),
            },
            Is::Paused => Observation::Paused("paused by Anna".into()),
            Is::Done => Observation::Done,
        }
    }

    /// How many times it has reached a barrier.
    fn arrivals(&self, name: u8) -> usize {
        let upto = self.passed + usize::from(self.is == Is::AtBarrier);
        let names = self.script.iter().take(upto);
        names.filter(|passed| **passed == name).count()
    }
}
