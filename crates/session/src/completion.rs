//! Detects the end of commands. The protocol has no "done", so the statuses are the evidence.
//!
//! This needs neither the arm's clock nor the duration of a motion:
//!
//! - A status on the straight path of an in-flight command: all earlier commands have ended.
//! - The arm comes to rest at the end of a command: it has ended when its pause has.
//! - The arm rests although the start of any command would be visible by now: all have ended, at their
//!   targets or elsewhere.
//! - A status arrives: the arm's queue has room, so at most as many commands are in flight as fit into
//!   the rest of it (note N20).

mod geometry;

use std::time::Duration;

use dobot_arm::Position;
use dobot_wire::Status;

use self::geometry::{beside, is_at_limit};
use crate::NotReached;
use crate::in_flight::{InFlight, Sent};
use crate::plan::{ARRIVED_MM, position};

/// Detects from the statuses which commands have ended.
#[derive(Clone, Debug, Default)]
pub(crate) struct Completion {
    seen: Option<Steady>,
    first: Option<First>,
    /// When the end of a command was last detected.
    freed: Duration,
    /// Until when the ended commands explain that the arm rests.
    busy_until: Duration,
}

/// The last status and when its values last changed.
#[derive(Clone, Copy, Debug)]
struct Steady {
    status: Status,
    received: Duration,
    since: Duration,
    /// Number of equal statuses in a row.
    repeats: u32,
}

/// What is known about the first in-flight command.
#[derive(Clone, Copy, Debug)]
struct First {
    number: u64,
    /// When it became the first.
    since: Duration,
    /// The status at that time, and whether the arm rested.
    status: Status,
    rested: bool,
    /// Progress along its straight path, in mm; it never decreases.
    progress_mm: f64,
    /// When the arm came to rest at its end.
    arrived: Option<Duration>,
    reported: bool,
}

/// A conclusion from the statuses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Verdict {
    /// This number of commands have ended, from the first.
    Over(usize),
    /// The arm pauses after the first command.
    Pauses,
    /// The first command has ended or was abandoned, and the arm is not at its target.
    Missed(NotReached, Position),
}

/// The evidence for a verdict.
#[derive(Clone, Copy)]
struct Evidence<'a> {
    now: Duration,
    answer: Duration,
    seen: Steady,
    sent: &'a Sent,
    in_flight: &'a InFlight,
}

impl Completion {
    /// Handles a status.
    pub(crate) fn handle_status(&mut self, now: Duration, status: &Status) {
        // Between two statuses that are far apart, anything may have happened.
        let same =
            |last: &Steady| last.status == *status && now.saturating_sub(last.received) <= GAP;
        self.seen = Some(match self.seen.filter(same) {
            Some(seen) => Steady {
                received: now,
                repeats: seen.repeats + 1,
                ..seen
            },
            None => Steady {
                status: *status,
                received: now,
                since: now,
                repeats: 1,
            },
        });
    }

    /// Returns the next conclusion from the last status. The caller applies it and polls again until
    /// `None`. `answer` is the longest time until a status shows a sent command.
    pub(crate) fn poll(
        &mut self,
        now: Duration,
        answer: Duration,
        in_flight: &InFlight,
    ) -> Option<Verdict> {
        let (seen, sent) = (self.seen?, in_flight.first()?);
        let look = Evidence {
            now,
            answer,
            seen,
            sent,
            in_flight,
        };
        let known = self.first.filter(|first| first.number == sent.number);
        let mut first = known.unwrap_or_else(|| First::new(sent, self.freed.max(sent.at), &seen));
        let (over, next) = look.passed(&first);
        if over > 0 {
            self.finish(now, next);
            return Some(Verdict::Over(over));
        }
        first = next.unwrap_or(first);
        let verdict = self.judge(&look, &mut first);
        self.first = Some(first);
        match verdict {
            Some(Verdict::Over(over)) => {
                let next = in_flight.get(over);
                self.finish(now, next.map(|next| First::new(next, now, &seen)));
            }
            Some(Verdict::Missed(..)) => {
                self.busy_until = now;
                self.finish(now, None);
            }
            Some(Verdict::Pauses) | None => {}
        }
        verdict
    }

    fn finish(&mut self, now: Duration, next: Option<First>) {
        self.freed = now;
        self.first = next;
    }

    /// Judges the first command, if no later command shows that it has ended.
    fn judge(&mut self, look: &Evidence, first: &mut First) -> Option<Verdict> {
        let (now, sent, seen) = (look.now, look.sent, &look.seen);
        if sent.plan.is_still() || sent.plan.is_endless() {
            let taken = first.since.max(sent.at + look.answer) + look.waits(first);
            let acted = first.acted(sent, seen) || now >= taken;
            return acted.then_some(Verdict::Over(1));
        }
        let idle = self.idle(look, first, 0)?;
        if first.arrived.is_none() && seen.rests() && now >= idle && sent.plan.is_near(&seen.status)
        {
            // It ended where the arm already was, or returned there between two statuses.
            first.arrived = Some(idle);
        }
        if let Some(arrived) = first.arrived {
            return self.arrived(look, first, arrived);
        }
        if !seen.rests() {
            return look.timed_out(first);
        }
        if sent.plan.target.is_none() {
            let is_received = seen.since > first.since && now >= sent.at + look.answer;
            return (is_received || now >= idle + sent.plan.pause).then_some(Verdict::Over(1));
        }
        self.missed(look, first)
    }

    /// Judges a command after arrival: it ends with its pause, or when the arm moves on.
    fn arrived(
        &mut self,
        look: &Evidence,
        first: &mut First,
        arrived: Duration,
    ) -> Option<Verdict> {
        let plan = &look.sent.plan;
        if look.now >= arrived + plan.pause || !plan.is_near(&look.seen.status) {
            if !plan.pause.is_zero() {
                self.busy_until = look.now;
            }
            return Some(Verdict::Over(1));
        }
        if plan.pause < LONG_PAUSE || first.reported {
            return None;
        }
        first.reported = true;
        Some(Verdict::Pauses)
    }

    /// From when on the arm is certainly idle if it has not moved and has received the commands up to
    /// `index`: no pause explains the rest, and a command would be visible.
    fn idle(&self, look: &Evidence, first: &First, index: usize) -> Option<Duration> {
        let mut pauses = look.waits(first);
        for sent in look.in_flight.iter().take(index) {
            let here = sent.plan.target.is_none() || sent.plan.is_near(&look.seen.status);
            if here || sent.plan.trajectory.is_err() {
                pauses += sent.plan.pause;
            }
        }
        let later = look.in_flight.iter().take(index + 1).skip(1);
        pauses += later.map(|sent| sent.waits).sum();
        let sent = look.in_flight.get(index)?;
        let rests_since = look.seen.since.max(self.busy_until).max(sent.at);
        Some(rests_since + pauses + look.answer)
    }

    /// Judges an arm that rests elsewhere: it passed the end of the first command unseen, or abandoned it.
    /// Statuses that arrive together, after the computer was suspended, are old.
    fn missed(&self, look: &Evidence, first: &First) -> Option<Verdict> {
        let (seen, plan) = (&look.seen, &look.sent.plan);
        let mut ends = look.in_flight.iter();
        let ends_here =
            |sent: &Sent| sent.plan.is_near(&seen.status) || sent.plan.jogs_by(&seen.status);
        if let Some(later) = ends.position(ends_here) {
            let idle = self.idle(look, first, later)?;
            return (look.now >= idle).then_some(Verdict::Over(later));
        }
        // A command that is refused or cut short can pause anywhere.
        let mut idle = self.idle(look, first, 0)?;
        if plan.trajectory.is_err() {
            idle += plan.pause;
        }
        let waited = look.now.saturating_sub(look.sent.at.max(first.since));
        if seen.repeats < ABANDONED || waited < ABANDONED_AFTER || look.now < idle {
            return None;
        }
        let reason = if plan.leaves_limits() || is_at_limit(&seen.status, plan.after.tool) {
            NotReached::AtLimit
        } else {
            NotReached::Stalled
        };
        Some(Verdict::Missed(reason, plan.target?))
    }
}

impl Evidence<'_> {
    /// Number of commands that have ended because a later one runs or has ended, and what is known about the
    /// next one.
    fn passed(&self, first: &First) -> (usize, Option<First>) {
        let (on_trajectory, progress_mm) = self.on_trajectory(first);
        let arrived_at = self.seen.arrived_at(self.answer, first, self.in_flight);
        let over = on_trajectory
            .max(self.beyond_room())
            .max(arrived_at.unwrap_or(0));
        let arrived = (arrived_at == Some(over)).then_some(self.seen.since);
        let next = if over == 0 {
            *first
        } else if let Some(next) = self.in_flight.get(over) {
            First::new(next, self.now, &self.seen)
        } else {
            return (over, None);
        };
        let next = First {
            progress_mm: if over == on_trajectory {
                progress_mm
            } else {
                0.0
            },
            arrived: next.arrived.or(arrived),
            ..next
        };
        (over, Some(next))
    }

    /// Number of commands before the one that the arm follows, and the progress along it.
    fn on_trajectory(&self, first: &First) -> (usize, f64) {
        let found = position(&self.seen.status);
        for (index, sent) in self.in_flight.iter().enumerate() {
            let Some((from, to)) = sent.plan.line() else {
                if sent.plan.is_still() || sent.plan.is_endless() {
                    continue;
                }
                // An unknown path may cross later ones.
                break;
            };
            let (aside, along) = beside(from, to, found);
            let back = index == 0 && along < first.progress_mm - ARRIVED_MM;
            if aside > ARRIVED_MM || back {
                continue;
            }
            if index == 0 || along > ARRIVED_MM {
                return (index, along);
            }
            // An earlier path may end where a later one starts, and later ones may pass here again.
            break;
        }
        (0, first.progress_mm)
    }

    /// Number of commands that must have ended because the arm's queue has room again: a status arrives
    /// only while at most three commands wait and one is executed (note N20).
    fn beyond_room(&self) -> usize {
        let arrived = |sent: &&Sent| self.now.saturating_sub(sent.at) >= self.answer;
        let arrived = self.in_flight.iter().take_while(arrived).count();
        arrived.saturating_sub(MAX_WITH_ROOM)
    }

    /// How much the pause before the first command can grow: not at all if the arm had that command
    /// before the previous one ended (note N47).
    fn waits(&self, first: &First) -> Duration {
        if self.sent.at + self.answer * 2 <= first.since {
            return Duration::ZERO;
        }
        self.sent.waits
    }

    /// The arm still moves long after everything should have ended: the end of the first command may have
    /// been missed.
    fn timed_out(&self, first: &First) -> Option<Verdict> {
        let waited = self.now.saturating_sub(first.since);
        let expected = self.sent.plan.target?;
        (waited > self.in_flight.longest_silence().saturating_add(PATIENCE))
            .then_some(Verdict::Missed(NotReached::TimedOut, expected))
    }
}

impl First {
    fn new(sent: &Sent, since: Duration, seen: &Steady) -> Self {
        Self {
            number: sent.number,
            since,
            status: seen.status,
            rested: seen.rests(),
            progress_mm: 0.0,
            arrived: None,
            reported: false,
        }
    }

    /// Whether the status shows that a command without an end of its own acts: it looks as it should
    /// and did not before, or an arm at rest begins to move.
    fn acted(&self, sent: &Sent, seen: &Steady) -> bool {
        if sent.plan.is_endless() {
            return self.rested && self.status != seen.status;
        }
        !sent.plan.shows(&self.status) && sent.plan.shows(&seen.status)
    }
}

impl Steady {
    const fn rests(&self) -> bool {
        self.repeats >= AT_REST
    }

    /// The first command of which the arm has come to rest where it ends, since it moved. It would not
    /// rest there without a pause, had it got another one to go on with.
    fn arrived_at(&self, answer: Duration, first: &First, in_flight: &InFlight) -> Option<usize> {
        if !self.rests() || self.since <= first.since {
            return None;
        }
        let continues = |index: usize| {
            let mut later = in_flight.iter().skip(index + 1);
            let next = later.find(|sent| !sent.plan.is_still());
            next.is_some_and(|sent| sent.at + answer <= self.since)
        };
        let rests = |(index, sent): (usize, &Sent)| {
            let pauses = !sent.plan.pause.is_zero();
            sent.plan.ends_at(&self.status) && (pauses || !continues(index))
        };
        in_flight.iter().enumerate().position(rests)
    }
}

/// Equal statuses in a row that show an arm at rest.
const AT_REST: u32 = 2;
/// Equal statuses in a row, more than a second of them, after which the arm will not continue by itself.
const ABANDONED: u32 = 15;
/// The minimum time for [`ABANDONED`].
const ABANDONED_AFTER: Duration = Duration::from_secs(1);
/// A longer gap between two statuses means that three or more are missing.
const GAP: Duration = Duration::from_millis(280);
/// How long to wait beyond the slowest motion.
const PATIENCE: Duration = Duration::from_secs(10);
/// A pause of at least this length is reported when it starts.
const LONG_PAUSE: Duration = Duration::from_secs(5);
/// Three waiting commands and one that is executed; with one more the arm sends no status.
const MAX_WITH_ROOM: usize = 4;
