//! How close packets may follow each other.

use core::time::Duration;

/// From a packet to the next that must not be lost, where there is no hurry: more than the 43.68 ms
/// that a packet takes on the line, and the 8 ms that a stock arm wants between two (note N26).
pub const PACKET_GAP: Duration = Duration::from_millis(60);
/// The time after which the line is free for the next packet: 43.68 ms, 8 ms and a margin (note N26).
pub const LINE_TIME: Duration = Duration::from_millis(55);
