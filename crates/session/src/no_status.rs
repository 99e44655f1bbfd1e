//! Why an open link has no status.

use dobot_wire::{Decoder, PACKET_LEN, Packet};

use crate::plausible;

/// The bytes that arrived instead of a status.
#[derive(Clone, Debug, PartialEq, Eq, Hash, thiserror::Error)]
#[non_exhaustive]
pub enum NoStatus {
    /// None.
    #[error("nothing was received")]
    Nothing,
    /// Statuses with the high byte of each float first.
    #[error(
        "the floats of its statuses are big-endian; Table 2.1 has the low byte of each float first"
    )]
    BigEndian,
    /// Text, as from a web server or another device.
    #[error("{bytes} bytes were received, but no valid status; they begin with {beginning:?}")]
    Text {
        /// The number of bytes.
        bytes: u64,
        /// The beginning of the text, printable ASCII.
        beginning: String,
    },
    /// Other bytes.
    #[error("{bytes} bytes were received, but no valid status")]
    Other {
        /// The number of bytes.
        bytes: u64,
    },
}

impl NoStatus {
    /// Returns what to do.
    #[must_use]
    pub const fn hint(&self) -> &'static str {
        match self {
            Self::Nothing => {
                "check that the arm is switched on, its cable plugged in, and the port its own: `dobot ports` lists the ports"
            }
            Self::BigEndian => "let the arm send the low byte of each float first",
            Self::Text { .. } => {
                "another device or program is there: `dobot ports` lists the serial ports; over TCP, check host and port"
            }
            Self::Other { .. } => {
                "check the line speed and the device: 9600 baud is usual, another one is named as in serial:/dev/ttyUSB0@115200; over TCP, check host and port"
            }
        }
    }
}

/// The bytes of a link since its last status.
#[derive(Clone, Debug, Default)]
pub struct StatusWait {
    /// The end of the bytes, where a packet may begin.
    end: Vec<u8>,
    is_swapped: bool,
    beginning: Vec<u8>,
    bytes: u64,
}

impl StatusWait {
    /// Handles bytes in which no status ended.
    pub fn handle_bytes(&mut self, bytes: &[u8]) {
        let free = BEGINNING.saturating_sub(self.beginning.len());
        self.beginning.extend(bytes.iter().take(free));
        self.bytes += bytes.len() as u64;
        self.end.extend(bytes);
        self.is_swapped |= self.end.windows(PACKET_LEN).any(is_swapped_status);
        self.end
            .drain(..self.end.len().saturating_sub(PACKET_LEN - 1));
    }

    /// Returns what arrived instead of a status.
    #[must_use]
    pub fn no_status(&self) -> NoStatus {
        let bytes = self.bytes;
        match self.text() {
            _ if self.is_swapped => NoStatus::BigEndian,
            _ if bytes == 0 => NoStatus::Nothing,
            Some(beginning) => NoStatus::Text { bytes, beginning },
            None => NoStatus::Other { bytes },
        }
    }

    /// The first line, if the beginning is text.
    fn text(&self) -> Option<String> {
        let is_text = |byte: &u8| matches!(byte, b' '..=b'~' | b'\t' | b'\r' | b'\n');
        let text = str::from_utf8(&self.beginning).ok()?;
        let line = text.lines().find(|line| !line.trim().is_empty())?;
        let is_text = self.beginning.iter().all(is_text);
        (is_text && line.len() >= SHORTEST_TEXT).then(|| line.trim().to_owned())
    }
}

/// Returns whether a window is a status with the high byte of each float first.
fn is_swapped_status(window: &[u8]) -> bool {
    let packet = window.try_into().ok().and_then(Packet::from_bytes);
    let Some(Packet::Frame(frame)) = packet else {
        return false;
    };
    let bytes = frame.swapped().to_bytes();
    Decoder::statuses(plausible).feed(&bytes).count() > 0
}

/// The bytes kept of a text.
const BEGINNING: usize = 60;
/// Fewer printable bytes are a coincidence.
const SHORTEST_TEXT: usize = 4;

#[cfg(test)]
mod tests {
    use super::*;

    fn after(bytes: &[u8], piece: usize) -> NoStatus {
        let mut wait = StatusWait::default();
        bytes.chunks(piece).for_each(|part| wait.handle_bytes(part));
        wait.no_status()
    }

    /// An arm with rear arm and forearm at 45 degrees: 135 sin 45 + 160 cos 45 + 55.07.
    fn big_endian_status() -> Vec<u8> {
        let floats: [f32; 10] = [263.6665, 0.0, -17.6777, 0.0, 0.0, 45.0, 45.0, 0.0, 0.0, 0.0];
        let body = floats.iter().flat_map(|float| float.to_be_bytes());
        [0xA5].into_iter().chain(body).chain([0x5A]).collect()
    }

    #[test]
    fn statuses_with_the_high_byte_first_are_named_in_any_pieces() {
        for piece in [1, 7, 42, 100] {
            let found = after(&big_endian_status().repeat(3), piece);
            assert_eq!(found, NoStatus::BigEndian);
        }
        assert!(NoStatus::BigEndian.to_string().contains("big-endian"));
    }

    #[test]
    fn a_text_is_shown_by_its_first_line() {
        let found = after(b"\r\nHTTP/1.1 400 Bad Request\r\nServer: x\r\n", 5);
        let text = found.to_string();
        assert!(
            text.ends_with("begin with \"HTTP/1.1 400 Bad Request\""),
            "{text}"
        );
    }

    #[test]
    fn other_bytes_are_counted() {
        assert_eq!(after(&[0xA5, 1, 2, 0x5A], 1), NoStatus::Other { bytes: 4 });
        assert_eq!(after(&[], 1), NoStatus::Nothing);
    }
}
