//! `dobot conformance` on virtual arms, and on addresses that have none.

use std::fs;
use std::net::TcpListener;

use crate::support::program::{Outcome, command, dobot};

/// Runs `dobot conformance` in its own folder.
fn conformance(arguments: &[&str]) -> (Outcome, tempfile::TempDir) {
    let folder = tempfile::tempdir().expect("there is room");
    let output = command(&[&["conformance"], arguments].concat())
        .current_dir(&folder)
        .output()
        .expect("the program starts");
    (output.into(), folder)
}

#[test]
fn both_personalities_conform_and_the_report_distinguishes_them() {
    for personality in ["specification", "firmware-1.1"] {
        let arguments = [
            "virtual:",
            "--personality",
            personality,
            "--traps",
            "--with-laser",
        ];
        let (outcome, folder) = conformance(&arguments);
        let outcome = outcome.succeeds();
        let speaks = format!("0 differ, 0 not tried; speaks {personality}\n");
        assert!(outcome.stdout.contains(&speaks), "{outcome:?}");
        let report = fs::read_to_string(folder.path().join("conformance.md"));
        let report = report.expect("it is the default place of the report");
        assert!(
            report.contains(&format!("| speaks | {personality} |")),
            "{report}"
        );
    }
}

#[test]
fn a_stock_arm_conforms_over_bluetooth_and_the_document_has_no_such_port() {
    let arguments = ["virtual:", "--port", "bluetooth"];
    let stock = ["--personality", "firmware-1.1", "--traps", "--with-laser"];
    let (outcome, _folder) = conformance(&[&arguments[..], &stock].concat());
    let outcome = outcome.succeeds();
    let speaks = "0 differ, 0 not tried; speaks firmware-1.1 over Bluetooth\n";
    assert!(outcome.stdout.contains(speaks), "{outcome:?}");
    let (outcome, _folder) = conformance(&arguments);
    outcome.fails(2, &["USB port only", "--personality firmware-1.1"]);
}

#[test]
fn a_report_is_overwritten_and_nothing_else_is() {
    let folder = tempfile::tempdir().expect("there is room");
    let file = folder.path().join("mine.md");
    let path = file.to_str().expect("the path is text");
    let arguments = ["conformance", "virtual:", "--report", path];
    dobot(&arguments).succeeds();
    dobot(&arguments).succeeds();
    fs::write(&file, "my diary").expect("there is room");
    dobot(&arguments).fails(1, &["mine.md exists", "--report"]);
    assert_eq!(fs::read_to_string(&file).expect("it is there"), "my diary");
}

#[test]
fn an_arm_at_a_port_is_not_moved_without_consent() {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let address = format!("tcp:{}", listener.local_addr().expect("it is bound"));
    let (outcome, folder) = conformance(&[&address]);
    outcome.fails(1, &["no terminal", "--yes"]);
    assert!(!folder.path().join("conformance.md").exists());
}

#[test]
fn an_address_without_an_arm_is_reported_with_a_remedy() {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let address = format!("tcp:{}", listener.local_addr().expect("it is bound"));
    drop(listener);
    let (outcome, _folder) = conformance(&[&address, "--yes"]);
    outcome.fails(1, &["cannot connect", "dobot arm --tcp"]);
}

#[test]
fn a_personality_and_a_port_are_for_a_virtual_arm_only() {
    let arguments = [
        "tcp:127.0.0.1:5555",
        "--yes",
        "--personality",
        "specification",
    ];
    let (outcome, _folder) = conformance(&arguments);
    outcome.fails(2, &["--personality is only for virtual:", "leave out"]);
    let arguments = ["tcp:127.0.0.1:5555", "--yes", "--port", "bluetooth"];
    let (outcome, _folder) = conformance(&arguments);
    outcome.fails(2, &["--port is only for virtual:", "leave out"]);
}
