//! The station as a service.

use std::path::Path;
use std::process::Command;

use crate::support::program::{command_at, dobot, run};

/// `dobot service` of a person with this home.
fn service(home: &Path, arguments: &[&str]) -> Command {
    let mut command = command_at(home, &[&["service"], arguments].concat());
    command.env("HOME", home);
    command
}

#[test]
fn a_service_is_installed_shown_and_removed() {
    let home = tempfile::tempdir().expect("there is room");
    let file = home.path().join(".config/systemd/user/dobot.service");
    let data = home.path().join("the data");
    let data = data.to_str().expect("the path is text");
    let install = [
        "install",
        "--data",
        data,
        "--",
        "--arm",
        "serial:/dev/ttyUSB0",
    ];
    let installed = run(&mut service(home.path(), &install), b"").succeeds();
    assert!(installed.stdout.contains("dobot.service"), "{installed:?}");
    let text = std::fs::read_to_string(&file).expect("it is there");
    for line in [
        "up --log-format json --arm serial:/dev/ttyUSB0",
        "Restart=always",
        "WatchdogSec=",
        "DOBOT_DATA=",
    ] {
        assert!(text.contains(line), "{line} is missing: {text}");
    }
    verify(&file);
    run(&mut service(home.path(), &["status"]), b"").succeeds();
    run(&mut service(home.path(), &["remove"]), b"").succeeds();
    assert!(!file.exists());
    run(&mut service(home.path(), &["status"]), b"").fails(1, &["no service", "service install"]);
    run(&mut service(home.path(), &["remove"]), b"").fails(1, &["no service", "service install"]);
}

#[test]
fn a_service_file_for_a_package_is_printed_and_nothing_is_installed() {
    let home = tempfile::tempdir().expect("there is room");
    let print = ["print", "--system", "--", "--http", "0.0.0.0:8642"];
    let printed = run(&mut service(home.path(), &print), b"").succeeds();
    for line in [
        "up --log-format json --http 0.0.0.0:8642",
        "StateDirectory=dobot",
        "WantedBy=multi-user.target",
    ] {
        assert!(printed.stdout.contains(line), "{line}: {printed:?}");
    }
    assert!(!home.path().join(".config").exists());
}

/// The verdict of systemd, if it is installed.
fn verify(file: &Path) {
    let verified = Command::new("systemd-analyze")
        .args(["verify", "--user"])
        .arg(file)
        .output();
    let Ok(verified) = verified else {
        eprintln!("not verified: there is no systemd-analyze (Debian package systemd)");
        return;
    };
    let errors = String::from_utf8_lossy(&verified.stderr);
    let about_dobot = errors.lines().filter(|line| line.contains("dobot"));
    assert_eq!(
        about_dobot.collect::<Vec<_>>(),
        Vec::<&str>::new(),
        "{errors}"
    );
}

#[test]
fn a_service_that_could_not_start_is_not_installed() {
    let home = tempfile::tempdir().expect("there is room");
    let install = ["install", "--", "--arm", "usb:"];
    run(&mut service(home.path(), &install), b"").fails(2, &["dobot up", "usb:"]);
    assert!(!home.path().join(".config").exists());
    dobot(&["service", "install", "--user", "--system"]).fails(2, &["--system"]);
}

#[test]
fn a_folder_that_cannot_be_written_is_named() {
    let home = tempfile::tempdir().expect("there is room");
    std::fs::write(home.path().join(".config"), "a file").expect("there is room");
    run(&mut service(home.path(), &["install"]), b"").fails(1, &["cannot change", "dobot.service"]);
}
