//! A supervisor and a virtual arm, in virtual time: what would happen.

use std::time::Duration;

use dobot_api::JobState;
use dobot_api::{
    Calibrations, ClientId, FleetWideStop, JobPath, JobView, LinkPhase, NewJob, Notice, Reply,
    Request, Role,
};
use dobot_controller::{Controller, PowerUp};
use dobot_journal::{JobId, Journal, JournalError};
use dobot_safety::Policy;
use dobot_sim::{SerialLine, VirtualArm};
use dobot_supervisor::{Effect, KeptFleetStop, Refusal, StartedJob, StoppedBy, Supervisor};
use dobot_wire::Packet;

use crate::job_path::path_of;
use crate::jobs;
use crate::watchdog::GAP;
use crate::{OfferAnswer, OfferAsk};

/// A supervisor and a virtual arm, in virtual time, with a real journal: for tests of everything that
/// can go wrong, thousands of times faster than it would.
///
/// The arm goes on whatever becomes of the supervisor: [`VirtualStation::crash`] takes the supervisor away in the
/// middle of whatever it does, and puts a new one in its place, as after a SIGKILL.
#[derive(Debug)]
pub struct VirtualStation {
    supervisor: Supervisor,
    arm: VirtualArm,
    journal: Journal,
    policy: Policy,
    power_up: PowerUp,
    calibrations: Calibrations,
    plugged: bool,
    /// The arm's port is gone by itself.
    port_gone: bool,
    now: Duration,
    /// When the supervisor that is there now was started.
    started: Duration,
    /// When the journal has written what it was asked for.
    disk: Vec<(Duration, Effect)>,
    /// How long the journal takes to write.
    disk_takes: Duration,
    /// How often the computer looks at its port and its clock; always, if that is 0.
    looks_every: Duration,
    /// When it does so next.
    looks: Duration,
    notices: Vec<Notice>,
    packets: Vec<(Duration, [u8; 42])>,
    /// The stops that are on the disk: the one of this arm, and those of the fleet.
    stops: (Option<StoppedBy>, Vec<KeptFleetStop>),
}

impl VirtualStation {
    /// A station that has just been started, with an arm that has just been switched on.
    ///
    /// # Panics
    ///
    /// Never: a journal in memory can always be made.
    #[must_use]
    pub fn new(power_up: PowerUp, policy: Policy) -> Self {
        let arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
        Self::with_arm(arm, power_up, policy)
    }

    /// The same with an arm of one's own: with faults, or in a world.
    ///
    /// # Panics
    ///
    /// Never: a journal in memory can always be made.
    #[must_use]
    pub fn with_arm(arm: VirtualArm, power_up: PowerUp, policy: Policy) -> Self {
        let journal = Journal::in_memory().expect("there is memory");
        Self::with_journal(arm, power_up, policy, journal)
    }

    /// The same with a journal of one's own: on a disk that can be full.
    #[must_use]
    pub fn with_journal(
        arm: VirtualArm,
        power_up: PowerUp,
        policy: Policy,
        journal: Journal,
    ) -> Self {
        let mut virtual_station = Self {
            supervisor: Supervisor::new(policy.clone(), Some(power_up.personality.dialect())),
            arm,
            journal,
            policy,
            power_up,
            calibrations: Calibrations::default(),
            plugged: false,
            port_gone: false,
            now: Duration::ZERO,
            started: Duration::ZERO,
            disk: Vec::new(),
            disk_takes: Duration::from_millis(3),
            looks_every: Duration::ZERO,
            looks: Duration::ZERO,
            notices: Vec::new(),
            packets: Vec::new(),
            stops: Default::default(),
        };
        virtual_station.plug();
        virtual_station
    }

    /// From now on the computer has so much else to do that it looks at its port and its clock only
    /// that often: statuses come in heaps, and what is due is done late.
    pub const fn load(&mut self, looks_every: Duration) {
        self.looks_every = looks_every;
    }

    /// Lets time pass.
    pub fn run_for(&mut self, time: Duration) {
        self.run_until(self.now + time, |_| false);
    }

    /// Lets time pass until something is so, or until `latest`; says whether it is.
    pub fn run_until(&mut self, latest: Duration, mut is_so: impl FnMut(&Self) -> bool) -> bool {
        self.settle();
        while !is_so(self) {
            if self.now >= latest {
                return false;
            }
            self.step(latest);
        }
        true
    }

    /// One moment further, at the most to `latest`.
    pub fn step(&mut self, latest: Duration) {
        self.now = self.next_step().min(latest);
        self.arm.handle_time(self.now);
        self.follow_port();
        self.settle();
    }

    fn next_step(&self) -> Duration {
        if self.now < self.looks {
            return self.looks;
        }
        let supervisor = self.started.saturating_add(self.supervisor.poll_wakeup());
        let disk = self.disk.first().map_or(Duration::MAX, |it| it.0);
        let soon = self.now + Duration::from_nanos(1);
        self.arm.poll_wakeup().min(supervisor).min(disk).max(soon)
    }

    /// Pulls the cable.
    pub fn unplug(&mut self) {
        self.plugged = false;
        let why = Some("the cable was pulled".to_owned());
        let now = self.supervisor_now();
        self.supervisor.handle_link_down(now, LinkPhase::Lost, why);
        self.settle();
    }

    /// Puts the cable back.
    pub fn plug(&mut self) {
        self.plugged = true;
        // What the arm said meanwhile nobody heard.
        self.arm.poll_bytes(&mut Vec::new());
        self.arm.handle_open(self.now);
        let now = self.supervisor_now();
        self.supervisor.handle_link_up(now, "virtual:");
        self.settle();
    }

    /// The station is killed in this very moment, and started again after a while; the arm goes on.
    ///
    /// # Errors
    ///
    /// [`Refusal`] where the interrupted job cannot be read again.
    pub fn crash(&mut self, away: Duration) -> Result<(), Refusal> {
        self.disk.clear();
        self.now += away;
        self.arm.handle_time(self.now);
        let dialect = Some(self.power_up.personality.dialect());
        self.supervisor = Supervisor::new(self.policy.clone(), dialect);
        self.started = self.now;
        let (own, fleet) = self.stops.clone();
        self.supervisor
            .handle_kept_stops(Duration::ZERO, own, fleet);
        self.recover()?;
        self.plug();
        Ok(())
    }

    /// The station does nothing more, and its watchdog sends these packets, each a gap after the one before: for a
    /// station that is then killed by [`VirtualStation::crash`].
    pub fn guard(&mut self, packets: &[Packet]) {
        for packet in packets {
            self.now += GAP;
            self.arm.handle_time(self.now);
            let packet = packet.to_bytes();
            self.packets.push((self.now, packet));
            self.arm.handle_bytes(self.now, &packet);
        }
    }

    /// The pose is not to be trusted until a person confirms it, as when the port of a real arm is opened.
    pub fn distrust(&mut self, reason: &str) {
        self.supervisor.distrust(reason);
    }

    /// A client that may do everything.
    pub fn client(&mut self, name: &str) -> ClientId {
        self.client_as(name, Role::Admin)
    }

    /// A client of a role.
    pub fn client_as(&mut self, name: &str, role: Role) -> ClientId {
        self.client_of(name, role, name)
    }

    /// A client of a role whom time slots know by the name of a person.
    pub fn client_of(&mut self, name: &str, role: Role, person: &str) -> ClientId {
        let now = self.supervisor_now();
        self.supervisor.handle_client(now, name, role, person)
    }

    /// Puts another policy in place of the one that holds.
    ///
    /// # Errors
    ///
    /// [`Refusal`]; the old one holds on then.
    pub fn set_policy(&mut self, client: ClientId, policy: Policy) -> Result<(), Refusal> {
        let now = self.supervisor_now();
        self.supervisor.handle_policy(now, client, policy.clone())?;
        self.policy = policy;
        self.settle();
        Ok(())
    }

    /// A client leaves, or is lost.
    pub fn leave(&mut self, client: ClientId) {
        let now = self.supervisor_now();
        self.supervisor.handle_left(now, client);
        self.settle();
    }

    /// A client asks for something; what takes its time is waited for.
    ///
    /// # Errors
    ///
    /// [`Refusal`].
    pub fn ask(&mut self, client: ClientId, request: Request) -> Result<Reply, Refusal> {
        let now = self.supervisor_now();
        if self.supervisor.check_request(client, &request).is_ok() {
            if matches!(
                request,
                Request::StartJob { .. }
                    | Request::StepJob { .. }
                    | Request::CancelJob { .. }
                    | Request::MoveJob { .. }
                    | Request::ForgetJob { .. }
            ) {
                self.catch_up();
            }
            match request {
                Request::SubmitJob { job, key } => {
                    let job = self.submit_as(&job, key)?;
                    return self.kept(job);
                }
                // The virtual arm stays as it is: its faults say what it is like.
                Request::Calibrate { calibration } => {
                    let calibrations = self.calibrations.clone();
                    let calibrations = calibrations.replaced_by(calibration.map(|it| *it));
                    self.supervisor
                        .handle_calibration(now, client, &calibrations)?;
                    self.calibrations = calibrations.clone();
                    self.settle();
                    return Ok(Reply::Calibrated {
                        calibrations: Box::new(calibrations),
                    });
                }
                Request::QueueAgain { job, key } => {
                    let model = self.supervisor.planning_model()?;
                    let job = self.submit_as(&jobs::again(&self.journal, job, &model)?, key)?;
                    return self.kept(job);
                }
                Request::MoveJob { job, before } => {
                    jobs::move_before(&self.journal, job, before)?;
                    return self.kept(job);
                }
                Request::ForgetJob { job } if !self.is_at(job) => {
                    return jobs::forget(&self.journal, job).map(|()| Reply::Done);
                }
                Request::StartJob { job } => return self.start_with(client, job, false),
                Request::StepJob { job } => return self.start_with(client, job, true),
                Request::CancelJob { job } if !self.is_at(job) => {
                    jobs::end_waiting(&self.journal, job, &self.supervisor.client_name(client))?;
                    return self.kept(job);
                }
                _ => {}
            }
        }
        let answer = self.supervisor.handle_request(now, client, request);
        self.settle();
        answer.unwrap_or(Ok(Reply::Done))
    }

    /// Somebody stops the whole fleet at this station, which goes by the number `origin`. The others are to be told of the
    /// stop that is returned.
    pub fn stop_fleet(&mut self, origin: &str, by: StoppedBy) -> FleetWideStop {
        let now = self.supervisor_now();
        let now_ms = u64::try_from(self.now.as_millis()).unwrap_or_default();
        let (stop, _) = self.supervisor.handle_fleet_stop(now, origin, by, now_ms);
        self.settle();
        stop
    }

    /// Another station tells which stops of the fleet it knows of; gives those that are known here then.
    pub fn adopt_fleet_stops(&mut self, stops: &[FleetWideStop]) -> Vec<FleetWideStop> {
        let now = self.supervisor_now();
        self.supervisor.handle_fleet_stops(now, stops);
        self.settle();
        self.supervisor.state().fleet_stops
    }

    /// Somebody lets the whole fleet move again. The others are to be told of the stops that are returned.
    pub fn reset_fleet(&mut self, by: &str) -> Vec<FleetWideStop> {
        let now = self.supervisor_now();
        let stops = self.supervisor.handle_fleet_reset(now, by);
        self.settle();
        stops
    }

    /// A program that speaks the arm's own protocol sends a packet.
    ///
    /// # Errors
    ///
    /// [`Refusal`].
    pub fn send_raw(&mut self, client: ClientId, packet: &Packet) -> Result<(), Refusal> {
        let now = self.supervisor_now();
        let taken = self.supervisor.handle_raw(now, client, packet);
        self.settle();
        taken
    }

    /// Puts a job into the journal.
    ///
    /// # Errors
    ///
    /// [`Refusal`].
    pub fn submit(&mut self, job: &NewJob) -> Result<u64, Refusal> {
        self.submit_as(job, None)
    }

    /// Another station offers a job under a key, or asks what has become of its offer.
    ///
    /// # Errors
    ///
    /// [`Refusal`] where the journal cannot be written; nothing is answered then.
    pub fn offer(&mut self, key: &str, ask: OfferAsk) -> Result<OfferAnswer, Refusal> {
        self.catch_up();
        let model = self.supervisor.planning_model();
        jobs::answer(&self.journal, &self.policy, key, ask, model, 0)
    }

    fn submit_as(&self, job: &NewJob, key: Option<String>) -> Result<u64, Refusal> {
        let model = self.supervisor.planning_model()?;
        let id = jobs::submit(&self.journal, &self.policy, job.clone(), key, model, 0)?;
        Ok(id.0)
    }

    /// Starts a job, or goes on with it; a person has done what it waits for.
    ///
    /// # Errors
    ///
    /// [`Refusal`].
    pub fn start(&mut self, client: ClientId, job: u64) -> Result<Reply, Refusal> {
        let waits = self
            .jobs()?
            .iter()
            .any(|it| it.job == job && it.waits_for_person);
        if waits {
            self.ask(client, Request::ConfirmJob { job })?;
        }
        self.start_with(client, job, false)
    }

    fn start_with(
        &mut self,
        client: ClientId,
        job: u64,
        single_step: bool,
    ) -> Result<Reply, Refusal> {
        self.supervisor.check_rests(job)?;
        let model = self.supervisor.planning_model()?;
        let started = jobs::startable(&self.journal, &self.policy, job, model)?;
        let started = StartedJob {
            single_step,
            ..started
        };
        let now = self.supervisor_now();
        let reply = self.supervisor.handle_start(now, client, started);
        self.settle();
        reply
    }

    /// All jobs: the oldest first, unless queued ones were moved.
    ///
    /// # Errors
    ///
    /// [`Refusal`] where the journal cannot be read.
    pub fn jobs(&mut self) -> Result<Vec<JobView>, Refusal> {
        self.catch_up();
        jobs::list(&self.journal, self.supervisor.job().as_ref())
    }

    /// Lets the laser burn without having been armed: that of a virtual arm harms nobody.
    pub fn free_laser(&mut self) {
        self.supervisor.free_laser();
    }

    /// Whether the arm has told anything since this was asked last.
    pub fn poll_status(&mut self) -> bool {
        std::iter::from_fn(|| self.supervisor.poll_status()).count() > 0
    }

    /// What became of a job, by the journal.
    ///
    /// # Errors
    ///
    /// [`JournalError`].
    pub fn job(&self, job: u64) -> Result<dobot_journal::Job, JournalError> {
        self.journal.job(JobId(job))
    }

    /// The way of a job, once through its commands, as it was planned.
    ///
    /// # Errors
    ///
    /// [`Refusal::NoSuchJob`].
    pub fn job_path(&self, job: u64) -> Result<JobPath, Refusal> {
        path_of(&self.journal, job)
    }

    /// How the arm differs from the drawing of it, as far as somebody has said so.
    #[must_use]
    pub const fn calibrations(&self) -> &Calibrations {
        &self.calibrations
    }

    /// The supervisor, to look at.
    #[must_use]
    pub const fn supervisor(&self) -> &Supervisor {
        &self.supervisor
    }

    /// The arm, to look at.
    #[must_use]
    pub const fn arm(&self) -> &VirtualArm {
        &self.arm
    }

    /// The station stands still for a while; the arm goes on, and what it says waits.
    pub fn stall(&mut self, silent: Duration) {
        self.now += silent;
        self.arm.handle_time(self.now);
        let now = self.supervisor_now();
        self.supervisor.handle_stall(now, silent);
        self.settle();
    }

    /// A watchdog watches over the arm again, or why none does.
    pub fn set_watchdog(&mut self, gone: Option<&str>) {
        let now = self.supervisor_now();
        self.supervisor
            .handle_watchdog(now, gone.map(str::to_owned));
        self.settle();
    }

    /// The station is killed, and nobody starts it again: what is left is the arm.
    #[must_use]
    pub fn into_arm(self) -> VirtualArm {
        self.arm
    }

    /// The arm, to do something to it.
    pub const fn arm_mut(&mut self) -> &mut VirtualArm {
        &mut self.arm
    }

    /// The time since the arm was switched on.
    #[must_use]
    pub const fn now(&self) -> Duration {
        self.now
    }

    /// What all watchers were told.
    #[must_use]
    pub fn notices(&self) -> &[Notice] {
        &self.notices
    }

    /// Every packet that was put on the wire, and when.
    #[must_use]
    pub fn packets(&self) -> &[(Duration, [u8; 42])] {
        &self.packets
    }

    /// A port that is gone by itself is opened again as soon as it is back.
    fn follow_port(&mut self) {
        if self.plugged && !self.arm.has_port() {
            self.port_gone = true;
            self.unplug();
        } else if self.port_gone && self.arm.has_port() {
            self.port_gone = false;
            self.plug();
        }
    }

    /// Waits until the journal knows what the supervisor has told: that a job is paused, say.
    fn catch_up(&mut self) {
        let latest = self.now + PATIENCE;
        self.run_until(latest, |it| it.disk.is_empty());
    }

    /// Whether the arm is at this job.
    fn is_at(&self, job: u64) -> bool {
        self.supervisor.job().is_some_and(|it| it.job == job)
    }

    fn kept(&self, job: u64) -> Result<Reply, Refusal> {
        let job = jobs::find(&self.journal, job)?;
        let job = jobs::view(&job);
        Ok(Reply::Job { job })
    }

    fn supervisor_now(&self) -> Duration {
        self.now.saturating_sub(self.started)
    }

    fn recover(&mut self) -> Result<(), Refusal> {
        let jobs = self
            .journal
            .jobs()
            .map_err(|error| jobs::journal_refusal(&error))?;
        let Some(job) = jobs.into_iter().find(|it| it.state == JobState::Running) else {
            return Ok(());
        };
        let model = jobs::recovery_model(&job);
        let started = self.started_job(job.id.0, model)?;
        let now = self.supervisor_now();
        self.supervisor.handle_recovered(now, started, job.window);
        Ok(())
    }

    fn started_job(&self, job: u64, model: dobot_motion::Model) -> Result<StartedJob, Refusal> {
        let job = self
            .journal
            .job(JobId(job))
            .map_err(|error| jobs::journal_refusal(&error))?;
        jobs::look_again(&self.journal, &self.policy, &job, model)
    }

    /// Carries bytes and writes to the disk until nobody wants anything more in this moment.
    fn settle(&mut self) {
        if self.now < self.looks {
            return;
        }
        self.looks = self.now + self.looks_every;
        let mut bytes = Vec::new();
        self.arm.poll_bytes(&mut bytes);
        let now = self.supervisor_now();
        if self.plugged && !bytes.is_empty() {
            self.supervisor.handle_bytes(now, &bytes);
        }
        self.supervisor.handle_time(now);
        self.write();
        while let Some(packet) = self.supervisor.poll_bytes() {
            if self.plugged {
                let packet = packet.to_bytes();
                self.packets.push((self.now, packet));
                self.arm.handle_bytes(self.now, &packet);
            }
        }
        while let Some(effect) = self.supervisor.poll_effect() {
            self.disk.push((self.now + self.disk_takes, effect));
        }
        if let Some(stops) = self.supervisor.poll_kept_stops() {
            self.stops = stops;
        }
        while let Some(notice) = self.supervisor.poll_notice() {
            self.notices.push(notice);
        }
    }

    fn write(&mut self) {
        let now = self.supervisor_now();
        while self.disk.first().is_some_and(|it| it.0 <= self.now) {
            let (_, effect) = self.disk.remove(0);
            let outcome = jobs::write(&self.journal, &effect).map_err(|error| error.to_string());
            self.supervisor.handle_written(now, &effect, outcome);
        }
    }
}

/// A disk that takes longer has failed.
const PATIENCE: Duration = Duration::from_secs(10);
