//! Rehearsals with real rules and virtual arms.

use std::collections::BTreeMap;

use dobot_controller::Personality;
use dobot_safety::Policy;
use dobot_teach::{NoFiles, Program};

use crate::together::{Part, Rehearsal, RehearseError, check, rehearse};

fn part(arm: &str, steps: &str) -> Part {
    let text = format!("title = \"{arm}\"\n{steps}");
    let program = Program::from_toml(&text).unwrap();
    Part {
        arm: arm.into(),
        file: format!("{arm}.toml"),
        compiled: program.compile(&mut NoFiles).unwrap(),
        text,
        files: BTreeMap::new(),
    }
}

/// Moves there, pauses, waits for the other part, and moves back.
fn there_and_back(pause_s: u32) -> String {
    format!(
        "[[steps]]\ngo = {{ x = 200, y = 60, z = 0 }}\npause = {pause_s}\n\
         [[steps]]\nbarrier = \"there\"\n\
         [[steps]]\ngo = {{ x = 200, y = -60, z = 0 }}\n\
         [[steps]]\nbarrier = \"back\"\n\
         [[steps]]\ngo = {{ x = 200, y = 0, z = 0 }}\n"
    )
}

fn rehearsed(parts: &[Part]) -> Rehearsal {
    assert_eq!(check(parts), [""; 0]);
    rehearse(parts, &Policy::default(), Personality::Specification).unwrap()
}

/// A status arrives every 80 ms; detecting rest takes one or two more.
const STATUSES_S: f64 = 0.35;

#[test]
fn a_part_waits_at_the_barrier_for_as_long_as_the_other_pauses_before_it() {
    let rehearsal = rehearsed(&[
        part("one", &there_and_back(0)),
        part("two", &there_and_back(5)),
    ]);
    let [there, back] = &rehearsal.barriers[..] else {
        panic!("{rehearsal:#?}")
    };
    assert_eq!((&*there.barrier, &*back.barrier), ("there", "back"));
    let waited_s = there.waits[0].waited_s;
    assert!((waited_s - 5.0).abs() < STATUSES_S, "{rehearsal:#?}");
    assert!(there.waits[1].waited_s < STATUSES_S, "{rehearsal:#?}");
    // From there on both parts do the same.
    assert!(
        back.waits.iter().all(|wait| wait.waited_s < STATUSES_S),
        "{rehearsal:#?}"
    );
    let [one, two] = &rehearsal.parts[..] else {
        panic!("{rehearsal:#?}")
    };
    let (one_s, two_s) = (one.over_s.unwrap(), two.over_s.unwrap());
    assert!((one_s - two_s).abs() < STATUSES_S, "{rehearsal:#?}");
    assert!(
        back.at_s > there.at_s && one_s > back.at_s,
        "{rehearsal:#?}"
    );
}

#[test]
fn an_endless_part_is_rehearsed_until_it_has_shown_its_cycle() {
    let cycle = "[[steps]]\nrepeat = \"forever\"\n\
                 [[steps.steps]]\ngo = { x = 200, y = 60, z = 0 }\n\
                 [[steps.steps]]\nbarrier = \"there\"\n\
                 [[steps.steps]]\ngo = { x = 200, y = -60, z = 0 }\n";
    let rehearsal = rehearsed(&[part("one", cycle), part("two", cycle)]);
    assert!(rehearsal.barriers.len() >= 2, "{rehearsal:#?}");
    assert!(
        rehearsal.parts.iter().all(|part| part.over_s.is_none()),
        "{rehearsal:#?}"
    );
}

#[test]
fn a_part_that_breaks_a_rule_is_reported_with_its_file() {
    let deep = there_and_back(0).replace("y = -60, z = 0", "y = -60, z = -200");
    let parts = [part("one", &there_and_back(0)), part("two", &deep)];
    let error = rehearse(&parts, &Policy::default(), Personality::Specification).unwrap_err();
    let RehearseError::Refused { file, .. } = &error else {
        panic!("{error}")
    };
    assert_eq!(file, "two.toml");
}
