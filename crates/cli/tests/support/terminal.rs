//! A `dobot` in its own terminal, with a person who presses keys.

use std::fs::File;
use std::io::{Read, Write};
use std::num::NonZero;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

use rustix::fs::{Mode, OFlags, open};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{Winsize, tcsetwinsize};

use super::PATIENCE;

/// The key events that a terminal reports.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Keyboard {
    /// That they are pressed.
    Plain,
    /// Releases too, by the protocol of kitty.
    Kitty,
}

/// A program in a terminal of 80 columns and 24 rows; it ends with the test.
pub(crate) struct Terminal {
    child: Child,
    keys: File,
    shown: Receiver<String>,
    /// All that was shown and not asked for yet.
    unread: String,
    screen: vt100::Parser,
}

const ROWS: NonZero<u16> = NonZero::new(24).unwrap();
const COLUMNS: NonZero<u16> = NonZero::new(80).unwrap();

impl Terminal {
    pub(crate) fn new(command: &Command, keyboard: Keyboard) -> Self {
        Self::showing(command, keyboard, |_| Stdio::null())
    }

    /// The same, which shows errors, warnings and progress, too.
    pub(crate) fn with_errors(command: &Command) -> Self {
        Self::showing(command, Keyboard::Plain, |inside| {
            inside.try_clone().expect("a handle").into()
        })
    }

    fn showing(command: &Command, keyboard: Keyboard, errors: impl FnOnce(&File) -> Stdio) -> Self {
        let master = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).expect("a terminal is free");
        grantpt(&master).expect("it is ours");
        unlockpt(&master).expect("it is ours");
        let size = Winsize {
            ws_row: ROWS.get(),
            ws_col: COLUMNS.get(),
            ws_xpixel: 0,
            ws_ypixel: 0,
        };
        tcsetwinsize(&master, size).expect("it is a terminal");
        let name = ptsname(&master, Vec::new()).expect("it has a name");
        let flags = OFlags::RDWR | OFlags::NOCTTY;
        let inside = File::from(open(&name, flags, Mode::empty()).expect("it is unlocked"));
        let child = alone(command)
            .env("TERM", "xterm-256color")
            .stdin(inside.try_clone().expect("a handle"))
            .stderr(errors(&inside))
            .stdout(inside)
            .spawn()
            .expect("the program starts");
        let keys = File::from(master);
        let (sender, shown) = mpsc::channel();
        let screen = keys.try_clone().expect("a handle");
        thread::spawn(move || show(screen, keyboard, |text| sender.send(text).is_ok()));
        Self {
            child,
            keys,
            shown,
            unread: String::new(),
            screen: vt100::Parser::new(ROWS, COLUMNS, 0),
        }
    }

    /// Waits until the screen shows a text, in one piece.
    pub(crate) fn shows(&mut self, text: &str) {
        let is_shown = self.shows_within(PATIENCE, text);
        assert!(is_shown, "`{text}` is missing: {:?}", self.unread);
    }

    /// Whether the screen shows a text within this time, in one piece.
    pub(crate) fn shows_within(&mut self, time: Duration, text: &str) -> bool {
        let until = Instant::now() + time;
        loop {
            if let Some(at) = self.unread.find(text) {
                self.unread.drain(..at + text.len());
                return true;
            }
            match self
                .shown
                .recv_timeout(until.saturating_duration_since(Instant::now()))
            {
                Ok(more) => self.read(&more),
                Err(_) => return false,
            }
        }
    }

    /// Waits until one of the texts is on the screen, and returns its index.
    pub(crate) fn shows_one_of(&mut self, texts: &[&str]) -> usize {
        while let Ok(more) = self.shown.try_recv() {
            self.read(&more);
        }
        let until = Instant::now() + PATIENCE;
        loop {
            let screen = self.screen.screen().contents();
            if let Some(index) = texts.iter().position(|text| screen.contains(text)) {
                return index;
            }
            let left = until.saturating_duration_since(Instant::now());
            let more = self.shown.recv_timeout(left);
            assert!(more.is_ok(), "{texts:?} are missing:\n{screen}");
            self.read(&more.unwrap_or_default());
        }
    }

    /// Whether the screen as a whole shows a text within this time.
    pub(crate) fn screen_shows_within(&mut self, time: Duration, text: &str) -> bool {
        let until = Instant::now() + time;
        loop {
            if self.screen.screen().contents().contains(text) {
                return true;
            }
            let left = until.saturating_duration_since(Instant::now());
            match self.shown.recv_timeout(left) {
                Ok(more) => self.read(&more),
                Err(_) => return false,
            }
        }
    }

    fn read(&mut self, more: &str) {
        self.screen.process(more.as_bytes());
        self.unread.push_str(more);
    }

    /// What keys send.
    pub(crate) fn types(&mut self, keys: &str) {
        self.keys.write_all(keys.as_bytes()).expect("it is open");
    }

    /// Presses keys until the program has ended: a key that follows another one too closely is ignored.
    pub(crate) fn types_until_the_end(mut self, keys: &str) -> ExitStatus {
        const TRIED_AGAIN_AFTER: Duration = Duration::from_millis(500);
        loop {
            // The program may end at the same time.
            let _ = self.keys.write_all(keys.as_bytes());
            let until = Instant::now() + TRIED_AGAIN_AFTER;
            loop {
                let left = until.saturating_duration_since(Instant::now());
                match self.shown.recv_timeout(left) {
                    Ok(_) if left.is_zero() => break,
                    Ok(_) => {}
                    Err(RecvTimeoutError::Timeout) => break,
                    Err(RecvTimeoutError::Disconnected) => return self.ends(),
                }
            }
        }
    }

    /// Waits until the program has ended.
    pub(crate) fn ends(mut self) -> ExitStatus {
        self.child.wait().expect("it ends")
    }
}

impl Drop for Terminal {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The command in its own session: otherwise it would use the terminal that runs the test.
fn alone(command: &Command) -> Command {
    let mut alone = Command::new("setsid");
    alone.arg(command.get_program()).args(command.get_args());
    for (name, value) in command.get_envs() {
        match value {
            Some(value) => alone.env(name, value),
            None => alone.env_remove(name),
        };
    }
    alone
}

/// Reads the screen, and answers queries to the terminal.
fn show(mut screen: File, keyboard: Keyboard, mut pass: impl FnMut(String) -> bool) {
    let mut bytes = [0; 4096];
    // The read fails when the program is gone.
    while let Ok(read @ 1..) = screen.read(&mut bytes) {
        let text = String::from_utf8_lossy(&bytes[..read]).into_owned();
        if text.contains("\x1b[c") {
            let flags = match keyboard {
                Keyboard::Plain => "",
                Keyboard::Kitty => "\x1b[?0u",
            };
            let answer = format!("{flags}\x1b[?62c");
            screen.write_all(answer.as_bytes()).expect("it is open");
        }
        if !pass(text) {
            break;
        }
    }
}
