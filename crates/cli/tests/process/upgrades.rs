//! The data of earlier versions: `samples/VERSION` is the data folder of a station of that version with two jobs, of which one was
//! paused in the middle, a stop, a policy, a calibrated arm, tokens, hooks, a button, a stored file, drawing defaults and a
//! recording, and a taught program beside them.

use std::fs;
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use crate::support::api::Api;
use crate::support::arm::fast_arm;
use crate::support::program::dobot;
use crate::support::up::Up;

const VERSIONS: [&str; 1] = ["0.1.0"];

fn sample(version: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/process/samples")
        .join(version)
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("there is room");
    for entry in fs::read_dir(from).expect("it is a folder") {
        let entry = entry.expect("it can be read");
        let to = to.join(entry.file_name());
        if entry.path().is_dir() {
            copy(&entry.path(), &to);
        } else {
            fs::copy(entry.path(), to).expect("there is room");
        }
    }
}

/// A copy of a sample, which a station may change.
fn data(version: &str) -> TempDir {
    let folder = tempfile::tempdir().expect("there is room");
    copy(&sample(version), folder.path());
    folder
}

#[test]
fn a_station_continues_with_the_data_of_earlier_versions() {
    for version in VERSIONS {
        let up = Up::with_data(data(version));
        let jobs = up.dobot(&["jobs"]).succeeds().stdout;
        let job = |text: &str| jobs.lines().any(|line| line.contains(text));
        assert!(job("done         33 of     33"), "{version}: {jobs}");
        assert!(job("A longer text"), "{version}: {jobs}");
        let state = up.wait_for_state(|state| state["stop"].is_object());
        assert_eq!(state["stop"]["reason"], "finger caught", "{version}");
        let tokens = up.dobot(&["token", "list"]).succeeds().stdout;
        assert!(
            tokens.contains("Anna") && tokens.contains("hall-screen"),
            "{version}: {tokens}"
        );
        let recordings = up.dobot(&["log"]).succeeds().stdout;
        assert!(
            recordings.contains("dobot-2026-11-30T05-43-25Z.mcap"),
            "{version}: {recordings}"
        );
        let stored = up.dobot(&["files", "get", "corner.svg", "--out", "-"]);
        assert!(
            stored.succeeds().stdout.contains("M0 0H20V10"),
            "{version}: the file is as it was stored"
        );
        let buttons = Api::new(&up.page).asks("GET", "buttons", &serde_json::Value::Null);
        assert_eq!(buttons[0]["name"], "Lift", "{version}: {buttons}");
        up.dobot(&["stop", "--reset"]).succeeds();
        up.dobot(&["move", "220", "0", "-100"])
            .fails(1, &["table allows -50"]);
    }
}

#[test]
fn files_of_earlier_versions_are_read_without_a_station() {
    for version in VERSIONS {
        let folder = data(version);
        let file = |name: &str| folder.path().join(name).display().to_string();
        dobot(&["policy", "check", &file("policy.toml")]).succeeds();
        dobot(&["check", &file("taught.toml")]).succeeds();
        let defaults = ["--defaults", &file("draw.toml")];
        dobot(&[&["draw", "--text", "Hi", "--dry-run"], &defaults[..]].concat()).succeeds();
        let recording = file("recordings/dobot-2026-11-30T05-43-25Z.mcap");
        let moved = dobot(&["log", &recording]).succeeds().stdout;
        assert!(moved.lines().count() > 33, "{version}: {moved}");
    }
}

#[test]
fn the_calibration_of_an_arm_is_kept_by_later_versions() {
    for version in VERSIONS {
        let mut arm = fast_arm(&["--tcp", "127.0.0.1:0"]);
        let folder = data(version);
        let arms = folder.path().join("arms.toml");
        let text = fs::read_to_string(&arms).expect("it is there");
        let address = arm.address();
        let text = text.replace("tcp:127.0.0.1:5600", &address);
        fs::write(&arms, text).expect("there is room");
        let up = Up::in_folder(folder, &["--arm", &address], &[]);
        let calibrations = Api::new(&up.page).asks("GET", "calibration", &serde_json::Value::Null);
        let zeros = &calibrations["calibration"]["zeros"];
        assert_eq!(zeros["rear"], 3.5, "{version}: {calibrations}");
    }
}
