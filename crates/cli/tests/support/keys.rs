//! An arm, and a person who moves it with keys.

use std::time::Instant;

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

    pub(crate) fn gets_jog(&self, axis: LinearJogAxis) {
        self.gets(|command| is_jog(command, axis));
    }

    /// Presses the arrow until the arm jogs by it: one press is over before an arm that runs down rests.
    pub(crate) fn jogs_forward(&mut self) {
        for _ in 0..50 {
            self.terminal.types(UP);
            let mut statuses = 0;
            while statuses < 4 {
                match self.arm.next() {
                    Passed::FromArm(..) => statuses += 1,
                    Passed::ToArm(_, command) if is_jog(&command, LinearJogAxis::XPlus) => return,
                    _ => {}
                }
            }
        }
        panic!("the arm does not jog");
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
        last.map_or(f32::NAN, |[x_mm, _, _]| x_mm)
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
