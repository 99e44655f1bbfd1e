//! What a session believes of its arm: the motion model after what was sent, and the time that this
//! takes.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_course::{Model, Settings};
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
    /// Before then no status can show that all that was sent is over.
    rests_from: Duration,
    /// The pause of the last command, which begins anew while nothing waits (note N47), and how much
    /// later than foreseen that makes what is under way.
    last_pause: Duration,
    late: Duration,
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
            rests_from: Duration::ZERO,
            last_pause: Duration::ZERO,
            late: Duration::ZERO,
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
        // An arm that has not begun yet rests, too.
        let rests = self.last.replace(*status) == Some(*status) && now >= self.rests_from;
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
        self.foresee_rest(now, ends, duration, seconds_of(pause_s));
        self.under_way.push_back(Foreseen {
            command: id,
            duration,
            pause: seconds_of(pause_s),
            endless,
            ends_ahead: course
                .and_then(|it| it.end())
                .is_some_and(|it| it.joints.base.abs().0 < AHEAD_DEG),
            ends,
            bound,
        });
        self.sent = Some(after(&model, command));
    }

    /// From when on statuses may show a rest behind a command that should end then. What is said to be
    /// over already need not be.
    fn foresee_rest(&mut self, now: Duration, ends: Duration, takes: Duration, pause: Duration) {
        let (late, rests_from) = if now < self.rests_from {
            (self.late, self.rests_from.saturating_add(takes))
        } else {
            (Duration::ZERO, Duration::ZERO)
        };
        self.late = late.max(self.last_pause);
        self.last_pause = pause;
        self.rests_from = ends
            .saturating_add(self.late)
            .saturating_add(SHOWN)
            .max(rests_from);
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
            return;
        };
        let early = first.ends.saturating_sub(now + first.duration);
        for foreseen in &mut self.under_way {
            foreseen.ends = foreseen.ends.saturating_sub(early);
        }
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
        self.rests_from = Duration::ZERO;
        self.last_pause = Duration::ZERO;
        self.sent = Some(Model::new(self.dialect, status));
        self.given = self.sent;
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
/// From the end of a motion until two statuses have told of it: ticks to notice it, two periods, the
/// line.
const SHOWN: Duration = Duration::from_millis(250);
/// [`ARRIVAL`] at the latest, with what a computer may be late.
const LATEST: Duration = Duration::from_millis(120);
/// A stock arm goes in whole ticks of 20 ms: a few for each command, and a fiftieth of long ones.
const ROUNDING: Duration = Duration::from_millis(120);
const ROUNDING_SHARE: u32 = 50;
const AHEAD_DEG: f64 = 0.001;
/// Many of them added up still are a duration.
const FOR_EVER: Duration = Duration::from_secs(u32::MAX as u64);
