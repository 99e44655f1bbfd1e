//! How good a link is.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_wire::{Counts, Status};

use crate::permit_scheme::ReceivedStatus;

/// How good a link is, as far as its statuses tell.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LinkQuality {
    /// Whether it leads to the Bluetooth port of a stock arm (note N38).
    pub bluetooth: bool,
    /// Statuses per second over the last two seconds; 12.5 on a good link with room in the queue, 18.75
    /// over Bluetooth.
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
#[derive(Clone, Debug, Default)]
pub(crate) struct Meter {
    /// From one status to the next, of those that tell where the arm is.
    period: Duration,
    heard: VecDeque<Duration>,
    /// When the last of them came.
    told: Option<Duration>,
    /// Messages since the last permit: one behind it, and one before the next (note N38).
    messages: u64,
    lost: u64,
    /// Of the lost ones those that may still come, in a heap with the one behind them.
    late: u64,
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
    pub(crate) fn new(period: Duration) -> Self {
        Self {
            period,
            ..Self::default()
        }
    }

    pub(crate) const fn period(&self) -> Duration {
        self.period
    }

    pub(crate) const fn set_period(&mut self, period: Duration) {
        self.period = period;
    }

    /// A motion left; it shows if nothing moved before.
    pub(crate) fn handle_sent(&mut self, now: Duration, at_rest: bool, moves: bool) {
        self.waits_since = (at_rest && moves).then_some(now);
    }

    pub(crate) fn handle_status(&mut self, now: Duration, heard: &ReceivedStatus, had_room: bool) {
        self.heard.push_back(now);
        while self.heard.front().is_some_and(|it| *it + WINDOW < now) {
            self.heard.pop_front();
        }
        self.note_permit(heard.permits);
        if !heard.tells {
            return;
        }
        if let Some(told) = self.told.replace(now)
            && had_room
        {
            let gap = now.saturating_sub(told);
            self.note_gap(gap);
            if gap <= self.period + MOST_JITTER {
                self.jitter = self.jitter.max(gap.saturating_sub(self.period));
            }
        }
        let status = heard.status;
        if self.last.replace(status).is_some_and(|it| it != status)
            && let Some(since) = self.waits_since.take()
        {
            self.note_latency(now.saturating_sub(since));
        }
    }

    /// What comes in a heap behind a gap was late, and not lost.
    fn note_gap(&mut self, gap: Duration) {
        if gap < self.period / 2 && self.late > 0 {
            self.late -= 1;
            self.lost -= 1;
        } else {
            self.late = self.missing(gap);
            self.lost += self.late;
        }
    }

    /// From a command to the first status that shows it, where that was measured.
    pub(crate) const fn latency(&self) -> Option<Duration> {
        self.latency
    }

    /// How many statuses are missing in a gap.
    fn missing(&self, gap: Duration) -> u64 {
        let periods = (gap + self.period / 2).as_millis() / self.period.as_millis();
        u64::try_from(periods).unwrap_or(u64::MAX).saturating_sub(1)
    }

    fn note_permit(&mut self, permits: bool) {
        self.messages = if permits { 0 } else { self.messages + 1 };
        if self.messages > MESSAGES {
            self.messages = 1;
            self.lost += 1;
        }
    }

    pub(crate) fn quality(&self, now: Duration, counts: &Counts) -> LinkQuality {
        LinkQuality {
            statuses_per_s: self.rate(now),
            bluetooth: false,
            lost: self.lost,
            damaged_bytes: counts.skipped_bytes,
            resyncs: counts.resyncs,
            latency: self.latency,
            silent_for: now.saturating_sub(self.heard.back().copied().unwrap_or_default()),
        }
    }

    /// How many came in a second lately; the time since the last one counts only where the next one is due.
    fn rate(&self, now: Duration) -> f64 {
        let recent = || self.heard.iter().filter(|it| **it + WINDOW >= now);
        let (Some(first), Some(last)) = (recent().next(), recent().next_back()) else {
            return 0.0;
        };
        let took = last
            .saturating_sub(*first)
            .max(now.saturating_sub(*first + self.period));
        let gaps = u32::try_from(recent().count() - 1).unwrap_or(u32::MAX);
        if took.is_zero() {
            return 0.0;
        }
        f64::from(gaps) / took.as_secs_f64()
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

/// So many messages stand between two permits over Bluetooth (note N38).
const MESSAGES: u64 = 2;
const WINDOW: Duration = Duration::from_secs(2);
/// How much later another command may show than the one that was seen: the two meet other phases
/// of the control tick and of what the arm calculates.
const PHASE: Duration = Duration::from_millis(60);
/// A packet each way at 9600 baud, a tick until it is taken, and one until that is told.
const FASTEST: Duration = Duration::from_millis(140);
/// The same over a link that is late by 0.2 s each way.
pub(crate) const UNSEEN: Duration = Duration::from_millis(560);
/// What varies more than that is a status that was lost.
const MOST_JITTER: Duration = Duration::from_millis(200);
/// What is later than that was put off by something else, or lost.
const SLOWEST: Duration = Duration::from_secs(2);
