//! The bytes of a script on their way to the arm.

use std::collections::VecDeque;
use std::time::Duration;

use crate::serial_line::STOCK_BYTE_TIME;
use crate::{ScriptLine, Start};

/// The bytes of a script, each at its time.
#[derive(Debug)]
pub(super) struct Feed<'a> {
    /// The lines that have not begun.
    lines: &'a [ScriptLine],
    /// What is left of the line under way.
    bytes: &'a [u8],
    /// When the last line was let go; its bytes may have begun later.
    let_go: Duration,
    /// When the last byte has arrived.
    line_free: Duration,
    /// When the statuses have arrived that a line may wait for.
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

    /// Notes that a status arrives at that time, which may lie ahead.
    pub(super) fn credit(&mut self, at: Duration) {
        self.credits.push_back(at);
    }

    /// The next byte and when it arrives, if it does by then.
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

    /// How many lines are not sent whole.
    pub(super) const fn unsent(&self) -> usize {
        self.lines.len() + if self.bytes.is_empty() { 0 } else { 1 }
    }

    /// Whether the next line waits for a status that has not been sent.
    pub(super) fn starves(&self) -> bool {
        self.bytes.is_empty()
            && self
                .lines
                .first()
                .is_some_and(|it| it.start == Start::Credit)
            && self.credits.back().is_none_or(|&at| at <= self.let_go)
    }

    /// When the last byte has arrived.
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

    /// When the first status arrives after the last line was let go.
    fn next_credit(&mut self) -> Option<Duration> {
        while self.credits.front().is_some_and(|&at| at <= self.let_go) {
            self.credits.pop_front();
        }
        self.credits.front().copied()
    }
}
