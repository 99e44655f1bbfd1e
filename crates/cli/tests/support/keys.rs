//! An arm, and a person who moves it with keys.

use std::time::{Duration, Instant};

use dobot_wire::{Command, LinearJogAxis};

use super::PATIENCE;
use super::arm::{WiredArm, real_time_arm};
use super::program::command;
use super::terminal::{Keyboard, Terminal};
use super::wire::Passed;

/// An arm, and a person with keys.
pub(crate) struct Bench {
    arm: WiredArm,
    pub(crate) terminal: Terminal,
}

impl Bench {
    /// The arm keeps to a clock, as the keys do.
    pub(crate) fn new(verb: &[&str], keyboard: Keyboard) -> Self {
        let arm = WiredArm::new(real_time_arm(&["--tcp", "127.0.0.1:0"]));
        let to = ["--to", &arm.address, "--dialect", "specification"];
        let arguments = [verb, &to, &["--pose-confirmed"]].concat();
        let mut terminal = Terminal::new(&command(&arguments), keyboard);
        // The first screen is there.
        terminal.shows("STOP");
        Self { arm, terminal }
    }

    /// Waits for a command to the arm.
    pub(crate) fn gets(&self, mut is_match: impl FnMut(&Command) -> bool) -> Command {
        let until = Instant::now() + PATIENCE;
        loop {
            assert!(Instant::now() < until, "the arm does not get the command");
            if let Passed::ToArm(_, command) = self.arm.next()
                && is_match(&command)
            {
                return command;
            }
        }
    }

    /// Presses a key until the arm gets a command, and waits for it ten seconds each time. Keys that a busy program reads together are
    /// a paste, which is ignored.
    pub(crate) fn presses_until_sent(
        &mut self,
        key: &str,
        is_match: impl Fn(&Command) -> bool,
    ) -> Command {
        self.presses_each(200, key, is_match)
    }

    /// Presses a key each time that the arm has sent this many statuses, until it gets a command.
    fn presses_each(
        &mut self,
        interval: usize,
        key: &str,
        is_match: impl Fn(&Command) -> bool,
    ) -> Command {
        for _ in 0..50 {
            self.terminal.types(key);
            let mut statuses = 0;
            while statuses < interval {
                match self.arm.next() {
                    Passed::FromArm(..) => statuses += 1,
                    Passed::ToArm(_, command) if is_match(&command) => return command,
                    _ => {}
                }
            }
        }
        panic!("the arm does not get the command after {key:?}");
    }

    pub(crate) fn gets_jog(&self, axis: LinearJogAxis) {
        self.gets(|command| is_jog(command, axis));
    }

    /// Presses the arrow until the arm jogs by it: one press is over before an arm that runs down rests.
    pub(crate) fn jogs_forward(&mut self) {
        self.jogs(UP, LinearJogAxis::XPlus);
    }

    fn jogs(&mut self, arrow: &str, axis: LinearJogAxis) {
        self.presses_each(4, arrow, |command| is_jog(command, axis));
    }

    /// Presses an arrow until the arm rests at least this many mm farther along an axis: 0 for x, 1 for y.
    pub(crate) fn jogs_by(&mut self, arrow: &str, axis: usize, by_mm: f32) {
        let button = [LinearJogAxis::XPlus, LinearJogAxis::YPlus][axis];
        let began_mm = self.rests_at()[axis];
        // On a busy machine a press may be over before the arm has moved.
        while self.rests_at()[axis] < began_mm + by_mm {
            self.jogs(arrow, button);
            self.gets_jog(LinearJogAxis::Released);
        }
    }

    /// Presses a key again and again, as a person does who sees that nothing happens, until the screen shows a text.
    pub(crate) fn presses_until(&mut self, key: &str, text: &str) {
        const SEEN_WITHIN: Duration = Duration::from_millis(500);
        for _ in 0..100 {
            self.terminal.types(key);
            if self.terminal.screen_shows_within(SEEN_WITHIN, text) {
                return;
            }
        }
        panic!("`{text}` is missing after {key:?}");
    }

    /// Answers a question with a text, letter by letter.
    pub(crate) fn answers(&mut self, text: &str) {
        for (at, letter) in text.char_indices() {
            self.terminal.types(&letter.to_string());
            self.terminal
                .shows_one_of(&[&format!("{}█", &text[..at + letter.len_utf8()])]);
        }
        self.terminal.types("\r");
    }

    /// Waits for this many statuses, within which the arm gets no release.
    pub(crate) fn still_jogs_for(&self, statuses: usize) {
        let mut seen = 0;
        while seen < statuses {
            match self.arm.next() {
                Passed::FromArm(..) => seen += 1,
                Passed::ToArm(_, Command::LinearJog(jog)) => {
                    assert_ne!(jog.axis, LinearJogAxis::Released, "after {seen} statuses");
                }
                _ => {}
            }
        }
    }

    /// Waits until the arm reports the same position for two seconds, and returns its x in mm: on a busy machine the program
    /// learns later that it rests.
    pub(crate) fn rests(&self) -> f32 {
        let [x_mm, ..] = self.rests_at();
        x_mm
    }

    /// The same, with its whole position.
    pub(crate) fn rests_at(&self) -> [f32; 3] {
        let (mut last, mut same) = (None, 0);
        let until = Instant::now() + PATIENCE;
        while same < 25 {
            assert!(Instant::now() < until, "the arm does not rest");
            if let Passed::FromArm(_, status) = self.arm.next() {
                let place = Some([status.x_mm, status.y_mm, status.z_mm]);
                same = if place == last { same + 1 } else { 0 };
                last = place;
            }
        }
        last.unwrap_or([f32::NAN; 3])
    }

    pub(crate) fn leaves(self) {
        assert!(self.terminal.types_until_the_end("q").success());
    }
}

fn is_jog(command: &Command, axis: LinearJogAxis) -> bool {
    matches!(command, Command::LinearJog(jog) if jog.axis == axis)
}

/// The arrow as most terminals send it.
pub(crate) const UP: &str = "\x1b[A";
pub(crate) const LEFT: &str = "\x1b[D";
