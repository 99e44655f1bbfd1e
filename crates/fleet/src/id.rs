//! The number that a station goes by.

use std::io::ErrorKind;
use std::path::Path;

use data_encoding::HEXLOWER;
use dobot_api::write_private;

/// The number that the station with these data goes by, 32 hexadecimal digits: made once.
///
/// # Errors
///
/// [`IdError`].
pub fn own_id(file: &Path) -> Result<String, IdError> {
    let at = || file.display().to_string();
    match std::fs::read_to_string(file) {
        Ok(text) => {
            let text = text.trim();
            let is_id = text.len() == 32 && text.bytes().all(|it| it.is_ascii_hexdigit());
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
            let written = write_private(file, &format!("{id}\n"));
            written.map_err(|source| IdError::File { file: at(), source })?;
            Ok(id)
        }
        Err(source) => Err(IdError::File { file: at(), source }),
    }
}

/// A number that nothing else has: 32 hexadecimal digits.
pub(crate) fn new_id() -> Result<String, getrandom::Error> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes)?;
    Ok(HEXLOWER.encode(&bytes))
}

/// Why a station has no number.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum IdError {
    /// The file holds something else.
    #[error(
        "{file} does not hold 32 hexadecimal digits, the number that this station goes by in a fleet; delete it to get another one"
    )]
    Garbled {
        /// The file.
        file: String,
    },
    /// It cannot be read, made or written.
    #[error("the number that this station goes by in a fleet cannot be kept in {file}")]
    File {
        /// The file.
        file: String,
        /// Why.
        #[source]
        source: std::io::Error,
    },
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn a_station_keeps_its_number_and_another_one_has_another() {
        let folder = tempfile::tempdir().unwrap();
        let [one, other] = ["one", "other"].map(|it| folder.path().join(it));
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
