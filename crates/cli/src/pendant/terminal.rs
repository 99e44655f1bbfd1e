//! The terminal of the pendant: its screen and its key events.

use std::io::{self, IsTerminal, stdout};
use std::time::Duration;

use anyhow::anyhow;
use crossterm::event::{
    DisableBracketedPaste, DisableFocusChange, EnableBracketedPaste, EnableFocusChange,
    KeyboardEnhancementFlags as Flags, PopKeyboardEnhancementFlags, PushKeyboardEnhancementFlags,
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
    /// Opens the screen, and enables reports of key releases if the terminal supports them.
    pub(crate) fn open() -> io::Result<Self> {
        // From here on, a panic also restores the terminal.
        let terminal = ratatui::try_init()?;
        // A terminal that does not answer reports only presses.
        let reports_releases = supports_keyboard_enhancement().unwrap_or(false);
        let screen = Self {
            terminal,
            keys: if reports_releases || cfg!(windows) {
                KeyReports::Releases
            } else {
                KeyReports::Presses
            },
            free_from: Instant::now(),
        };
        execute!(stdout(), EnableFocusChange, EnableBracketedPaste)?;
        if reports_releases {
            execute!(stdout(), PushKeyboardEnhancementFlags(FLAGS))?;
        }
        Ok(screen)
    }

    /// The key events that the terminal reports.
    pub(crate) const fn keys(&self) -> KeyReports {
        self.keys
    }

    /// The time of the next drawing, which limits the frame rate.
    pub(crate) const fn free_from(&self) -> Instant {
        self.free_from
    }

    /// Draws the screen.
    pub(crate) fn draw(&mut self, draw: impl FnOnce(&mut Frame)) -> io::Result<()> {
        self.terminal.draw(draw)?;
        self.free_from = Instant::now() + FRAME;
        Ok(())
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        // Errors do not matter: the terminal may be gone.
        if self.keys == KeyReports::Releases && !cfg!(windows) {
            let _ = execute!(stdout(), PopKeyboardEnhancementFlags);
        }
        let _ = execute!(stdout(), DisableBracketedPaste, DisableFocusChange);
        ratatui::restore();
    }
}

/// Checks that there is a terminal; `instead` is the hint.
pub(crate) fn check_terminal(what: &str, instead: &str) -> Result<(), Failure> {
    if io::stdin().is_terminal() && io::stdout().is_terminal() {
        return Ok(());
    }
    Err(Failure::new(anyhow!("{what} needs a terminal"), instead))
}

/// Thirty frames per second.
const FRAME: Duration = Duration::from_millis(33);
/// Reports of presses, repeats and releases of all keys.
const FLAGS: Flags = Flags::DISAMBIGUATE_ESCAPE_CODES
    .union(Flags::REPORT_EVENT_TYPES)
    .union(Flags::REPORT_ALL_KEYS_AS_ESCAPE_CODES);
