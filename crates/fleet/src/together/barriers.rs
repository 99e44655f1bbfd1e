//! The barriers of a part, in execution order.

use std::collections::{BTreeSet, HashSet};
use std::sync::Arc;

use dobot_teach::Compiled;

/// The barriers of a part, in execution order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Barriers {
    once: Vec<Barrier>,
    /// The barriers that repeat after the others.
    cycle: Vec<Barrier>,
    /// The number of repetitions; `None` until a person ends it.
    times: Option<u64>,
}

/// A step of a part at which its arm waits for others.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Barrier {
    /// The name: all parts with this name wait for each other.
    pub(super) name: Arc<str>,
    /// The step, counted from 1 in execution order.
    pub(super) step: usize,
    /// The called program that contains it; none in the program itself.
    pub(super) file: Option<Arc<str>>,
    /// The line on which it begins, counted from 1.
    pub(super) line: usize,
}

impl Barriers {
    /// Returns the barriers of a program.
    pub(super) fn of(program: &Compiled) -> Self {
        let mut all = Self {
            times: Some(0),
            ..Self::default()
        };
        for (index, step) in program.steps.iter().enumerate() {
            let Some(name) = &step.barrier else {
                continue;
            };
            let barrier = Barrier {
                name: name.clone(),
                step: index + 1,
                file: step.file.clone(),
                line: step.line,
            };
            match program.repeat {
                Some(repeat) if step.first >= repeat.from => all.cycle.push(barrier),
                _ => all.once.push(barrier),
            }
        }
        if let Some(repeat) = program.repeat.filter(|_| !all.cycle.is_empty()) {
            all.times = repeat.times;
        }
        all
    }

    #[cfg(test)]
    pub(super) const fn of_lists(
        once: Vec<Barrier>,
        cycle: Vec<Barrier>,
        times: Option<u64>,
    ) -> Self {
        Self { once, cycle, times }
    }

    /// Returns the next barrier after this many have been passed; `None` after the last one.
    pub(super) fn at(&self, passed: u64) -> Option<&Barrier> {
        let once = self.once.len() as u64;
        let place = self.place(passed);
        let (list, index) = match passed.checked_sub(once) {
            None => (&self.once, place),
            Some(_) if self.is_over(passed) => return None,
            Some(_) => (&self.cycle, place - once),
        };
        list.get(usize::try_from(index).ok()?)
    }

    /// Returns the names of the remaining barriers after this many have been passed.
    pub(super) fn ahead(&self, passed: u64) -> BTreeSet<&str> {
        if self.is_over(passed) {
            return BTreeSet::new();
        }
        let once = self.once.len() as u64;
        let skipped = usize::try_from(passed.min(once)).unwrap_or(usize::MAX);
        let is_last = |index: u64| self.times.is_some_and(|times| index + 1 >= times);
        let len = self.cycle.len().max(1) as u64;
        // In the last cycle, the barriers already passed do not return.
        let passed_in_cycle = match passed.checked_sub(once) {
            Some(within) if is_last(within / len) => within % len,
            _ => 0,
        };
        let passed_in_cycle = usize::try_from(passed_in_cycle).unwrap_or(usize::MAX);
        let cycle = if self.times == Some(0) {
            &[][..]
        } else {
            &self.cycle
        };
        let ahead = self.once.iter().skip(skipped);
        let ahead = ahead.chain(cycle.iter().skip(passed_in_cycle));
        ahead.map(|barrier| &*barrier.name).collect()
    }

    /// Whether a barrier has this name.
    pub(super) fn has(&self, name: &str) -> bool {
        self.all().any(|barrier| *barrier.name == *name)
    }

    /// Returns all barriers; those of a cycle once.
    pub(super) fn all(&self) -> impl Iterator<Item = &Barrier> {
        self.once.iter().chain(&self.cycle)
    }

    /// Whether it repeats until a person ends it.
    pub(super) fn never_ends(&self) -> bool {
        self.times.is_none()
    }

    /// Returns the place among all barriers: in a cycle it is the same each time.
    fn place(&self, passed: u64) -> u64 {
        let once = self.once.len() as u64;
        match passed.checked_sub(once) {
            Some(within) => once + within.checked_rem(self.cycle.len() as u64).unwrap_or(0),
            None => passed,
        }
    }

    fn is_over(&self, passed: u64) -> bool {
        let Some(within) = passed.checked_sub(self.once.len() as u64) else {
            return false;
        };
        let cycles = within.checked_div(self.cycle.len() as u64);
        cycles.is_none_or(|cycles| self.times.is_some_and(|times| cycles >= times))
    }
}

/// The course of the parts through their barriers, without faults.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Course {
    /// To their ends, or for ever if they never end.
    Done,
    /// To a deadlock: the number of barriers that each part has passed.
    Stuck(Vec<u64>),
    /// Too many barriers to check.
    TooLong,
}

/// Follows all parts through their barriers. The order of releases makes no difference: each part
/// has one order of its own.
pub(super) fn course(parts: &[&Barriers]) -> Course {
    let mut passed = vec![0; parts.len()];
    let mut been = HashSet::new();
    for _ in 0..MAX_RELEASES {
        let next = next_barriers(parts, &passed);
        if next.iter().all(Option::is_none) {
            return Course::Done;
        }
        let Some(name) = meeting(parts, &next) else {
            return Course::Stuck(passed);
        };
        for (next, passed) in next.iter().zip(&mut passed) {
            *passed += u64::from(next.is_some_and(|barrier| barrier.name == name));
        }
        let rest = parts.iter().zip(&passed);
        let only_endless = rest
            .clone()
            .all(|(barriers, n)| barriers.never_ends() || barriers.at(*n).is_none());
        let places: Vec<u64> = rest.map(|(barriers, n)| barriers.place(*n)).collect();
        if only_endless && !been.insert(places) {
            return Course::Done;
        }
    }
    Course::TooLong
}

/// Returns the barrier that each part waits at next, after a number of barriers; `None` if it has passed
/// all.
pub(super) fn next_barriers<'a>(
    parts: &[&'a Barriers],
    passed: &[u64],
) -> Vec<Option<&'a Barrier>> {
    let parts = parts.iter().zip(passed);
    parts.map(|(barriers, n)| barriers.at(*n)).collect()
}

/// Returns a barrier at which all parts with it have arrived.
fn meeting(parts: &[&Barriers], next: &[Option<&Barrier>]) -> Option<Arc<str>> {
    let names = next.iter().flatten().map(|barrier| &barrier.name);
    let is_met = |name: &&Arc<str>| {
        let mut both = parts.iter().zip(next);
        both.all(|(part, next)| {
            !part.has(name) || next.is_some_and(|barrier| barrier.name == **name)
        })
    };
    names.into_iter().find(is_met).cloned()
}

/// The maximum number of releases that are checked.
const MAX_RELEASES: usize = 1_000_000;
