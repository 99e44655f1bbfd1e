//! What a controller counts and refuses.

use heapless::Deque;

use crate::Refused;

/// What a controller has counted since power-up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Packets received whole, voice included.
    pub packets: u64,
    /// Bytes received that belong to no packet.
    pub skipped_bytes: u64,
    /// Commands that were begun.
    pub begun: u64,
    /// Packets and commands refused, for whatever reason.
    pub refused: u64,
    /// Statuses sent.
    pub statuses: u64,
    /// Statuses that were lost because they were not fetched.
    pub lost_statuses: u64,
}

/// What a controller counts and refuses, for its host to see.
#[derive(Debug, Default)]
pub(crate) struct Log {
    pub(crate) counters: Counters,
    refusals: Deque<Refused, REFUSALS_LEN>,
}

impl Log {
    pub(crate) const fn begun(&mut self) {
        self.counters.begun += 1;
    }

    pub(crate) fn refuse(&mut self, refused: Refused) {
        self.counters.refused += 1;
        if self.refusals.is_full() {
            self.refusals.pop_front();
        }
        self.refusals
            .push_back(refused)
            .expect("room was made just above");
    }

    pub(crate) fn poll_refused(&mut self) -> Option<Refused> {
        self.refusals.pop_front()
    }
}

const REFUSALS_LEN: usize = 8;
