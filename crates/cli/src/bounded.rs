//! Bounded reads of inputs that may never end.

use std::fs::File;
use std::io::{self, ErrorKind, Read};
use std::path::Path;

/// Reads all bytes, or one byte more than the maximum that `most` returns for the first bytes.
pub(crate) fn bytes(mut from: impl Read, most: impl FnOnce(&[u8]) -> u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let begun = from.by_ref().take(START).read_to_end(&mut bytes)?;
    let left = most(&bytes).saturating_add(1).saturating_sub(begun as u64);
    from.take(left).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Reads a settings file: a policy, defaults, materials or a calibration.
pub(crate) fn settings(file: &Path) -> io::Result<String> {
    let bytes = bytes(File::open(file)?, |_| MAX_SETTINGS)?;
    if bytes.len() as u64 > MAX_SETTINGS {
        let most_mb = MAX_SETTINGS / 1_000_000;
        let problem = format!(
            "it has more than {most_mb} MB, the maximum for a settings file; check that it is the right file"
        );
        return Err(io::Error::new(ErrorKind::FileTooLarge, problem));
    }
    let text = String::from_utf8(bytes);
    text.map_err(|_| io::Error::new(ErrorKind::InvalidData, "it is not UTF-8 text"))
}

/// The number of first bytes, which identify the kind of a file.
const START: u64 = 1000;
/// The maximum size of a settings file; the longest known one has about 10,000 bytes.
const MAX_SETTINGS: u64 = 1_000_000;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn input_up_to_the_limit_is_read_and_one_byte_beyond_it() {
        let read = |bytes: &[u8]| super::bytes(bytes, |_| 2000).expect("memory can be read");
        assert_eq!(read(&[7; 2000]), [7; 2000]);
        assert_eq!(read(&[7; 3000]), [7; 2001]);
        assert_eq!(read(b"1,2"), b"1,2");
        let endless = super::bytes(io::repeat(0), |_| 2000);
        assert_eq!(endless.expect("it never fails").len(), 2001);
    }
}
