//! Saving of a calibration: shown first, then written, with the previous one beside it.

use std::collections::VecDeque;
use std::io;
use std::path::PathBuf;

use dobot_api::CalibrationFile;
use dobot_calibrate::{read_calibration, write_calibration};

use super::{before, named};

/// Saves a calibration in a file after it was shown.
#[derive(Debug)]
pub(super) struct Kept {
    /// The previous calibration.
    pub(super) known: Option<CalibrationFile>,
    file: PathBuf,
    /// The calibration that was shown and waits for the second key.
    shown: Option<CalibrationFile>,
    files: VecDeque<(PathBuf, String)>,
}

impl Kept {
    pub(super) const fn new(file: PathBuf, known: Option<CalibrationFile>) -> Self {
        Self {
            known,
            file,
            shown: None,
            files: VecDeque::new(),
        }
    }

    /// Handles another key: the calibration must be shown again.
    pub(super) fn forget_shown(&mut self) {
        self.shown = None;
    }

    /// Saves a calibration that was shown; otherwise shows it, and returns a text for the person.
    pub(super) fn save(&mut self, found: CalibrationFile) -> Option<String> {
        let found = named(found, &self.file);
        if self.shown.take().as_ref() != Some(&found) {
            self.shown = Some(found);
            return Some("press w again to save this calibration, any other key to cancel".into());
        }
        if let Some(known) = &self.known {
            let text = write_calibration(known);
            self.files.push_back((before(&self.file), text));
        }
        let text = write_calibration(&found);
        self.files.push_back((self.file.clone(), text));
        None
    }

    /// Adds a file to be written beside the calibration.
    pub(super) fn write(&mut self, file: PathBuf, text: String) {
        self.files.push_front((file, text));
    }

    pub(super) fn poll_file(&mut self) -> Option<(PathBuf, String)> {
        self.files.pop_front()
    }

    /// Handles the result of writing a file; returns a text for the person.
    pub(super) fn handle_saved(&mut self, text: &str, saved: io::Result<()>) -> Option<String> {
        match saved {
            Ok(()) if self.files.is_empty() => {
                self.known = read_calibration(text).ok();
                Some(format!("saved in {}", self.file.display()))
            }
            Ok(()) => None,
            Err(error) => {
                // Without a copy of the previous one nothing is replaced.
                self.files.clear();
                Some(format!("not saved: {error}"))
            }
        }
    }
}
