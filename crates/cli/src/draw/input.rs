//! The bytes of a drawing: of a file or of standard input, as many as a drawing may have.

use std::fs::File;
use std::io::{self, ErrorKind, Read};
use std::path::Path;

use anyhow::{Context, anyhow};

use crate::failure::Failure;

/// Reads a whole file, or standard input where it is `-`.
pub(super) fn read(file: &Path) -> Result<Vec<u8>, Failure> {
    if file == Path::new("-") {
        let read = limited(io::stdin().lock(), MOST_BYTES);
        let bytes = read.context("cannot read standard input")?;
        return bytes.ok_or_else(|| too_large("standard input"));
    }
    let read = File::open(file).and_then(|it| limited(it, MOST_BYTES));
    let bytes = read.map_err(|error| unread(file, error))?;
    bytes.ok_or_else(|| too_large(&file.display().to_string()))
}

/// All that comes, or nothing where that is more than `most` bytes: some inputs never end.
fn limited(from: impl Read, most: u64) -> io::Result<Option<Vec<u8>>> {
    let mut bytes = Vec::new();
    let read = from.take(most + 1).read_to_end(&mut bytes)?;
    Ok((read as u64 <= most).then_some(bytes))
}

fn too_large(name: &str) -> Failure {
    let most_mb = MOST_BYTES / 1_000_000;
    Failure::new(
        anyhow!("{name} has more than {most_mb} MB, and a drawing may have {most_mb} MB"),
        "is it the right one? draw it in parts, or leave out detail that no pen shows",
    )
}

fn unread(file: &Path, error: io::Error) -> Failure {
    let missing = error.kind() == ErrorKind::NotFound;
    let error = anyhow::Error::from(error).context(format!("cannot read {}", file.display()));
    if missing {
        return Failure::new(
            error,
            "give the name of a drawing; examples/drawings/ has some of each kind",
        );
    }
    error.into()
}

/// A dense drawing of an hour has some ten.
const MOST_BYTES: u64 = 256_000_000;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_as_long_as_allowed_is_read_and_one_byte_more_is_not() {
        let read = |bytes: &[u8]| limited(bytes, 4).expect("memory can be read");
        assert_eq!(read(b"1,2\n"), Some(b"1,2\n".to_vec()));
        assert_eq!(read(b"1,2,3"), None);
        assert!(limited(io::repeat(0), 4).expect("it never fails").is_none());
    }
}
