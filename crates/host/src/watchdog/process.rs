//! The watchdog process: heartbeats on standard input, the arm's port on standard output.

use std::io;
use std::os::fd::AsFd;
use std::path::Path;
use std::time::Duration;

use rustix::event::{PollFd, PollFlags, poll};
use rustix::io::Errno;

use super::clock::Clock;
use super::port::{WriteOutcome, timespec, write_some, write_within};
use super::reporter::Reporter;
use super::{Hazards, Heartbeat, JogKind, Silence, Watchdog};

/// Guards a station until its goodbye, or until everything necessary has been sent.
///
/// # Errors
///
/// The operating system's error for standard input.
pub fn guard(note: &Path) -> io::Result<()> {
    // In its own session: terminal keys do not reach it, and a terminal that stops background
    // writers does not stop it. If it already leads a session, there is nothing to do.
    let _ = rustix::process::setsid();
    let (beats, port) = (io::stdin(), io::stdout());
    let clock = Clock::new();
    let mut guard = Guard {
        watchdog: Watchdog::new(clock.now()),
        clock,
        line: Vec::new(),
        reported: None,
        ended: false,
        reporter: Reporter::start(note),
    };
    while !guard.watchdog.is_over() {
        let ready = guard.wait(&beats, &port)?;
        guard.step(ready, &beats, &port)?;
    }
    write_within(&port, &guard.line, PATIENCE);
    guard.reporter.finish(PATIENCE);
    Ok(())
}

struct Guard {
    watchdog: Watchdog,
    clock: Clock,
    /// The rest of the packet being written.
    line: Vec<u8>,
    /// The last reported silence.
    reported: Option<Silence>,
    /// Whether the heartbeat pipe is closed.
    ended: bool,
    reporter: Reporter,
}

/// What can be done without waiting.
#[derive(Clone, Copy, Debug)]
struct Ready {
    beats: bool,
    port: bool,
}

impl Guard {
    /// Waits for a heartbeat, the port, or time.
    fn wait(&self, heartbeats: &impl AsFd, port: &impl AsFd) -> io::Result<Ready> {
        let mut wanted = PollFlags::empty();
        if self.watchdog.silence().is_some() {
            wanted |= PollFlags::IN;
        }
        if !self.line.is_empty() {
            wanted |= PollFlags::OUT;
        }
        // A port that is gone would always be ready.
        let (has_port, has_beats) = (!wanted.is_empty(), !self.ended);
        let mut waited = Vec::with_capacity(2);
        waited.extend(has_beats.then(|| PollFd::new(heartbeats, PollFlags::IN)));
        waited.extend(has_port.then(|| PollFd::new(port, wanted)));
        let within = self.watchdog.poll_wakeup().saturating_sub(self.clock.now());
        match poll(&mut waited, Some(&timespec(within))) {
            Ok(_) | Err(Errno::INTR) => {}
            Err(error) => return Err(error.into()),
        }
        let mut ready = waited.iter().map(|polled| !polled.revents().is_empty());
        Ok(Ready {
            beats: has_beats && ready.next() == Some(true),
            port: has_port && ready.next() == Some(true),
        })
    }

    /// Heartbeats first: however late this process is, it sends nothing while the station is alive.
    fn step(&mut self, ready: Ready, heartbeats: &impl AsFd, port: &impl AsFd) -> io::Result<()> {
        if ready.beats {
            self.receive_heartbeats(heartbeats)?;
        }
        self.watchdog.handle_time(self.clock.now());
        let mut gone = ready.port && self.follow(port);
        if let Some(packet) = self.watchdog.poll_bytes()
            && self.line.is_empty()
        {
            self.line.extend_from_slice(&packet.to_bytes());
        }
        if !self.line.is_empty() {
            match write_some(port, &self.line) {
                WriteOutcome::Some(written) => drop(self.line.drain(..written)),
                WriteOutcome::Later => {}
                WriteOutcome::Gone => gone = true,
            }
        }
        if gone {
            // There is no port any more.
            self.line.clear();
            self.watchdog
                .handle_heartbeat(self.clock.now(), Heartbeat::Goodbye);
        }
        self.report();
        Ok(())
    }

    fn receive_heartbeats(&mut self, heartbeats: &impl AsFd) -> io::Result<()> {
        let mut bytes = [0; 256];
        let read = match rustix::io::read(heartbeats, &mut bytes) {
            Err(Errno::AGAIN | Errno::INTR) => return Ok(()),
            read => read?,
        };
        let now = self.clock.now();
        if read == 0 {
            self.ended = true;
            self.watchdog.handle_end(now);
        }
        for heartbeat in bytes[..read]
            .iter()
            .filter_map(|byte| Heartbeat::from_byte(*byte))
        {
            self.watchdog.handle_heartbeat(now, heartbeat);
        }
        Ok(())
    }

    /// Reads from the arm while the watchdog acts; returns whether the port is gone.
    fn follow(&mut self, port: &impl AsFd) -> bool {
        if self.watchdog.silence().is_none() {
            return false;
        }
        let mut bytes = [0; 4096];
        match rustix::io::read(port, &mut bytes) {
            Ok(1..) => self.watchdog.handle_reply(self.clock.now()),
            Err(Errno::AGAIN | Errno::INTR) => {}
            Ok(0) | Err(_) => return true,
        }
        false
    }

    /// Reports what it does on standard error and in the note for the next start.
    fn report(&mut self) {
        let silence = self.watchdog.silence();
        if silence == self.reported {
            return;
        }
        self.reported = silence;
        let Some(silence) = silence else {
            return;
        };
        let silent = self
            .clock
            .now()
            .saturating_sub(self.watchdog.last_heartbeat());
        let text = text(silence, silent, self.watchdog.hazards());
        self.reporter.report(&text);
    }
}

fn text(silence: Silence, silent: Duration, hazards: Hazards) -> String {
    let why = match silence {
        Silence::Ended => "the station ended without a goodbye".to_owned(),
        Silence::Stalled => format!("the station was silent for {:.2} s", silent.as_secs_f64()),
    };
    let button = match hazards.jog {
        None => "",
        Some(JogKind::Joint) => ", and released the joint jog button",
        Some(JogKind::Linear) => ", and released the linear jog button",
    };
    format!("{why}: the watchdog switched the laser off{button}")
}

/// The time a port may take for the rest of the last packet, and a reader for the last line.
const PATIENCE: Duration = Duration::from_millis(200);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_actions_of_the_watchdog_are_reported_in_one_line() {
        let hazards = Hazards {
            jog: Some(JogKind::Linear),
            burns: true,
        };
        assert_eq!(
            text(Silence::Stalled, Duration::from_millis(312), hazards),
            "the station was silent for 0.31 s: the watchdog switched the laser off, and released the linear jog button"
        );
        assert_eq!(
            text(Silence::Ended, Duration::ZERO, Hazards::default()),
            "the station ended without a goodbye: the watchdog switched the laser off"
        );
    }
}
