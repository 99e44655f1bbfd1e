//! What a session believes of its arm: the motion model after what was sent, and the time that this
//! takes.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_course::{Course, Model, Settings};
use dobot_wire::{Command, Dialect, Status};

use crate::CommandId;

/// The model after all that was sent, and after all that was given.
#[derive(Debug)]
pub(crate) struct Belief {
    dialect: Dialect,
    /// After all that was sent; there is none before the first status.
    sent: Option<Model>,
    /// After what waits, too.
    given: Option<Model>,
    under_way: VecDeque<Foreseen>,
    last: Option<Status>,
    /// Until then the arm may pause once more where the last command ended (note N47).
    paused_until: Duration,
    /// When the last command sent is over, or should be.
    last_ends: Duration,
}

/// When a command under way should be over.
#[derive(Clone, Copy, Debug)]
struct Foreseen {
    /// `None` for one that left beside the session: nobody tells when it is over.
    command: Option<CommandId>,
    duration: Duration,
    /// The pause in that.
    pause: Duration,
    /// Whether it goes on until told otherwise.
    endless: bool,
    /// Whether the laser is on meanwhile: on the way, or where there is none, before or behind.
    lit: bool,
    /// Whether the base stands at 0 when it is over.
    ends_ahead: bool,
    /// When it should be over.
    ends: Duration,
    /// When it must be over.
    bound: Duration,
}

impl Belief {
    /// An arm whose dialect nobody has told is taken for one of the document.
    pub(crate) fn new(dialect: Option<&Dialect>) -> Self {
        Self {
            dialect: dialect.copied().unwrap_or(Dialect::SPECIFICATION),
            sent: None,
            given: None,
            under_way: VecDeque::new(),
            last: None,
            paused_until: Duration::ZERO,
            last_ends: Duration::ZERO,
        }
    }

    /// The arm turns out to speak another dialect; what stands as at power-up stands as at its own.
    pub(crate) fn set_dialect<'a>(
        &mut self,
        dialect: Dialect,
        waiting: impl Iterator<Item = &'a Command>,
    ) {
        let (before, after) = (Settings::stock(&self.dialect), Settings::stock(&dialect));
        self.dialect = dialect;
        if let Some(model) = &mut self.sent {
            model.dialect = dialect;
            if model.settings.jump_height == before.jump_height {
                model.settings.jump_height = after.jump_height;
            }
        }
        self.plan_anew(waiting);
    }

    pub(crate) const fn after_sent(&self) -> Option<&Model> {
        self.sent.as_ref()
    }

    pub(crate) const fn after_given(&self) -> Option<&Model> {
        self.given.as_ref()
    }

    /// Takes a status, and what waits. An arm that rests with nothing under way is where it says.
    pub(crate) fn handle_status<'a>(
        &mut self,
        now: Duration,
        status: &Status,
        waiting: impl Iterator<Item = &'a Command>,
    ) {
        self.under_way
            .retain(|it| it.command.is_some() || it.bound > now);
        let rests = self.last.replace(*status) == Some(*status);
        match &mut self.sent {
            None => self.sent = Some(Model::new(self.dialect, status)),
            Some(model) if self.under_way.is_empty() && rests => {
                let before = *model;
                model.seen(status);
                if *model == before {
                    return;
                }
            }
            Some(_) => return,
        }
        self.plan_anew(waiting);
    }

    /// Begins from what was sent: what waited has changed.
    pub(crate) fn plan_anew<'a>(&mut self, waiting: impl Iterator<Item = &'a Command>) {
        self.given = self.sent;
        for command in waiting {
            self.handle_given(command);
        }
    }

    /// Takes a command that waits behind all others.
    pub(crate) fn handle_given(&mut self, command: &Command) {
        self.given = self.given.map(|model| after(&model, command));
    }

    /// Takes a command that leaves now, with its name if its end will be told; `longest` is how long it may take if it cannot be foreseen.
    pub(crate) fn handle_sent(
        &mut self,
        now: Duration,
        id: Option<CommandId>,
        command: &Command,
        longest: Duration,
    ) {
        let Some(model) = self.sent else {
            return;
        };
        let course = model.course(command).ok();
        let endless = course.is_some_and(|it| it.duration_s().is_none());
        let seconds = course.map_or(Some(0.0), |it| it.duration_s());
        let pause_s = course.map_or(0.0, |it| it.pause_s());
        let duration = seconds_of(seconds.unwrap_or(0.0));
        let most = match course {
            Some(_) => duration + duration / ROUNDING_SHARE + seconds_of(pause_s) + ROUNDING,
            None => longest + ROUNDING,
        };
        let before = self.under_way.back();
        let ends = before
            .map_or(Duration::ZERO, |it| it.ends)
            .max(now + ARRIVAL)
            + duration;
        let bound = before
            .map_or(Duration::ZERO, |it| it.bound)
            .max(now + LATEST)
            .max(self.paused_until)
            + most;
        let after = after(&model, command);
        self.last_ends = ends;
        self.under_way.push_back(Foreseen {
            command: id,
            duration,
            pause: seconds_of(pause_s),
            endless,
            lit: lit(&model, course.as_ref(), &after),
            ends_ahead: course
                .and_then(|it| it.end())
                .is_some_and(|it| it.joints.base.abs().0 < AHEAD_DEG),
            ends,
            bound,
        });
        self.sent = Some(after);
    }

    /// A command, and all before it, is over.
    pub(crate) fn handle_over(&mut self, now: Duration, id: CommandId) {
        let last = self.under_way.iter().find(|it| it.command == Some(id));
        self.paused_until = now + last.map_or(Duration::ZERO, |it| it.pause);
        self.under_way
            .retain(|it| it.command.is_none_or(|it| it > id));
        // What follows began before that was seen. It may have begun long before: a target passed
        // without a rest is seen to be over late, so that nothing is ever put off.
        let Some(first) = self.under_way.front() else {
            self.last_ends = self.last_ends.min(now);
            return;
        };
        let early = first.ends.saturating_sub(now + first.duration);
        for foreseen in &mut self.under_way {
            foreseen.ends = foreseen.ends.saturating_sub(early);
        }
        self.last_ends = self.last_ends.saturating_sub(early);
    }

    /// A command ended elsewhere: nobody knows where the arm is, until it is seen at rest.
    pub(crate) fn handle_not_reached(&mut self, now: Duration, id: CommandId) {
        self.handle_over(now, id);
        for model in [&mut self.sent, &mut self.given].into_iter().flatten() {
            model.lose_place();
        }
    }

    /// The arm was reset: nothing that was told to it counts any more.
    pub(crate) fn handle_reset(&mut self, status: &Status) {
        self.under_way.clear();
        self.paused_until = Duration::ZERO;
        self.sent = Some(Model::new(self.dialect, status));
        self.given = self.sent;
    }

    /// Whether the laser may be on: it is, or something under way has it on.
    pub(crate) fn is_lit(&self) -> bool {
        self.stays_lit() || self.under_way.iter().any(|it| it.lit)
    }

    /// Whether the laser is on when all that was sent is over.
    pub(crate) fn stays_lit(&self) -> bool {
        self.sent.is_some_and(|it| it.laser)
    }

    /// From when on the arm stands if nothing more is sent; `None` while a jog goes on.
    pub(crate) fn stands_from(&self) -> Option<Duration> {
        match self.under_way.back() {
            None => Some(self.last_ends),
            Some(last) if last.endless => None,
            Some(last) => Some(last.ends.saturating_sub(last.pause)),
        }
    }

    /// Since when what should be going on now does so; if nothing should, when the last was over.
    pub(crate) fn goes_on_since(&self, now: Duration) -> Duration {
        let goes_on = |it: &&Foreseen| it.endless || it.ends > now;
        let it = self.under_way.iter().find(goes_on);
        it.map_or(self.last_ends, |it| it.ends.saturating_sub(it.duration))
    }

    /// Whether the arm would pause with the laser on if it got this command now.
    pub(crate) fn would_pause_lit(&self, command: &Command) -> bool {
        let course = |it: &Model| it.course(command).ok();
        let lit = self.sent.as_ref().filter(|it| it.laser);
        lit.and_then(course).is_some_and(|it| it.pause_s() > 0.0)
    }

    /// How many commands the arm may still have, urgent ones included.
    pub(crate) fn under_way(&self) -> usize {
        self.under_way.len()
    }

    /// Whether everything that could move was seen to be over.
    pub(crate) fn is_at_rest(&self) -> bool {
        self.under_way.is_empty()
    }

    /// Whether something under way turns the base to 0.
    pub(crate) fn turns_to_zero(&self) -> bool {
        self.under_way.iter().any(|it| it.ends_ahead)
    }

    /// How long those commands take that wait in the arm behind the one that it should execute now.
    /// That one need not have been seen to begin: of targets that are passed without a rest the
    /// statuses say so late only.
    pub(crate) fn behind_the_first(&self, now: Duration) -> Duration {
        let not_over = self.under_way.iter().skip_while(|it| it.ends <= now);
        not_over.skip(1).map(|it| it.duration).sum()
    }

    /// How long it takes until all that was sent is over; a jog counts as over.
    pub(crate) fn ahead(&self, now: Duration) -> Duration {
        let last = self.under_way.back();
        last.map_or(Duration::ZERO, |it| it.ends.saturating_sub(now))
    }

    /// By when the arm is at rest, if nothing more is sent; `Duration::MAX` while it jogs.
    pub(crate) fn rests_within(&self, now: Duration) -> Duration {
        match self.under_way.back() {
            None if self.sent.is_some_and(|it| !it.knows_place()) => Duration::MAX,
            None => Duration::ZERO,
            Some(last) if last.endless => Duration::MAX,
            Some(last) => last.bound.saturating_sub(now),
        }
    }
}

/// Whether the laser is on during a command.
fn lit(before: &Model, course: Option<&Course>, after: &Model) -> bool {
    match course {
        Some(it) if it.moves() => it.laser(),
        _ => before.laser || after.laser,
    }
}

fn after(model: &Model, command: &Command) -> Model {
    if let Ok(course) = model.course(command) {
        return model.after(command, &course);
    }
    // It is refused, skipped or cut short: where the arm is then is seen when it rests.
    let mut model = model.begun(command);
    model.lose_place();
    model
}

fn seconds_of(seconds: f64) -> Duration {
    Duration::try_from_secs_f64(seconds).unwrap_or(FOR_EVER)
}

/// From the status with which a command leaves to its first motion: 43.68 ms on the line, and half a
/// tick.
const ARRIVAL: Duration = Duration::from_millis(55);
/// The same at the latest, with what a computer may be late.
const LATEST: Duration = Duration::from_millis(120);
/// A stock arm goes in whole ticks of 20 ms: a few for each command, and a fiftieth of long ones.
const ROUNDING: Duration = Duration::from_millis(120);
const ROUNDING_SHARE: u32 = 50;
const AHEAD_DEG: f64 = 0.001;
/// Many of them added up still are a duration.
const FOR_EVER: Duration = Duration::from_secs(u32::MAX as u64);
