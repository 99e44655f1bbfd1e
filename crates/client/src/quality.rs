//! How good a link is.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_wire::{Counts, Status};

/// How good a link is, as far as its statuses tell.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LinkQuality {
    /// Statuses per second over the last two seconds; 12.5 on a good link with room in the queue.
    pub statuses_per_s: f64,
    /// Statuses that did not come although they were due and the queue had room.
    pub lost: u64,
    /// Bytes that belong to no status.
    pub damaged_bytes: u64,
    /// How often the stream of statuses was lost and found again.
    pub resyncs: u64,
    /// From a command to the first status that shows it, smoothed; `None` until it was seen once.
    pub latency: Option<Duration>,
    /// How long ago the last status came.
    pub silent_for: Duration,
}

/// Takes note of what a link does.
#[derive(Debug, Default)]
pub(crate) struct Meter {
    heard: VecDeque<Duration>,
    lost: u64,
    latency: Option<Duration>,
    /// The longest that it took from a command to the first status that shows it.
    slowest: Option<Duration>,
    /// How much later than the one before a status came, against its time.
    jitter: Duration,
    last: Option<Status>,
    /// When a command left for an arm at rest, and nothing has moved since.
    waits_since: Option<Duration>,
}

impl Meter {
    /// A motion left; it shows if nothing moved before.
    pub(crate) fn handle_sent(&mut self, now: Duration, at_rest: bool, moves: bool) {
        self.waits_since = (at_rest && moves).then_some(now);
    }

    pub(crate) fn handle_status(&mut self, now: Duration, status: &Status, had_room: bool) {
        if let Some(heard) = self.heard.back()
            && had_room
        {
            let gap = now.saturating_sub(*heard);
            self.lost += missing(gap);
            if gap <= PERIOD + MOST_JITTER {
                self.jitter = self.jitter.max(gap.saturating_sub(PERIOD));
            }
        }
        self.heard.push_back(now);
        while self.heard.front().is_some_and(|it| *it + WINDOW < now) {
            self.heard.pop_front();
        }
        if self.last.replace(*status).is_some_and(|it| it != *status)
            && let Some(since) = self.waits_since.take()
        {
            self.note_latency(now.saturating_sub(since));
        }
    }

    /// From a command to the first status that shows it, where that was measured.
    pub(crate) const fn latency(&self) -> Option<Duration> {
        self.latency
    }

    pub(crate) fn quality(&self, now: Duration, counts: &Counts) -> LinkQuality {
        let recent = self.heard.iter().filter(|it| **it + WINDOW >= now).count();
        let begun = now.min(WINDOW).as_secs_f64();
        LinkQuality {
            statuses_per_s: if begun > 0.0 {
                f64::from(u32::try_from(recent).unwrap_or(u32::MAX)) / begun
            } else {
                0.0
            },
            lost: self.lost,
            damaged_bytes: counts.skipped_bytes,
            resyncs: counts.resyncs,
            latency: self.latency,
            silent_for: now.saturating_sub(self.heard.back().copied().unwrap_or_default()),
        }
    }

    /// By when a status surely shows what was sent: until that was seen, on a link that is as slow
    /// as any; then as slow as it was seen, and as much slower as its statuses vary, each way.
    pub(crate) fn answer(&self) -> Duration {
        let Some(slowest) = self.slowest else {
            return UNSEEN;
        };
        let steady = (slowest + PHASE).clamp(FASTEST, SLOWEST);
        (steady + 2 * self.jitter).min(steady.max(UNSEEN))
    }

    fn note_latency(&mut self, found: Duration) {
        self.slowest = self.slowest.max(Some(found));
        self.latency = Some(match self.latency {
            Some(before) => (before * 7 + found) / 8,
            None => found,
        });
    }
}

/// How many statuses are missing in a gap.
fn missing(gap: Duration) -> u64 {
    let periods = (gap + PERIOD / 2).as_millis() / PERIOD.as_millis();
    u64::try_from(periods).unwrap_or(u64::MAX).saturating_sub(1)
}

/// A status comes that often (note N27).
const PERIOD: Duration = Duration::from_millis(80);
const WINDOW: Duration = Duration::from_secs(2);
/// How much later another command may show than the one that was seen: the two meet other phases
/// of the control tick and of what the arm calculates.
const PHASE: Duration = Duration::from_millis(60);
/// A packet each way at 9600 baud, a tick until it is taken, and one until that is told.
const FASTEST: Duration = Duration::from_millis(140);
/// The same over a link that is late by 0.2 s each way.
const UNSEEN: Duration = Duration::from_millis(560);
/// What varies more than that is a status that was lost.
const MOST_JITTER: Duration = Duration::from_millis(200);
/// What is later than that was put off by something else, or lost.
const SLOWEST: Duration = Duration::from_secs(2);
