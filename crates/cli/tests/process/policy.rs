//! `dobot policy`.

use std::fs;

use tempfile::TempDir;

use crate::support::program::{Outcome, dobot};

/// A policy file with this text, and its folder.
fn file(text: &str) -> (TempDir, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("policy.toml");
    fs::write(&path, text).expect("it is written");
    let name = path.to_str().expect("the path is text").to_owned();
    (folder, name)
}

#[test]
fn the_default_is_printed_with_its_comments_and_is_a_good_file() {
    let shown = dobot(&["policy"]).succeeds();
    assert!(shown.stdout.starts_with("# The safety policy"), "{shown:?}");
    assert!(shown.stdout.contains("# degrees"), "{shown:?}");
    let (_folder, name) = file(&shown.stdout);
    let outcome = dobot(&["policy", "check", &name]).succeeds();
    assert!(outcome.stdout.contains("is a valid policy"), "{outcome:?}");
}

#[test]
fn an_error_in_a_file_is_reported_with_its_line() {
    let (_folder, name) = file("[jog]\ndead_man_s = 150\n");
    dobot(&["policy", "check", &name]).fails(
        1,
        &[
            "policy.toml: line 2: jog.dead_man_s is 150",
            "0.05 to 2",
            "hint: ",
        ],
    );
    let (_folder, name) = file("[joints]\nelbow_deg = [0, 1]\n");
    dobot(&["policy", "check", &name]).fails(1, &["line 2", "elbow_deg", "base_deg"]);
    dobot(&["policy", "check", "no-such.toml"]).fails(1, &["cannot read the policy no-such.toml"]);
}

#[test]
fn the_policy_in_force_includes_the_defaults() {
    let (_folder, name) = file("[joints]\nbase_deg = [-90, 90]\n");
    let outcome = dobot(&["policy", "show", &name]).succeeds();
    for part in [
        "base_deg = [-90.0, 90.0]",
        "rear_deg = [-5.0, 85.0]",
        "dead_man_s = 0.15",
    ] {
        assert!(outcome.stdout.contains(part), "{part}: {outcome:?}");
    }
}

#[test]
fn the_schema_is_json() {
    let outcome = dobot(&["policy", "schema"]).succeeds();
    let schema: serde_json::Value = serde_json::from_str(&outcome.stdout).expect("it is JSON");
    assert!(schema["properties"]["keep_out"].is_object(), "{schema}");
}

fn asked(path: &str, policy: &str) -> Outcome {
    let (_folder, name) = file(policy);
    let from = ["--start-point", "200", "-100", "0"];
    let rest = ["--path", path, "--policy", &name];
    dobot(&[&["policy", "test", "200", "100", "0"][..], &from, &rest].concat())
}

#[test]
fn a_move_can_be_checked_before_it_is_made() {
    let wall =
        "[keep_out.cup]\ncylinder = { x_mm = 200, y_mm = 0, radius_mm = 30, z_mm = [-103, -25] }\n";
    let outcome = asked("movl", "").succeeds();
    assert!(
        outcome.stdout.contains("allowed: x 200 y 100 z 0 mm"),
        "{outcome:?}"
    );
    asked("movl", wall).fails(
        1,
        &[
            "refused by keep_out.cup",
            "the tool would touch keep_out.cup",
            "up to x 200 y -",
        ],
    );
    dobot(&[
        "policy",
        "test",
        "200",
        "0",
        "-90",
        "--start-point",
        "200",
        "0",
        "0",
    ])
    .fails(
        1,
        &["refused by table", "z would be -90 mm", "-63 mm and more"],
    );
}

#[test]
fn a_check_without_a_place_is_a_usage_error() {
    dobot(&["policy", "test", "200", "0", "0"]).fails(2, &["--start-point"]);
    dobot(&[
        "policy",
        "test",
        "200",
        "0",
        "--start-point",
        "200",
        "0",
        "0",
    ])
    .fails(2, &["3 values"]);
    dobot(&[
        "policy",
        "test",
        "200",
        "0",
        "0",
        "--start-point",
        "900",
        "0",
        "0",
    ])
    .fails(1, &["cannot reach x 900 y 0 z 0 mm"]);
}
