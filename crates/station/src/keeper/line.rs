//! The line to the arm: one packet after the other, with the gap that a stock arm wants.

use std::time::Duration;

use dobot_wire::Packet;

use super::Keeper;

impl Keeper {
    /// The packet to send now, if there is one. What is urgent goes first; but nothing goes while
    /// the packet before is still on the line, for a stock arm may lose both. Only the first packet
    /// of a stop does not wait: it is said again anyway.
    pub fn poll_bytes(&mut self) -> Option<Packet> {
        if self.now < self.line_free && !std::mem::take(&mut self.at_once) {
            return None;
        }
        let packet = self
            .urgent
            .pop_front()
            .or_else(|| self.session.poll_bytes())?;
        self.at_once = false;
        self.line_free = self.now.max(self.line_free) + PACKET_AND_GAP;
        Some(packet)
    }

    /// Whether something urgent waits for the line.
    #[must_use]
    pub fn is_urgent(&self) -> bool {
        !self.urgent.is_empty()
    }

    /// When the line is free again, while something waits for that.
    pub(super) fn line_wakeup(&self) -> Option<Duration> {
        (self.now < self.line_free).then_some(self.line_free)
    }
}

/// 43.68 ms on the line, the 8 ms that a stock arm wants between two (note N26), and a bit.
const PACKET_AND_GAP: Duration = Duration::from_millis(55);
