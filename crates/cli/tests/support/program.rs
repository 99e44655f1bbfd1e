//! Runs `dobot` and reports the outcome.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::LazyLock;

/// What came of a run.
#[derive(Debug)]
pub(crate) struct Outcome {
    pub(crate) code: Option<i32>,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Outcome {
    #[track_caller]
    pub(crate) fn succeeds(self) -> Self {
        assert_eq!(self.code, Some(0), "{self:?}");
        self
    }

    /// Fails with one error and a hint that contain these texts.
    #[track_caller]
    pub(crate) fn fails(self, code: i32, parts: &[&str]) -> Self {
        assert_eq!(self.code, Some(code), "{self:?}");
        let errors = ["error: ", r#"{"error":"#].map(|start| self.stderr.matches(start).count());
        assert_eq!(errors.iter().sum::<usize>(), 1, "{self:?}");
        for part in parts {
            assert!(self.stderr.contains(part), "`{part}` is missing: {self:?}");
        }
        self
    }

    /// Checks that the job is left waiting for a person, and returns the line about it.
    pub(crate) fn waits(self) -> String {
        assert_eq!(self.code, Some(3), "{self:?}");
        assert!(!self.stderr.contains("error"), "{self:?}");
        self.stderr.lines().last().unwrap_or_default().to_owned()
    }
}

impl From<Output> for Outcome {
    fn from(output: Output) -> Self {
        Self {
            code: output.status.code(),
            stdout: String::from_utf8_lossy(&output.stdout).into_owned(),
            stderr: String::from_utf8_lossy(&output.stderr).into_owned(),
        }
    }
}

/// `dobot`, for which no station runs. Nothing that an earlier run has kept of an arm is there.
pub(crate) fn command(arguments: &[&str]) -> Command {
    static DATA: LazyLock<PathBuf> = LazyLock::new(|| {
        let name = format!("no-station-{}", std::process::id());
        let data = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        // An earlier run may have had the same number.
        let _ = std::fs::remove_dir_all(&data);
        data
    });
    command_at(&DATA, arguments)
}

/// `dobot`, with the data of a station in this folder.
pub(crate) fn command_at(data: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_dobot"));
    command.args(arguments).env("DOBOT_DATA", data);
    command
        .env_remove("RUST_LOG")
        .env_remove("DOBOT_STATION")
        .env_remove("DOBOT_TOKEN");
    command
}

pub(crate) fn dobot(arguments: &[&str]) -> Outcome {
    dobot_reading(arguments, b"")
}

pub(crate) fn dobot_reading(arguments: &[&str], input: &[u8]) -> Outcome {
    run(&mut command(arguments), input)
}

pub(crate) fn run(command: &mut Command, input: &[u8]) -> Outcome {
    let mut child = command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut stdin = child.stdin.take().expect("it is piped");
    // A program that does not read its input may close it.
    let _ = stdin.write_all(input);
    drop(stdin);
    child.wait_with_output().expect("the program ends").into()
}

pub(crate) fn example(name: &str) -> String {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("../../examples/drawings")
        .join(name);
    path.to_str().expect("the path is text").to_owned()
}
