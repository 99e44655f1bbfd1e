//! The supervisor of the arm: every rule for people and arm, as an engine.

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

pub use self::fleet_stops::KeptFleetStop;
pub use self::job::FORGETTABLE;
pub use self::plan::{JobPlan, draws_below_mm};
pub use self::run::{Effect, StartedJob};
pub use self::stop_latch::StoppedBy;

/// The supervisor of the arm, as an engine: it owns no port, no file and no clock.
///
/// Things happen to it (`handle_*`), it wants things (`poll_*`). Its time counts from the start of
/// the station and never goes back. Every byte that reaches the arm passes here, and with it every
/// rule: who has control, what the policy allows, that a stop holds, that the laser is off unless a
/// person has armed it.
///
/// Each rule is a part with a state of its own, which no other part sees. The supervisor orders them: it
/// asks one what another has to know, and does what they want of each other.
#[derive(Debug)]
pub struct Supervisor {
    /// Who is there, and who has control.
    leases: Leases,
    link: Link,
    arm: Arm,
    stop_latch: StopLatch,
    stop_sequence: StopSequence,
    jogging: Jogging,
    commands: Commands,
    detecting: Detecting,
    run: Option<Run>,
    /// The job for which a person has done what it waits for.
    confirmed_job: Option<u64>,
    /// Why nobody would stop the arm if the station were killed.
    unguarded: Option<String>,
    /// What is missing of the kept jobs.
    jobs_missing: Option<String>,
    journal_requests: JournalRequests,
    outgoing: OutgoingEvents,
}

impl Supervisor {
    /// A supervisor that has no arm yet. It trusts the pose of one whose port it has opened only when a
    /// person has confirmed it, that of a virtual one from the start.
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

    /// Takes that something of the station goes wrong, in one line.
    pub fn handle_trouble(&mut self, now: Duration, text: String) {
        self.handle_time(now);
        self.notify(News::Trouble, text);
    }

    /// Takes that kept jobs are missing, in one line: all who watch are told, now and with each state.
    pub fn handle_jobs_missing(&mut self, now: Duration, text: String) {
        self.handle_trouble(now, text.clone());
        self.jobs_missing = Some(text);
    }

    /// Lets the laser burn without having been armed: that of a virtual arm harms nobody.
    pub fn free_laser(&mut self) {
        self.arm.session_mut().free_laser();
    }

    /// The pose is not to be trusted until a person confirms it, and why.
    pub fn distrust(&mut self, reason: &str) {
        self.arm.session_mut().distrust(reason);
        self.outgoing.note_change();
    }

    /// The dialect that the arm speaks, if that is known.
    #[must_use]
    pub fn dialect(&self) -> Option<Dialect> {
        self.arm.session().dialect().copied()
    }

    /// How the dialect was found, if the arm was asked for it.
    #[must_use]
    pub const fn finding(&self) -> Option<&Finding> {
        self.detecting.finding()
    }

    /// Takes which dialect the arm is known to speak, unless somebody has said it already.
    pub fn handle_known_dialect(&mut self, dialect: Dialect) {
        if self.arm.session().dialect().is_none() {
            self.arm.session_mut().set_dialect(dialect);
            self.outgoing.note_change();
        }
    }

    /// Takes how the arm at an address differs from the drawing of it, before it is given anything. Another arm may have
    /// been plugged in there, so people are told which one it is taken to be.
    pub fn handle_known_calibration(&mut self, address: &str, known: &Calibrations) {
        self.arm.set_calibration(known.arm());
        self.outgoing.note_change();
        if known.calibration.is_some() {
            let name = known.name().unwrap_or("the arm that was calibrated there");
            let text = format!(
                "the arm at {address} is taken to be {name}; if it is another one, have its own calibration hold: `dobot calibrate ARM.toml --use`"
            );
            self.notify(News::Calibrated, text);
        }
    }

    /// How the arm differs from what it says now: its zeros are right once it was told its angles.
    #[must_use]
    pub fn calibration(&self) -> Calibration {
        self.arm.calibration()
    }

    /// Takes the passing of time.
    pub fn handle_time(&mut self, now: Duration) {
        // What the arm has told so far comes first: all others judge by it.
        self.arm.handle_time(now);
        self.follow_session();
        // Whose time is over moves the arm no more, whatever of his still waits.
        self.watch_slots();
        // A client that fell silent is heard before its press that waits: no arm moves for it any more.
        self.watch_dead_man();
        self.watch_press();
        // Behind both, for the one begins a halt, and the other ends one.
        let (is_linked, unknown) = (self.link.is_there(), self.unknown_motion());
        self.stop_sequence.repeat(&mut self.arm, is_linked, unknown);
        self.journal_requests.handle_time(self.arm.now());
        self.watch_delivery();
        // The job last: nothing of it is given before all that may hinder it was heard.
        self.feed();
    }

    /// Takes a status: each part sees it, in this order. None of them gives the arm a command of a job;
    /// that comes behind all events.
    fn handle_status(&mut self, status: Status) {
        // The link first: the first packet to an arm that is heard again switches the laser off.
        // Whatever was before: a crash, another program, a cable that was out.
        if self.link.handle_status() {
            self.notify(News::LinkUp, "the arm tells its state".into());
        }
        if self.link.take_pending_laser_off() {
            // What was said last may have got lost with the link.
            self.arm.send_urgent(LASER_OFF);
            self.stop_sequence.release_again(&self.arm);
            if self.stop_latch.handle_delivered() {
                self.notify(
                    News::Trouble,
                    "the stop is delivered now: the link to the arm is back".into(),
                );
            }
        }
        // From here on it is known where the arm is, and whether it rests.
        self.outgoing.pass_on(status);
        self.arm.handle_status(status);
        // A button that leads to where the arm may not be is let go of before anything else is decided,
        // and before the halt, for it begins one.
        if let Some((client, refusal)) = self.jogging.handle_status(&self.arm) {
            self.withdraw(refusal.clone());
            self.notify_refused(client, &refusal);
        }
        let rests = self.arm.is_at_rest();
        self.stop_sequence.handle_status(rests);
        // The stop before the job: that the arm rests is told before what it means for the job.
        if self.stop_latch.handle_status(rests) {
            self.notify(News::AtRest, "the arm is at rest".into());
            self.release_fleet_stop();
        }
        self.judge_grip(&status);
        self.with_run(Run::handle_status);
        // The detection last: it sets the dialect, which a job that has the arm would forbid.
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

    /// Keeps the session and the journal supplied with what the job needs next.
    fn feed(&mut self) {
        let may_lift = !self.stop_latch.holds() && self.link.is_there();
        self.with_run(|run, arm| run.feed(arm, may_lift));
    }

    /// Has the job do something, if there is one, and what it wants.
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
                JobEffect::Ask(effect) => self.journal_requests.ask(effect),
                JobEffect::Keep(effect) => self.journal_requests.keep_phase(effect),
                JobEffect::Notify(news, text) => self.notify(news, text),
                JobEffect::Forget => self.run = None,
                JobEffect::TryAgain => self.try_again(),
            }
            self.outgoing.note_change();
        }
    }

    /// All that is known now.
    #[must_use]
    pub fn state(&self) -> State {
        State {
            at_s: self.arm.now().as_secs_f64(),
            link: self.link.view(&self.arm.session().link()),
            arm: self.arm.last().map(|reported| {
                let status = self.arm.true_status(&reported);
                ArmView {
                    status,
                    told: Some(reported).filter(|_| self.arm.is_calibrated()),
                    moving: self.arm.still() == 0,
                    near: self.arm.near(&ArmPlace::of_status(&status)),
                }
            }),
            calibrated: self.arm.calibrated_view(),
            dialect: self.arm.session().dialect().copied(),
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

    /// The next thing that happened, for all who watch.
    pub fn poll_notice(&mut self) -> Option<Notice> {
        self.outgoing.poll_notice()
    }

    /// The next status of the arm, as it came.
    pub fn poll_status(&mut self) -> Option<Status> {
        self.outgoing.poll_status()
    }

    /// The answer to a request that took its time.
    pub fn poll_answer(&mut self) -> Option<(ClientId, Result<Reply, Refusal>)> {
        self.outgoing.poll_answer()
    }

    /// What the journal is to keep, in order.
    pub fn poll_effect(&mut self) -> Option<Effect> {
        self.journal_requests.poll_effect()
    }

    /// Whether something changed since this was asked last.
    pub fn poll_changed(&mut self) -> bool {
        self.outgoing.poll_changed()
    }

    /// When [`Supervisor::handle_time`] wants to be called next, at the latest.
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

    /// The packet to send now, if there is one.
    pub fn poll_bytes(&mut self) -> Option<Packet> {
        self.arm.poll_bytes()
    }

    /// Whether something urgent waits for the line.
    #[must_use]
    pub fn is_urgent(&self) -> bool {
        self.arm.is_urgent()
    }

    /// Whether the arm was seen at rest for a while, after all that it was sent.
    #[must_use]
    pub fn is_at_rest(&self) -> bool {
        self.arm.is_at_rest()
    }

    /// Whether the statuses may be passed on to a raw program, for which each one is a permit: not
    /// while what it sent already waits here.
    #[must_use]
    pub fn permits_raw(&self) -> bool {
        self.arm.session().waiting() < RAW_WAITING
    }

    /// The rules.
    #[must_use]
    pub const fn policy(&self) -> &Policy {
        self.arm.policy()
    }

    /// The conversation with the arm.
    #[must_use]
    pub const fn session(&self) -> &Session {
        self.arm.session()
    }

    /// By when the arm is at rest if nothing more is sent; a button that is held is let go now.
    fn rests_within(&self) -> Duration {
        self.arm.rests_within(self.unknown_motion())
    }

    /// How long the arm may be at what the session does not know of.
    fn unknown_motion(&self) -> Duration {
        let unseen = self.run.as_ref().map_or(0.0, Run::unseen_s);
        seconds(unseen).max(self.detecting.motion(self.arm.now()))
    }

    fn notify(&mut self, news: News, text: String) {
        self.outgoing.notify(self.arm.now(), news, text);
    }

    /// The model from which a job is planned: the arm as it will be after all that it was given.
    ///
    /// # Errors
    ///
    /// [`Refusal::NoLink`] while no arm has told anything, [`Refusal::Send`] while nobody knows its
    /// dialect.
    pub fn planning_model(&self) -> Result<Model, Refusal> {
        if self.arm.session().dialect().is_none() {
            let field = "a job";
            return Err(Refusal::Send(SendError::Undecided { field }));
        }
        match self.arm.session().model() {
            Some(model) => Ok(*model),
            None => Err(Refusal::NoLink(
                "no arm has told where it stands yet".into(),
            )),
        }
    }

    /// All time slots, from now on.
    #[must_use]
    pub fn slots(&self) -> Vec<TimeSlot> {
        self.leases.slots(self.arm.now())
    }

    /// Takes the time slots that the station before this one had.
    ///
    /// # Errors
    ///
    /// [`Refusal::BadSlots`]; there are none then.
    pub fn handle_kept_slots(&mut self, now: Duration, slots: &[TimeSlot]) -> Result<(), Refusal> {
        self.handle_time(now);
        self.leases.set_slots(self.arm.now(), slots)?;
        self.outgoing.note_change();
        self.watch_slots();
        Ok(())
    }

    /// What a client calls itself.
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

/// A number of seconds that the policy has checked.
fn seconds(seconds: f64) -> Duration {
    Duration::try_from_secs_f64(seconds).unwrap_or_default()
}

/// More of a raw program's packets do not wait here: it gets no permit.
const RAW_WAITING: usize = 2;
