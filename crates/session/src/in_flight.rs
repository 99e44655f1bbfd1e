//! In-flight commands and when each of them ends.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_motion::Model;
use dobot_wire::Command;

use crate::CommandId;
use crate::plan::Plan;

/// Commands that were sent and are not known to have ended, oldest first.
#[derive(Clone, Debug, Default)]
pub(crate) struct InFlight {
    all: VecDeque<Sent>,
    numbered: u64,
    /// The expected end of the last command.
    last_ends: Duration,
    /// The number of motions sent.
    motions_sent: u64,
}

/// A sent command and its prediction.
#[derive(Clone, Debug)]
pub(crate) struct Sent {
    /// The sequence number, urgent commands included.
    pub(crate) number: u64,
    /// `None` for an urgent command: no caller waits for its end.
    pub(crate) id: Option<CommandId>,
    pub(crate) command: Command,
    pub(crate) plan: Box<Plan>,
    /// When it was sent.
    pub(crate) at: Duration,
    /// How much a pause before it can grow until the arm reads it (note N47).
    pub(crate) waits: Duration,
    /// Whether the laser is on during the motion or, without a motion, before or after it.
    lit: bool,
    /// Expected end.
    ends: Duration,
    /// Latest possible end.
    bound: Duration,
}

impl Sent {
    /// Expected duration.
    fn duration(&self) -> Duration {
        self.plan.motion + self.plan.pause
    }

    /// Latest possible end if everything before it has ended at `before`.
    fn bound_after(&self, before: Duration) -> Duration {
        let duration = self.plan.longest_motion + self.plan.pause;
        before.max(self.at + LATEST) + self.waits + duration + duration / ROUNDING_SHARE + ROUNDING
    }
}

impl InFlight {
    /// Adds a command that is sent now. `before` is the model after all earlier commands.
    pub(crate) fn push(
        &mut self,
        now: Duration,
        id: Option<CommandId>,
        command: Command,
        plan: Box<Plan>,
        before: &Model,
    ) {
        let last = self.all.back();
        let ends = last.map_or(Duration::ZERO, |sent| sent.ends);
        let bound = last.map_or(Duration::ZERO, |sent| sent.bound);
        let mut sent = Sent {
            number: self.numbered,
            id,
            command,
            waits: crate::plan::seconds(before.idle_pause_s()),
            lit: lit(before, &plan),
            plan,
            at: now,
            ends: ends.max(now + ARRIVAL),
            bound,
        };
        sent.ends += sent.duration();
        sent.bound = sent.bound_after(bound);
        self.last_ends = sent.ends;
        if sent.id.is_some() && !sent.plan.is_still() {
            self.motions_sent += 1;
        }
        self.numbered += 1;
        self.all.push_back(sent);
    }

    /// Removes the first command, which has ended.
    pub(crate) fn pop(&mut self, now: Duration) -> Option<Sent> {
        let over = self.all.pop_front()?;
        // The next command started before this end was detected, possibly long before: a target that
        // is passed without stopping is detected late. So the expected ends only ever move forward.
        let early = self.all.front().map_or(Duration::ZERO, |next| {
            next.ends.saturating_sub(now + next.duration())
        });
        let mut before = now;
        for sent in &mut self.all {
            sent.ends = sent.ends.saturating_sub(early);
            sent.bound = sent.bound.min(sent.bound_after(before));
            before = sent.bound;
        }
        let last = self.all.back();
        self.last_ends = last.map_or(self.last_ends.min(now), |sent| sent.ends);
        Some(over)
    }

    /// Removes the first command if it is urgent and past its latest end, even if no status showed it.
    pub(crate) fn pop_expired(&mut self, now: Duration) -> Option<Sent> {
        let expired = |sent: &Sent| sent.id.is_none() && sent.bound <= now;
        if self.all.front().is_some_and(expired) {
            return self.pop(now);
        }
        None
    }

    /// Predicts all commands again, starting from `model`.
    pub(crate) fn replan(&mut self, mut model: Model) {
        for sent in &mut self.all {
            sent.plan = Plan::new(&model, &sent.command);
            model = sent.plan.after;
        }
    }

    /// The model after each command.
    pub(crate) fn models(&mut self) -> impl Iterator<Item = &mut Model> {
        self.all.iter_mut().map(|sent| &mut sent.plan.after)
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = &Sent> {
        self.all.iter()
    }

    pub(crate) fn first(&self) -> Option<&Sent> {
        self.all.front()
    }

    pub(crate) fn last(&self) -> Option<&Sent> {
        self.all.back()
    }

    pub(crate) fn get(&self, index: usize) -> Option<&Sent> {
        self.all.get(index)
    }

    /// Number of commands, urgent ones included.
    pub(crate) fn len(&self) -> usize {
        self.all.len()
    }

    /// Whether the laser is on during any command.
    pub(crate) fn is_lit(&self) -> bool {
        self.all.iter().any(|sent| sent.lit)
    }

    /// When the arm stops if nothing more is sent; `None` during a jog.
    pub(crate) fn stops_at(&self) -> Option<Duration> {
        match self.all.back() {
            None => Some(self.last_ends),
            Some(last) if last.plan.is_endless() => None,
            Some(last) => Some(last.ends.saturating_sub(last.plan.pause)),
        }
    }

    /// When the command that should be running now started, or, if none should be, when the last one ended.
    pub(crate) fn running_since(&self, now: Duration) -> Duration {
        let runs = |sent: &&Sent| sent.plan.is_endless() || sent.ends > now;
        let running = self.all.iter().find(runs);
        running.map_or(self.last_ends, |sent| {
            sent.ends.saturating_sub(sent.duration())
        })
    }

    /// Number of commands whose end a caller waits for.
    pub(crate) fn awaited(&self) -> usize {
        self.all.iter().filter(|sent| sent.id.is_some()).count()
    }

    pub(crate) fn clear(&mut self) {
        self.all.clear();
        self.last_ends = Duration::ZERO;
    }

    /// From when on two equal statuses show that everything has ended. Earlier, the arm may not have started.
    pub(crate) fn rest_visible_from(&self) -> Duration {
        self.last_ends + SHOWN
    }

    /// Number of motions sent.
    pub(crate) const fn motions_sent(&self) -> u64 {
        self.motions_sent
    }

    /// Time until all commands have ended; a jog counts as ended.
    pub(crate) fn ahead(&self, now: Duration) -> Duration {
        let last = self.all.back();
        last.map_or(Duration::ZERO, |sent| sent.ends.saturating_sub(now))
    }

    /// Latest time until the arm is at rest if nothing more is sent: `Duration::MAX` during a jog, `None`
    /// without in-flight commands.
    pub(crate) fn rests_within(&self, now: Duration) -> Option<Duration> {
        self.all.back().map(|last| {
            if last.plan.is_endless() {
                Duration::MAX
            } else {
                last.bound.saturating_sub(now)
            }
        })
    }

    /// Latest time until at most `left` commands remain. An arm with a full queue is silent until then
    /// (note N20). The expected ends do not bound this time: they are not moved when a command takes longer.
    pub(crate) fn drains_within(&self, left: usize, now: Duration) -> Duration {
        let over = self.all.len().checked_sub(left + 1);
        let last = over.and_then(|index| self.all.get(index));
        last.map_or(Duration::ZERO, |sent| sent.bound.saturating_sub(now))
    }

    /// Upper bound of the time that all commands take on an arm whose speeds another client has lowered.
    /// An arm with a full queue is silent for this long (note N20).
    pub(crate) fn longest_silence(&self) -> Duration {
        let sum = |part: fn(&Sent) -> Duration| {
            let parts = self.all.iter().map(part);
            parts.fold(Duration::ZERO, Duration::saturating_add)
        };
        sum(|sent| sent.plan.longest_motion)
            .saturating_mul(SLOWER)
            .saturating_add(sum(|sent| sent.plan.pause))
            .saturating_add(sum(|sent| sent.waits))
    }
}

/// Whether the laser is on during a command.
fn lit(before: &Model, plan: &Plan) -> bool {
    match &plan.trajectory {
        Ok(trajectory) if trajectory.moves() => trajectory.laser(),
        _ => before.laser || plan.after.laser,
    }
}

/// Time from sending a command to its first motion: 43.68 ms on the line and half a tick.
const ARRIVAL: Duration = Duration::from_millis(55);
/// Time from the end of a motion until two statuses have shown it: ticks to detect it, two status periods, the
/// line.
const SHOWN: Duration = Duration::from_millis(250);
/// The longest [`ARRIVAL`], on a computer that is late.
const LATEST: Duration = Duration::from_millis(120);
/// A stock arm moves in whole ticks of 20 ms: up to six extra ticks per command, and 2 % of long ones.
const ROUNDING: Duration = Duration::from_millis(120);
const ROUNDING_SHARE: u32 = 50;
/// The largest factor by which another client is assumed to have slowed the arm.
const SLOWER: u32 = 20;
