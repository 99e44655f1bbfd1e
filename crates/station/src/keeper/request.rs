//! What clients ask for.

use std::time::Duration;

use dobot_wire::{Command, Dialect};

use super::commands::button;
use super::jog::{Press, Still, act, is_released, moves};
use super::{Keeper, seconds};
use crate::words::{ClientId, Jog, News, Refusal, Reply, Request, plain};

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
            Ok(()) if matches!(request, Request::Detect) => self.detect(client).err().map(Err),
            Ok(()) => Some(self.obey(client, request)),
        };
        if let Some(Err(refusal)) = &answer {
            self.tell_refused(client, refusal);
            if matches!(refusal, Refusal::Policy(_) | Refusal::Send(_)) && self.leases.has(client) {
                // What its client believes about the arm is wrong.
                self.arm.part_from_laser();
            }
        }
        self.outbox.note_change();
        self.pump();
        answer
    }

    /// Whether a client may ask for this at all.
    ///
    /// # Errors
    ///
    /// [`Refusal::Role`].
    pub fn check_request(&self, client: ClientId, request: &Request) -> Result<(), Refusal> {
        self.leases.check_role(client, request.role())
    }

    /// Begins to ask the arm for its dialect; the answer comes when the arm has made its motions.
    fn detect(&mut self, client: ClientId) -> Result<(), Refusal> {
        self.check_may_move(client)?;
        self.arm.check_trust()?;
        let rests_within = self.rests_within();
        self.detecting.begin(client, &self.arm, rests_within)?;
        self.halt.forget();
        Ok(())
    }

    fn obey(&mut self, client: ClientId, request: Request) -> Result<Reply, Refusal> {
        match request {
            Request::Command { command } => self.command(client, &command),
            Request::Jog { jog } => self.jog(client, jog, self.arm.policy().jog.dead_man_s),
            Request::Release => {
                self.leases.check(client)?;
                self.let_go();
                Ok(Reply::Done)
            }
            Request::Stop { reason } => Ok(self.stop_arm(client, reason)),
            Request::ResetStop => self.reset_stop(client),
            Request::TakeLease
            | Request::ReleaseLease
            | Request::AskLease
            | Request::GrantLease { .. }
            | Request::SeizeLease => self.change_lease(client, &request),
            Request::ArmLaser { for_s } => self.arm_laser(client, for_s),
            Request::DisarmLaser => {
                self.disarm_laser("a client asked for it");
                Ok(Reply::Done)
            }
            Request::ConfirmPose => self.confirm_pose(client),
            Request::SetDialect { dialect } => {
                self.detecting.forget_finding();
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

    /// Stops: laser off first, buttons let go, nothing more is sent. The arm finishes the command
    /// that it is at, for its protocol knows no stop; a stop that is said again says it to the arm
    /// again.
    fn stop_arm(&mut self, client: ClientId, reason: Option<String>) -> Reply {
        let by = self.name(client);
        let rests_within = self.rests_within();
        self.halt.begin(&mut self.arm);
        self.disarm_laser("the arm was stopped");
        let why = format!("the arm was stopped by {by}");
        self.jogging.bar(Refusal::LetGo(why.clone()));
        self.drop_waiting(&why);
        self.interrupt_run(&why);
        self.end_detection(&why);
        let reason = reason.map(|it| plain(&it, REASON_LEN));
        let now = self.arm.now();
        if let Some(text) = self.stop.handle_stop(now, by, reason, rests_within) {
            self.tell(News::Stopped, text);
        }
        Reply::Stopping {
            rests_within_s: rests_within.as_secs_f64(),
        }
    }

    fn reset_stop(&mut self, client: ClientId) -> Result<Reply, Refusal> {
        if self.stop.reset(self.arm.now(), self.link.is_there())? {
            self.halt.forget();
            let text = format!("{} lets the arm move again", self.name(client));
            self.tell(News::StopReset, text);
        }
        Ok(Reply::Done)
    }

    fn change_lease(&mut self, client: ClientId, request: &Request) -> Result<Reply, Refusal> {
        let now = self.arm.now();
        let changes = match *request {
            Request::ReleaseLease => self.leases.release(client)?,
            Request::AskLease => self.leases.ask(now, client)?,
            Request::GrantLease { to } => self.leases.grant(now, client, to)?,
            Request::SeizeLease => self.leases.seize(now, client),
            _ => self.leases.take(now, client)?,
        };
        self.follow_lease(changes);
        Ok(Reply::Lease {
            lease: self.leases.view(),
        })
    }

    /// Presses a jog button, or holds it.
    pub(super) fn jog(
        &mut self,
        client: ClientId,
        jog: Jog,
        patience_s: f64,
    ) -> Result<Reply, Refusal> {
        self.leases.check(client)?;
        if is_released(jog) {
            self.let_go();
            return Ok(Reply::Done);
        }
        if !moves(jog) {
            return self.command(client, &jog.command());
        }
        if let Some(held) = self.jogging.handle_hold(self.arm.now(), client, jog) {
            return match held? {
                Still::Same => Ok(Reply::Done),
                Still::OtherSpeed => self.change_speed(jog),
            };
        }
        self.let_go();
        let press = Press {
            client,
            jog,
            patience: seconds(patience_s),
        };
        let (free, within) = (self.check_free(), self.rests_within());
        let pressed = self
            .jogging
            .handle_press(&mut self.arm, press, free, within);
        if pressed? {
            self.halt.forget();
        }
        Ok(Reply::Done)
    }

    fn change_speed(&mut self, jog: Jog) -> Result<Reply, Refusal> {
        if let Err(why) = self.check_free().and_then(|()| act(&mut self.arm, jog)) {
            self.withdraw(why.clone());
            return Err(why);
        }
        self.halt.forget();
        Ok(Reply::Done)
    }

    /// Whether a client may move the arm by hand now.
    pub(super) fn check_may_move(&self, client: ClientId) -> Result<(), Refusal> {
        self.leases.check(client)?;
        self.check_free()
    }

    /// Whether nothing hinders the arm from being moved by hand.
    pub(super) fn check_free(&self) -> Result<(), Refusal> {
        self.link.check()?;
        self.stop.check()?;
        self.detecting.check()?;
        match &self.run {
            Some(run) if run.has_the_arm() => Err(Refusal::JobRunning(run.job())),
            _ => Ok(()),
        }
    }

    fn arm_laser(&mut self, client: ClientId, for_s: f64) -> Result<Reply, Refusal> {
        self.leases.check_arms_laser(client)?;
        self.stop.check()?;
        self.arm.arm_laser(for_s)?;
        let name = self.name(client);
        let text = format!("{name} armed the laser for {for_s:.0} s: goggles on");
        self.tell(News::LaserArmed, text);
        Ok(Reply::Done)
    }

    /// Sends one command, if its whole way is allowed.
    pub(super) fn command(
        &mut self,
        client: ClientId,
        command: &Command,
    ) -> Result<Reply, Refusal> {
        if let Some(jog) = button(command) {
            return self.jog(client, jog, self.arm.policy().jog.dead_man_s);
        }
        self.check_may_move(client)?;
        // Whoever sends another command does not hold his button any more.
        self.let_go();
        let within = self.rests_within();
        let id = self
            .commands
            .handle_command(&mut self.arm, client, command, within)?;
        self.halt.forget();
        Ok(Reply::Accepted {
            command: id.0,
            takes_s: Some(self.arm.session().ahead_s()),
        })
    }

    pub(super) fn still_moving(&self) -> Refusal {
        super::still_moving(self.rests_within())
    }

    fn confirm_pose(&mut self, client: ClientId) -> Result<Reply, Refusal> {
        self.link.check()?;
        // Nothing moves until it is confirmed, so nobody has to have control for that.
        if !self.arm.session().is_trusted() {
            self.arm.session_mut().confirm_pose();
            let text = format!("{} confirmed where the arm stands", self.name(client));
            self.tell(News::PoseTrusted, text);
        }
        Ok(Reply::Done)
    }

    pub(super) fn set_dialect(&mut self, dialect: Dialect) -> Result<Reply, Refusal> {
        if let Some(run) = self.run.as_ref().filter(|it| it.has_the_arm()) {
            return Err(Refusal::JobRunning(run.job()));
        }
        if self.arm.session().dialect() != Some(&dialect) {
            self.arm.session_mut().set_dialect(dialect);
            self.tell(
                News::DialectKnown { dialect },
                format!("the arm speaks {dialect}"),
            );
        }
        Ok(Reply::Done)
    }
}

const REASON_LEN: usize = 200;
