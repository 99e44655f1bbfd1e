//! The metadata of a recording: program, arm, dialect.

use std::collections::BTreeMap;

use dobot_wire::Dialect;
use jiff::Timestamp;

/// The metadata of a recording, stored in every file as MCAP metadata named `dobot`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct About {
    /// The recording program and its version, as in `dobot 0.1.0`.
    pub program: String,
    /// The arm's address, as in `serial:/dev/ttyUSB0`.
    pub address: String,
    /// The dialect of the arm; `None` if unknown.
    pub dialect: Option<Dialect>,
    /// The personality of a virtual arm, as in `firmware-1.1`; `None` for a real one.
    pub personality: Option<String>,
}

impl About {
    /// Returns the metadata of a file whose times count from `start`.
    pub(crate) fn metadata(&self, start: Timestamp) -> mcap::records::Metadata {
        let mut metadata = BTreeMap::from([
            (PROGRAM.to_owned(), self.program.clone()),
            (START.to_owned(), start.to_string()),
            (ADDRESS.to_owned(), self.address.clone()),
            (FORMAT.to_owned(), KNOWN.to_string()),
        ]);
        if let Some(dialect) = self.dialect {
            metadata.insert(DIALECT.to_owned(), dialect.to_string());
        }
        if let Some(personality) = &self.personality {
            metadata.insert(PERSONALITY.to_owned(), personality.clone());
        }
        mcap::records::Metadata {
            name: NAME.to_owned(),
            metadata,
        }
    }

    /// Checks that this version can read a file with this metadata. A file without a format has the first one.
    ///
    /// # Errors
    ///
    /// What was found and what to do, in one line.
    pub(crate) fn check_format(record: &mcap::records::Metadata) -> Result<(), String> {
        let format = record.metadata.get(FORMAT);
        let format = format.filter(|_| record.name == NAME);
        if format.is_none_or(|format| format.parse::<u32>().is_ok_and(|format| format <= KNOWN)) {
            return Ok(());
        }
        Err(format!(
            "the recording has format {}, written by {}; this version reads formats up to {KNOWN}: use a newer version",
            format.map_or("", String::as_str),
            record
                .metadata
                .get(PROGRAM)
                .map_or("another program", String::as_str),
        ))
    }

    /// Parses the metadata of a file and the start of its times; `None` for metadata of another
    /// kind. An unknown dialect becomes `None`.
    pub(crate) fn of_metadata(record: &mcap::records::Metadata) -> Option<(Self, Timestamp)> {
        let field = |name| record.metadata.get(name).cloned();
        let start = field(START)?.parse().ok()?;
        let about = Self {
            program: field(PROGRAM).unwrap_or_default(),
            address: field(ADDRESS).unwrap_or_default(),
            dialect: field(DIALECT).and_then(|name| name.parse().ok()),
            personality: field(PERSONALITY),
        };
        (record.name == NAME).then_some((about, start))
    }
}

const NAME: &str = "dobot";
const PROGRAM: &str = "program";
const START: &str = "start";
const ADDRESS: &str = "address";
const DIALECT: &str = "dialect";
const PERSONALITY: &str = "personality";
const FORMAT: &str = "format";
/// The newest format that this version knows, which it writes.
const KNOWN: u32 = 1;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn the_description_of_a_recording_survives_the_file() {
        let start: Timestamp = "2026-11-21T12:30:00.25Z".parse().unwrap();
        let real = About {
            program: "dobot 0.1.0".to_owned(),
            address: "serial:/dev/ttyUSB0".to_owned(),
            dialect: None,
            personality: None,
        };
        let virtual_arm = About {
            dialect: Some(Dialect::FIRMWARE_1_1),
            personality: Some("firmware-1.1".to_owned()),
            ..real.clone()
        };
        for about in [real, virtual_arm] {
            let read = About::of_metadata(&about.metadata(start)).unwrap();
            assert_eq!(read, (about, start));
        }
    }

    #[test]
    fn a_recording_of_a_newer_program_is_refused() {
        let mut metadata = About {
            program: "dobot 0.3.0".to_owned(),
            ..About::default()
        }
        .metadata(Timestamp::UNIX_EPOCH);
        assert_eq!(About::check_format(&metadata), Ok(()));
        metadata.metadata.insert(FORMAT.to_owned(), "2".to_owned());
        let error = About::check_format(&metadata).unwrap_err();
        for part in ["format 2", "dobot 0.3.0", "up to 1", "newer version"] {
            assert!(error.contains(part), "`{part}` is missing: {error}");
        }
        metadata.metadata.remove(FORMAT);
        assert_eq!(About::check_format(&metadata), Ok(()));
    }

    #[test]
    fn metadata_of_another_kind_is_not_mistaken_for_it() {
        let start = Timestamp::UNIX_EPOCH;
        let mut metadata = About::default().metadata(start);
        metadata.name = "camera".to_owned();
        assert_eq!(About::of_metadata(&metadata), None);
        let mut metadata = About::default().metadata(start);
        metadata
            .metadata
            .insert(START.to_owned(), "noon".to_owned());
        assert_eq!(About::of_metadata(&metadata), None);
    }
}
