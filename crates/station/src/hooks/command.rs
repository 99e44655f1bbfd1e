//! Commands: an event is written to their standard input.

use std::io::Write;
use std::process::{Child, Stdio};
use std::time::Instant;
use std::{process, thread, time::Duration};

use super::config::Command;

/// Runs a command without a shell, with an event as JSON on its standard input.
///
/// # Errors
///
/// Why it was not done, in one line.
pub(super) async fn run(command: Command, body: Vec<u8>) -> Result<(), String> {
    let done = tokio::task::spawn_blocking(move || run_blocking(&command, body)).await;
    done.map_err(|_| "the station is ending")?
}

fn run_blocking(command: &Command, body: Vec<u8>) -> Result<(), String> {
    let mut process = process::Command::new(&command.program);
    process
        .args(&command.arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    // A group of its own, so that it ends with all that it has started.
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(&mut process, 0);
    let mut child = process
        .spawn()
        .map_err(|error| format!("it cannot be started: {error}"))?;
    if let Some(mut input) = child.stdin.take() {
        // A command that reads nothing must not hold up its end.
        let write = move || drop(input.write_all(&body));
        thread::spawn(write);
    }
    wait(&mut child, command.limit)
}

fn wait(child: &mut Child, limit: Duration) -> Result<(), String> {
    let began = Instant::now();
    loop {
        match child.try_wait() {
            Ok(Some(status)) if status.success() => return Ok(()),
            Ok(Some(status)) => return Err(format!("it failed with {status}")),
            Ok(None) if began.elapsed() < limit => thread::sleep(LOOK),
            Ok(None) => {
                end(child);
                return Err(format!(
                    "it was ended, because it took longer than {} s",
                    limit.as_secs()
                ));
            }
            Err(error) => return Err(error.to_string()),
        }
    }
}

fn end(child: &mut Child) {
    #[cfg(unix)]
    if let Some(group) = i32::try_from(child.id())
        .ok()
        .and_then(rustix::process::Pid::from_raw)
    {
        // It may have ended meanwhile.
        let _ = rustix::process::kill_process_group(group, rustix::process::Signal::KILL);
    }
    // As above.
    let _ = child.kill();
    let _ = child.wait();
}

/// The interval at which the end of a command is checked.
const LOOK: Duration = Duration::from_millis(20);
