//! The bytes of a script on their way to the arm.

use std::collections::VecDeque;
use std::time::Duration;

use crate::serial_line::STOCK_BYTE_TIME;
use crate::{ScriptLine, Start};

/// The bytes of a script, each at its time.
#[derive(Debug)]
pub(super) struct Feed<'a> {
    /// The lines not started.
    lines: &'a [ScriptLine],
    /// The rest of the current line.
    bytes: &'a [u8],
    /// The release time of the last line; its bytes may have started later.
    let_go: Duration,
    /// The arrival time of the last byte.
    line_free: Duration,
    /// The arrival times of statuses that a line may wait for.
    credits: VecDeque<Duration>,
}

impl<'a> Feed<'a> {
    pub(super) const fn new(lines: &'a [ScriptLine]) -> Self {
        Self {
            lines,
            bytes: &[],
            let_go: Duration::ZERO,
            line_free: Duration::ZERO,
            credits: VecDeque::new(),
        }
    }

    /// Records the arrival of a status, which may be in the future.
    pub(super) fn credit(&mut self, at: Duration) {
        self.credits.push_back(at);
    }

    /// Takes the next byte and its arrival time, if it arrives by then.
    pub(super) fn next_byte(&mut self, until: Duration) -> Option<(Duration, u8)> {
        if self.bytes.is_empty() {
            self.begin_next(until)?;
        }
        let arrival = self.line_free + STOCK_BYTE_TIME;
        let (&byte, rest) = self.bytes.split_first()?;
        if arrival > until {
            return None;
        }
        self.bytes = rest;
        self.line_free = arrival;
        Some((arrival, byte))
    }

    /// The number of lines not completely sent.
    pub(super) const fn unsent(&self) -> usize {
        self.lines.len() + if self.bytes.is_empty() { 0 } else { 1 }
    }

    /// Whether the next line waits for a status that has not been sent.
    pub(super) fn starves(&self) -> bool {
        self.bytes.is_empty()
            && self
                .lines
                .first()
                .is_some_and(|line| line.start == Start::Credit)
            && self.credits.back().is_none_or(|&at| at <= self.let_go)
    }

    /// The arrival time of the last byte.
    pub(super) const fn line_free(&self) -> Duration {
        self.line_free
    }

    fn begin_next(&mut self, until: Duration) -> Option<()> {
        let (line, rest) = self.lines.split_first()?;
        let at = match line.start {
            Start::At(at) => at.max(self.let_go),
            Start::Credit => self.next_credit()?,
        };
        if at > until {
            return None;
        }
        self.lines = rest;
        self.bytes = &line.bytes;
        self.let_go = at;
        self.line_free = self.line_free.max(at);
        Some(())
    }

    /// The arrival time of the first status after the last line was released.
    fn next_credit(&mut self) -> Option<Duration> {
        while self.credits.front().is_some_and(|&at| at <= self.let_go) {
            self.credits.pop_front();
        }
        self.credits.front().copied()
    }
}
