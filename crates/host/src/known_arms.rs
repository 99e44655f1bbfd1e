//! What is known of each arm that was met: which dialect it speaks, and how that was found.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use dobot_api::Calibrations;
use dobot_wire::{Dialect, Finding};
use serde::{Deserialize, Serialize};

/// What is known of each arm, in a file that a person can read and change.
#[derive(Debug)]
pub(crate) struct KnownArms {
    file: PathBuf,
    known: BTreeMap<String, KnownArm>,
}

/// What is known of one arm.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
struct KnownArm {
    #[serde(default)]
    dialect: Option<Dialect>,
    /// How that was found, in words; empty where a person has said it.
    #[serde(default)]
    evidence: Vec<String>,
    #[serde(flatten)]
    calibrations: Calibrations,
}

/// The new text of a file, still to be written.
#[derive(Debug)]
#[must_use]
pub(crate) struct NewText {
    file: PathBuf,
    text: String,
}

impl NewText {
    pub(crate) fn of(file: &Path, content: &impl Serialize) -> io::Result<Self> {
        Ok(Self {
            file: file.to_owned(),
            text: toml::to_string(content).map_err(io::Error::other)?,
        })
    }

    /// Writes the file first beside the old one, so that a crash leaves one of the two whole.
    pub(crate) fn write(&self) -> io::Result<()> {
        let beside = self.file.with_extension("new");
        fs::write(&beside, &self.text)?;
        fs::rename(&beside, &self.file)
    }
}

/// Why the file of the arms is of no use.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum KnownArmsError {
    /// It cannot be read.
    #[error("cannot read {file}")]
    Read {
        /// The file.
        file: String,
        /// Why.
        #[source]
        source: io::Error,
    },
    /// It does not say what it should.
    #[error("{file} is not what is known of arms: {why}")]
    Content {
        /// The file.
        file: String,
        /// What is wrong with it.
        why: String,
    },
}

impl KnownArms {
    pub(crate) fn read(file: &Path) -> Result<Self, KnownArmsError> {
        let text = read_file(file).map_err(|source| KnownArmsError::Read {
            file: file.display().to_string(),
            source,
        })?;
        let known = match text {
            None => BTreeMap::new(),
            Some(text) => toml::from_str(&text).map_err(|error| KnownArmsError::Content {
                file: file.display().to_string(),
                why: error.to_string(),
            })?,
        };
        Ok(Self {
            file: file.to_owned(),
            known,
        })
    }

    /// The dialect of the arm at an address, if that is known.
    pub(crate) fn dialect(&self, address: &str) -> Option<Dialect> {
        self.known.get(address).and_then(|it| it.dialect)
    }

    /// How the arm at an address differs from the drawing of it, as far as that is known.
    pub(crate) fn calibrations(&self, address: &str) -> Calibrations {
        let known = self.known.get(address);
        known.map_or_else(Calibrations::default, |it| it.calibrations.clone())
    }

    /// Takes what an arm speaks, and how that was found, if it was.
    pub(crate) fn keep(
        &mut self,
        address: &str,
        dialect: Dialect,
        finding: Option<&Finding>,
    ) -> io::Result<Option<NewText>> {
        let evidence = finding.map(Finding::lines).unwrap_or_default();
        self.change(address, |it| {
            it.dialect = Some(dialect);
            it.evidence = evidence;
        })
    }

    /// Takes how an arm differs from the drawing of it.
    pub(crate) fn calibrate(
        &mut self,
        address: &str,
        calibrations: Calibrations,
    ) -> io::Result<Option<NewText>> {
        self.change(address, |it| it.calibrations = calibrations)
    }

    fn change(
        &mut self,
        address: &str,
        change: impl FnOnce(&mut KnownArm),
    ) -> io::Result<Option<NewText>> {
        let before = self.known.get(address);
        let mut arm = before.cloned().unwrap_or_default();
        change(&mut arm);
        if before == Some(&arm) {
            return Ok(None);
        }
        self.known.insert(address.to_owned(), arm);
        NewText::of(&self.file, &self.known).map(Some)
    }
}

/// A file of text, if there is one.
pub(crate) fn read_file(file: &Path) -> io::Result<Option<String>> {
    match fs::read_to_string(file) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        read => read.map(Some),
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_api::CalibrationFile;

    use super::*;

    #[test]
    fn what_was_found_of_an_arm_is_known_the_next_time() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("arms.toml");
        let mut arms = KnownArms::read(&file).unwrap();
        assert_eq!(arms.dialect("serial:/dev/ttyUSB0@9600"), None);
        let new = arms.keep("serial:/dev/ttyUSB0@9600", Dialect::FIRMWARE_1_1, None);
        new.unwrap().unwrap().write().unwrap();
        let same = arms.keep("serial:/dev/ttyUSB0@9600", Dialect::FIRMWARE_1_1, None);
        assert!(same.unwrap().is_none(), "there is nothing new to write");
        let again = KnownArms::read(&file).unwrap();
        let known = again.dialect("serial:/dev/ttyUSB0@9600");
        assert_eq!(known, Some(Dialect::FIRMWARE_1_1));
        assert_eq!(again.dialect("serial:/dev/ttyUSB1@9600"), None);
    }

    #[test]
    fn a_calibration_is_kept_beside_the_dialect_of_its_arm() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("arms.toml");
        let mut arms = KnownArms::read(&file).unwrap();
        let mut known = CalibrationFile::default();
        known.zeros.rear = 3.5;
        let calibrations = Calibrations {
            calibration: Some(known),
            before: Some(CalibrationFile::default()),
        };
        let _overwritten = arms.keep("tcp:lab:9", Dialect::FIRMWARE_1_1, None);
        let new = arms.calibrate("tcp:lab:9", calibrations.clone());
        new.unwrap().unwrap().write().unwrap();
        let again = KnownArms::read(&file).unwrap();
        assert_eq!(again.calibrations("tcp:lab:9"), calibrations);
        assert_eq!(again.dialect("tcp:lab:9"), Some(Dialect::FIRMWARE_1_1));
        assert_eq!(again.calibrations("tcp:lab:8"), Calibrations::default());
    }

    #[test]
    fn a_file_that_was_spoiled_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("arms.toml");
        fs::write(&file, "[arm]\ndialect = \"klingon\"").unwrap();
        let error = KnownArms::read(&file).unwrap_err().to_string();
        assert!(error.contains("arms.toml"), "{error}");
    }
}
