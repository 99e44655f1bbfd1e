//! Problems of a coordinated program, found before anything moves.

use super::barriers::{Barrier, Barriers, Course, course, next_barriers};
use super::part::Part;

/// Returns all problems, each in one line with file, step and remedy.
#[must_use]
pub fn check(parts: &[Part]) -> Vec<String> {
    let mut problems: Vec<String> = parts.iter().filter_map(untitled).collect();
    problems.extend(parts.iter().filter_map(burning));
    let alone = alone(parts);
    // A barrier without a partner would also be reported as a deadlock.
    if alone.is_empty() {
        problems.extend(stuck(parts));
    }
    problems.extend(alone);
    problems
}

fn untitled(part: &Part) -> Option<String> {
    let file = &part.file;
    let none = format!(
        "{file}: the title is missing, by which its station names the job; begin with title = \"...\""
    );
    part.compiled.title.is_empty().then_some(none)
}

/// Reports laser steps: a laser is armed by a person who stays with it.
fn burning(part: &Part) -> Option<String> {
    let step = part.burning_step()?;
    let (file, line) = (&part.file, part.compiled.steps.get(step)?.line);
    Some(format!(
        "{file}: step {} (line {line}) switches the laser on; a laser may burn only while the person who armed it stays with it; run this program alone",
        step + 1
    ))
}

/// Reports barriers that only one part has.
fn alone(parts: &[Part]) -> Vec<String> {
    let barriers: Vec<_> = parts.iter().map(Part::barriers).collect();
    let mut problems = Vec::new();
    for (part, own) in parts.iter().zip(&barriers) {
        for barrier in own.all() {
            let all = barriers.iter();
            if all.filter(|other| other.has(&barrier.name)).count() > 1 {
                continue;
            }
            let others = barriers.iter().filter(|other| *other != own);
            let (place, have) = (place(part, barrier), barriers_of(others));
            problems.push(format!(
                "{place}: no other part has this barrier, {have}; use the same name in both, or remove the step"
            ));
        }
    }
    problems
}

/// Describes the barriers of the other parts.
fn barriers_of<'a>(others: impl Iterator<Item = &'a Barriers>) -> String {
    let mut names: Vec<_> = others
        .flat_map(|other| other.all().map(|barrier| &*barrier.name))
        .collect();
    names.sort_unstable();
    names.dedup();
    match &names[..] {
        [] => "the others have no barriers".to_owned(),
        names => format!("the others have {names:?}"),
    }
}

/// Reports deadlocks.
fn stuck(parts: &[Part]) -> Vec<String> {
    let barriers: Vec<_> = parts.iter().map(Part::barriers).collect();
    let all: Vec<_> = barriers.iter().collect();
    let passed = match course(&all) {
        Course::Done => return Vec::new(),
        Course::TooLong => return vec![TOO_LONG.to_owned()],
        Course::Stuck(passed) => passed,
    };
    let next = next_barriers(&all, &passed);
    let mut problems = Vec::new();
    for (index, barrier) in next.iter().enumerate() {
        let Some(barrier) = barrier else {
            continue;
        };
        let elsewhere: Vec<String> = (0..parts.len())
            .filter(|other| barriers[*other].has(&barrier.name))
            .filter(|other| next[*other].is_none_or(|there| there.name != barrier.name))
            .map(|other| where_is(&parts[other], next[other]))
            .collect();
        let (place, elsewhere) = (place(&parts[index], barrier), elsewhere.join(" and "));
        problems.push(format!(
            "{place}: deadlock, since {elsewhere}; all parts must reach their barriers in the same order and equally often"
        ));
    }
    problems
}

fn where_is(part: &Part, next: Option<&Barrier>) -> String {
    match next {
        Some(next) => format!("{} waits at {}", part.arm, place(part, next)),
        None => format!("{} has no barriers left ({})", part.arm, part.file),
    }
}

fn place(part: &Part, barrier: &Barrier) -> String {
    let file = match &barrier.file {
        Some(called) => format!("{} calls {called}", part.file),
        None => part.file.clone(),
    };
    format!(
        "{file}: step {} (line {}, barrier {:?})",
        barrier.step, barrier.line, barrier.name
    )
}

const TOO_LONG: &str = "the parts meet more than 1000000 times before they finish; let them repeat \"forever\", or less often";

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_teach::{NoFiles, Program};

    use super::*;

    /// A part with these steps after its first motion.
    fn part(arm: &str, steps: &str) -> Part {
        let text =
            format!("title = \"{arm}\"\n[[steps]]\ngo = {{ x = 200, y = 0, z = 0 }}\n{steps}");
        let program = Program::from_toml(&text).unwrap();
        Part {
            arm: arm.into(),
            file: format!("{arm}.toml"),
            compiled: program.compile(&mut NoFiles).unwrap(),
            text,
            files: std::collections::BTreeMap::new(),
        }
    }

    fn barriers(names: &[&str]) -> String {
        let step = |name: &&str| format!("[[steps]]\nbarrier = {name:?}\n");
        names.iter().map(step).collect()
    }

    fn cycle(times: &str, names: &[&str]) -> String {
        let steps = barriers(names).replace("[[steps]]", "[[steps.steps]]");
        format!("[[steps]]\nrepeat = {times}\n{steps}")
    }

    fn problems(parts: [&str; 2]) -> Vec<String> {
        let [one, two] = parts;
        check(&[part("one", one), part("two", two)])
    }

    #[test]
    fn parts_with_the_same_barriers_in_the_same_order_are_accepted() {
        let both = barriers(&["x", "y"]);
        assert_eq!(problems([&both, &both]), [""; 0]);
        let both = cycle("\"forever\"", &["x", "y"]);
        assert_eq!(problems([&both, &both]), [""; 0]);
        // Once, and twice in a cycle, is three times.
        let apart = format!("{}{}", barriers(&["x"]), cycle("2", &["x"]));
        assert_eq!(problems([&apart, &cycle("3", &["x"])]), [""; 0]);
    }

    #[test]
    fn two_parts_that_wait_for_each_other_are_reported_with_step_and_line() {
        let found = problems([&barriers(&["x", "y"]), &barriers(&["y", "x"])]);
        assert_eq!(found.len(), 2, "{found:?}");
        let parts = [
            "one.toml: step 2 (line 4, barrier \"x\")",
            "two waits at two.toml: step 2 (line 4, barrier \"y\")",
            "same order",
        ];
        for part in parts {
            assert!(found[0].contains(part), "{part} is missing: {found:?}");
        }
    }

    #[test]
    fn a_part_that_reaches_a_barrier_more_often_than_the_other_is_reported() {
        let found = problems([&barriers(&["x", "x", "x"]), &barriers(&["x", "x"])]);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(
            found[0].contains("step 4 (line 8, barrier \"x\")"),
            "{found:?}"
        );
        assert!(found[0].contains("two has no barriers left"), "{found:?}");
        let found = problems([&cycle("\"forever\"", &["x"]), &cycle("5", &["x"])]);
        assert_eq!(found.len(), 1, "{found:?}");
    }

    #[test]
    fn a_barrier_of_one_part_alone_is_reported_with_those_of_the_others() {
        let found = problems([&barriers(&["handed over"]), &barriers(&["handed-over"])]);
        assert_eq!(found.len(), 2, "{found:?}");
        assert!(found[0].contains("\"handed over\"") && found[0].contains("[\"handed-over\"]"));
    }

    #[test]
    fn a_burning_part_is_refused_in_a_program_for_several_arms() {
        let burns = "[[steps]]\nlaser = true\n[[steps]]\nlaser = false\n";
        let found = problems([burns, ""]);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(
            found[0].contains("one.toml: step 2 (line 4) switches the laser on"),
            "{found:?}"
        );
    }
}
