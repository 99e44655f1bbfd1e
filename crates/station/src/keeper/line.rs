//! The line to the arm: one packet after the other, with the gap that a stock arm wants.

use std::time::Duration;

use dobot_wire::Packet;

use super::Keeper;

impl Keeper {
    /// The packet to send now, if there is one. What is urgent goes before all that waits, but behind
    /// a command that counts as sent already: what the arm averages depends on the order (note N49).
    /// Nothing goes while the packet before is still on the line, for a stock arm may lose both. Only
    /// the first packet of a stop waits for neither: it is said again anyway.
    pub fn poll_bytes(&mut self) -> Option<Packet> {
        let at_once = std::mem::take(&mut self.at_once);
        if self.now < self.line_free && !at_once {
            return None;
        }
        let packet = if at_once || !self.session.has_bytes() {
            let urgent = self.urgent.pop_front();
            urgent.or_else(|| self.session.poll_bytes())?
        } else {
            self.session.poll_bytes()?
        };
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
const PACKET_AND_GAP: Duration = dobot_wire::LINE_TIME;
