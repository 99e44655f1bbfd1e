//! The line to the arm: one packet after the other, with the gap that a stock arm wants.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_session::Session;
use dobot_wire::Packet;

/// The line, and what is to go over it before all that waits.
#[derive(Debug, Default)]
pub(super) struct UrgentQueue {
    urgent: VecDeque<Packet>,
    /// When the packet before is over, and the gap behind it.
    free: Duration,
    /// The next urgent packet does not wait for that.
    at_once: bool,
}

impl UrgentQueue {
    pub(super) fn push(&mut self, packet: Packet) {
        self.urgent.push_back(packet);
    }

    pub(super) fn clear(&mut self) {
        self.urgent.clear();
    }

    /// The next urgent packet does not wait for the line.
    pub(super) const fn hurry(&mut self) {
        self.at_once = true;
    }

    pub(super) fn is_empty(&self) -> bool {
        self.urgent.is_empty()
    }

    /// The packet to send now, if there is one. What is urgent goes before all that waits, but behind
    /// a command that counts as sent already: what the arm averages depends on the order (note N49).
    /// Nothing goes while the packet before is still on the line, for a stock arm may lose both. Only
    /// the first packet of a stop waits for neither: it is said again anyway.
    pub(super) fn poll(&mut self, now: Duration, session: &mut Session) -> Option<Packet> {
        let at_once = std::mem::take(&mut self.at_once);
        if now < self.free && !at_once {
            return None;
        }
        let packet = if at_once || !session.has_bytes() {
            let urgent = self.urgent.pop_front();
            urgent.or_else(|| session.poll_bytes())?
        } else {
            session.poll_bytes()?
        };
        self.free = now.max(self.free) + PACKET_AND_GAP;
        Some(packet)
    }

    /// When it is free again, while something waits for that.
    pub(super) fn wakeup(&self, now: Duration) -> Option<Duration> {
        (now < self.free).then_some(self.free)
    }
}

/// 43.68 ms on the line, the 8 ms that a stock arm wants between two (note N26), and a bit.
const PACKET_AND_GAP: Duration = dobot_wire::LINE_TIME;
