//! The supervisor of the arm: all rules for people and arm, as an engine.

mod amend;
mod arm;
mod button;
mod commands;
mod detecting;
mod events;
mod fleet_stops;
mod job;
mod jog;
mod journal_requests;
mod laser;
mod lease;
mod link;
mod near;
mod outgoing_events;
mod plan;
mod request;
mod run;
mod senses;
mod slots;
mod stop_latch;
mod stop_sequence;
mod urgent;

use std::time::Duration;

use dobot_api::{
    ArmView, Calibrations, ClientId, News, Notice, QueueView, Reply, State, TimeSlot, TrustView,
};
use dobot_arm::Calibration;
use dobot_motion::{ArmPlace, LASER_OFF, Model};
use dobot_safety::Policy;
use dobot_session::{SendError, Session};
use dobot_wire::{Dialect, Finding, Packet, Status};

use self::arm::Arm;
use self::commands::Commands;
use self::detecting::Detecting;
use self::jog::Jogging;
use self::journal_requests::JournalRequests;
use self::lease::Leases;
use self::link::Link;
use self::outgoing_events::OutgoingEvents;
use self::run::{JobEffect, Run};
use self::stop_latch::StopLatch;
use self::stop_sequence::StopSequence;
use crate::refusal::Refusal;

pub use self::fleet_stops::SavedFleetStop;
pub use self::job::FORGETTABLE;
pub use self::link::cause_of_silence;
pub use self::plan::{JobPlan, draws_below_mm};
pub use self::run::{Effect, StartedJob};
pub use self::stop_latch::StoppedBy;

/// The supervisor of the arm, as an engine: it owns no port, file or clock.
///
/// Events go in (`handle_*`), outputs come out (`poll_*`). Its time counts from the start of the
/// station and never decreases. Every byte to the arm passes here and is subject to every rule:
/// control, the policy, stops, and a laser that stays off unless a person has armed it.
///
/// Each rule is a component with private state. The supervisor coordinates them: it passes facts
/// from one to another and carries out their effects.
#[derive(Debug)]
pub struct Supervisor {
    /// The clients and the lease.
    leases: Leases,
    link: Link,
    arm: Arm,
    stop_latch: StopLatch,
    stop_sequence: StopSequence,
    jogging: Jogging,
    commands: Commands,
    detecting: Detecting,
    run: Option<Run>,
    /// The job whose pause a person has confirmed.
    confirmed_job: Option<u64>,
    /// Why no watchdog would stop the arm if the station were killed.
    unguarded: Option<String>,
    /// What is missing of the stored jobs.
    jobs_missing: Option<String>,
    journal_requests: JournalRequests,
    outgoing: OutgoingEvents,
}

impl Supervisor {
    /// Creates a supervisor without an arm. It trusts the pose of a real arm only after a person
    /// has confirmed it, and that of a virtual arm from the start.
    #[must_use]
    pub fn new(policy: Policy, dialect: Option<Dialect>) -> Self {
        Self {
            leases: Leases::new(),
            link: Link::default(),
            arm: Arm::new(policy, dialect),
            stop_latch: StopLatch::default(),
            stop_sequence: StopSequence::default(),
            jogging: Jogging::default(),
            commands: Commands::default(),
            detecting: Detecting::default(),
            run: None,
            confirmed_job: None,
            unguarded: None,
            jobs_missing: None,
            journal_requests: JournalRequests::default(),
            outgoing: OutgoingEvents::new(),
        }
    }

    /// Handles a fault of the station, described in one line.
    pub fn handle_trouble(&mut self, now: Duration, text: String) {
        self.handle_time(now);
        self.notify(News::Trouble, text);
    }

    /// Handles a change of the buttons on the page, described in one line.
    pub fn handle_buttons_changed(&mut self, now: Duration, text: String) {
        self.handle_time(now);
        self.notify(News::ButtonsChanged, text);
    }

    /// Handles missing stored jobs, described in one line; reported now and in each state.
    pub fn handle_jobs_missing(&mut self, now: Duration, text: String) {
        self.handle_trouble(now, text.clone());
        self.jobs_missing = Some(text);
    }

    /// Lets the laser burn without being armed; for virtual arms only.
    pub fn free_laser(&mut self) {
        self.arm.session_mut().free_laser();
    }

    /// Marks the pose as not trusted until a person confirms it.
    pub fn distrust(&mut self, reason: &str) {
        self.arm.session_mut().distrust(reason);
        self.outgoing.note_change();
    }

    /// Returns the arm's dialect, if known.
    #[must_use]
    pub fn dialect(&self) -> Option<Dialect> {
        self.arm.session().dialect().copied()
    }

    /// Returns how the dialect was detected, if it was.
    #[must_use]
    pub const fn finding(&self) -> Option<&Finding> {
        self.detecting.finding()
    }

    /// Sets the arm's known dialect, unless one has been set already.
    pub fn handle_known_dialect(&mut self, dialect: Dialect) {
        if self.arm.session().dialect().is_none() {
            self.arm.session_mut().set_dialect(dialect);
            self.outgoing.note_change();
        }
    }

    /// Sets the known calibration of the arm at an address, before any command. Another arm may
    /// have been plugged in there, so a notice names the arm that is assumed.
    pub fn handle_known_calibration(&mut self, address: &str, known: &Calibrations) {
        self.arm.set_calibration(known.arm());
        self.outgoing.note_change();
        if known.calibration.is_some() {
            let name = known.name().unwrap_or("the arm that was calibrated there");
            let text = format!(
                "the arm at {address} is assumed to be {name}; if it is a different one, use its own calibration: `dobot calibrate ARM.toml --use`"
            );
            self.notify(News::Calibrated, text);
        }
    }

    /// Returns the current calibration: its zeros are 0 once the arm was given its true angles.
    #[must_use]
    pub fn calibration(&self) -> Calibration {
        self.arm.calibration()
    }

    /// Advances the time.
    pub fn handle_time(&mut self, now: Duration) {
        // The arm first: all other components depend on what it has reported.
        self.arm.handle_time(now);
        self.follow_session();
        // A client whose time slot is over must not move the arm, even with waiting commands.
        self.watch_slots();
        // Check for a silent client before its waiting press, so that no arm moves for it.
        self.watch_dead_man();
        self.watch_press();
        // After both, because the one starts a stop sequence and the other ends one.
        let (is_linked, unknown) = (self.link.is_there(), self.unknown_motion());
        self.stop_sequence.repeat(&mut self.arm, is_linked, unknown);
        self.journal_requests.handle_time(self.arm.now());
        self.watch_delivery();
        // The job last: none of its commands is sent before everything that may prevent it is
        // known.
        self.feed();
    }

    /// Handles a status: every component sees it, in this order. None of them sends a command of a
    /// job; that happens after all events.
    fn handle_status(&mut self, status: Status) {
        // The link first: the first packet to an arm that reappears switches the laser off,
        // whatever happened before (a crash, another program, an unplugged cable).
        if self.link.handle_status() {
            self.notify(News::LinkUp, "the arm is connected".into());
        }
        if self.link.take_pending_laser_off() {
            // The last packets may have been lost with the link.
            self.arm.send_urgent(LASER_OFF);
            self.stop_sequence.release_again(&self.arm);
            if self.stop_latch.handle_delivered() {
                self.notify(
                    News::Trouble,
                    "the link to the arm is back: the stop has been delivered".into(),
                );
            }
        }
        // From here on it is known where the arm is and whether it is at rest.
        self.outgoing.pass_on(status);
        self.arm.handle_status(status);
        // Release a button that leads to a forbidden position before anything else is decided, and
        // before the stop sequence, because the release starts one.
        if let Some((client, refusal)) = self.jogging.handle_status(&self.arm) {
            self.withdraw(refusal.clone());
            self.notify_refused(client, &refusal);
        }
        let rests = self.arm.is_at_rest();
        self.stop_sequence.handle_status(rests);
        // The stop before the job: report rest before its consequences for the job.
        if self.stop_latch.handle_status(rests) {
            self.notify(News::AtRest, "the arm is at rest".into());
            self.release_fleet_stop();
        }
        self.check_grip(&status);
        self.with_run(Run::handle_status);
        // The detection last: it sets the dialect, which a job using the arm would forbid.
        self.watch_detection(&status);
    }

    fn watch_detection(&mut self, status: &Status) {
        if let Some(packet) = self.detecting.handle_status(self.arm.now(), status) {
            self.arm.send_question(packet);
        }
        if let Some((client, found)) = self.detecting.poll_outcome() {
            let answer = found.and_then(|finding| {
                self.set_dialect(finding.dialect)
                    .map(|_| Reply::Found { finding })
            });
            self.outgoing.answer(client, answer);
        }
    }

    /// Supplies session and journal with the job's next commands.
    fn feed(&mut self) {
        let may_lift = !self.stop_latch.holds() && self.link.is_there();
        self.with_run(|run, arm| run.feed(arm, may_lift));
    }

    /// Runs an action on the current job, if any, and applies its effects.
    fn with_run<W: IntoIterator<Item = JobEffect>>(
        &mut self,
        act: impl FnOnce(&mut Run, &mut Arm) -> W,
    ) {
        if let Some(run) = &mut self.run {
            let effects = act(run, &mut self.arm);
            self.apply_effects(effects);
        }
    }

    fn apply_effects(&mut self, effects: impl IntoIterator<Item = JobEffect>) {
        for effect in effects {
            match effect {
                JobEffect::Write(effect) => self.journal_requests.ask(effect),
                JobEffect::WritePhase(effect) => self.journal_requests.keep_phase(effect),
                JobEffect::Notify(news, text) => self.notify(news, text),
                JobEffect::Drop => self.run = None,
                JobEffect::Resend => self.resend_lost(),
            }
            self.outgoing.note_change();
        }
    }

    /// Returns the current state.
    #[must_use]
    pub fn state(&self) -> State {
        State {
            at_s: self.arm.now().as_secs_f64(),
            link: self.link.view(&self.arm.session().link()),
            arm: self.arm.last().map(|reported| {
                let status = self.arm.calibrated_status(&reported);
                ArmView {
                    status,
                    raw: Some(reported).filter(|_| self.arm.is_calibrated()),
                    moving: !self.arm.is_at_rest(),
                    touch_refused: self.arm.touch_refused(),
                    near: self.arm.near(&ArmPlace::of_status(&status)),
                }
            }),
            calibrated: self.arm.calibrated_view(),
            dialect: self.arm.session().dialect().copied(),
            settings: self.arm.settings(),
            trust: TrustView {
                trusted: self.arm.session().is_trusted(),
                reason: self.arm.session().distrust_reason().map(str::to_owned),
            },
            queue: QueueView {
                waiting: self.arm.session().waiting(),
                under_way: self.arm.session().in_flight(),
                ahead_s: self.arm.session().ahead_s(),
            },
            lease: self.leases.view(),
            lock: self.leases.lock_view(),
            slots: self.leases.slots_view(),
            stop: self.stop_latch.view(),
            fleet_stops: self.stop_latch.fleet_stops(),
            laser: self.arm.laser_view(),
            job: self.job(),
            jobs_missing: self.jobs_missing.clone(),
            clients: self.leases.clients(),
        }
    }

    /// Returns the next notice for observers.
    pub fn poll_notice(&mut self) -> Option<Notice> {
        self.outgoing.poll_notice()
    }

    /// Returns the next status of the arm, as received.
    pub fn poll_status(&mut self) -> Option<Status> {
        self.outgoing.poll_status()
    }

    /// Returns the next answer to a request that took time.
    pub fn poll_answer(&mut self) -> Option<(ClientId, Result<Reply, Refusal>)> {
        self.outgoing.poll_answer()
    }

    /// Returns the next effect for the journal, in order.
    pub fn poll_effect(&mut self) -> Option<Effect> {
        self.journal_requests.poll_effect()
    }

    /// Returns whether something has changed since the last call.
    pub fn poll_changed(&mut self) -> bool {
        self.outgoing.poll_changed()
    }

    /// Returns the latest time at which to call [`Supervisor::handle_time`] next.
    #[must_use]
    pub fn poll_wakeup(&self) -> Duration {
        [
            Some(self.arm.session().poll_wakeup()).filter(|_| self.link.is_there()),
            self.jogging.times_out_at(),
            self.arm.session().laser_armed_until(),
            self.stop_sequence.next(),
            self.journal_requests.next(),
            self.stop_latch.wakeup(),
            self.leases.wakeup(),
            self.arm.line_wakeup(),
        ]
        .into_iter()
        .flatten()
        .min()
        .unwrap_or(Duration::MAX)
    }

    /// Returns the packet to send now, if any.
    pub fn poll_bytes(&mut self) -> Option<Packet> {
        self.arm.poll_bytes()
    }

    /// Returns whether an urgent packet waits for the line.
    #[must_use]
    pub fn is_urgent(&self) -> bool {
        self.arm.is_urgent()
    }

    /// Returns whether the arm has been seen at rest for a while after everything it was sent.
    #[must_use]
    pub fn is_at_rest(&self) -> bool {
        self.arm.is_at_rest()
    }

    /// Returns whether statuses may be passed on to a raw program, which treats each as a permit:
    /// not while its packets are still waiting here.
    #[must_use]
    pub fn permits_raw(&self) -> bool {
        self.arm.session().waiting() < RAW_WAITING
    }

    /// Returns the policy.
    #[must_use]
    pub const fn policy(&self) -> &Policy {
        self.arm.policy()
    }

    /// Returns the session with the arm.
    #[must_use]
    pub const fn session(&self) -> &Session {
        self.arm.session()
    }

    /// Returns the time until the arm is at rest if nothing more is sent and a held button is
    /// released now.
    fn rests_within(&self) -> Duration {
        self.arm.rests_within(self.unknown_motion())
    }

    /// Returns how long a motion unknown to the session may still take.
    fn unknown_motion(&self) -> Duration {
        let unseen = self.run.as_ref().map_or(0.0, Run::unseen_s);
        seconds(unseen).max(self.detecting.motion(self.arm.now()))
    }

    fn notify(&mut self, news: News, text: String) {
        self.outgoing.notify(self.arm.now(), news, text);
    }

    /// Returns the model for planning a job: the arm as it will be after everything it was given.
    ///
    /// # Errors
    ///
    /// [`Refusal::NoLink`] while no status has arrived, [`Refusal::Send`] while the dialect is
    /// unknown.
    pub fn planning_model(&self) -> Result<Model, Refusal> {
        if self.arm.session().dialect().is_none() {
            let field = "a job";
            return Err(Refusal::Send(SendError::Undecided { field }));
        }
        match self.arm.session().model() {
            Some(model) => Ok(*model),
            None => Err(Refusal::NoLink("the arm has not sent a status yet".into())),
        }
    }

    /// Returns the current and upcoming time slots.
    #[must_use]
    pub fn slots(&self) -> Vec<TimeSlot> {
        self.leases.slots(self.arm.now())
    }

    /// Restores the time slots of the previous station process.
    ///
    /// # Errors
    ///
    /// [`Refusal::BadSlots`]; then there are no slots.
    pub fn handle_saved_slots(&mut self, now: Duration, slots: &[TimeSlot]) -> Result<(), Refusal> {
        self.handle_time(now);
        self.leases.set_slots(self.arm.now(), slots)?;
        self.outgoing.note_change();
        self.watch_slots();
        Ok(())
    }

    /// Returns a client's name.
    #[must_use]
    pub fn client_name(&self, client: ClientId) -> String {
        self.leases.name(client)
    }
}

fn still_moving(within: Duration) -> Refusal {
    Refusal::StillMoving {
        within_s: within.as_secs_f64(),
    }
}

/// Converts a number of seconds that the policy has checked.
fn seconds(seconds: f64) -> Duration {
    Duration::try_from_secs_f64(seconds).unwrap_or_default()
}

/// A raw program gets no permit while this many of its packets wait.
const RAW_WAITING: usize = 2;
