//! The id of a station.

use std::io::ErrorKind;
use std::path::Path;

use data_encoding::HEXLOWER;
use dobot_api::write_private;

/// Returns the id of the station with this file, 32 hexadecimal digits, creating it on the first
/// call.
///
/// # Errors
///
/// [`IdError`].
pub fn own_id(file: &Path) -> Result<String, IdError> {
    let at = || file.display().to_string();
    match std::fs::read_to_string(file) {
        Ok(text) => {
            let text = text.trim();
            let is_id = text.len() == 32 && text.bytes().all(|byte| byte.is_ascii_hexdigit());
            if is_id {
                return Ok(text.to_ascii_lowercase());
            }
            Err(IdError::Garbled { file: at() })
        }
        Err(error) if error.kind() == ErrorKind::NotFound => {
            let id = new_id().map_err(|error| IdError::File {
                file: at(),
                source: error.into(),
            })?;
            let written = write_private(file, format!("{id}\n"));
            written.map_err(|source| IdError::File { file: at(), source })?;
            Ok(id)
        }
        Err(source) => Err(IdError::File { file: at(), source }),
    }
}

/// Returns a unique id: 32 hexadecimal digits.
pub(crate) fn new_id() -> Result<String, getrandom::Error> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes)?;
    Ok(HEXLOWER.encode(&bytes))
}

/// The error returned when a station has no id.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum IdError {
    /// The file has invalid contents.
    #[error(
        "{file} does not contain 32 hexadecimal digits, the station's id in a fleet; delete the file to create a new id"
    )]
    Garbled {
        /// The file.
        file: String,
    },
    /// The file cannot be read, created or written.
    #[error("the station's id in a fleet cannot be stored in {file}")]
    File {
        /// The file.
        file: String,
        /// The cause.
        #[source]
        source: std::io::Error,
    },
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn a_station_keeps_its_number_and_another_station_has_another() {
        let folder = tempfile::tempdir().unwrap();
        let [one, other] = ["one", "other"].map(|name| folder.path().join(name));
        let first = own_id(&one).unwrap();
        assert_eq!(own_id(&one).unwrap(), first);
        assert_ne!(own_id(&other).unwrap(), first);
        std::fs::write(&one, "desk-3").unwrap();
        assert!(
            own_id(&one)
                .unwrap_err()
                .to_string()
                .contains("32 hexadecimal digits")
        );
    }
}
