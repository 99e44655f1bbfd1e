//! The counters and refusals of a controller.

use heapless::Deque;

use crate::Refused;

/// The counters of a controller since power-up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Counters {
    /// Complete packets received, including voice.
    pub packets: u64,
    /// Bytes received that belong to no packet.
    pub skipped_bytes: u64,
    /// Commands started.
    pub begun: u64,
    /// Packets and commands refused, for any reason.
    pub refused: u64,
    /// Statuses sent.
    pub statuses: u64,
    /// Statuses lost because they were not fetched.
    pub lost_statuses: u64,
}

/// The counters and the latest refusals.
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
            .expect("an entry was removed above");
    }

    pub(crate) fn poll_refused(&mut self) -> Option<Refused> {
        self.refusals.pop_front()
    }
}

const REFUSALS_LEN: usize = 8;
