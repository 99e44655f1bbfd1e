//! A supervisor and a virtual arm in virtual time.

use std::time::Duration;

use dobot_api::JobState;
use dobot_api::{
    Answer, Calibrations, ClientId, FleetWideStop, JobPath, JobView, LinkCause, LinkPhase,
    LinkProblem, NewJob, Notice, Reply, Request, Role,
};
use dobot_controller::{Controller, PowerUp};
use dobot_journal::{JobId, Journal, JournalError};
use dobot_safety::Policy;
use dobot_sim::{SerialLine, VirtualArm};
use dobot_supervisor::{Effect, Refusal, SavedFleetStop, StartedJob, StoppedBy, Supervisor};
use dobot_wire::Packet;

use crate::job_path::path_of;
use crate::jobs::{self, GivenAnswer};
use crate::watchdog::GAP;
use crate::{OfferAnswer, OfferRequest, Rules};

/// A supervisor and a virtual arm in virtual time, with a real journal: for tests of everything
/// that can go wrong, thousands of times faster than real time.
///
/// The arm continues whatever happens to the supervisor: [`VirtualStation::crash`] replaces the
/// supervisor at any moment, as after a SIGKILL.
#[derive(Debug)]
pub struct VirtualStation {
    supervisor: Supervisor,
    arm: VirtualArm,
    journal: Journal,
    policy: Policy,
    power_up: PowerUp,
    calibrations: Calibrations,
    plugged: bool,
    /// Whether the arm's port has disappeared by itself.
    port_gone: bool,
    now: Duration,
    /// When the current supervisor was started.
    started: Duration,
    /// When each requested write reaches the disk.
    disk: Vec<(Duration, Effect)>,
    /// The duration of a disk write.
    disk_takes: Duration,
    /// The interval at which the computer checks port and clock; 0 for always.
    looks_every: Duration,
    /// When it checks next.
    looks: Duration,
    notices: Vec<Notice>,
    packets: Vec<(Duration, [u8; 42])>,
    /// The saved stops: this arm's own and the fleet-wide ones.
    stops: (Option<StoppedBy>, Vec<SavedFleetStop>),
}

impl VirtualStation {
    /// Creates a station that was just started, with an arm that was just switched on.
    ///
    /// # Panics
    ///
    /// Never: an in-memory journal can always be created.
    #[must_use]
    pub fn new(power_up: PowerUp, policy: Policy) -> Self {
        let arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
        Self::with_arm(arm, power_up, policy)
    }

    /// Creates a station with the given arm, for example one with faults or in a world.
    ///
    /// # Panics
    ///
    /// Never: an in-memory journal can always be created.
    #[must_use]
    pub fn with_arm(arm: VirtualArm, power_up: PowerUp, policy: Policy) -> Self {
        let journal = Journal::in_memory().expect("there is memory");
        Self::with_journal(arm, power_up, policy, journal)
    }

    /// Creates a station with the given journal, for example on a disk that can be full.
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

    /// Simulates a busy computer that checks port and clock only at this interval: statuses arrive
    /// in batches, and everything due is late.
    pub const fn load(&mut self, looks_every: Duration) {
        self.looks_every = looks_every;
    }

    /// Lets time pass.
    pub fn run_for(&mut self, time: Duration) {
        self.run_until(self.now + time, |_| false);
    }

    /// Lets time pass until a condition holds, or until `latest`; returns whether it holds.
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

    /// Advances by one step, at most to `latest`.
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
        let disk = self.disk.first().map_or(Duration::MAX, |disk| disk.0);
        let soon = self.now + Duration::from_nanos(1);
        self.arm.poll_wakeup().min(supervisor).min(disk).max(soon)
    }

    /// Unplugs the cable.
    pub fn unplug(&mut self) {
        self.plugged = false;
        let problem = LinkProblem {
            cause: LinkCause::Broken,
            text: "the cable was pulled".to_owned(),
            remedy: None,
        };
        let now = self.supervisor_now();
        self.supervisor
            .handle_link_down(now, LinkPhase::Lost, problem);
        self.settle();
    }

    /// Plugs the cable in.
    pub fn plug(&mut self) {
        self.plugged = true;
        // What the arm sent meanwhile is lost.
        self.arm.poll_bytes(&mut Vec::new());
        self.arm.handle_open(self.now);
        let now = self.supervisor_now();
        self.supervisor.handle_link_up(now, "virtual:");
        self.settle();
    }

    /// Kills the station at this moment and restarts it after a while; the arm continues.
    ///
    /// # Errors
    ///
    /// [`Refusal`] if the interrupted job cannot be read again.
    pub fn crash(&mut self, away: Duration) -> Result<(), Refusal> {
        self.disk.clear();
        self.now += away;
        self.arm.handle_time(self.now);
        let dialect = Some(self.power_up.personality.dialect());
        self.supervisor = Supervisor::new(self.policy.clone(), dialect);
        self.started = self.now;
        let (own, fleet) = self.stops.clone();
        self.supervisor
            .handle_saved_stops(Duration::ZERO, own, fleet);
        self.recover()?;
        self.plug();
        Ok(())
    }

    /// Freezes the station while its watchdog sends these packets with gaps: for a station that is
    /// then killed by [`VirtualStation::crash`].
    pub fn guard(&mut self, packets: &[Packet]) {
        for packet in packets {
            self.now += GAP;
            self.arm.handle_time(self.now);
            let packet = packet.to_bytes();
            self.packets.push((self.now, packet));
            self.arm.handle_bytes(self.now, &packet);
        }
    }

    /// Marks the pose as not trusted until a person confirms it, as when the port of a real arm is
    /// opened.
    pub fn distrust(&mut self, reason: &str) {
        self.supervisor.distrust(reason);
    }

    /// Connects a client with the highest role.
    pub fn client(&mut self, name: &str) -> ClientId {
        self.client_as(name, Role::Admin)
    }

    /// Connects a client with a role.
    pub fn client_as(&mut self, name: &str, role: Role) -> ClientId {
        self.client_of(name, role, name)
    }

    /// Connects a client with a role and a person for time slots.
    pub fn client_of(&mut self, name: &str, role: Role, person: &str) -> ClientId {
        let now = self.supervisor_now();
        self.supervisor.handle_client(now, name, role, person)
    }

    /// Replaces the policy.
    ///
    /// # Errors
    ///
    /// [`Refusal`]; the old policy stays.
    pub fn set_policy(&mut self, client: ClientId, policy: Policy) -> Result<(), Refusal> {
        let now = self.supervisor_now();
        self.supervisor.handle_policy(now, client, policy.clone())?;
        self.policy = policy;
        self.settle();
        Ok(())
    }

    /// Disconnects a client.
    pub fn leave(&mut self, client: ClientId) {
        let now = self.supervisor_now();
        self.supervisor.handle_left(now, client);
        self.settle();
    }

    /// Handles a client's request, waiting for a delayed answer.
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
                    | Request::AnswerJob { .. }
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
                Request::MarkEpisode { .. } => {
                    let why = "this arm has no station".to_owned();
                    return Err(Refusal::NotRecorded(why));
                }
                // The virtual arm does not change: its faults define its geometry.
                Request::Calibrate { calibration } => {
                    let calibrations = self.calibrations.clone();
                    let calibrations =
                        calibrations.replaced_by(calibration.map(|calibration| *calibration));
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
                Request::AnswerJob {
                    job,
                    question,
                    answer,
                } => return self.answer(job, question, answer),
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

    /// Stops the whole fleet from this station, which has the id `origin`. Returns the stop to send
    /// to the other stations.
    pub fn stop_fleet(&mut self, origin: &str, by: StoppedBy) -> FleetWideStop {
        let now = self.supervisor_now();
        let now_ms = u64::try_from(self.now.as_millis()).unwrap_or_default();
        let (stop, _) = self.supervisor.handle_fleet_stop(now, origin, by, now_ms);
        self.settle();
        stop
    }

    /// Adopts the stops known to another station; returns those known here.
    pub fn adopt_fleet_stops(&mut self, stops: &[FleetWideStop]) -> Vec<FleetWideStop> {
        let now = self.supervisor_now();
        self.supervisor.handle_fleet_stops(now, stops);
        self.settle();
        self.supervisor.state().fleet_stops
    }

    /// Resets all fleet-wide stops. Returns the stops to send to the other stations.
    pub fn reset_fleet(&mut self, by: &str) -> Vec<FleetWideStop> {
        let now = self.supervisor_now();
        let stops = self.supervisor.handle_fleet_reset(now, by);
        self.settle();
        stops
    }

    /// Handles a packet of a raw program.
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

    /// Queues a job in the journal.
    ///
    /// # Errors
    ///
    /// [`Refusal`].
    pub fn submit(&mut self, job: &NewJob) -> Result<u64, Refusal> {
        self.submit_as(job, None)
    }

    /// Handles another station's request about a job offer.
    ///
    /// # Errors
    ///
    /// [`Refusal`] if the journal cannot be written; then there is no answer.
    pub fn offer(&mut self, key: &str, ask: OfferRequest) -> Result<OfferAnswer, Refusal> {
        self.catch_up();
        let model = self.supervisor.planning_model();
        jobs::answer(&self.journal, &self.policy, key, ask, model, 0)
    }

    fn submit_as(&self, job: &NewJob, key: Option<String>) -> Result<u64, Refusal> {
        let model = self.supervisor.planning_model()?;
        let id = jobs::submit(&self.journal, &self.policy, job.clone(), key, model, 0)?;
        Ok(id.0)
    }

    /// Starts or resumes a job, confirming its pause.
    ///
    /// # Errors
    ///
    /// [`Refusal`].
    pub fn start(&mut self, client: ClientId, job: u64) -> Result<Reply, Refusal> {
        let waits = self
            .jobs()?
            .iter()
            .any(|view| view.job == job && view.waits_for_person);
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

    fn answer(
        &mut self,
        job: u64,
        question: Option<u64>,
        answer: Answer,
    ) -> Result<Reply, Refusal> {
        let given = GivenAnswer {
            job,
            before: self.supervisor.answers_of(job, question)?,
            answer,
        };
        let model = self.supervisor.planning_model()?;
        let longer = jobs::extended(&self.journal, &self.policy, given, model)?;
        let now = self.supervisor_now();
        let reply = self.supervisor.handle_answered(now, longer);
        self.settle();
        reply
    }

    /// Gives the answer that is due without a person.
    fn give_due_answer(&mut self) {
        let Some((job, answer)) = self.supervisor.poll_due_answer() else {
            return;
        };
        if let Err(refusal) = self.answer(job, None, answer) {
            let now = self.supervisor_now();
            self.supervisor.handle_bad_answer(now, &refusal);
        }
    }

    /// Returns all jobs: oldest first, unless queued ones were moved.
    ///
    /// # Errors
    ///
    /// [`Refusal`] if the journal cannot be read.
    pub fn jobs(&mut self) -> Result<Vec<JobView>, Refusal> {
        self.catch_up();
        jobs::list(&self.journal, self.supervisor.job().as_ref())
    }

    /// Lets the laser burn without being armed; for virtual arms only.
    pub fn free_laser(&mut self) {
        self.supervisor.free_laser();
    }

    /// Returns whether the arm has sent a status since the last call.
    pub fn poll_status(&mut self) -> bool {
        std::iter::from_fn(|| self.supervisor.poll_status()).count() > 0
    }

    /// Returns a job from the journal.
    ///
    /// # Errors
    ///
    /// [`JournalError`].
    pub fn job(&self, job: u64) -> Result<dobot_journal::Job, JournalError> {
        self.journal.job(JobId(job))
    }

    /// Returns the planned path of a job, once through its commands.
    ///
    /// # Errors
    ///
    /// [`Refusal::NoSuchJob`].
    pub fn job_path(&self, job: u64) -> Result<JobPath, Refusal> {
        path_of(&self.journal, job)
    }

    /// Returns the calibrations.
    #[must_use]
    pub const fn calibrations(&self) -> &Calibrations {
        &self.calibrations
    }

    /// Returns the rules in force.
    #[must_use]
    pub fn rules(&self) -> Rules {
        Rules::with_calibrations(&self.policy, self.calibrations.clone())
    }

    /// Returns the supervisor.
    #[must_use]
    pub const fn supervisor(&self) -> &Supervisor {
        &self.supervisor
    }

    /// Returns the arm.
    #[must_use]
    pub const fn arm(&self) -> &VirtualArm {
        &self.arm
    }

    /// Stalls the station for a while; the arm continues, and its bytes wait.
    pub fn stall(&mut self, silent: Duration) {
        self.now += silent;
        self.arm.handle_time(self.now);
        let now = self.supervisor_now();
        self.supervisor.handle_stall(now, silent);
        self.settle();
    }

    /// Sets whether a watchdog guards the arm, or why none does.
    pub fn set_watchdog(&mut self, gone: Option<&str>) {
        let now = self.supervisor_now();
        self.supervisor
            .handle_watchdog(now, gone.map(str::to_owned));
        self.settle();
    }

    /// Kills the station for good and returns the arm.
    #[must_use]
    pub fn into_arm(self) -> VirtualArm {
        self.arm
    }

    /// Returns the arm mutably.
    pub const fn arm_mut(&mut self) -> &mut VirtualArm {
        &mut self.arm
    }

    /// Returns the time since the arm was switched on.
    #[must_use]
    pub const fn now(&self) -> Duration {
        self.now
    }

    /// Returns all notices published.
    #[must_use]
    pub fn notices(&self) -> &[Notice] {
        &self.notices
    }

    /// Returns every packet put on the wire, with its time.
    #[must_use]
    pub fn packets(&self) -> &[(Duration, [u8; 42])] {
        &self.packets
    }

    /// Opens a port that had disappeared as soon as it is back.
    fn follow_port(&mut self) {
        if self.plugged && !self.arm.has_port() {
            self.port_gone = true;
            self.unplug();
        } else if self.port_gone && self.arm.has_port() {
            self.port_gone = false;
            self.plug();
        }
    }

    /// Waits until the journal has all earlier effects, such as a pause.
    fn catch_up(&mut self) {
        let latest = self.now + PATIENCE;
        self.run_until(latest, |station| station.disk.is_empty());
    }

    /// Returns whether this is the current job.
    fn is_at(&self, job: u64) -> bool {
        self.supervisor.job().is_some_and(|view| view.job == job)
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
        let Some(job) = jobs.into_iter().find(|job| job.state == JobState::Running) else {
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
        jobs::check_again(&self.journal, &self.policy, &job, model)
    }

    /// Transfers bytes and completes writes until nothing is left to do at this moment.
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
        self.give_due_answer();
        self.write();
        self.take_outputs();
    }

    fn take_outputs(&mut self) {
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
        if let Some(stops) = self.supervisor.poll_saved_stops() {
            self.stops = stops;
        }
        while let Some(notice) = self.supervisor.poll_notice() {
            self.notices.push(notice);
        }
    }

    fn write(&mut self) {
        let now = self.supervisor_now();
        while self.disk.first().is_some_and(|disk| disk.0 <= self.now) {
            let (_, effect) = self.disk.remove(0);
            let outcome = jobs::write(&self.journal, &effect).map_err(|error| error.to_string());
            self.supervisor.handle_written(now, &effect, outcome);
        }
    }
}

/// A disk that takes longer has failed.
const PATIENCE: Duration = Duration::from_secs(10);
