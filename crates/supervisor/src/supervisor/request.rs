//! Requests of clients, as API requests or as raw packets.

use std::time::Duration;

use dobot_api::{
    Button, Calibrations, ClientId, Device, EpisodeMark, Jog, News, Reply, Request, Role, TimeSlot,
};
use dobot_arm::{Degrees, Pose, Position};
use dobot_safety::Policy;
use dobot_wire::{Command, Configuration, Dialect, Packet, single};

use super::amend::amended;
use super::commands::{button, translate};
use super::events::NOT_DELIVERED;
use super::lease::{Change, LostControl};
use super::slots::SlotChange;
use super::stop_latch::StopLatch;
use super::stop_latch::StoppedBy;
use super::{Supervisor, still_moving};
use crate::plain;
use crate::refusal::{Refusal, span};

impl Supervisor {
    /// Handles a connected client; `person` is its name for time slots.
    pub fn handle_client(
        &mut self,
        now: Duration,
        name: &str,
        role: Role,
        person: &str,
    ) -> ClientId {
        self.handle_time(now);
        self.outgoing.note_change();
        self.leases.handle_client(name, role, person)
    }

    /// Handles the kind of device on which a client is open as a page.
    pub fn handle_device(&mut self, client: ClientId, device: Option<Device>) {
        self.leases.set_device(client, device);
        self.outgoing.note_change();
    }

    /// Handles a disconnected client, on purpose or not: its lease ends and its button is released.
    pub fn handle_left(&mut self, now: Duration, client: ClientId) {
        self.handle_time(now);
        let changes = self.leases.handle_left(client);
        self.follow_lease(changes);
        self.outgoing.note_change();
    }

    /// Handles a packet of a raw program. The first one takes the lease if it is free.
    ///
    /// # Errors
    ///
    /// [`Refusal`]; the packet is not sent, and a notice is published.
    pub fn handle_raw(
        &mut self,
        now: Duration,
        client: ClientId,
        packet: &Packet,
    ) -> Result<(), Refusal> {
        self.handle_time(now);
        let taken = self.take_raw(client, packet);
        if let Err(refusal) = &taken {
            self.notify_refused(client, refusal);
        }
        self.feed();
        taken
    }

    /// Handles a request. Returns `None` if the answer takes time: [`Supervisor::poll_answer`]
    /// returns it later.
    ///
    /// The caller stores and plans jobs, since that may take long: it answers
    /// [`Request::SubmitJob`], [`Request::QueueAgain`], [`Request::MoveJob`] and
    /// [`Request::ForgetJob`] (unless the job is the current one), and turns [`Request::StartJob`]
    /// and [`Request::StepJob`] into [`Supervisor::handle_start`].
    pub fn handle_request(
        &mut self,
        now: Duration,
        client: ClientId,
        request: Request,
    ) -> Option<Result<Reply, Refusal>> {
        self.handle_time(now);
        if let Request::CheckCommand { command } = request {
            return Some(self.preview(&command));
        }
        if let Request::Near {
            x_mm,
            y_mm,
            z_mm,
            rotation_deg,
        } = request
        {
            let pose = Pose {
                position: Position::new(x_mm, y_mm, z_mm),
                rotation: Degrees(rotation_deg),
            };
            return Some(self.arm.near_at(pose).map(|near| Reply::Near { near }));
        }
        let answer = match self.check_request(client, &request) {
            Err(refusal) => Some(Err(refusal)),
            Ok(()) if matches!(request, Request::Detect) => self.detect(client).err().map(Err),
            Ok(()) => Some(self.obey(client, request)),
        };
        if let Some(Err(refusal)) = &answer {
            self.notify_refused(client, refusal);
            if matches!(refusal, Refusal::Policy(_) | Refusal::Send(_)) && self.leases.has(client) {
                // The client's idea of the arm is wrong.
                self.arm.send_laser_off();
            }
        }
        self.outgoing.note_change();
        self.feed();
        answer
    }

    /// Checks that a client's role allows this request.
    ///
    /// # Errors
    ///
    /// [`Refusal::Role`].
    pub fn check_request(&self, client: ClientId, request: &Request) -> Result<(), Refusal> {
        self.leases.check_role(client, request.role())
    }

    /// Replaces the policy. Commands sent earlier were checked by the old policy, so they must be
    /// over; the laser is disarmed.
    ///
    /// # Errors
    ///
    /// [`Refusal::Role`], [`Refusal::JobRunning`], [`Refusal::Detecting`],
    /// [`Refusal::StillMoving`]; the old policy stays.
    pub fn handle_policy(
        &mut self,
        now: Duration,
        client: ClientId,
        policy: Policy,
    ) -> Result<(), Refusal> {
        self.handle_time(now);
        self.check_may_change(client)?;
        self.disarm_laser("the policy was changed");
        self.arm.set_policy(policy);
        let text = format!("{} changed the safety policy", self.client_name(client));
        self.notify(News::PolicyChanged, text);
        self.outgoing.note_change();
        self.feed();
        Ok(())
    }

    /// Checks that a client may change policy or calibration: nothing may be in flight.
    fn check_may_change(&self, client: ClientId) -> Result<(), Refusal> {
        self.leases.check_role(client, Role::Admin)?;
        if let Some(job) = self.job().filter(|_| self.is_executing_job()) {
            return Err(Refusal::JobRunning(job.job));
        }
        self.detecting.check()?;
        if !self.arm.is_idle() || self.jogging.times_out_at().is_some() {
            return Err(still_moving(self.rests_within()));
        }
        Ok(())
    }

    /// Replaces the calibration. Commands sent earlier used the old one, so they must be over.
    ///
    /// # Errors
    ///
    /// [`Refusal::Role`], [`Refusal::JobRunning`], [`Refusal::Detecting`],
    /// [`Refusal::StillMoving`]; the old calibration stays.
    pub fn handle_calibration(
        &mut self,
        now: Duration,
        client: ClientId,
        calibrations: &Calibrations,
    ) -> Result<(), Refusal> {
        self.handle_time(now);
        self.check_may_change(client)?;
        self.disarm_laser("the arm was calibrated");
        let calibration = calibrations.arm();
        self.arm.set_calibration(calibration);
        self.outgoing.note_change();
        let name = self.client_name(client);
        let text = if calibration.is_none() {
            format!("{name} removed the calibration: the arm is assumed to match the drawing")
        } else {
            let arm = calibrations.name().unwrap_or("the arm");
            format!("{name} calibrated {arm}: positions are calibrated from now on")
        };
        self.notify(News::Calibrated, text);
        self.feed();
        Ok(())
    }

    /// Gives a calibrated arm its true angles. Its base must point straight ahead, because that is
    /// what the arm then assumes (note N26).
    fn set_angles(&mut self, client: ClientId) -> Result<Reply, Refusal> {
        self.check_may_move(client)?;
        let model = self.arm.session().model().copied();
        let Some(model) = model.filter(|_| self.arm.is_at_rest()) else {
            return Err(self.still_moving());
        };
        let joints = model.calibrated_place(&model.place).joints;
        if joints.base.0.abs() > STRAIGHT_DEG {
            return Err(Refusal::OutOfRange {
                name: "the true base angle",
                found: (joints.base.0 * 100.0).round() / 100.0,
                allowed: format!(
                    "-{STRAIGHT_DEG} to {STRAIGHT_DEG} degrees: turn the base straight ahead first"
                ),
            });
        }
        let angles = Configuration::InitialAngles {
            rear_deg: single(joints.rear.0),
            fore_deg: single(joints.fore.0),
        };
        self.command(client, &angles.into())
    }

    /// Returns the path a command would take if it were sent now.
    fn preview(&self, command: &Command) -> Result<Reply, Refusal> {
        let command = &self.arm.raw_command(command)?;
        let command = translate(&self.arm, command, self.rests_within())?;
        let way = self.arm.preview(&command)?;
        Ok(Reply::Way { way })
    }

    /// Starts the detection of the dialect; the answer follows when the arm has made its motions.
    fn detect(&mut self, client: ClientId) -> Result<(), Refusal> {
        self.check_may_move(client)?;
        self.arm.check_trust()?;
        let rests_within = self.rests_within();
        self.detecting.begin(client, &self.arm, rests_within)?;
        self.stop_sequence.forget();
        Ok(())
    }

    fn obey(&mut self, client: ClientId, request: Request) -> Result<Reply, Refusal> {
        match request {
            Request::Command { command } => {
                let raw = self.arm.raw_command(&command)?;
                self.command(client, &raw)
            }
            Request::SensedCommand { sense, command } => {
                self.sensed_command(client, sense, &command)
            }
            Request::Heard {
                client: talker,
                heard,
            } => self.publish_heard(client, talker, heard),
            Request::Jog { jog } => self.jog(client, jog, self.arm.policy().jog.dead_man_s),
            Request::Release => {
                self.leases.check(client)?;
                self.release_button();
                self.check_delivered("the release")
            }
            Request::Step { button, by } => self.step(client, button, by),
            Request::Stop { reason } => Ok(self.stop_arm(client, reason)),
            Request::ResetStop => self.reset_stop(client),
            Request::TakeLease
            | Request::ReleaseLease
            | Request::AskLease
            | Request::GrantLease { .. }
            | Request::SeizeLease => self.change_lease(client, &request),
            Request::Lock { message } => Ok(self.lock(client, message)),
            Request::Unlock => {
                if self.leases.unlock() {
                    let text = format!("{} unlocked the arm", self.client_name(client));
                    self.notify(News::Unlocked, text);
                }
                Ok(Reply::Done)
            }
            Request::SetSlots { slots } => self.set_slots(client, &slots),
            Request::ShowState => Ok(Reply::State {
                state: Box::new(self.state()),
            }),
            Request::ShowSlots => Ok(self.slots_reply()),
            Request::Message { text } => {
                let text = plain(&text, REASON_LEN);
                let text = format!("{}: {text}", self.client_name(client));
                self.notify(News::Message { client }, text);
                Ok(Reply::Done)
            }
            Request::MarkEpisode { mark, task } => self.mark_episode(client, mark, task.as_deref()),
            Request::ArmLaser { for_s } => self.arm_laser(client, for_s),
            Request::DisarmLaser => {
                self.disarm_laser("a client asked for it");
                self.check_delivered("laser off")
            }
            Request::ConfirmPose => self.confirm_pose(client),
            Request::SetAngles => self.set_angles(client),
            Request::SetDialect { dialect } => {
                self.detecting.forget_finding();
                self.set_dialect(dialect)
            }
            Request::ConfirmJob { job } => self.confirm_job(client, job),
            Request::PauseJob => self.pause_job(client),
            Request::SetJobSpeed { percent } => self.set_job_speed(client, percent),
            Request::SetJobHeight { offset_mm } => self.set_job_height(client, offset_mm),
            Request::CancelJob { job } => self.cancel_job(client, job),
            Request::ForgetJob { job } => Err(self.refuse_removal(job)),
            Request::CheckCommand { .. }
            | Request::Near { .. }
            | Request::Calibrate { .. }
            | Request::Detect
            | Request::SubmitJob { .. }
            | Request::QueueAgain { .. }
            | Request::MoveJob { .. }
            | Request::StartJob { .. }
            | Request::AnswerJob { .. }
            | Request::StepJob { .. } => Err(Refusal::Malformed(
                "this request is not accepted here".into(),
            )),
        }
    }

    /// Marks an episode in the recording, which contains all notices.
    fn mark_episode(
        &mut self,
        client: ClientId,
        mark: EpisodeMark,
        task: Option<&str>,
    ) -> Result<Reply, Refusal> {
        let name = self.client_name(client);
        let task = task.map(|task| plain(task, REASON_LEN));
        let text = match (mark, &task) {
            (EpisodeMark::Begin, None) => format!("{name} began an episode"),
            (EpisodeMark::Begin, Some(task)) => format!("{name} began an episode: {task}"),
            (EpisodeMark::End, None) => format!("{name} ended the episode"),
            (EpisodeMark::Discard, None) => format!("{name} discarded the episode"),
            (_, Some(_)) => {
                let why = "task: allowed only where an episode begins";
                return Err(Refusal::Malformed(why.into()));
            }
        };
        self.notify(News::EpisodeMarked { mark, task }, text);
        Ok(Reply::Done)
    }

    fn stop_arm(&mut self, client: ClientId, reason: Option<String>) -> Reply {
        let by = self.client_name(client);
        let why = format!("the arm was stopped by {by}");
        let reason = reason.map(|reason| plain(&reason, REASON_LEN));
        let by = StoppedBy {
            by: self.leases.bare_name(client),
            device: self.leases.device(client),
            client: Some(client),
            reason,
        };
        self.bring_to_rest(&why, |stop, now, rests_within, delivered| {
            stop.handle_stop(now, by, rests_within, delivered)
        })
    }

    /// Brings the arm to rest: laser off first, buttons released, nothing more is sent. The arm
    /// finishes its current command, because its protocol has no stop; a repeated stop is sent to
    /// the arm again. `hold` gets the time, the time until rest and whether the packets are
    /// delivered, and returns the text to publish.
    pub(super) fn bring_to_rest(
        &mut self,
        why: &str,
        hold: impl FnOnce(&mut StopLatch, Duration, Duration, bool) -> Option<String>,
    ) -> Reply {
        let rests_within = self.rests_within();
        self.stop_sequence.begin(&mut self.arm);
        self.disarm_laser("the arm was stopped");
        self.jogging.revoke(Refusal::LetGo(why.to_owned()));
        self.drop_waiting(why);
        self.interrupt_run(why);
        self.end_detection(why);
        // Without an arm there is nothing to deliver to.
        let delivered = self.link.is_there() || self.arm.last().is_none();
        let notice = hold(
            &mut self.stop_latch,
            self.arm.now(),
            rests_within,
            delivered,
        );
        if let Some(text) = notice {
            self.notify(News::Stopped, text);
            if !delivered {
                self.notify(News::Trouble, NOT_DELIVERED.to_owned());
            }
        }
        Reply::Stopping {
            rests_within_s: rests_within.as_secs_f64(),
            delivered,
        }
    }

    fn reset_stop(&mut self, client: ClientId) -> Result<Reply, Refusal> {
        if self
            .stop_latch
            .reset(self.arm.now(), self.link.is_there())?
        {
            self.stop_sequence.forget();
            let text = format!("{} cleared the stop", self.client_name(client));
            self.notify(News::StopReset, text);
        }
        Ok(Reply::Done)
    }

    /// Locks the arm for administrators. A running job comes to rest; an administrator can resume
    /// it.
    fn lock(&mut self, client: ClientId, message: Option<String>) -> Reply {
        let message = message.map(|message| plain(&message, REASON_LEN));
        let by = self.client_name(client);
        let text = match &message {
            Some(message) => format!("{by} locked the arm: {message}"),
            None => format!("{by} locked the arm"),
        };
        let ended = self.leases.lock(self.arm.now(), client, message);
        self.follow_lease(ended);
        // Without a running job there is nothing to pause.
        let _ = self.pause_job(client);
        self.notify(News::Locked, text);
        Reply::Done
    }

    fn set_slots(&mut self, client: ClientId, slots: &[TimeSlot]) -> Result<Reply, Refusal> {
        self.leases.set_slots(self.arm.now(), slots)?;
        let by = self.client_name(client);
        let text = match self.slots().last() {
            None => format!("{by} cleared the time slots: the arm is free"),
            Some(last) => format!(
                "{by} set {} time slots, for the next {}",
                slots.len(),
                span(last.ends_in_s)
            ),
        };
        self.notify(News::SlotsChanged, text);
        self.watch_slots();
        Ok(self.slots_reply())
    }

    fn slots_reply(&self) -> Reply {
        let slots = self.slots();
        Reply::Slots { slots }
    }

    /// Applies the time slots: a client whose slot is over loses control, as by a lock. A running
    /// job comes to rest; the next holder can resume it.
    pub(super) fn watch_slots(&mut self) {
        let (turns, over) = self.leases.handle_time(self.arm.now());
        if let Some(LostControl { why, changes }) = over {
            self.follow_lease(changes);
            // Without a running job there is nothing to pause.
            let _ = self.pause_for(&why);
        }
        for turn in turns {
            let (news, text) = slot_notice(turn);
            self.notify(news, text);
        }
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

    /// Checks that a client may move the arm by hand now.
    pub(super) fn check_may_move(&self, client: ClientId) -> Result<(), Refusal> {
        self.leases.check(client)?;
        self.check_free()
    }

    fn follow_lease(&mut self, changes: impl IntoIterator<Item = Change>) {
        for change in changes {
            match change {
                Change::Ended { client, why } => self.lease_over(client, &why),
                Change::Taken(client) => {
                    let text = format!("{} has control", self.client_name(client));
                    self.notify(News::LeaseTaken { client }, text);
                }
                Change::Asked(client) => {
                    let text = format!("{} asks for control", self.client_name(client));
                    self.notify(News::LeaseAsked { client }, text);
                }
            }
        }
    }

    /// Without control nothing moves: buttons are released, waiting commands dropped, and the laser
    /// goes off. A drawing with a pen continues; it belongs to the station.
    fn lease_over(&mut self, client: ClientId, why: &str) {
        self.arm.send_laser_off();
        self.disarm_laser(why);
        self.release_button();
        self.end_detection(why);
        if self.commands.any_of(client) {
            self.drop_waiting(why);
        }
        self.notify(News::LeaseFree, format!("control is free: {why}"));
    }

    fn arm_laser(&mut self, client: ClientId, for_s: f64) -> Result<Reply, Refusal> {
        self.leases.check_arms_laser(client)?;
        self.stop_latch.check()?;
        self.check_guarded()?;
        self.arm.arm_laser(for_s)?;
        let name = self.client_name(client);
        let text = format!("{name} armed the laser for {for_s:.0} s: goggles on");
        self.notify(News::LaserArmed, text);
        Ok(Reply::Done)
    }

    /// Sends one command, if its whole path is allowed.
    pub(super) fn command(
        &mut self,
        client: ClientId,
        command: &Command,
    ) -> Result<Reply, Refusal> {
        if let Some(jog) = button(command) {
            return self.jog(client, jog, self.arm.policy().jog.dead_man_s);
        }
        self.check_may_move(client)?;
        // A client that sends another command no longer holds its button.
        self.release_button();
        let within = self.rests_within();
        let id = self
            .commands
            .handle_command(&mut self.arm, client, command, within)?;
        self.stop_sequence.forget();
        Ok(Reply::Accepted {
            command: id.0,
            takes_s: Some(self.arm.session().ahead_s()),
        })
    }

    /// Moves the arm by one step of a button.
    fn step(&mut self, client: ClientId, button: Button, by: f32) -> Result<Reply, Refusal> {
        if !(SHORTEST_STEP..=LONGEST_STEP).contains(&by) {
            return Err(Refusal::OutOfRange {
                name: "the step",
                found: by.into(),
                allowed: format!("{SHORTEST_STEP} to {LONGEST_STEP} mm or degrees"),
            });
        }
        let Some(from) = self.arm.end_status() else {
            return Err(Refusal::NoLink("no status has come yet".into()));
        };
        let Some(command) = button.step(&from, by) else {
            return Err(Refusal::Malformed(format!(
                "the button {} has no step; allowed are those of a joint, of an axis and of the servo",
                button.name()
            )));
        };
        let command = self.arm.raw_command(&command)?;
        self.command(client, &command)
    }

    fn take_raw(&mut self, client: ClientId, packet: &Packet) -> Result<(), Refusal> {
        let taken = self.leases.handle_program(self.arm.now(), client);
        self.follow_lease(taken);
        self.leases.check(client)?;
        let packet = &self.amended(client, packet);
        let command = self.arm.session().parse(packet)?;
        let hold_timeout_s = self.arm.policy().jog.raw_dead_man_s;
        match command {
            Command::JointJog(jog) => self.jog(client, Jog::Joint(jog), hold_timeout_s),
            Command::LinearJog(jog) => self.jog(client, Jog::Linear(jog), hold_timeout_s),
            command => {
                // Any other packet means that the button is no longer held.
                self.release_button();
                self.command(client, &command)
            }
        }
        .map(|_| ())
    }

    /// Replaces values that a stock arm would accept harmlessly; a notice reports a run of equal
    /// modifications once.
    fn amended(&mut self, client: ClientId, packet: &Packet) -> Packet {
        let model = self
            .arm
            .session()
            .model()
            .filter(|_| self.arm.session().dialect().is_some());
        let changed = model.and_then(|model| amended(packet, model, self.arm.policy()));
        let Some((sent, what)) = changed else {
            return *packet;
        };
        let text = format!("{}: {what}", self.client_name(client));
        if self.leases.handle_amended(client, &text) {
            self.notify(News::Amended { client }, text);
        }
        sent
    }

    /// Publishes a notice of a refusal.
    pub(super) fn notify_refused(&mut self, client: ClientId, refusal: &Refusal) {
        if self.jogging.was_reported(client, refusal) {
            return;
        }
        // The arm's own protocol has no refusals: the reader of this notice is the only one to
        // know.
        let is_program = self.leases.is_program(client);
        let remedy = refusal
            .hint()
            .or_else(|| is_program.then(|| CONTINUE_HINT.into()));
        let remedy = remedy.map_or_else(String::new, |remedy| format!("; {remedy}"));
        let text = format!("refused to {}: {refusal}{remedy}", self.client_name(client));
        let kind = refusal.kind().to_owned();
        self.notify(News::Refused { client, kind }, text);
    }

    pub(super) fn still_moving(&self) -> Refusal {
        super::still_moving(self.rests_within())
    }

    fn confirm_pose(&mut self, client: ClientId) -> Result<Reply, Refusal> {
        self.link.check()?;
        // Nothing moves before the confirmation, so no client needs control for it.
        if !self.arm.session().is_trusted() {
            self.arm.session_mut().confirm_pose();
            let text = format!("{} confirmed the pose", self.client_name(client));
            self.notify(News::PoseTrusted, text);
        }
        Ok(Reply::Done)
    }

    pub(super) fn set_dialect(&mut self, dialect: Dialect) -> Result<Reply, Refusal> {
        if let Some(run) = self.run.as_ref().filter(|run| run.occupies_arm()) {
            return Err(Refusal::JobRunning(run.job()));
        }
        if self.arm.session().dialect() != Some(&dialect) {
            self.arm.session_mut().set_dialect(dialect);
            self.notify(
                News::DialectKnown { dialect },
                format!("the arm speaks {dialect}"),
            );
        }
        Ok(Reply::Done)
    }
}

/// Returns the notice for a time slot.
fn slot_notice(turn: SlotChange) -> (News, String) {
    match turn {
        SlotChange::Began { student, lasts } => {
            let text = format!(
                "the time slot of {student} has begun and lasts {}",
                span(lasts.as_secs_f64())
            );
            (News::SlotBegan { student }, text)
        }
        SlotChange::Ending { student, left } => {
            let left = span(left.as_secs_f64());
            let text = format!("the time slot of {student} ends in {left}");
            (News::SlotEnding { student }, text)
        }
        SlotChange::Ended { student } => {
            let text = format!("the time slot of {student} is over");
            (News::SlotEnded { student }, text)
        }
    }
}

/// The hint for a refused packet without a more specific one.
const CONTINUE_HINT: &str = "send an allowed packet; this one was ignored";
pub(super) const REASON_LEN: usize = 200;
/// The shortest and the longest step of a button, in mm or degrees.
const SHORTEST_STEP: f32 = 0.01;
const LONGEST_STEP: f32 = 100.0;
/// A base this close to straight ahead counts as straight ahead.
const STRAIGHT_DEG: f64 = 0.1;
