//! `dobot model`.

use std::fs;

use serde_json::Value;

use crate::support::program::dobot;

#[test]
fn the_tool_has_the_length_of_the_default_policy_unless_specified() {
    let length = |more: &[&str]| {
        let outcome = dobot(&[&["model", "--format", "json"][..], more].concat()).succeeds();
        let model: Value = serde_json::from_str(&outcome.stdout).expect("it is JSON");
        model["tool"]["length_mm"].clone()
    };
    let policy = dobot(&["policy"]).succeeds().stdout;
    let line = policy
        .lines()
        .find(|line| line.starts_with("laser_mm"))
        .expect("it is there");
    let laser_mm = length(&["--tool", "laser"]).to_string();
    let laser_mm = laser_mm.trim_end_matches(".0");
    assert!(
        line.contains(&format!("= {laser_mm}")),
        "{line}: {laser_mm}"
    );
    assert_eq!(length(&["--tool", "pen", "--length", "62.5"]), 62.5);
    assert_eq!(length(&["--tool", "none"]), Value::Null);
}

#[test]
fn a_folder_gets_a_new_file_and_an_existing_file_is_kept() {
    let folder = tempfile::tempdir().expect("there is room");
    let out = folder.path().to_str().expect("the path is text");
    for (format, name) in [
        ("urdf", "dobot_arm.urdf"),
        ("mjcf", "dobot_arm.xml"),
        ("json", "dobot_arm.json"),
    ] {
        let arguments = ["model", "--format", format, "-o", out];
        let printed = dobot(&arguments[..3]).succeeds().stdout;
        dobot(&arguments).succeeds();
        let file = folder.path().join(name);
        assert_eq!(fs::read_to_string(&file).expect("it is there"), printed);
        fs::write(&file, "mine").expect("there is room");
        dobot(&arguments).fails(1, &[name, "exists", "hint: overwrite it with `--force`"]);
        assert_eq!(fs::read_to_string(&file).expect("it is there"), "mine");
        dobot(&[&arguments[..], &["--force"]].concat()).succeeds();
        assert_eq!(fs::read_to_string(&file).expect("it is there"), printed);
    }
}

#[test]
fn moveit_gets_a_new_folder_and_existing_files_are_kept() {
    dobot(&["model", "--format", "moveit"]).fails(2, &["--out"]);
    let folder = tempfile::tempdir().expect("there is room");
    let out = folder.path().join("moveit");
    let arguments = [
        "model",
        "--format",
        "moveit",
        "-o",
        out.to_str().expect("the path is text"),
    ];
    dobot(&arguments).succeeds();
    let urdf = fs::read_to_string(out.join("dobot_arm.urdf")).expect("it is there");
    assert_eq!(urdf, dobot(&["model"]).succeeds().stdout);
    for name in [
        "dobot_arm.srdf",
        "kinematics.yaml",
        "joint_limits.yaml",
        "demo.launch.py",
        "moveit.rviz",
    ] {
        assert!(out.join(name).is_file(), "{name}");
    }
    fs::write(out.join("dobot_arm.srdf"), "mine").expect("there is room");
    dobot(&arguments).fails(1, &["exists", "hint: overwrite it with `--force`"]);
    assert_eq!(
        fs::read_to_string(out.join("dobot_arm.srdf")).expect("it is there"),
        "mine"
    );
}

#[test]
fn an_invalid_length_is_refused() {
    for length in ["0", "19.99", "201", "nan", "inf"] {
        let outcome = dobot(&["model", "--length", length]).fails(2, &["20 to 200 mm"]);
        assert_eq!(outcome.stdout, "");
    }
    dobot(&["model", "--length=-40"]).fails(2, &["-40 mm", "20 to 200 mm"]);
    dobot(&["model", "--tool", "none", "--length", "40"]).fails(2, &["without a tool", "hint: "]);
    dobot(&["model", "--tool", "camera"]).fails(2, &["gripper"]);
    dobot(&["model", "--format", "sdf"]).fails(2, &["mjcf"]);
}
