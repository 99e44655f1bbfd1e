//! The known arms: the dialect of each, how it was detected, and the calibration.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use dobot_api::Calibrations;
use dobot_wire::{Dialect, Finding};
use serde::{Deserialize, Serialize};

/// The known arms, in a file that a person can read and edit.
#[derive(Debug)]
pub(crate) struct KnownArms {
    file: PathBuf,
    known: BTreeMap<String, KnownArm>,
}

/// A known arm.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
struct KnownArm {
    #[serde(default)]
    dialect: Option<Dialect>,
    /// The evidence for the dialect, in words; empty if a person has set it.
    #[serde(default)]
    evidence: Vec<String>,
    #[serde(flatten)]
    calibrations: Calibrations,
}

/// New content of a file, to be written.
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

    /// Writes a temporary file first, so that a crash leaves one complete file.
    pub(crate) fn write(&self) -> io::Result<()> {
        let beside = self.file.with_extension("new");
        fs::write(&beside, &self.text)?;
        fs::rename(&beside, &self.file)
    }
}

/// Why the file of known arms cannot be used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum KnownArmsError {
    /// It cannot be read.
    #[error("cannot read {file}")]
    Read {
        /// The file.
        file: String,
        /// The operating system's error.
        #[source]
        source: io::Error,
    },
    /// Its content is invalid.
    #[error("{file} is not a file of known arms: {why}")]
    Content {
        /// The file.
        file: String,
        /// The reason.
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

    /// Returns the dialect of the arm at an address, if known.
    pub(crate) fn dialect(&self, address: &str) -> Option<Dialect> {
        self.known.get(address).and_then(|known| known.dialect)
    }

    /// Returns the calibrations of the arm at an address.
    pub(crate) fn calibrations(&self, address: &str) -> Calibrations {
        let known = self.known.get(address);
        known.map_or_else(Calibrations::default, |known| known.calibrations.clone())
    }

    /// Records the dialect of an arm, and how it was detected, if it was.
    pub(crate) fn keep(
        &mut self,
        address: &str,
        dialect: Dialect,
        finding: Option<&Finding>,
    ) -> io::Result<Option<NewText>> {
        let evidence = finding.map(Finding::lines).unwrap_or_default();
        self.change(address, |known| {
            known.dialect = Some(dialect);
            known.evidence = evidence;
        })
    }

    /// Records the calibration of an arm.
    pub(crate) fn calibrate(
        &mut self,
        address: &str,
        calibrations: Calibrations,
    ) -> io::Result<Option<NewText>> {
        self.change(address, |known| known.calibrations = calibrations)
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

/// Reads a text file, if it exists.
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
    fn findings_about_an_arm_are_known_the_next_time() {
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
    fn a_damaged_file_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("arms.toml");
        fs::write(&file, "[arm]\ndialect = \"klingon\"").unwrap();
        let error = KnownArms::read(&file).unwrap_err().to_string();
        assert!(error.contains("arms.toml"), "{error}");
    }
}
