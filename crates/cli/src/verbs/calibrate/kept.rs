//! What is kept of an arm: shown first, then written, with what was known before beside it.

use std::collections::VecDeque;
use std::io;
use std::path::PathBuf;

use dobot_api::CalibrationFile;
use dobot_calibrate::{read_calibration, write_calibration};

use super::{before, named};

/// Keeps a calibration in a file once it was shown.
#[derive(Debug)]
pub(super) struct Kept {
    /// What was known of the arm before.
    pub(super) known: Option<CalibrationFile>,
    file: PathBuf,
    /// What was shown and waits for the second key.
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

    /// A person did something else: what was shown has to be shown again.
    pub(super) fn forget_shown(&mut self) {
        self.shown = None;
    }

    /// What was shown is kept; what was not is shown first, in the words that come back.
    pub(super) fn keep(&mut self, found: CalibrationFile) -> Option<String> {
        let found = named(found, &self.file);
        if self.shown.take().as_ref() != Some(&found) {
            self.shown = Some(found);
            return Some(
                "this is what would be kept; w again keeps it, any other key does not".into(),
            );
        }
        if let Some(known) = &self.known {
            let text = write_calibration(known);
            self.files.push_back((before(&self.file), text));
        }
        let text = write_calibration(&found);
        self.files.push_back((self.file.clone(), text));
        None
    }

    /// A file that is to be written beside the calibration.
    pub(super) fn write(&mut self, file: PathBuf, text: String) {
        self.files.push_front((file, text));
    }

    pub(super) fn poll_file(&mut self) -> Option<(PathBuf, String)> {
        self.files.pop_front()
    }

    /// Takes what came of writing this text; tells the person.
    pub(super) fn handle_saved(&mut self, text: &str, saved: io::Result<()>) -> Option<String> {
        match saved {
            Ok(()) if self.files.is_empty() => {
                self.known = read_calibration(text).ok();
                Some(format!("kept in {}", self.file.display()))
            }
            Ok(()) => None,
            Err(error) => {
                // Without the one before it nothing is replaced.
                self.files.clear();
                Some(format!("not kept: {error}"))
            }
        }
    }
}
