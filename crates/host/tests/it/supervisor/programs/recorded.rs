//! Programs as recorded in `vectors/programs/`.

use std::fs;
use std::path::Path;

use dobot_wire::{Frame, PACKET_LEN};
use serde::Deserialize;

/// A program's packets and their outcome.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Program {
    #[serde(rename = "program")]
    pub(super) name: String,
    pub(super) does: String,
    /// It sends one packet for each status, as the vendor's client does.
    #[serde(default)]
    pub(super) one_per_status: bool,
    #[serde(default)]
    pub(super) within: Within,
    /// The readings of the tilt sensors of rear arm and forearm at power-up.
    #[serde(default = "as_usual")]
    pub(super) pose_deg: [f64; 2],
    /// When the arms are compared; if absent, wherever they rest.
    #[serde(default)]
    pub(super) looks_ms: Vec<u64>,
    pub(super) packets: Vec<RecordedPacket>,
    pub(super) end_ms: u64,
}

const fn as_usual() -> [f64; 2] {
    [45.0, 45.0]
}

/// The largest differences between two arms.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Within {
    pub(super) mm: f64,
    pub(super) deg: f64,
}

impl Default for Within {
    fn default() -> Self {
        Self {
            mm: 0.02,
            deg: 0.02,
        }
    }
}

/// A packet.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RecordedPacket {
    pub(super) at_ms: u64,
    #[serde(default)]
    floats: Vec<f32>,
    #[serde(default)]
    hex: String,
    /// The packet sent to the arm instead.
    sent: Option<Vec<f32>>,
    /// The notice about it.
    pub(super) notice: Option<String>,
    /// The reason for which it is refused.
    pub(super) refused: Option<String>,
    /// It would make a stock arm hang or lose its pose.
    #[serde(default)]
    pub(super) traps: bool,
}

impl RecordedPacket {
    /// The packet as the program sends it.
    pub(super) fn frame(&self) -> Frame {
        if self.hex.is_empty() {
            return frame(&self.floats);
        }
        let digits: Vec<u32> = self
            .hex
            .chars()
            .filter_map(|character| character.to_digit(16))
            .collect();
        let bytes = digits.chunks(2).map(|pair| pair[0] * 16 + pair[1]);
        let bytes: Vec<u8> = bytes.map(|byte| u8::try_from(byte).unwrap()).collect();
        let bytes: [u8; PACKET_LEN] = bytes.try_into().unwrap();
        Frame::from_bytes(&bytes).unwrap()
    }

    /// The packet as the arm gets it, if it does.
    pub(super) fn sent(&self) -> Option<Frame> {
        let sent = self.sent.as_deref().map_or_else(|| self.frame(), frame);
        self.refused.is_none().then_some(sent)
    }
}

fn frame(floats: &[f32]) -> Frame {
    let floats = (1..).zip(floats);
    floats.fold(Frame::ZERO, |frame, (n, value)| frame.with(n, *value))
}

/// A program by the name of its file.
pub(super) fn program(name: &str) -> Program {
    let path = folder().join(format!("{name}.json"));
    let text = fs::read_to_string(&path).unwrap();
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The names of all of them.
pub(super) fn names() -> Vec<String> {
    let files = fs::read_dir(folder()).unwrap();
    let paths = files.map(|file| file.unwrap().path());
    let mut names: Vec<String> = paths
        .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
        .collect();
    names.sort();
    names
}

fn folder() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../vectors/programs")
}
