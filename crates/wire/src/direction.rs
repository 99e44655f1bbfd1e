//! The two directions of the line and their plausibility checks.

use crate::{Frame, HEADER, PACKET_LEN, Packet, VOICE_HEADER, Voice};

/// A direction of the line: [`Statuses`] or [`Commands`].
pub trait Direction: sealed::Sealed {
    /// The type of packets in this direction.
    type Item;

    /// Whether a packet can begin with this byte.
    fn begins(byte: u8) -> bool;

    /// Whether to trust a window; `locked` means that the previous packet ended where this one starts.
    fn trusts(&self, window: &[u8; PACKET_LEN], locked: bool) -> bool;

    /// Reads a trusted window.
    fn read(window: &[u8; PACKET_LEN]) -> Self::Item;
}

/// From controller to client: frames that hold a [`Status`](crate::Status).
///
/// A window is trusted only when it is plausible, locked or not (note N22).
#[derive(Clone, Copy, Debug)]
pub struct Statuses {
    plausible: fn(&Frame) -> bool,
}

impl Statuses {
    pub(crate) const fn new(plausible: fn(&Frame) -> bool) -> Self {
        Self { plausible }
    }
}

impl Direction for Statuses {
    type Item = Frame;

    #[inline]
    fn begins(byte: u8) -> bool {
        byte == HEADER
    }

    #[inline]
    fn trusts(&self, window: &[u8; PACKET_LEN], _: bool) -> bool {
        Frame::is_delimited(window) && {
            let frame = Frame::from_window(window);
            is_status(&frame) && (self.plausible)(&frame)
        }
    }

    #[inline]
    fn read(window: &[u8; PACKET_LEN]) -> Frame {
        Frame::from_window(window)
    }
}

/// From client to controller: frames that hold a [`Command`](crate::Command), and voice packets.
///
/// In lock a window is trusted by its delimiters alone, so that a bad command is refused and not
/// lost; without lock it must be plausible (note N24).
#[derive(Clone, Copy, Debug)]
pub struct Commands;

impl Direction for Commands {
    type Item = Packet;

    #[inline]
    fn begins(byte: u8) -> bool {
        byte == HEADER || byte == VOICE_HEADER
    }

    #[inline]
    fn trusts(&self, window: &[u8; PACKET_LEN], locked: bool) -> bool {
        if Frame::is_delimited(window) {
            let frame = Frame::from_window(window);
            return is_state(frame.float(1)) && (locked || is_sized(&frame))
                || locked && is_bad_in_place(window);
        }
        Voice::is_delimited(window)
            && (Voice::from_window(window).text().is_ok() || locked && is_bad_in_place(window))
    }

    #[inline]
    fn read(window: &[u8; PACKET_LEN]) -> Packet {
        if window[0] == HEADER {
            Packet::Frame(Frame::from_window(window))
        } else {
            Packet::Voice(Voice::from_window(window))
        }
    }
}

mod sealed {
    pub trait Sealed {}

    impl Sealed for super::Statuses {}

    impl Sealed for super::Commands {}
}

/// Whether a frame may be a status by itself: every float in range and isGrab 0 or 1 (note N22).
#[inline]
fn is_status(frame: &Frame) -> bool {
    let floats = frame.floats();
    let in_range = floats
        .iter()
        .zip(STATUS_LIMITS)
        .fold(true, |all, (float, limit)| all & (float.abs() <= limit));
    let is_grab = floats[8].to_bits();
    in_range && (is_grab == 0 || is_grab == 1.0_f32.to_bits())
}

/// The states of Table 2.2, and the undocumented 15 (note N25).
#[inline]
fn is_state(float: f32) -> bool {
    STATES.contains(&float)
}

/// Whether every float has a size that somebody sends: bytes read at the wrong place mostly give
/// numbers beyond it (note N24).
fn is_sized(frame: &Frame) -> bool {
    frame
        .floats()
        .iter()
        .all(|float| float.abs() <= COMMAND_LIMIT && !float.is_subnormal())
}

/// Whether a window is a bad packet in the right place, not a good one read at the wrong place: in
/// the latter the true header lies inside (note N24).
#[cold]
fn is_bad_in_place(window: &[u8; PACKET_LEN]) -> bool {
    !window[1..].windows(5).any(|bytes| {
        bytes[0] == HEADER && is_state(f32::from_le_bytes([bytes[1], bytes[2], bytes[3], bytes[4]]))
    })
}

const STATES: [f32; 11] = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 15.0];

/// The largest absolute value of a float of a command, whatever its unit (note N24).
const COMMAND_LIMIT: f32 = 1e6;

/// The largest absolute value of each float of a status, in millimetres and degrees (note N22).
const STATUS_LIMITS: [f32; 10] = [
    2000.0, 1000.0, 1000.0, // X with the 1000 of note N38, Y, Z
    1000.0, // rHead
    190.0, 179.0, 179.0,  // base, rear arm, forearm
    1000.0, // servo
    1.0,    // isGrab
    3600.0, // gripper
];
