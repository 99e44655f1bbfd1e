//! Compressed files: `.svgz`, and other files compressed with gzip.

use std::io::{ErrorKind, Read};

use flate2::read::MultiGzDecoder;

use crate::error::SourceError;
use crate::limits::MAX_BYTES;

/// Unpacks a gzip file; any other stays unchanged. Some small files expand to terabytes.
pub(crate) fn unpacked(bytes: Vec<u8>) -> Result<Vec<u8>, SourceError> {
    if !bytes.starts_with(GZIP) {
        return Ok(bytes);
    }
    let mut unpacked = Vec::new();
    let mut reader = MultiGzDecoder::new(bytes.as_slice()).take(MAX_BYTES + 1);
    let read = reader.read_to_end(&mut unpacked);
    read.map_err(|error| SourceError::Packed {
        problem: match error.kind() {
            ErrorKind::UnexpectedEof => "it ends too soon",
            _ => "it is damaged",
        },
    })?;
    if unpacked.len() as u64 > MAX_BYTES {
        return Err(SourceError::TooLarge { most: MAX_BYTES });
    }
    Ok(unpacked)
}

const GZIP: &[u8] = &[0x1f, 0x8b];

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use std::io::Write;

    use flate2::Compression;
    use flate2::write::GzEncoder;

    use super::*;

    fn packed(bytes: &[u8]) -> Vec<u8> {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
        encoder.write_all(bytes).unwrap();
        encoder.finish().unwrap()
    }

    #[test]
    fn packed_data_is_unpacked_and_other_data_is_unchanged() {
        assert_eq!(unpacked(packed(b"<svg/>")).unwrap(), b"<svg/>");
        assert_eq!(unpacked(b"<svg/>".to_vec()).unwrap(), b"<svg/>");
        assert_eq!(unpacked(Vec::new()).unwrap(), b"");
    }

    #[test]
    fn a_truncated_or_oversized_file_is_refused() {
        let whole = packed(b"<svg></svg>");
        let error = unpacked(whole[..whole.len() - 9].to_vec()).unwrap_err();
        let error = error.to_string();
        assert!(
            error.starts_with("cannot unpack the file (gzip): it ")
                && error.ends_with("; copy or download it again"),
            "{error}"
        );
        let bomb = packed(&vec![b' '; 64_000_001]);
        let error = unpacked(bomb).unwrap_err();
        assert!(error.to_string().contains("more than 64 MB"), "{error}");
    }
}
