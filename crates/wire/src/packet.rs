//! The packets that travel from client to controller.

use crate::{Frame, PACKET_LEN, Voice};

/// A packet from client to controller: a frame or a voice command (note N17).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Packet {
    /// Ten floats between `A5` and `5A`.
    Frame(Frame),
    /// Forty bytes of text between `B5` and `5B`.
    Voice(Voice),
}

impl Packet {
    /// Reads a packet; `None` where the delimiters are neither a frame's nor a voice command's.
    #[must_use]
    pub fn from_bytes(bytes: &[u8; PACKET_LEN]) -> Option<Self> {
        Frame::from_bytes(bytes)
            .map(Self::Frame)
            .or_else(|| Voice::from_bytes(bytes).map(Self::Voice))
    }

    /// Writes the packet.
    #[must_use]
    pub fn to_bytes(&self) -> [u8; PACKET_LEN] {
        match self {
            Self::Frame(frame) => frame.to_bytes(),
            Self::Voice(voice) => voice.to_bytes(),
        }
    }
}

impl From<Frame> for Packet {
    fn from(frame: Frame) -> Self {
        Self::Frame(frame)
    }
}

impl From<Voice> for Packet {
    fn from(voice: Voice) -> Self {
        Self::Voice(voice)
    }
}
