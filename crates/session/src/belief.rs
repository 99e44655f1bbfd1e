//! What a session believes of its arm: the motion model after what was sent, and after what waits.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_arm::Calibration;
use dobot_motion::{ArmSettings, Button, Model};
use dobot_wire::{Command, Dialect, MoveJoints, MoveTo, MovingMode, Status};

use crate::plan::Plan;
use crate::under_way::{Sent, UnderWay};
use crate::{CommandId, SendError};

/// The arm as it is believed to be, and the commands that it and the session have.
#[derive(Clone, Debug)]
pub(crate) struct Belief {
    dialect: Dialect,
    /// How the arm differs from the drawing of it, before it is told its true angles.
    calibration: Calibration,
    /// After all that was seen to be over; there is none before the first status.
    over: Option<Model>,
    under_way: UnderWay,
    waiting: VecDeque<WaitingCommand>,
    /// What releases the button that was held last. It is kept when it has been sent, for it may get
    /// lost: to an arm at rest it says nothing.
    release: Option<Command>,
    /// That button was sent, and nothing behind it: the arm jogs, or will as soon as it hears that.
    jogs: bool,
    last: Option<Status>,
    /// The last two statuses are the same, and came when all that was sent should have been over.
    stood: bool,
}

/// A command that waits for its turn.
#[derive(Clone, Debug)]
pub(crate) struct WaitingCommand {
    pub(crate) id: CommandId,
    pub(crate) command: Command,
    /// None before the first status.
    plan: Option<Box<Plan>>,
}

impl WaitingCommand {
    /// Why it must not be sent by now.
    pub(crate) fn trap(&self) -> Option<SendError> {
        self.plan.as_ref().and_then(|it| it.trap())
    }
}

impl Belief {
    /// An arm whose dialect nobody has told is taken for one of the document.
    pub(crate) fn new(dialect: Option<&Dialect>) -> Self {
        Self {
            dialect: dialect.copied().unwrap_or(Dialect::SPECIFICATION),
            calibration: Calibration::NONE,
            over: None,
            under_way: UnderWay::default(),
            waiting: VecDeque::new(),
            release: None,
            jogs: false,
            last: None,
            stood: false,
        }
    }

    /// The arm turns out to differ from the drawing of it so.
    pub(crate) fn set_calibration(&mut self, calibration: Calibration) {
        let is_same_arm = calibration.is_same(&self.calibration);
        self.calibration = calibration;
        for model in self.over.iter_mut().chain(self.under_way.models()) {
            // An arm that was told its angles still knows them where only the paper lies elsewhere.
            if is_same_arm {
                model.calibration.table = calibration.table;
            } else {
                model.calibration = calibration;
            }
        }
        self.plan_anew();
    }

    /// An arm of which nothing is known but its status.
    fn unknown(&self, status: &Status) -> Model {
        Model::new(self.dialect, status).calibrated(self.calibration)
    }

    /// The arm turns out to speak another dialect; what stands as at power-up stands as at its own.
    pub(crate) fn set_dialect(&mut self, dialect: Dialect) {
        let (before, after) = (
            ArmSettings::stock(&self.dialect),
            ArmSettings::stock(&dialect),
        );
        self.dialect = dialect;
        for model in self.over.iter_mut().chain(self.under_way.models()) {
            model.dialect = dialect;
            if model.settings.jump_height == before.jump_height {
                model.settings.jump_height = after.jump_height;
            }
        }
        self.plan_anew();
    }

    /// The arm turns out to serve its Bluetooth port.
    pub(crate) fn note_bluetooth(&mut self) {
        let mut is_news = false;
        for model in self.over.iter_mut().chain(self.under_way.models()) {
            is_news |= !model.is_bluetooth;
            model.is_bluetooth = true;
        }
        if is_news {
            self.plan_anew();
        }
    }

    /// What is believed when all that was sent is over.
    pub(crate) fn after_sent(&self) -> Option<&Model> {
        let last = self.under_way.last().map(|it| &it.plan.after);
        last.or(self.over.as_ref())
    }

    /// What is believed when all that was given is over, what waits included.
    pub(crate) fn after_given(&self) -> Option<&Model> {
        let last = self.waiting.back().and_then(|it| it.plan.as_ref());
        last.map(|it| &it.after).or_else(|| self.after_sent())
    }

    pub(crate) const fn under_way(&self) -> &UnderWay {
        &self.under_way
    }

    /// How many commands wait.
    pub(crate) fn waiting(&self) -> usize {
        self.waiting.len()
    }

    /// Takes a status. An arm that rests with nothing under way is where it says.
    pub(crate) fn handle_status(&mut self, now: Duration, status: &Status) {
        while let Some(expired) = self.under_way.pop_expired(now) {
            self.over = Some(expired.plan.after);
        }
        self.stood =
            self.last.replace(*status) == Some(*status) && now >= self.under_way.rests_from();
        match &mut self.over {
            None => self.over = Some(self.unknown(status)),
            Some(model) if self.under_way.len() == 0 && !self.jogs && self.stood => {
                let before = *model;
                model.observe(status);
                if *model == before {
                    return;
                }
            }
            Some(_) => return,
        }
        self.plan_anew();
    }

    /// Predicts anew what waits: what it begins from has changed.
    fn plan_anew(&mut self) {
        let Some(mut model) = self.after_sent().copied() else {
            return;
        };
        for given in &mut self.waiting {
            let plan = Plan::new(&model, &given.command);
            model = plan.after;
            given.plan = Some(plan);
        }
    }

    /// Where a command leads behind all that was given; `None` before the first status.
    pub(crate) fn plan(&self, command: &Command) -> Option<Box<Plan>> {
        self.after_given().map(|model| Plan::new(model, command))
    }

    /// Takes a command that waits behind all others, and where it leads.
    pub(crate) fn give(&mut self, id: CommandId, command: Command, plan: Option<Box<Plan>>) {
        self.waiting.push_back(WaitingCommand { id, command, plan });
    }

    /// The next command to send.
    pub(crate) fn take_next(&mut self) -> Option<WaitingCommand> {
        self.waiting.pop_front()
    }

    /// Forgets what waits; says which they were.
    pub(crate) fn forget_waiting(&mut self) -> Vec<CommandId> {
        self.waiting.drain(..).map(|it| it.id).collect()
    }

    /// The same, to look at.
    pub(crate) fn next(&self) -> Option<&WaitingCommand> {
        self.waiting.front()
    }

    /// Whether the next command is a vector that burns, or one that does not, and how long it takes.
    pub(crate) fn next_vector(&self) -> Option<(bool, Duration)> {
        let next = self.next()?;
        let is_vector = matches!(next.command, Command::WriteVector(_));
        let plan = next.plan.as_ref().filter(|_| is_vector)?;
        let lit = plan.trajectory.is_ok_and(|it| it.laser());
        Some((lit, plan.motion))
    }

    /// Whether the next command is a straight line that could have no length, for nobody knows yet where
    /// the arm comes to rest (note N34).
    pub(crate) fn waits_for_place(&self) -> bool {
        let unknown = self.after_sent().is_some_and(|it| !it.knows_place());
        let is_line = |it: &WaitingCommand| {
            matches!(
                it.command,
                Command::MoveTo(MoveTo {
                    mode: MovingMode::MovL,
                    ..
                }) | Command::MoveJoints(MoveJoints {
                    mode: MovingMode::MovL,
                    ..
                })
            )
        };
        let is_next = self.next().is_some_and(is_line);
        self.dialect.loses_pose_on_the_spot && unknown && is_next && !self.jogs
    }

    /// Forgets the first waiting command of a kind, and those behind it but for the release of a button;
    /// says which they were.
    pub(crate) fn forget_from_first(&mut self, kind: impl Fn(&Command) -> bool) -> Vec<CommandId> {
        let first = self.waiting.iter().position(|it| kind(&it.command));
        let from_first = self.waiting.split_off(first.unwrap_or(self.waiting.len()));
        let (releases, others): (Vec<_>, Vec<_>) = from_first
            .into_iter()
            .partition(|it| Button::of(&it.command) == Some(Button::Released));
        self.waiting.extend(releases);
        self.plan_anew();
        others.into_iter().map(|it| it.id).collect()
    }

    /// Whether the laser may be on: it is, or something under way has it on.
    pub(crate) fn is_lit(&self) -> bool {
        self.stays_lit() || self.under_way.is_lit()
    }

    /// Whether the laser is on when all that was sent is over.
    pub(crate) fn stays_lit(&self) -> bool {
        self.after_sent().is_some_and(|it| it.laser)
    }

    /// Whether the arm would pause with the laser on if it got this command now.
    pub(crate) fn would_pause_lit(&self, command: &Command) -> bool {
        let lit = self.after_sent().filter(|it| it.laser);
        let trajectory = lit.and_then(|it| it.trajectory(command).ok());
        trajectory.is_some_and(|it| it.pause_s() > 0.0)
    }

    /// Takes the one that was next and leaves now.
    pub(crate) fn handle_sent(&mut self, now: Duration, given: WaitingCommand) {
        self.note_button(&given.command);
        if let Some(before) = self.after_sent().copied() {
            let plan = given
                .plan
                .unwrap_or_else(|| Plan::new(&before, &given.command));
            self.under_way
                .push(now, Some(given.id), given.command, plan, &before);
        }
    }

    /// Takes one that leaves now, before all that waits and beside the session.
    pub(crate) fn handle_urgent(&mut self, now: Duration, command: &Command) {
        self.note_button(command);
        if let Some(before) = self.after_sent().copied() {
            let plan = Plan::new(&before, command);
            self.under_way.push(now, None, *command, plan, &before);
            self.plan_anew();
        }
    }

    /// The first command under way is over.
    pub(crate) fn handle_over(&mut self, now: Duration) -> Option<Sent> {
        let over = self.under_way.pop(now)?;
        self.over = Some(over.plan.after);
        Some(over)
    }

    /// It ended elsewhere: nobody knows where the arm is, until it is seen at rest.
    pub(crate) fn handle_missed(&mut self, now: Duration) -> Option<Sent> {
        let missed = self.handle_over(now)?;
        if let Some(model) = &mut self.over {
            model.lose_place();
            self.under_way.plan_anew(*model);
        }
        self.plan_anew();
        Some(missed)
    }

    /// The arm was reset: nothing that was told to it counts any more. Says how many commands that
    /// were asked for are forgotten.
    pub(crate) fn handle_reset(&mut self, status: &Status) -> usize {
        let forgotten = self.waiting.len() + self.under_way.asked_for();
        self.waiting.clear();
        self.under_way.clear();
        self.release = None;
        self.jogs = false;
        self.over = Some(self.unknown(status));
        forgotten
    }

    /// Whether everything that could move was seen to be over.
    pub(crate) fn is_at_rest(&self) -> bool {
        self.under_way.len() == 0 && !self.jogs
    }

    /// Whether the statuses showed it at rest, too.
    pub(crate) fn was_seen_at_rest(&self) -> bool {
        self.is_at_rest() && self.stood
    }

    /// What releases the button that was held last; `None` where none was.
    pub(crate) const fn release(&self) -> Option<Command> {
        self.release
    }

    /// Whether the base stands at 0 behind something under way.
    pub(crate) fn comes_to_zero(&self) -> bool {
        self.under_way.iter().any(|it| ends_ahead(&it.plan))
    }

    /// Whether it would behind the command that is next.
    pub(crate) fn would_come_to_zero(&self) -> bool {
        let next = self.waiting.front().and_then(|it| it.plan.as_ref());
        next.is_some_and(|it| ends_ahead(it))
    }

    /// By when the arm is at rest, if nothing more is sent; `Duration::MAX` while it jogs.
    pub(crate) fn rests_within(&self, now: Duration) -> Duration {
        if self.jogs {
            return Duration::MAX;
        }
        let unknown = self.over.is_some_and(|it| !it.knows_place());
        let at_rest = if unknown {
            Duration::MAX
        } else {
            Duration::ZERO
        };
        self.under_way.rests_within(now).unwrap_or(at_rest)
    }

    /// Takes note of the button that a command presses, which leaves now.
    fn note_button(&mut self, command: &Command) {
        let release = Button::release_of(command);
        self.jogs = release.is_some();
        self.release = release.or(self.release);
    }
}

/// Whether the base stands at 0 where a command leads.
fn ends_ahead(plan: &Plan) -> bool {
    let end = plan.trajectory.ok().and_then(|it| it.end());
    end.is_some_and(|it| it.joints.base.abs().0 < AHEAD_DEG)
}

const AHEAD_DEG: f64 = 0.001;
