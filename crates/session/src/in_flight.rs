//! What was sent and is not over, and by when it is.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_motion::Model;
use dobot_wire::Command;

use crate::CommandId;
use crate::plan::Plan;

/// The commands sent and not seen to be over, oldest first.
#[derive(Clone, Debug, Default)]
pub(crate) struct InFlight {
    all: VecDeque<Sent>,
    numbered: u64,
    /// When the last one sent is over, or should be.
    last_ends: Duration,
}

/// A command that was sent, with the prediction that was made for it.
#[derive(Clone, Debug)]
pub(crate) struct Sent {
    /// Counts all that were sent, urgent ones included.
    pub(crate) number: u64,
    /// `None` for one that left beside the session: nobody asks when it is over.
    pub(crate) id: Option<CommandId>,
    pub(crate) command: Command,
    pub(crate) plan: Box<Plan>,
    /// When it left.
    pub(crate) at: Duration,
    /// For how long the pause before it may begin anew, until it is taken (note N47).
    pub(crate) waits: Duration,
    /// Whether the laser is on meanwhile: on the way, or where there is none, before or behind.
    lit: bool,
    /// When it should be over.
    ends: Duration,
    /// When it must be over.
    bound: Duration,
}

impl Sent {
    /// How long it should take.
    fn duration(&self) -> Duration {
        self.plan.motion + self.plan.pause
    }

    /// When it must be over, if all before it is by then.
    fn bound_after(&self, before: Duration) -> Duration {
        let duration = self.plan.longest_motion + self.plan.pause;
        before.max(self.at + LATEST) + self.waits + duration + duration / ROUNDING_SHARE + ROUNDING
    }
}

impl InFlight {
    /// Takes a command that leaves now, behind which `before` is believed until then.
    pub(crate) fn push(
        &mut self,
        now: Duration,
        id: Option<CommandId>,
        command: Command,
        plan: Box<Plan>,
        before: &Model,
    ) {
        let last = self.all.back();
        let ends = last.map_or(Duration::ZERO, |it| it.ends);
        let bound = last.map_or(Duration::ZERO, |it| it.bound);
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
        self.numbered += 1;
        self.all.push_back(sent);
    }

    /// The first one is over.
    pub(crate) fn pop(&mut self, now: Duration) -> Option<Sent> {
        let over = self.all.pop_front()?;
        // What follows began before that was seen. It may have begun long before: a target passed
        // without a rest is seen to be over late, so that nothing is ever put off.
        let early = self.all.front().map_or(Duration::ZERO, |it| {
            it.ends.saturating_sub(now + it.duration())
        });
        let mut before = now;
        for sent in &mut self.all {
            sent.ends = sent.ends.saturating_sub(early);
            sent.bound = sent.bound.min(sent.bound_after(before));
            before = sent.bound;
        }
        let last = self.all.back();
        self.last_ends = last.map_or(self.last_ends.min(now), |it| it.ends);
        Some(over)
    }

    /// The first one, if it left beside the session and must be over: nobody need have seen it.
    pub(crate) fn pop_expired(&mut self, now: Duration) -> Option<Sent> {
        let expired = |it: &Sent| it.id.is_none() && it.bound <= now;
        if self.all.front().is_some_and(expired) {
            return self.pop(now);
        }
        None
    }

    /// Predicts anew where all of them lead, from another model than was believed.
    pub(crate) fn plan_anew(&mut self, mut model: Model) {
        for sent in &mut self.all {
            sent.plan = Plan::new(&model, &sent.command);
            model = sent.plan.after;
        }
    }

    /// The models that are believed when each is over.
    pub(crate) fn models(&mut self) -> impl Iterator<Item = &mut Model> {
        self.all.iter_mut().map(|it| &mut it.plan.after)
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

    /// How many the arm may still have, urgent ones included.
    pub(crate) fn len(&self) -> usize {
        self.all.len()
    }

    /// Whether the laser is on during any of them.
    pub(crate) fn is_lit(&self) -> bool {
        self.all.iter().any(|it| it.lit)
    }

    /// From when on the arm stands if nothing more is sent; `None` while a jog goes on.
    pub(crate) fn stands_from(&self) -> Option<Duration> {
        match self.all.back() {
            None => Some(self.last_ends),
            Some(last) if last.plan.is_endless() => None,
            Some(last) => Some(last.ends.saturating_sub(last.plan.pause)),
        }
    }

    /// Since when what should be going on now does so; if nothing should, when the last was over.
    pub(crate) fn goes_on_since(&self, now: Duration) -> Duration {
        let goes_on = |it: &&Sent| it.plan.is_endless() || it.ends > now;
        let it = self.all.iter().find(goes_on);
        it.map_or(self.last_ends, |it| it.ends.saturating_sub(it.duration()))
    }

    /// How many of them somebody asks for.
    pub(crate) fn asked_for(&self) -> usize {
        self.all.iter().filter(|it| it.id.is_some()).count()
    }

    pub(crate) fn clear(&mut self) {
        self.all.clear();
        self.last_ends = Duration::ZERO;
    }

    /// From when on two statuses can have told that all that was sent is over: an arm that has not
    /// begun yet rests, too.
    pub(crate) fn rests_from(&self) -> Duration {
        self.last_ends + SHOWN
    }

    /// How long it takes until all of them are over; a jog counts as over.
    pub(crate) fn ahead(&self, now: Duration) -> Duration {
        let last = self.all.back();
        last.map_or(Duration::ZERO, |it| it.ends.saturating_sub(now))
    }

    /// By when the arm is at rest, if nothing more is sent; `Duration::MAX` while it jogs, `None`
    /// where nothing is under way.
    pub(crate) fn rests_within(&self, now: Duration) -> Option<Duration> {
        self.all.back().map(|last| {
            if last.plan.is_endless() {
                Duration::MAX
            } else {
                last.bound.saturating_sub(now)
            }
        })
    }

    /// Within what time no more than so many of them are left, at the most: so long an arm is silent whose
    /// queue that fills (note N20). By when each should end does not tell that: what takes longer than it
    /// should puts nothing off.
    pub(crate) fn leaves_within(&self, left: usize, now: Duration) -> Duration {
        let over = self.all.len().checked_sub(left + 1);
        let last = over.and_then(|it| self.all.get(it));
        last.map_or(Duration::ZERO, |it| it.bound.saturating_sub(now))
    }

    /// How long they take at the most on an arm that somebody else has made slow, before it has room
    /// for another: a full queue keeps an arm silent for just that long (note N20).
    pub(crate) fn longest_silence(&self) -> Duration {
        let sum = |part: fn(&Sent) -> Duration| {
            let parts = self.all.iter().map(part);
            parts.fold(Duration::ZERO, Duration::saturating_add)
        };
        sum(|it| it.plan.longest_motion)
            .saturating_mul(SLOWER)
            .saturating_add(sum(|it| it.plan.pause))
            .saturating_add(sum(|it| it.waits))
    }
}

/// Whether the laser is on during a command.
fn lit(before: &Model, plan: &Plan) -> bool {
    match &plan.trajectory {
        Ok(it) if it.moves() => it.laser(),
        _ => before.laser || plan.after.laser,
    }
}

/// From the status with which a command leaves to its first motion: 43.68 ms on the line, and half a
/// tick.
const ARRIVAL: Duration = Duration::from_millis(55);
/// From the end of a motion until two statuses have told of it: ticks to notice it, two periods, the
/// line.
const SHOWN: Duration = Duration::from_millis(250);
/// [`ARRIVAL`] at the latest, with what a computer may be late.
const LATEST: Duration = Duration::from_millis(120);
/// A stock arm goes in whole ticks of 20 ms: a few for each command, and a fiftieth of long ones.
const ROUNDING: Duration = Duration::from_millis(120);
const ROUNDING_SHARE: u32 = 50;
/// Slower than that nobody has made an arm on purpose, against what this session knows.
const SLOWER: u32 = 20;
