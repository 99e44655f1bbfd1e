//! Parts in a world where persons pause, responses are lost and stations fall silent; and
//! rehearsals.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod rehearsals;
mod world;

use std::collections::BTreeSet;
use std::sync::Arc;

use proptest::prelude::*;

use self::world::{Faults, World};
use super::barriers::{Barrier, Barriers, Course, course};

/// Barriers by name: some once, then some repeatedly.
pub(super) fn barriers(once: &[u8], cycle: &[u8], times: Option<u64>) -> Barriers {
    let named = |names: &[u8]| -> Vec<Barrier> {
        let named = names.iter().map(|name| Barrier {
            name: Arc::from(name.to_string()),
            step: 1,
            file: None,
            line: 1,
        });
        named.collect()
    };
    Barriers::of_lists(named(once), named(cycle), times)
}

/// The barriers that each part reaches, in order: all parts meet in one order.
fn meetings() -> impl Strategy<Value = Vec<Vec<u8>>> {
    let who = prop::collection::vec(prop::collection::btree_set(0..5_usize, 2..=4), 4);
    let order = prop::collection::vec(0..4_u8, 0..12);
    (who, order).prop_map(|(who, order)| {
        let of_part = |part: usize| {
            let names = order.iter().copied();
            names
                .filter(|index| who[usize::from(*index)].contains(&part))
                .collect()
        };
        (0..5).map(of_part).collect()
    })
}

/// Whether all parts reach their ends, by brute force.
fn come_through(parts: &[Vec<u8>], seed: u64) -> bool {
    let mut random = dobot_geometry::Random::new(seed);
    let mut passed = vec![0; parts.len()];
    loop {
        let next: Vec<_> = parts
            .iter()
            .zip(&passed)
            .map(|(names, n)| names.get(*n).copied())
            .collect();
        let waiting: BTreeSet<u8> = next.iter().flatten().copied().collect();
        if waiting.is_empty() {
            return true;
        }
        let is_met = |name: &u8| {
            let mut having = parts.iter().zip(&next).filter(|part| part.0.contains(name));
            having.all(|entry| *entry.1 == Some(*name))
        };
        let met: Vec<u8> = waiting.into_iter().filter(is_met).collect();
        if met.is_empty() {
            return false;
        }
        let chosen = met[random.below(u32::try_from(met.len()).unwrap()) as usize];
        for (next, passed) in next.iter().zip(&mut passed) {
            *passed += usize::from(*next == Some(chosen));
        }
    }
}

proptest! {
    #[test]
    fn all_deadlocks_are_found_and_nothing_else(
        parts in prop::collection::vec(
            (prop::collection::vec(0..3_u8, 0..4), prop::collection::vec(0..3_u8, 0..3), 1..3_u64),
            2..5,
        ),
        seed: u64,
    ) {
        let short: Vec<_> = parts.iter().map(|(once, cycle, times)| barriers(once, cycle, Some(*times))).collect();
        let written_out: Vec<Vec<u8>> = parts
            .iter()
            .map(|(once, cycle, times)| {
                let cycles = (0..*times).flat_map(|_| cycle.iter());
                once.iter().chain(cycles).copied().collect()
            })
            .collect();
        let found = course(&short.iter().collect::<Vec<_>>());
        let is_done = come_through(&written_out, seed);
        prop_assert_eq!(found == Course::Done, is_done, "{:?}", found);
    }

    #[test]
    fn the_barriers_ahead_are_those_not_yet_passed(
        once in prop::collection::vec(0..3_u8, 0..4),
        cycle in prop::collection::vec(0..3_u8, 1..3),
        times in 1..4_u64,
    ) {
        let short = barriers(&once, &cycle, Some(times));
        let cycles = (0..times).flat_map(|_| cycle.iter());
        let all: Vec<u8> = once.iter().chain(cycles).copied().collect();
        for passed in 0..=all.len() {
            let ahead: BTreeSet<String> = all[passed..].iter().map(ToString::to_string).collect();
            let found = short.ahead(passed as u64);
            prop_assert_eq!(found, ahead.iter().map(|barrier| &**barrier).collect::<BTreeSet<_>>());
            let next = short.at(passed as u64).map(|barrier| barrier.name.to_string());
            prop_assert_eq!(next, all.get(passed).map(ToString::to_string));
        }
    }

    #[test]
    fn no_part_passes_a_barrier_early_and_all_finish_despite_faults(
        parts in meetings(),
        seed: u64,
    ) {
        let mut world = World::new(parts, seed, Faults::All);
        world.come_through();
    }

    #[test]
    fn parts_that_depend_on_a_paused_part_hold_and_no_others(
        parts in meetings(),
        seed: u64,
    ) {
        let mut world = World::new(parts, seed, Faults::Pauses);
        world.come_through();
    }
}

#[test]
fn a_silent_part_holds_its_dependants_after_three_seconds_and_not_before() {
    let mut world = World::new(vec![vec![0], vec![0], vec![]], 1, Faults::None);
    world.start();
    assert_eq!(world.silent_until_held(0), [0, 1]);
}

#[test]
fn a_part_started_by_a_person_at_its_arm_is_paused_with_those_that_wait_for_it() {
    let mut world = World::new(vec![vec![0, 1], vec![0, 1], vec![]], 1, Faults::None);
    world.start();
    world.run_to_barrier(0);
    world.start_by_hand(0);
    assert_eq!(world.held(), [0, 1]);
    assert!(world.is_paused(0) && world.is_paused(1));
    let hindered = world.resume();
    assert_eq!(hindered.len(), 1, "{hindered:?}");
    assert!(hindered[0].1.contains("before the others had arrived"));
    assert_eq!(world.held(), [0, 1]);
}

#[test]
fn a_start_refused_by_one_station_leaves_all_parts_waiting() {
    let mut world = World::new(vec![vec![0], vec![0], vec![]], 1, Faults::None);
    world.refuse_next_start(1);
    world.start();
    assert!((0..3).all(|part| world.is_queued(part)));
    world.resume();
    world.come_through();
}
