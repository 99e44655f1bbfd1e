//! Voice control.

use crate::{PACKET_LEN, ParseError};

/// A spoken order as text (state 5; the document only names it, note N17 describes it).
///
/// As bytes it holds any forty; [`Voice::text`] judges them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
#[repr(align(4))] // As a frame: then both lie at one place in a packet, and reading is one copy.
pub struct Voice {
    /// The text, filled up with zeros.
    #[cfg_attr(feature = "serde", serde(with = "as_text"))]
    #[cfg_attr(
        feature = "schema",
        schemars(with = "alloc::string::String", length(max = 40))
    )]
    text: [u8; TEXT_LEN],
}

impl Voice {
    /// Takes a text of up to 40 bytes.
    ///
    /// # Errors
    ///
    /// [`ParseError::VoiceTooLong`] and [`ParseError::VoiceByte`] where the text does not fit a
    /// packet or is not printable ASCII.
    pub fn new(text: &str) -> Result<Self, ParseError> {
        let mut voice = Self {
            text: [0; TEXT_LEN],
        };
        voice
            .text
            .get_mut(..text.len())
            .ok_or(ParseError::VoiceTooLong { found: text.len() })?
            .copy_from_slice(text.as_bytes());
        voice.text()?;
        Ok(voice)
    }

    /// Reads a packet; `None` where the delimiters are not `B5` and `5B`.
    #[must_use]
    pub fn from_bytes(bytes: &[u8; PACKET_LEN]) -> Option<Self> {
        Self::is_delimited(bytes).then(|| Self::from_window(bytes))
    }

    /// The text without the zeros that fill it up.
    ///
    /// # Errors
    ///
    /// [`ParseError::VoiceByte`] where a byte is not printable ASCII, a zero inside included.
    #[expect(clippy::missing_panics_doc, reason = "printable ASCII is always UTF-8")]
    pub fn text(&self) -> Result<&str, ParseError> {
        let len = self
            .text
            .iter()
            .rposition(|&byte| byte != 0)
            .map_or(0, |last| last + 1);
        let text = &self.text[..len];
        match text.iter().position(|byte| !matches!(byte, b' '..=b'~')) {
            Some(at) => Err(ParseError::VoiceByte {
                byte: at + 1,
                found: text[at],
            }),
            None => Ok(core::str::from_utf8(text).expect("printable ASCII is UTF-8")),
        }
    }

    /// Writes the packet: `B5`, the text, `5B`.
    #[must_use]
    pub fn to_bytes(&self) -> [u8; PACKET_LEN] {
        let mut bytes = [0; PACKET_LEN];
        bytes[0] = VOICE_HEADER;
        bytes[1..=TEXT_LEN].copy_from_slice(&self.text);
        bytes[PACKET_LEN - 1] = VOICE_TAIL;
        bytes
    }

    /// Whether a window begins and ends as a voice packet does.
    #[inline]
    pub(crate) const fn is_delimited(window: &[u8; PACKET_LEN]) -> bool {
        matches!(window, [VOICE_HEADER, .., VOICE_TAIL])
    }

    /// The text of a window, whatever its delimiters.
    #[inline]
    pub(crate) const fn from_window([_, text @ .., _]: &[u8; PACKET_LEN]) -> Self {
        Self { text: *text }
    }
}

#[cfg(feature = "serde")]
mod as_text {
    use alloc::string::String;

    use serde::{Deserialize as _, Deserializer, Serializer, de, ser};

    use super::{TEXT_LEN, Voice};

    pub(super) fn serialize<S: Serializer>(
        text: &[u8; TEXT_LEN],
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        let voice = Voice { text: *text };
        serializer.serialize_str(voice.text().map_err(ser::Error::custom)?)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<[u8; TEXT_LEN], D::Error> {
        let text = String::deserialize(deserializer)?;
        Voice::new(&text)
            .map(|voice| voice.text)
            .map_err(de::Error::custom)
    }
}

/// The first byte of a voice packet.
pub const VOICE_HEADER: u8 = 0xB5;

/// The last byte of a voice packet.
pub const VOICE_TAIL: u8 = 0x5B;

const TEXT_LEN: usize = PACKET_LEN - 2;
