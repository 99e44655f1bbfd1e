//! The terminal of the pendant: its screen, and what it tells of its keys.

use std::io::{self, IsTerminal, stdout};
use std::time::Duration;

use anyhow::anyhow;
use crossterm::event::{
    DisableFocusChange, EnableFocusChange, KeyboardEnhancementFlags as Flags,
    PopKeyboardEnhancementFlags, PushKeyboardEnhancementFlags,
};
use crossterm::execute;
use crossterm::terminal::supports_keyboard_enhancement;
use ratatui::{DefaultTerminal, Frame};
use tokio::time::Instant;

use super::KeyReports;
use crate::failure::Failure;

/// The screen, until it is dropped.
#[derive(Debug)]
pub(crate) struct Screen {
    terminal: DefaultTerminal,
    keys: KeyReports,
    free_from: Instant,
}

impl Screen {
    /// Takes the terminal, and has it tell when a key is let go if it can.
    pub(crate) fn open() -> io::Result<Self> {
        // From here on a panic restores the terminal, too.
        let terminal = ratatui::try_init()?;
        // One that does not answer tells presses alone.
        let tells = supports_keyboard_enhancement().unwrap_or(false);
        let screen = Self {
            terminal,
            keys: if tells || cfg!(windows) {
                KeyReports::Releases
            } else {
                KeyReports::Presses
            },
            free_from: Instant::now(),
        };
        execute!(stdout(), EnableFocusChange)?;
        if tells {
            execute!(stdout(), PushKeyboardEnhancementFlags(FLAGS))?;
        }
        Ok(screen)
    }

    /// What the terminal tells of its keys.
    pub(crate) const fn keys(&self) -> KeyReports {
        self.keys
    }

    /// From when on it is to be drawn anew: an arm tells more than a person sees, and no key waits for that.
    pub(crate) const fn free_from(&self) -> Instant {
        self.free_from
    }

    /// Draws anew.
    pub(crate) fn draw(&mut self, draw: impl FnOnce(&mut Frame)) -> io::Result<()> {
        self.terminal.draw(draw)?;
        self.free_from = Instant::now() + FRAME;
        Ok(())
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        // A terminal that is gone needs nothing.
        if self.keys == KeyReports::Releases && !cfg!(windows) {
            let _ = execute!(stdout(), PopKeyboardEnhancementFlags);
        }
        let _ = execute!(stdout(), DisableFocusChange);
        ratatui::restore();
    }
}

/// Whether a person sits at a terminal; `instead` is what a program does.
pub(crate) fn check_terminal(what: &str, instead: &str) -> Result<(), Failure> {
    if io::stdin().is_terminal() && io::stdout().is_terminal() {
        return Ok(());
    }
    Err(Failure::new(anyhow!("{what} needs a terminal"), instead))
}

/// Thirty pictures a second.
const FRAME: Duration = Duration::from_millis(33);
/// With presses, repeats and releases of all keys.
const FLAGS: Flags = Flags::DISAMBIGUATE_ESCAPE_CODES
    .union(Flags::REPORT_EVENT_TYPES)
    .union(Flags::REPORT_ALL_KEYS_AS_ESCAPE_CODES);
