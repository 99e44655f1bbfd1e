//! What clients ask for.

use std::time::Duration;

use dobot_arm::Pose;
use dobot_client::SendError;
use dobot_course::{Button, CourseError, Model};
use dobot_safety::Violation;
use dobot_wire::{Command, Dialect, JointJog, JointJogAxis, MoveTo, MovingMode, VoiceOrder};

use super::Keeper;
use crate::words::{ClientId, Jog, LinkPhase, News, Refusal, Reply, Request, plain};

impl Keeper {
    /// Takes a request. `None` when the answer takes its time: [`Keeper::poll_answer`] has it then.
    ///
    /// Jobs are kept and planned by the caller, since that may take long: he answers
    /// [`Request::SubmitJob`], and turns [`Request::StartJob`] into [`Keeper::handle_start`].
    pub fn handle_request(
        &mut self,
        now: Duration,
        client: ClientId,
        request: Request,
    ) -> Option<Result<Reply, Refusal>> {
        self.handle_time(now);
        let answer = match self.check_request(client, &request) {
            Err(refusal) => Some(Err(refusal)),
            Ok(()) if matches!(request, Request::Detect) => self.detect(client),
            Ok(()) => Some(self.obey(client, request)),
        };
        if let Some(Err(refusal)) = &answer {
            self.tell_refused(client, refusal);
            if matches!(refusal, Refusal::Policy(_) | Refusal::Send(_)) && self.has_lease(client) {
                // What its client believes about the arm is wrong.
                self.part_from_laser();
            }
        }
        self.changed = true;
        self.pump();
        answer
    }

    /// Whether a client may ask for this at all.
    ///
    /// # Errors
    ///
    /// [`Refusal::Role`].
    pub fn check_request(&self, client: ClientId, request: &Request) -> Result<(), Refusal> {
        let known = self.clients.get(&client);
        let found = known.map_or(crate::words::Role::Watch, |it| it.role);
        let needed = request.role();
        if found < needed {
            return Err(Refusal::Role { needed, found });
        }
        Ok(())
    }

    fn obey(&mut self, client: ClientId, request: Request) -> Result<Reply, Refusal> {
        match request {
            Request::Command { command } => self.command(client, &command),
            Request::Jog { jog } => self.jog(client, jog, self.policy.jog.dead_man_s),
            Request::Release => {
                self.check_lease(client)?;
                self.let_go();
                Ok(Reply::Done)
            }
            Request::Stop { reason } => {
                Ok(self.stop(client, reason.map(|it| plain(&it, REASON_LEN))))
            }
            Request::ResetStop => self.reset_stop(client),
            Request::TakeLease => self.take_lease(client),
            Request::ReleaseLease => self.release_lease(client),
            Request::AskLease => self.ask_lease(client),
            Request::GrantLease { to } => self.grant_lease(client, to),
            Request::SeizeLease => Ok(self.seize_lease(client)),
            Request::ArmLaser { for_s } => self.arm_laser(client, for_s),
            Request::DisarmLaser => {
                self.disarm_laser("a client asked for it");
                Ok(Reply::Done)
            }
            Request::ConfirmPose => self.confirm_pose(client),
            Request::SetDialect { dialect } => {
                self.finding = None;
                self.set_dialect(dialect)
            }
            Request::PauseJob => self.pause_job(client),
            Request::SetJobSpeed { percent } => self.set_job_speed(client, percent),
            Request::SetJobHeight { offset_mm } => self.set_job_height(client, offset_mm),
            Request::CancelJob { job } => self.cancel_job(client, job),
            Request::Detect | Request::SubmitJob { .. } | Request::StartJob { .. } => Err(
                Refusal::Malformed("jobs and detections are not asked for this way".into()),
            ),
        }
    }

    /// Sends one command, if its whole way is allowed.
    pub(super) fn command(
        &mut self,
        client: ClientId,
        command: &Command,
    ) -> Result<Reply, Refusal> {
        if let Some(jog) = button(command) {
            return self.jog(client, jog, self.policy.jog.dead_man_s);
        }
        self.check_may_move(client)?;
        // Whoever sends another command does not hold his button any more.
        self.let_go();
        let command = &self.understood(command)?;
        let waiting = self.session.waiting();
        if waiting >= MOST_WAITING {
            return Err(Refusal::TooMany {
                waiting,
                most: MOST_WAITING,
            });
        }
        self.check_place(command)?;
        self.check_way(command)?;
        let id = self.session.send(*command)?;
        self.halt = None;
        self.pending.insert(id, client);
        Ok(Reply::Accepted {
            command: id.0,
            takes_s: Some(self.session.ahead_s()),
        })
    }

    /// A command as this arm understands it: what is said to one that does not hear voice is carried
    /// out as the motion or the button that the words mean (note N50).
    fn understood(&self, command: &Command) -> Result<Command, Refusal> {
        let Command::Voice(voice) = command else {
            return Ok(*command);
        };
        let Some(dialect) = self.session.dialect() else {
            let field = "voice";
            return Err(Refusal::Send(SendError::Undecided { field }));
        };
        if self.session.is_bluetooth() {
            // It waits in the session until the arm rests.
            return Ok(*command);
        }
        if dialect.hears_voice {
            // From the first byte of a text on, a motion under way would rest and lose its place.
            return self.check_rest().map(|()| *command);
        }
        let (Some(order), Some(model)) = (VoiceOrder::parse(voice), self.session.model()) else {
            let error = CourseError::NotUnderstood;
            return Err(Refusal::Policy(Box::new(Violation::of_course(&error))));
        };
        Ok(spoken(order, model))
    }

    /// Whether the arm rests.
    fn check_rest(&self) -> Result<(), Refusal> {
        if !self.is_at_rest() || self.session.is_moving() || self.session.waiting() > 0 {
            return Err(self.still_moving());
        }
        Ok(())
    }

    /// Whether it is known where a motion would begin: not behind a jog, or a motion that ended
    /// elsewhere, until the arm was seen at rest.
    fn check_place(&self, command: &Command) -> Result<(), Refusal> {
        match self.session.model() {
            Some(model) if !model.knows_place() && leads_somewhere(command) => {
                Err(self.still_moving())
            }
            _ => Ok(()),
        }
    }

    pub(super) fn still_moving(&self) -> Refusal {
        Refusal::StillMoving {
            within_s: self.rests_within().as_secs_f64(),
        }
    }

    fn confirm_pose(&mut self, client: ClientId) -> Result<Reply, Refusal> {
        self.check_link()?;
        // Nothing moves until it is confirmed, so nobody has to have control for that.
        if !self.session.is_trusted() {
            self.session.confirm_pose();
            let text = format!("{} confirmed where the arm stands", self.name(client));
            self.tell(News::PoseTrusted, text);
        }
        Ok(Reply::Done)
    }

    pub(super) fn set_dialect(&mut self, dialect: Dialect) -> Result<Reply, Refusal> {
        if let Some(run) = self.run.as_ref().filter(|it| it.has_the_arm()) {
            return Err(Refusal::JobRunning(run.job()));
        }
        if self.session.dialect() != Some(&dialect) {
            self.session.set_dialect(dialect);
            self.tell(
                News::DialectKnown { dialect },
                format!("the arm speaks {dialect}"),
            );
        }
        Ok(Reply::Done)
    }

    pub(super) fn check_link(&self) -> Result<(), Refusal> {
        if self.link.phase == LinkPhase::Up {
            return Ok(());
        }
        let why = match (&self.link.problem, self.link.phase) {
            (Some(problem), _) => problem.clone(),
            (None, LinkPhase::Searching) => "no arm has been found yet".into(),
            (None, _) => "the arm has not told anything yet".into(),
        };
        Err(Refusal::NoLink(why))
    }
}

/// A button by which the arm moves has to be held, and its release is of its kind, however they are
/// pressed.
fn button(command: &Command) -> Option<Jog> {
    let switches = matches!(
        Button::of(command),
        Some(Button::Suction(_) | Button::Laser(_))
    );
    match command {
        Command::JointJog(it) if !switches => Some(Jog::Joint(*it)),
        Command::LinearJog(it) if !switches => Some(Jog::Linear(*it)),
        _ => None,
    }
}

/// Whether the way of a command begins where the arm is.
const fn leads_somewhere(command: &Command) -> bool {
    match command {
        Command::WriteVector(it) => !it.stop,
        Command::MoveTo(_)
        | Command::MoveJoints(_)
        | Command::MouseMove(_)
        | Command::Gesture(_)
        | Command::Voice(_) => true,
        _ => false,
    }
}

/// What an order means, as a command that every arm hears: a straight line at the speed that is set
/// for lines, with pump and gripper as they are, or the pump's button.
#[expect(
    clippy::cast_possible_truncation,
    reason = "a packet carries single precision"
)]
fn spoken(order: VoiceOrder, model: &Model) -> Command {
    let button = |axis| Command::from(JointJog::new(axis, 0.0));
    match order {
        VoiceOrder::Catch => button(JointJogAxis::SuctionOn),
        VoiceOrder::Release => button(JointJogAxis::SuctionOff),
        VoiceOrder::Move { x_mm, y_mm, z_mm } => {
            let Pose { position, rotation } = model.place.pose;
            MoveTo {
                x_mm: position.x.0 as f32 + x_mm,
                y_mm: position.y.0 as f32 + y_mm,
                z_mm: position.z.0 as f32 + z_mm,
                rotation_deg: rotation.0 as f32,
                suction: model.suction,
                mode: MovingMode::MovL,
                gripper_deg: model.gripper_deg as f32,
                pause_s: 0.0,
            }
            .into()
        }
    }
}

/// A client that has so much waiting had better send a job.
const MOST_WAITING: usize = 64;
const REASON_LEN: usize = 200;
