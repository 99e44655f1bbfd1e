//! The line to the arm: one packet at a time, with the gap that a stock arm needs.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_session::Session;
use dobot_wire::Packet;

/// The line, and the urgent packets that go before waiting ones.
#[derive(Debug, Default)]
pub(super) struct UrgentQueue {
    urgent: VecDeque<Packet>,
    /// When the previous packet and its gap are over.
    free: Duration,
    /// Whether the next urgent packet does not wait for that.
    at_once: bool,
}

impl UrgentQueue {
    pub(super) fn push(&mut self, packet: Packet) {
        self.urgent.push_back(packet);
    }

    pub(super) fn clear(&mut self) {
        self.urgent.clear();
    }

    /// Lets the next urgent packet not wait for the line.
    pub(super) const fn hurry(&mut self) {
        self.at_once = true;
    }

    pub(super) fn is_empty(&self) -> bool {
        self.urgent.is_empty()
    }

    /// Returns the packet to send now, if any. Urgent packets go before waiting ones, but after a
    /// command that counts as sent: the arm's averaging depends on the order (note N49). Nothing is
    /// sent while the previous packet is on the line, because a stock arm may lose both. Only the
    /// first packet of a stop waits for neither; it is repeated anyway.
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

    /// Returns when the line is free again, while something waits for it.
    pub(super) fn wakeup(&self, now: Duration) -> Option<Duration> {
        (now < self.free).then_some(self.free)
    }
}

/// 43.68 ms on the line, the 8 ms that a stock arm needs between packets (note N26), and a margin.
const PACKET_AND_GAP: Duration = dobot_wire::LINE_TIME;
