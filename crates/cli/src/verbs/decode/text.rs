//! Bytes as text.

mod digits;
mod dump;
mod list;
mod python;
mod socat;

use super::input::Input;
use data_encoding::HEXLOWER_PERMISSIVE;

/// Reads bytes from a text in any of the formats.
///
/// # Errors
///
/// If the text has none of the formats.
pub(super) fn read(text: &str) -> anyhow::Result<Input> {
    if let Some(input) = socat::read(text) {
        return input;
    }
    let formats = [python::read, dump::read, list::read];
    let found = formats.into_iter().find_map(|read| read(text));
    let Bytes { format, bytes } = found.unwrap_or_else(|| digits::read(text))?;
    Ok(Input::plain(format, bytes))
}

/// Bytes and their text format.
#[derive(Debug, PartialEq)]
struct Bytes {
    format: &'static str,
    bytes: Vec<u8>,
}

/// Whether a text contains only code around bytes: names, brackets and signs.
fn is_code(text: &str) -> bool {
    let is_sign = |letter: char| letter.is_whitespace() || "()[]{},;:+=>*".contains(letter);
    text.split(is_sign).all(|word| {
        word.chars()
            .all(|letter| letter.is_alphanumeric() || "_.".contains(letter))
    })
}

/// Parses one or two hex digits.
fn hex_byte(digits: &str) -> Option<u8> {
    let is_hex = digits.len() <= 2 && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
    is_hex
        .then(|| u8::from_str_radix(digits, 16).ok())
        .flatten()
}

/// Parses hex digits, two for each byte.
fn hex_bytes(digits: &str) -> Option<Vec<u8>> {
    HEXLOWER_PERMISSIVE.decode(digits.as_bytes()).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The content of a text in one direction.
    fn bytes(text: &str) -> Result<Vec<u8>, String> {
        let input = read(text).map_err(|error| error.to_string())?;
        let [stream] = &input.streams[..] else {
            return Err(format!("{} streams", input.streams.len()));
        };
        Ok(stream.parts[0].bytes.clone())
    }

    #[test]
    fn digits_may_be_written_in_any_usual_form() {
        for text in [
            "a500ff41",
            "A5 00 ff41",
            "a5:00:ff:41",
            "A5,00,FF,41",
            "A5-00-FF-41",
            "a5, 00, ff, 41",
            "0xa5, 0x00, 0xff, 0x41",
            "0xa5 0x0 0xff 0x41",
            r"\xa5\x00\xffA".replace('A', r"\x41").as_str(),
            "a500\r\nff41\r\n",
            "# sent\na5 00 # half\n\nff 41\n",
            "// c\n0xa5,0x00,\n0xff,0x41,\n",
            "[165, 0, 255, 65]",
            "165,0,255,65",
            "bytes([165, 0, 0xff, 65])",
            "{ 0xa5, 0x00, 0xff, 0x41 };",
            "unsigned char a_bin[] = {\n  0xa5, 0x00, 0xff,\n  0x41\n};\nunsigned int a_bin_len = 4;\n",
            r"b'\xa5\x00\xffA'",
            r#"b"\xa5\x00\xffA""#,
            r"bytearray(b'\xa5\x00\xffA')",
            "sent = b'\\xa5\\x00'\nsent += b'\\xff' + b'A'\n",
            "[b'\\xa5\\x00', b'\\xffA']",
        ] {
            assert_eq!(bytes(text), Ok(vec![0xA5, 0, 0xFF, 0x41]), "{text}");
        }
    }

    #[test]
    fn python_escapes_are_all_read() {
        assert_eq!(
            bytes(r#"b'\t\n\r\\\'\"\0\a \101'"#),
            Ok(b"\t\n\r\\'\"\0\x07 A".to_vec())
        );
    }

    #[test]
    fn a_line_missing_from_a_dump_is_reported() {
        let od = "0000000 a5 00\n0000004 ff 41\n0000006\n";
        let hex = "000010 a5 00\n000020 ff 41\n";
        for (text, expected) in [
            (od, "line 2: offset is 0x4; expected 0x2"),
            (hex, "line 2: offset "),
        ] {
            let error = bytes(text).expect_err(text);
            assert!(error.contains(expected), "{text}: {error}");
        }
        assert_eq!(bytes("00a500 ff"), Ok(vec![0, 0xA5, 0, 0xFF]));
    }

    #[test]
    fn an_error_is_reported_with_its_line() {
        for (text, expected) in [
            (
                "hello",
                "line 1: `hello` is not hex digits; expected 0 to 9 and a to f, two for each byte",
            ),
            ("a5 00\nff zz", "line 2: `zz`"),
            ("a5 0", "found 3 hex digits; expected two for each byte"),
            ("a5:0:ff0", "line 1: `ff0`"),
            (
                "[165, 300]",
                "`300` is not a byte; expected 0 to 255 or 0x00 to 0xff",
            ),
            (r"b'\xa5\xz0'", "line 1: `\\xz0` "),
            ("b'\\xa5", "line 1: the bytes literal has no end"),
            ("x = 1\ny = b'\u{e9}'", "line 2: `\u{e9}`"),
            (
                "00000000: a500 ff41  ..\n00000010: a500  ..",
                "line 2: offset is 0x10; expected 0x4 after the lines before",
            ),
            ("00000000: a5zz  ..\n", "line 1: `a5zz`"),
        ] {
            let error = bytes(text).expect_err(text);
            assert!(error.contains(expected), "{text}: {error}");
        }
    }

    proptest::proptest! {
        #[test]
        fn no_text_makes_it_panic(text in "(?s).{0,200}") {
            let _ = read(&text);
        }

        #[test]
        fn no_text_that_looks_like_bytes_makes_it_panic(
            text in r"([0-9a-f]{1,8}|0x|\\x|b'|'|\[|\]|\{|\}|[:,> <|*#\\\n]|length=|from=|to=|é){0,60}",
        ) {
            let _ = read(&text);
        }

        #[test]
        fn hex_digits_are_the_bytes(expected: Vec<u8>, upper: bool, separator in " |:|,|-| 0x|") {
            let byte = |byte: &u8| if upper { format!("{byte:02X}") } else { format!("{byte:02x}") };
            let prefix = if separator == " 0x" { "0x" } else { "" };
            let text: Vec<_> = expected.iter().map(byte).collect();
            proptest::prop_assume!(!text.is_empty());
            proptest::prop_assert_eq!(bytes(&(prefix.to_owned() + &text.join(&separator))), Ok(expected));
        }
    }
}
