//! The quality of a link.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_wire::{Counts, Status};

use crate::permit_scheme::ReceivedStatus;

/// The quality of a link, measured from its statuses.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct LinkQuality {
    /// Whether it leads to the Bluetooth port of a stock arm (note N38).
    pub bluetooth: bool,
    /// Statuses per second over the last two seconds; 12.5 on a good link with room in the queue, 18.75
    /// over Bluetooth.
    pub statuses_per_s: f64,
    /// Statuses that did not arrive although they were due and the arm's queue had room.
    pub lost: u64,
    /// Bytes that belong to no status.
    pub damaged_bytes: u64,
    /// Number of times the decoder lost and regained synchronisation.
    pub resyncs: u64,
    /// Time from a command to the first status that shows it, smoothed; `None` before the first measurement.
    pub latency: Option<Duration>,
    /// Time since the last status.
    pub silent_for: Duration,
}

/// Measures the quality of a link.
#[derive(Clone, Debug, Default)]
pub(crate) struct Meter {
    /// The period of the regular statuses.
    period: Duration,
    arrivals: VecDeque<Duration>,
    /// When the last regular status arrived.
    last_regular: Option<Duration>,
    /// Messages since the last permit: one follows it, one precedes the next (note N38).
    messages: u64,
    lost: u64,
    /// Lost statuses that may still arrive together with the next one.
    late: u64,
    latency: Option<Duration>,
    /// The longest time from a command to the first status that shows it.
    slowest: Option<Duration>,
    /// The largest delay of a status relative to the one before.
    jitter: Duration,
    last: Option<Status>,
    /// When a command was sent to an arm at rest, until a status shows motion.
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

    /// Handles that a command was sent. Its latency is visible if it moves an arm at rest.
    pub(crate) fn handle_sent(&mut self, now: Duration, at_rest: bool, moves: bool) {
        self.waits_since = (at_rest && moves).then_some(now);
    }

    pub(crate) fn handle_status(
        &mut self,
        now: Duration,
        received: &ReceivedStatus,
        had_room: bool,
    ) {
        self.arrivals.push_back(now);
        while self.arrivals.front().is_some_and(|at| *at + WINDOW < now) {
            self.arrivals.pop_front();
        }
        self.note_permit(received.permits);
        if !received.is_regular {
            return;
        }
        self.note_regular(now, had_room);
        let status = received.status;
        if self
            .last
            .replace(status)
            .is_some_and(|before| before != status)
            && let Some(since) = self.waits_since.take()
        {
            self.note_latency(now.saturating_sub(since));
        }
    }

    fn note_regular(&mut self, now: Duration, had_room: bool) {
        let Some(before) = self.last_regular.replace(now).filter(|_| had_room) else {
            return;
        };
        let gap = now.saturating_sub(before);
        self.note_gap(gap);
        if gap <= self.period + MAX_JITTER {
            self.jitter = self.jitter.max(gap.saturating_sub(self.period));
        }
    }

    /// Statuses that arrive together after a gap were late, not lost.
    fn note_gap(&mut self, gap: Duration) {
        if gap < self.period / 2 && self.late > 0 {
            self.late -= 1;
            self.lost -= 1;
        } else {
            self.late = self.missing(gap);
            self.lost += self.late;
        }
    }

    /// Time from a command to the first status that shows it, if measured.
    pub(crate) const fn latency(&self) -> Option<Duration> {
        self.latency
    }

    /// Number of statuses that are missing in a gap.
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
            silent_for: now.saturating_sub(self.arrivals.back().copied().unwrap_or_default()),
        }
    }

    /// Recent statuses per second. The time since the last one counts only when the next one is due.
    fn rate(&self, now: Duration) -> f64 {
        let recent = || self.arrivals.iter().filter(|at| **at + WINDOW >= now);
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

    /// Time after which a status certainly shows a command. Before the first measurement this assumes the
    /// slowest link; then it is the slowest measured time plus the jitter in each direction.
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

/// Messages between two permits over Bluetooth (note N38).
const MESSAGES: u64 = 2;
const WINDOW: Duration = Duration::from_secs(2);
/// How much later another command may become visible, because it meets another phase of the control tick.
const PHASE: Duration = Duration::from_millis(60);
/// A packet each way at 9600 baud, a tick until it is read and a tick until it is reported.
const FASTEST: Duration = Duration::from_millis(140);
/// The same over a link with a delay of 0.2 s each way.
pub(crate) const UNSEEN: Duration = Duration::from_millis(560);
/// A larger deviation is a lost status.
const MAX_JITTER: Duration = Duration::from_millis(200);
/// A longer latency has another cause, or the command was lost.
const SLOWEST: Duration = Duration::from_secs(2);
