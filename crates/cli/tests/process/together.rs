//! One program for several arms, rehearsed.

use std::path::PathBuf;

use serde_json::Value;

use crate::support::program::dobot;

fn rehearsed(file: &str) -> Value {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples/together");
    let file = folder.join(file);
    let file = file.to_str().expect("the path is text");
    let outcome = dobot(&["fleet", "together", file, "--dry-run", "--json"]);
    assert_eq!(outcome.code, Some(0), "{outcome:?}");
    serde_json::from_str(&outcome.stdout).expect("it is JSON")
}

fn names(plan: &Value) -> Vec<&str> {
    let barriers = plan["barriers"].as_array().expect("there are barriers");
    let names = barriers.iter().map(|barrier| barrier["barrier"].as_str());
    names.collect::<Option<_>>().expect("each has a name")
}

#[test]
fn the_examples_meet_at_their_barriers_in_order_and_finish() {
    let cube = rehearsed("cube.toml");
    let once = ["the place is free", "the cube is there"];
    assert_eq!(names(&cube), once.repeat(3));
    let pens = rehearsed("pens.toml");
    assert_eq!(names(&pens), ["black is done", "red is done"]);
    for part in [&cube, &pens].map(|plan| &plan["parts"]) {
        let parts = part.as_array().expect("there are parts");
        let over_s = parts.iter().map(|part| part["over_s"].as_f64());
        assert!(
            over_s.into_iter().all(|time_s| time_s > Some(1.0)),
            "{parts:?}"
        );
    }
    // The last pen waits for the other two.
    let waited_s = |part: usize| pens["parts"][part]["waited_s"].as_f64();
    assert!(
        waited_s(2) > waited_s(1) && waited_s(1) > waited_s(0),
        "{pens}"
    );
}

#[test]
fn a_deadlock_of_arms_is_reported_before_anything_is_rehearsed() {
    let folder = tempfile::tempdir().expect("there is a folder");
    let write = |name: &str, text: String| {
        std::fs::write(folder.path().join(name), text).expect("it can be written");
    };
    for (name, [first, second]) in [("one", ["x", "y"]), ("two", ["y", "x"])] {
        let go = "[[steps]]\ngo = { x = 200, y = 0, z = 0 }\n";
        let step = |name: &str| format!("[[steps]]\nbarrier = \"{name}\"\n");
        let text = format!("title = \"{name}\"\n{go}{}{}", step(first), step(second));
        write(&format!("{name}.toml"), text);
    }
    let parts = ["one", "two"]
        .map(|name| format!("[[parts]]\narm = \"{name}\"\nprogram = \"{name}.toml\"\n"));
    write("both.toml", format!("title = \"both\"\n{}", parts.concat()));
    let file = folder.path().join("both.toml");
    let file = file.to_str().expect("the path is text");
    let outcome = dobot(&["fleet", "together", file, "--dry-run"]);
    assert_eq!(outcome.code, Some(1), "{outcome:?}");
    for part in [
        "2 problems",
        "step 2 (line 4, barrier \"x\")",
        "deadlock",
        "same order",
    ] {
        assert!(
            outcome.stderr.contains(part),
            "{part} is missing: {outcome:?}"
        );
    }
}
