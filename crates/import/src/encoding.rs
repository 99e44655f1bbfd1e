//! Text files with a declared encoding other than UTF-8: a byte order mark, or the XML declaration.

use encoding_rs::{Encoding, UTF_8, UTF_16BE, UTF_16LE};

use crate::error::SourceError;

/// Converts a file to UTF-8 if it declares another encoding; other files stay unchanged.
pub(crate) fn in_utf8(bytes: Vec<u8>) -> Result<Vec<u8>, SourceError> {
    let Some(encoding) = encoding_of(&bytes)? else {
        return Ok(bytes);
    };
    let mark = Encoding::for_bom(&bytes).map_or(0, |encoding| encoding.1);
    let text = encoding.decode_without_bom_handling_and_without_replacement(&bytes[mark..]);
    match text {
        Some(text) => Ok(text.into_owned().into_bytes()),
        // Any file may start with two bytes like a mark.
        None if mark > 0 => Ok(bytes),
        None => Err(SourceError::Encoding {
            name: encoding.name().to_owned(),
            problem: "but contains bytes that are not valid in it",
        }),
    }
}

/// The declared encoding of a file, if not UTF-8.
fn encoding_of(bytes: &[u8]) -> Result<Option<&'static Encoding>, SourceError> {
    let encoding = match Encoding::for_bom(bytes) {
        Some((encoding, _)) => encoding,
        None if bytes.starts_with(b"<\0?\0") => UTF_16LE,
        None if bytes.starts_with(b"\0<\0?") => UTF_16BE,
        None => declared(bytes)?,
    };
    Ok((encoding != UTF_8).then_some(encoding))
}

/// The encoding in the XML declaration. A declaration readable as ASCII is not UTF-16, whatever it
/// declares.
fn declared(bytes: &[u8]) -> Result<&'static Encoding, SourceError> {
    let start = String::from_utf8_lossy(&bytes[..bytes.len().min(MAX_FIRST_LINE)]);
    let line = start.strip_prefix("<?xml");
    let line = line
        .and_then(|line| line.split_once("?>"))
        .map(|line| line.0);
    let value = line
        .and_then(|line| line.split_once("encoding"))
        .map(|line| line.1);
    let Some(quoted) = value.and_then(|value| value.trim_start().strip_prefix('=')) else {
        return Ok(UTF_8);
    };
    let name = quoted.split(['"', '\'']).nth(1).unwrap_or_default();
    match Encoding::for_label(name.as_bytes()) {
        Some(encoding) if encoding == UTF_16LE || encoding == UTF_16BE => Ok(UTF_8),
        Some(encoding) => Ok(encoding),
        None => Err(SourceError::Encoding {
            name: name.to_owned(),
            problem: "which is unknown",
        }),
    }
}

const MAX_FIRST_LINE: usize = 256;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    fn read(bytes: &[u8]) -> String {
        String::from_utf8(in_utf8(bytes.to_vec()).unwrap()).unwrap()
    }

    #[test]
    fn an_xml_file_is_read_in_its_declared_encoding() {
        let latin = b"<?xml version=\"1.0\" encoding='ISO-8859-1'?><svg id=\"K\xfcche\"/>";
        assert!(read(latin).ends_with("<svg id=\"Küche\"/>"));
        let cyrillic = b"<?xml version=\"1.0\" encoding = \"windows-1251\" ?><svg id=\"\xc4\"/>";
        assert!(read(cyrillic).ends_with("<svg id=\"Д\"/>"));
    }

    #[test]
    fn a_text_in_utf_16_is_read_with_and_without_a_byte_order_mark() {
        let text = "<?xml version=\"1.0\" encoding=\"UTF-16\"?><svg id=\"Küche\"/>";
        let little: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
        for (mark, bytes) in [(&b"\xff\xfe"[..], &little), (b"\xfe\xff", &big)] {
            assert_eq!(read(bytes), text);
            assert_eq!(read(&[mark, bytes].concat()), text);
        }
        // Some programs keep the old declaration when they save as UTF-8.
        assert_eq!(read(text.as_bytes()), text);
    }

    #[test]
    fn a_text_without_a_declared_encoding_is_unchanged() {
        let plain: [&[u8]; 5] = [
            b"",
            b"G1 X1 (Fr\xe4ser)",
            b"<svg/>",
            b"<?xml encoding",
            b"\xff\xfeno text",
        ];
        for bytes in plain {
            assert_eq!(in_utf8(bytes.to_vec()).unwrap(), bytes);
        }
    }

    #[test]
    fn an_unknown_or_violated_encoding_is_reported() {
        for (bytes, message) in [
            (
                &b"<?xml encoding=\"klingon\"?><svg/>"[..],
                "the file declares the encoding \"klingon\", which is unknown; save it as UTF-8",
            ),
            (
                b"<?xml encoding=\"shift_jis\"?><svg id=\"\x81\"/>",
                "the file declares the encoding \"Shift_JIS\", but contains bytes that are not valid in it; save it as UTF-8",
            ),
        ] {
            let error = in_utf8(bytes.to_vec()).unwrap_err();
            assert_eq!(error.to_string(), message);
        }
    }
}
