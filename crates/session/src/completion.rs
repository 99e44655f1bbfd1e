//! When a command is over: the protocol has no "done", so it is read off the statuses.
//!
//! Nothing here needs a clock on the other side, nor how long a motion takes. A status lies on the
//! straight way of one of the commands under way: all before that one are over. The arm came to rest
//! where one of them ends: that one is over when its pause is. The arm rests, and would have been
//! seen to begin by now whatever it was sent: all that is over, there or elsewhere. And a status comes
//! only while the arm's queue has room, so that no more commands can be under way than fit before
//! that (note N20).

mod geometry;

use std::time::Duration;

use dobot_arm::Position;
use dobot_wire::Status;

use self::geometry::{beside, is_at_limit};
use crate::NotReached;
use crate::in_flight::{InFlight, Sent};
use crate::plan::{ARRIVED_MM, position};

/// Watches the statuses for what is over.
#[derive(Clone, Debug, Default)]
pub(crate) struct Completion {
    seen: Option<Steady>,
    first: Option<First>,
    /// When a command was last seen to be over.
    freed: Duration,
    /// Up to then what is over explains why the arm rests.
    busy_until: Duration,
}

/// The last status, and since when all its values are the same.
#[derive(Clone, Copy, Debug)]
struct Steady {
    status: Status,
    heard: Duration,
    since: Duration,
    /// How many statuses in a row said the same.
    repeats: u32,
}

/// What is known of the command that is the first under way.
#[derive(Clone, Copy, Debug)]
struct First {
    number: u64,
    /// Since when it is the first.
    since: Duration,
    /// What the arm told then, and whether it rested.
    status: Status,
    rested: bool,
    /// How far along its straight way the arm was seen, so that it never goes back on it.
    progress_mm: f64,
    /// When the arm came to rest where it ends.
    arrived: Option<Duration>,
    told: bool,
}

/// What the statuses say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Verdict {
    /// So many of the first are over.
    Over(usize),
    /// The arm pauses behind the first one.
    Pauses,
    /// The first one is over or given up, and the arm is elsewhere than it leads.
    Missed(NotReached, Position),
}

/// What there is to judge by.
#[derive(Clone, Copy)]
struct Evidence<'a> {
    now: Duration,
    answer: Duration,
    seen: Steady,
    sent: &'a Sent,
    in_flight: &'a InFlight,
}

impl Completion {
    /// Takes a status.
    pub(crate) fn handle_status(&mut self, now: Duration, status: &Status) {
        // What was between two statuses that are far apart nobody knows.
        let same = |it: &Steady| it.status == *status && now.saturating_sub(it.heard) <= GAP;
        self.seen = Some(match self.seen.filter(same) {
            Some(seen) => Steady {
                heard: now,
                repeats: seen.repeats + 1,
                ..seen
            },
            None => Steady {
                status: *status,
                heard: now,
                since: now,
                repeats: 1,
            },
        });
    }

    /// What the last status says of the commands under way: to be asked again when that was obeyed,
    /// until it says nothing more. `answer` is how long it takes at the most until a status shows
    /// what was sent.
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
        let known = self.first.filter(|it| it.number == sent.number);
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

    /// What is to be said of the first command, if no later one says that it is over.
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
            // It led to where the arm was, or came back there between two statuses.
            first.arrived = Some(idle);
        }
        if let Some(arrived) = first.arrived {
            return self.arrived(look, first, arrived);
        }
        if !seen.rests() {
            return look.timed_out(first);
        }
        if sent.plan.target.is_none() {
            let came = seen.since > first.since && now >= sent.at + look.answer;
            return (came || now >= idle + sent.plan.pause).then_some(Verdict::Over(1));
        }
        self.missed(look, first)
    }

    /// What is to be said of a command where it ends: it is over when its pause is, or when the arm
    /// goes on.
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
        if plan.pause < TOLD || first.told {
            return None;
        }
        first.told = true;
        Some(Verdict::Pauses)
    }

    /// From when on the arm is surely idle, if it has not moved till then, and got the command of this
    /// index and all before: no pause explains that, and another command would show.
    fn idle(&self, look: &Evidence, first: &First, index: usize) -> Option<Duration> {
        let mut pauses = look.waits(first);
        for sent in look.in_flight.iter().take(index) {
            let here = sent.plan.target.is_none() || sent.plan.is_near(&look.seen.status);
            if here || sent.plan.trajectory.is_err() {
                pauses += sent.plan.pause;
            }
        }
        let later = look.in_flight.iter().take(index + 1).skip(1);
        pauses += later.map(|it| it.waits).sum();
        let sent = look.in_flight.get(index)?;
        let rests_since = look.seen.since.max(self.busy_until).max(sent.at);
        Some(rests_since + pauses + look.answer)
    }

    /// An arm that rests elsewhere has passed the end of the first command unseen, or gave it up.
    /// Statuses that come in a heap, after the computer stood still, tell of a time before.
    fn missed(&self, look: &Evidence, first: &First) -> Option<Verdict> {
        let (seen, plan) = (&look.seen, &look.sent.plan);
        let mut ends = look.in_flight.iter();
        let leads_here = |it: &Sent| it.plan.is_near(&seen.status) || it.plan.jogs_by(&seen.status);
        if let Some(later) = ends.position(leads_here) {
            let idle = self.idle(look, first, later)?;
            return (look.now >= idle).then_some(Verdict::Over(later));
        }
        // One that is refused or cut short may pause wherever the arm is.
        let mut idle = self.idle(look, first, 0)?;
        if plan.trajectory.is_err() {
            idle += plan.pause;
        }
        let waited = look.now.saturating_sub(look.sent.at.max(first.since));
        if seen.repeats < GIVEN_UP || waited < GIVEN_UP_AFTER || look.now < idle {
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
    /// How many commands are over because a later one goes on or has ended, and what is known of the
    /// one behind them.
    fn passed(&self, first: &First) -> (usize, Option<First>) {
        let (on_trajectory, progress_mm) = self.on_trajectory(first);
        let arrived_at = self.seen.came_to(self.answer, first, self.in_flight);
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

    /// How many commands lie before the one that the arm is seen to follow, and how far along it.
    fn on_trajectory(&self, first: &First) -> (usize, f64) {
        let found = position(&self.seen.status);
        for (index, sent) in self.in_flight.iter().enumerate() {
            let Some((from, to)) = sent.plan.trajectory.ok().and_then(|it| it.line()) else {
                if sent.plan.is_still() || sent.plan.is_endless() {
                    continue;
                }
                // An unknown way may cross those behind it.
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
            // Where a later way begins an earlier one may end, and those behind it come by again.
            break;
        }
        (0, first.progress_mm)
    }

    /// How many commands must be over because the arm has room again: a status comes only while
    /// three commands wait at the most, and one is executed (note N20).
    fn beyond_room(&self) -> usize {
        let arrived = |it: &&Sent| self.now.saturating_sub(it.at) >= self.answer;
        let arrived = self.in_flight.iter().take_while(arrived).count();
        arrived.saturating_sub(MOST_WITH_ROOM)
    }

    /// For how long a pause before the first command may begin anew: not if that command was there
    /// already when the one before it ended (note N47).
    fn waits(&self, first: &First) -> Duration {
        if self.sent.at + self.answer * 2 <= first.since {
            return Duration::ZERO;
        }
        self.sent.waits
    }

    /// The arm moves on although all would be over for long: that the first command is over need not
    /// have been seen.
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
            told: false,
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
    fn came_to(&self, answer: Duration, first: &First, in_flight: &InFlight) -> Option<usize> {
        if !self.rests() || self.since <= first.since {
            return None;
        }
        let goes_on = |index: usize| {
            let mut later = in_flight.iter().skip(index + 1);
            let next = later.find(|it| !it.plan.is_still());
            next.is_some_and(|it| it.at + answer <= self.since)
        };
        let rests = |(index, sent): (usize, &Sent)| {
            let pauses = !sent.plan.pause.is_zero();
            sent.plan.ends_at(&self.status) && (pauses || !goes_on(index))
        };
        in_flight.iter().enumerate().position(rests)
    }
}

/// That many equal statuses in a row: the arm is at rest.
const AT_REST: u32 = 2;
/// That many equal statuses in a row, more than a second: the arm will not go on by itself.
const GIVEN_UP: u32 = 15;
/// The time in which they come.
const GIVEN_UP_AFTER: Duration = Duration::from_secs(1);
/// Between two statuses that are as far apart some are missing: three in a row.
const GAP: Duration = Duration::from_millis(280);
/// Longer than the slowest motion, and not over.
const PATIENCE: Duration = Duration::from_secs(10);
/// A pause as long as this is told when it begins.
const TOLD: Duration = Duration::from_secs(5);
/// Three commands that wait and one that is executed: with one more no status comes.
const MOST_WITH_ROOM: usize = 4;
