//! The frame: ten floats between two delimiters.

use crate::table::whole_number;

/// Ten floats, numbered from 1 as in the tables (Tables 2.1 and 2.3).
///
/// A frame judges nothing: every bit pattern of every float survives the way from bytes to frame
/// and back, those of NaN included. What the floats mean is the business of
/// [`Command`](crate::Command) and [`Status`](crate::Status).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(transparent))]
pub struct Frame {
    floats: [f32; FLOATS],
}

impl Frame {
    /// Ten zeros: Appendix 1 wants every float that a command does not use to be 0.
    pub const ZERO: Self = Self {
        floats: [0.0; FLOATS],
    };

    /// Reads a packet; `None` where the delimiters are not `A5` and `5A`.
    #[must_use]
    #[inline]
    pub fn from_bytes(bytes: &[u8; PACKET_LEN]) -> Option<Self> {
        Self::is_delimited(bytes).then(|| Self::from_window(bytes))
    }

    /// The same frame with float `n` replaced.
    ///
    /// # Panics
    ///
    /// If `n` is not 1 to 10: the numbers are those of the tables, known when the code is written.
    #[must_use]
    pub const fn with(mut self, n: usize, value: f32) -> Self {
        self.floats[n - 1] = value;
        self
    }

    /// Float `n`.
    ///
    /// # Panics
    ///
    /// If `n` is not 1 to 10.
    #[must_use]
    #[inline]
    pub const fn float(&self, n: usize) -> f32 {
        self.floats[n - 1]
    }

    /// All ten floats in the order of the tables; float 1 is at index 0.
    #[must_use]
    #[inline]
    pub const fn floats(&self) -> &[f32; FLOATS] {
        &self.floats
    }

    /// Writes the packet: `A5`, ten floats with their low byte first, `5A`.
    #[must_use]
    pub fn to_bytes(&self) -> [u8; PACKET_LEN] {
        let mut bytes = [0; PACKET_LEN];
        bytes[0] = HEADER;
        let (floats, _) = bytes[1..].as_chunks_mut();
        for (bytes, float) in floats.iter_mut().zip(self.floats) {
            *bytes = float.to_le_bytes();
        }
        bytes[PACKET_LEN - 1] = TAIL;
        bytes
    }

    /// The frame that a sender with the other byte order meant.
    #[must_use]
    pub fn swapped(&self) -> Self {
        let floats = self
            .floats
            .map(|float| f32::from_be_bytes(float.to_le_bytes()));
        Self { floats }
    }

    /// The state of Table 2.2 that float 1 holds when all floats are read high byte first, if that makes
    /// sense of every float: 0, or a size that a command has. For a packet that is no command as it stands.
    #[must_use]
    pub fn big_endian_state(&self) -> Option<f32> {
        let swapped = self.swapped().floats;
        let [state, ..] = swapped;
        let is_sent =
            |float: &f32| *float == 0.0 || (SMALLEST_SENT..LARGEST_SENT).contains(&float.abs());
        let is_state = matches!(whole_number(state), Some(1..=10));
        (is_state && swapped.iter().all(is_sent)).then_some(state)
    }

    /// Whether a window begins and ends as a frame does.
    #[inline]
    pub(crate) const fn is_delimited(window: &[u8; PACKET_LEN]) -> bool {
        matches!(window, [HEADER, .., TAIL])
    }

    /// The floats of a window, whatever its delimiters.
    #[inline]
    pub(crate) fn from_window(window: &[u8; PACKET_LEN]) -> Self {
        let mut frame = Self::ZERO;
        let (floats, _) = window[1..].as_chunks();
        for (float, bytes) in frame.floats.iter_mut().zip(floats) {
            *float = f32::from_le_bytes(*bytes);
        }
        frame
    }
}

/// The length of every packet in bytes, both ways.
pub const PACKET_LEN: usize = 42;

/// The first byte of a frame.
pub const HEADER: u8 = 0xA5;

/// The last byte of a frame.
pub const TAIL: u8 = 0x5A;

const FLOATS: usize = 10;

/// No command needs a value nearer to 0, or as large.
const SMALLEST_SENT: f32 = 1e-4;
const LARGEST_SENT: f32 = 1e5;
