//! The estimate of an arm: the motion model after the in-flight commands and after the waiting ones.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_arm::Calibration;
use dobot_motion::{ArmSettings, Button, Model};
use dobot_wire::{Command, Dialect, MoveJoints, MoveTo, MovingMode, Status};

use crate::in_flight::{InFlight, Sent};
use crate::plan::Plan;
use crate::{CommandId, SendError};

/// The estimated state of the arm, and the commands that the arm and the session hold.
#[derive(Clone, Debug)]
pub(crate) struct ArmEstimate {
    dialect: Dialect,
    /// How the arm differs from its nominal dimensions, before its initial angles are set.
    calibration: Calibration,
    /// The model after all ended commands; `None` before the first status.
    over: Option<Model>,
    in_flight: InFlight,
    waiting: VecDeque<WaitingCommand>,
    /// The release of the last pressed button. It is kept after it was sent, because it may get lost; an
    /// arm at rest ignores it.
    release: Option<Command>,
    /// That button was the last command sent: the arm jogs, or will when it receives it.
    jogs: bool,
    last: Option<Status>,
    /// The last two statuses are equal and arrived after everything sent should have ended.
    stood: bool,
}

/// A command that waits to be sent.
#[derive(Clone, Debug)]
pub(crate) struct WaitingCommand {
    pub(crate) id: CommandId,
    pub(crate) command: Command,
    /// `None` before the first status.
    plan: Option<Box<Plan>>,
}

impl WaitingCommand {
    /// Why it must not be sent.
    pub(crate) fn trap(&self) -> Option<SendError> {
        self.plan.as_ref().and_then(|plan| plan.trap())
    }
}

impl ArmEstimate {
    /// Creates the estimate of an arm. An unknown dialect is assumed to be that of the specification.
    pub(crate) fn new(dialect: Option<&Dialect>) -> Self {
        Self {
            dialect: dialect.copied().unwrap_or(Dialect::SPECIFICATION),
            calibration: Calibration::NONE,
            over: None,
            in_flight: InFlight::default(),
            waiting: VecDeque::new(),
            release: None,
            jogs: false,
            last: None,
            stood: false,
        }
    }

    /// Sets the calibration of the arm.
    pub(crate) fn set_calibration(&mut self, calibration: Calibration) {
        let is_same_arm = calibration.is_same(&self.calibration);
        self.calibration = calibration;
        for model in self.over.iter_mut().chain(self.in_flight.models()) {
            // If only the paper moved, initial angles that were set remain valid.
            if is_same_arm {
                model.calibration.table = calibration.table;
            } else {
                model.calibration = calibration;
            }
        }
        self.replan();
    }

    /// The model of an arm of which only the status is known.
    fn unknown(&self, status: &Status) -> Model {
        Model::new(self.dialect, status).calibrated(self.calibration)
    }

    /// Sets the detected dialect. Settings that still have their power-up value take that of the new dialect.
    pub(crate) fn set_dialect(&mut self, dialect: Dialect) {
        let (before, after) = (
            ArmSettings::stock(&self.dialect),
            ArmSettings::stock(&dialect),
        );
        self.dialect = dialect;
        for model in self.over.iter_mut().chain(self.in_flight.models()) {
            model.dialect = dialect;
            if model.settings.jump_height == before.jump_height {
                model.settings.jump_height = after.jump_height;
            }
        }
        self.replan();
    }

    /// Notes that the arm uses its Bluetooth port.
    pub(crate) fn note_bluetooth(&mut self) {
        let mut is_news = false;
        for model in self.over.iter_mut().chain(self.in_flight.models()) {
            is_news |= !model.is_bluetooth;
            model.is_bluetooth = true;
        }
        if is_news {
            self.replan();
        }
    }

    /// The model after all in-flight commands.
    pub(crate) fn after_sent(&self) -> Option<&Model> {
        let last = self.in_flight.last().map(|sent| &sent.plan.after);
        last.or(self.over.as_ref())
    }

    /// The model after all commands, waiting ones included.
    pub(crate) fn after_all(&self) -> Option<&Model> {
        let last = self
            .waiting
            .back()
            .and_then(|command| command.plan.as_ref());
        last.map(|plan| &plan.after).or_else(|| self.after_sent())
    }

    pub(crate) const fn in_flight(&self) -> &InFlight {
        &self.in_flight
    }

    /// Number of waiting commands.
    pub(crate) fn waiting(&self) -> usize {
        self.waiting.len()
    }

    /// Handles a status. An arm at rest without in-flight commands is where it reports to be.
    pub(crate) fn handle_status(&mut self, now: Duration, status: &Status) {
        while let Some(expired) = self.in_flight.pop_expired(now) {
            self.over = Some(expired.plan.after);
        }
        self.stood = self.last.replace(*status) == Some(*status)
            && now >= self.in_flight.rest_visible_from();
        match &mut self.over {
            None => self.over = Some(self.unknown(status)),
            Some(model) if self.in_flight.len() == 0 && !self.jogs && self.stood => {
                let before = *model;
                model.observe(status);
                if *model == before {
                    return;
                }
            }
            Some(_) => return,
        }
        self.replan();
    }

    /// Predicts the waiting commands again, after their starting point has changed.
    fn replan(&mut self) {
        let Some(mut model) = self.after_sent().copied() else {
            return;
        };
        for given in &mut self.waiting {
            let plan = Plan::new(&model, &given.command);
            model = plan.after;
            given.plan = Some(plan);
        }
    }

    /// Predicts a command that follows all others; `None` before the first status.
    pub(crate) fn plan(&self, command: &Command) -> Option<Box<Plan>> {
        self.after_all().map(|model| Plan::new(model, command))
    }

    /// Appends a waiting command with its prediction.
    pub(crate) fn push(&mut self, id: CommandId, command: Command, plan: Option<Box<Plan>>) {
        self.waiting.push_back(WaitingCommand { id, command, plan });
    }

    /// Removes the next command to send.
    pub(crate) fn pop_next(&mut self) -> Option<WaitingCommand> {
        self.waiting.pop_front()
    }

    /// Discards the waiting commands and returns their ids.
    pub(crate) fn discard_waiting(&mut self) -> Vec<CommandId> {
        self.waiting.drain(..).map(|command| command.id).collect()
    }

    /// The next command to send.
    pub(crate) fn next(&self) -> Option<&WaitingCommand> {
        self.waiting.front()
    }

    /// If the next command is a vector: whether it burns, and its duration.
    pub(crate) fn next_vector(&self) -> Option<(bool, Duration)> {
        let next = self.next()?;
        let is_vector = matches!(next.command, Command::WriteVector(_));
        let plan = next.plan.as_ref().filter(|_| is_vector)?;
        let lit = plan.trajectory.is_ok_and(|trajectory| trajectory.laser());
        Some((lit, plan.motion))
    }

    /// Whether the next command is a straight line that may have no length, because it is not known yet
    /// where the arm will stop (note N34).
    pub(crate) fn waits_for_place(&self) -> bool {
        let unknown = self.after_sent().is_some_and(|model| !model.knows_place());
        let is_line = |waiting: &WaitingCommand| {
            matches!(
                waiting.command,
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

    /// Discards the first waiting command of a kind and all after it, except releases of buttons. Returns
    /// their ids.
    pub(crate) fn discard_from_first(&mut self, kind: impl Fn(&Command) -> bool) -> Vec<CommandId> {
        let first = self
            .waiting
            .iter()
            .position(|waiting| kind(&waiting.command));
        let from_first = self.waiting.split_off(first.unwrap_or(self.waiting.len()));
        let (releases, others): (Vec<_>, Vec<_>) = from_first
            .into_iter()
            .partition(|waiting| Button::of(&waiting.command) == Some(Button::Released));
        self.waiting.extend(releases);
        self.replan();
        others.into_iter().map(|waiting| waiting.id).collect()
    }

    /// Whether the laser may be on now or during an in-flight command.
    pub(crate) fn is_lit(&self) -> bool {
        self.stays_lit() || self.in_flight.is_lit()
    }

    /// Whether the laser is on after all in-flight commands.
    pub(crate) fn stays_lit(&self) -> bool {
        self.after_sent().is_some_and(|model| model.laser)
    }

    /// Whether the arm would pause with the laser on if this command were sent now.
    pub(crate) fn would_pause_lit(&self, command: &Command) -> bool {
        let lit = self.after_sent().filter(|model| model.laser);
        let trajectory = lit.and_then(|model| model.trajectory(command).ok());
        trajectory.is_some_and(|trajectory| trajectory.pause_s() > 0.0)
    }

    /// Handles that a waiting command is sent.
    pub(crate) fn handle_sent(&mut self, now: Duration, given: WaitingCommand) {
        self.note_button(&given.command);
        if let Some(before) = self.after_sent().copied() {
            let plan = given
                .plan
                .unwrap_or_else(|| Plan::new(&before, &given.command));
            self.in_flight
                .push(now, Some(given.id), given.command, plan, &before);
        }
    }

    /// Handles that an urgent command is sent, ahead of the waiting ones.
    pub(crate) fn handle_urgent(&mut self, now: Duration, command: &Command) {
        self.note_button(command);
        if let Some(before) = self.after_sent().copied() {
            let plan = Plan::new(&before, command);
            self.in_flight.push(now, None, *command, plan, &before);
            self.replan();
        }
    }

    /// Handles the end of the first in-flight command.
    pub(crate) fn handle_over(&mut self, now: Duration) -> Option<Sent> {
        let over = self.in_flight.pop(now)?;
        self.over = Some(over.plan.after);
        Some(over)
    }

    /// Handles that the first in-flight command missed its target: the place of the arm is unknown until it
    /// is seen at rest.
    pub(crate) fn handle_missed(&mut self, now: Duration) -> Option<Sent> {
        let missed = self.handle_over(now)?;
        if let Some(model) = &mut self.over {
            model.lose_place();
            self.in_flight.replan(*model);
        }
        self.replan();
        Some(missed)
    }

    /// Handles a reset of the arm. Returns the number of awaited commands that are lost.
    pub(crate) fn handle_reset(&mut self, status: &Status) -> usize {
        let lost = self.waiting.len() + self.in_flight.awaited();
        self.waiting.clear();
        self.in_flight.clear();
        self.release = None;
        self.jogs = false;
        self.over = Some(self.unknown(status));
        lost
    }

    /// Whether no motion is in flight.
    pub(crate) fn is_at_rest(&self) -> bool {
        self.in_flight.len() == 0 && !self.jogs
    }

    /// Whether, in addition, the statuses showed the arm at rest.
    pub(crate) fn was_seen_at_rest(&self) -> bool {
        self.is_at_rest() && self.stood
    }

    /// The release of the last pressed button; `None` if none was pressed.
    pub(crate) const fn release(&self) -> Option<Command> {
        self.release
    }

    /// Whether the last jog button sent is pressed.
    pub(crate) const fn is_jogging(&self) -> bool {
        self.jogs
    }

    /// Whether the base is at 0 after an in-flight command.
    pub(crate) fn comes_to_zero(&self) -> bool {
        self.in_flight.iter().any(|sent| ends_ahead(&sent.plan))
    }

    /// Whether the base would be at 0 after the next command.
    pub(crate) fn would_come_to_zero(&self) -> bool {
        let next = self
            .waiting
            .front()
            .and_then(|waiting| waiting.plan.as_ref());
        next.is_some_and(|plan| ends_ahead(plan))
    }

    /// Latest time until the arm is at rest if nothing more is sent; `Duration::MAX` during a jog.
    pub(crate) fn rests_within(&self, now: Duration) -> Duration {
        if self.jogs {
            return Duration::MAX;
        }
        let unknown = self.over.is_some_and(|model| !model.knows_place());
        let at_rest = if unknown {
            Duration::MAX
        } else {
            Duration::ZERO
        };
        self.in_flight.rests_within(now).unwrap_or(at_rest)
    }

    /// Records the button that a sent command presses.
    fn note_button(&mut self, command: &Command) {
        let release = Button::release_of(command);
        self.jogs = release.is_some();
        self.release = release.or(self.release);
    }
}

/// Whether the base is at 0 at the end of a plan.
fn ends_ahead(plan: &Plan) -> bool {
    let end = plan.trajectory.ok().and_then(|trajectory| trajectory.end());
    end.is_some_and(|end| end.joints.base.abs().0 < AHEAD_DEG)
}

const AHEAD_DEG: f64 = 0.001;
