//! The keeper of the arm: every rule for people and arm, as an engine.

mod amend;
mod arm;
mod commands;
mod detecting;
mod events;
mod halt;
mod job;
mod jog;
mod laser;
mod lease;
mod line;
mod link;
mod outbox;
mod plan;
mod raw;
mod request;
mod run;
mod save;
mod stop;
mod view;

use std::time::Duration;

use dobot_client::{CommandId, Finding, SendError, Session};
use dobot_course::{LASER_OFF, Model};
use dobot_safety::Policy;
use dobot_wire::{Dialect, Packet, Status};

use self::arm::Arm;
use self::commands::Commands;
use self::detecting::Detecting;
use self::halt::Halt;
use self::jog::{Jogging, Silence};
use self::lease::{Change, Leases};
use self::link::Link;
use self::outbox::Outbox;
use self::run::Run;
use self::save::Save;
use self::stop::Stop;
use crate::words::{ClientId, News, Notice, Refusal, Reply, Role};

pub use self::plan::JobPlan;
pub use self::run::{Begun, Effect};

/// The keeper of the arm, as an engine: it owns no port, no file and no clock.
///
/// Things happen to it (`handle_*`), it wants things (`poll_*`). Its time counts from the start of
/// the station and never goes back. Every byte that reaches the arm passes here, and with it every
/// rule: who has control, what the policy allows, that a stop holds, that the laser is off unless a
/// person has armed it.
#[derive(Debug)]
pub struct Keeper {
    arm: Arm,
    outbox: Outbox,
    link: Link,
    leases: Leases,
    stop: Stop,
    jogging: Jogging,
    halt: Halt,
    run: Option<Run>,
    save: Save,
    detecting: Detecting,
    commands: Commands,
}

impl Keeper {
    /// A keeper that has no arm yet. It trusts the pose of one whose port it has opened only when a
    /// person has confirmed it, that of a virtual one from the start.
    #[must_use]
    pub fn new(policy: Policy, dialect: Option<Dialect>) -> Self {
        Self {
            arm: Arm::new(policy, dialect),
            outbox: Outbox::new(),
            link: Link::default(),
            leases: Leases::new(),
            stop: Stop::default(),
            jogging: Jogging::default(),
            halt: Halt::default(),
            run: None,
            save: Save::default(),
            detecting: Detecting::default(),
            commands: Commands::default(),
        }
    }

    /// Takes that something of the station goes wrong, in one line.
    pub fn handle_trouble(&mut self, now: Duration, text: String) {
        self.handle_time(now);
        self.tell(News::Trouble, text);
    }

    /// Lets the laser burn without having been armed: that of a virtual arm harms nobody.
    pub fn free_laser(&mut self) {
        self.arm.session_mut().free_laser();
    }

    /// The pose is not to be trusted until a person confirms it, and why.
    pub fn distrust(&mut self, reason: &str) {
        self.arm.session_mut().distrust(reason);
        self.outbox.note_change();
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
            self.outbox.note_change();
        }
    }

    /// Takes that the station ends: nothing more is sent, and the laser goes off first.
    pub fn handle_end(&mut self, now: Duration) {
        self.handle_time(now);
        self.halt.begin(&mut self.arm);
        self.jogging.let_go();
        self.drop_waiting("the station ended");
        self.interrupt_run("the station ended");
        self.end_detection("the station ended");
    }

    /// Takes that the station stood still for so long: what it would have said meanwhile is said now,
    /// as after a fault. Its guardian may have said it, too.
    pub fn handle_stall(&mut self, now: Duration, silent: Duration) {
        self.arm.set_time(now);
        let why = format!("the station stood still for {:.1} s", silent.as_secs_f64());
        self.arm.send_at_once(LASER_OFF);
        self.withdraw(Refusal::LetGo(why.clone()));
        self.tell(
            News::Trouble,
            format!("{why}: the laser was switched off and the button let go"),
        );
        self.disarm_laser(&why);
    }

    /// Takes the passing of time.
    pub fn handle_time(&mut self, now: Duration) {
        self.arm.handle_time(now);
        self.follow_session();
        self.watch_dead_man();
        self.watch_press();
        let (is_linked, unknown) = (self.link.is_there(), self.unknown_motion());
        self.halt.repeat(&mut self.arm, is_linked, unknown);
        self.save.handle_time(self.arm.now());
        self.pump();
    }

    /// The next thing that happened, for all who watch.
    pub fn poll_notice(&mut self) -> Option<Notice> {
        self.outbox.poll_notice()
    }

    /// The next status of the arm, as it came.
    pub fn poll_status(&mut self) -> Option<Status> {
        self.outbox.poll_status()
    }

    /// The answer to a request that took its time.
    pub fn poll_answer(&mut self) -> Option<(ClientId, Result<Reply, Refusal>)> {
        self.outbox.poll_answer()
    }

    /// What the journal is to keep, in order.
    pub fn poll_effect(&mut self) -> Option<Effect> {
        self.save.poll_effect()
    }

    /// Whether something changed since this was asked last.
    pub fn poll_changed(&mut self) -> bool {
        self.outbox.poll_changed()
    }

    /// When [`Keeper::handle_time`] wants to be called next, at the latest.
    #[must_use]
    pub fn poll_wakeup(&self) -> Duration {
        [
            Some(self.arm.session().poll_wakeup()).filter(|_| self.link.is_there()),
            self.jogging.falls_silent(),
            self.arm.session().laser_armed_until(),
            self.halt.next(),
            self.save.next(),
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

    /// Lets go of the button, if one is pressed: its client did.
    fn let_go(&mut self) {
        if self.jogging.let_go() {
            self.release_button();
        }
    }

    /// The station lets go of the button, and its client has to press it anew; says whether the arm
    /// moved by it.
    fn withdraw(&mut self, why: Refusal) -> bool {
        let acted = self.jogging.bar(why);
        if acted {
            self.release_button();
        }
        acted
    }

    fn release_button(&mut self) {
        self.drop_waiting("the button was released");
        self.halt.release(&mut self.arm);
    }

    /// A press that waited acts, as soon as the arm rests.
    fn watch_press(&mut self) {
        let waits = self.jogging.waits();
        let Some((client, jog)) = waits.filter(|_| !self.arm.session().is_moving()) else {
            return;
        };
        match self
            .check_free()
            .and_then(|()| jog::act(&mut self.arm, jog))
        {
            Ok(()) => {
                self.halt.forget();
                self.jogging.handle_moves(self.arm.now());
            }
            Err(refusal) => {
                self.withdraw(refusal.clone());
                self.tell_refused(client, &refusal);
            }
        }
    }

    fn watch_dead_man(&mut self) {
        let Some(Silence { client, lasts }) = self.jogging.silence(self.arm.now()) else {
            return;
        };
        let who = client.map_or_else(|| "the arm".into(), |it| self.name(it));
        let silent_ms = lasts.as_secs_f64() * 1e3;
        let why = format!("{who} fell silent for {silent_ms:.0} ms");
        if self.withdraw(Refusal::LetGo(why.clone())) {
            self.tell(News::DeadMan, format!("{why}: the button was released"));
        }
    }

    /// Takes what came of an [`Effect`]: it is on the disk, or why it is not. No more of a job is
    /// sent then until somebody goes on with it.
    pub fn handle_written(&mut self, now: Duration, effect: &Effect, outcome: Result<(), String>) {
        self.handle_time(now);
        match outcome {
            Ok(()) => self.written(effect),
            Err(why) => self.not_written(effect, &why),
        }
        self.pump();
    }

    fn written(&mut self, effect: &Effect) {
        if self.save.handle_written(effect) {
            let text = "the journal of jobs can be written again".to_owned();
            self.tell(News::Trouble, text);
        }
        if let Some(run) = &mut self.run {
            run.handle_written(effect);
        }
    }

    fn not_written(&mut self, effect: &Effect, why: &str) {
        let is_news = self.save.handle_not_written(self.arm.now(), effect, why);
        let why = format!("the journal of jobs cannot be written: {why}");
        if self.run.as_ref().is_some_and(Run::has_the_arm) {
            self.arm.part_from_laser();
            self.drop_waiting(&why);
            self.interrupt_run(&why);
        }
        if is_news {
            self.tell(News::Trouble, why);
        }
    }

    /// Ends a detection that cannot go on.
    fn end_detection(&mut self, why: &str) {
        if let Some(client) = self.detecting.end() {
            let refusal = Refusal::NotFound(why.to_owned());
            self.outbox.answer((client, Err(refusal)));
        }
    }

    fn command_over(&mut self, id: CommandId, failed: Option<String>) {
        self.run_command_over(id, failed.as_deref());
        if !self.commands.handle_over(id) {
            return;
        }
        let command = id.0;
        match failed {
            None => self.tell(
                News::CommandDone { command },
                format!("command {command} is done"),
            ),
            Some(why) => {
                self.arm.part_from_laser();
                self.tell(
                    News::CommandFailed { command },
                    format!("command {command}: {why}"),
                );
            }
        }
    }

    /// The commands that are not over, of clients and of the job.
    fn under_way(&self) -> Vec<CommandId> {
        let of_clients = self.commands.ids();
        let of_run = self.run.iter().flat_map(Run::under_way);
        let mut ids: Vec<_> = of_clients.chain(of_run).collect();
        ids.sort_unstable();
        ids
    }

    /// By when the arm is at rest if nothing more is sent; a button that is held is let go now.
    fn rests_within(&self) -> Duration {
        self.arm.rests_within(self.unknown_motion())
    }

    /// How long the arm may be at what the session does not know of.
    fn unknown_motion(&self) -> Duration {
        let unseen = self.run.as_ref().map_or(0.0, Run::unseen_s);
        seconds(unseen).max(self.detecting.motion())
    }

    /// Forgets the commands that have not been sent.
    fn drop_waiting(&mut self, why: &str) {
        for id in self.arm.session_mut().forget_waiting() {
            self.command_forgotten(id, why);
        }
    }

    fn command_forgotten(&mut self, id: CommandId, why: &str) {
        if let Some(run) = &mut self.run {
            run.handle_forgotten(id);
        }
        if self.commands.handle_over(id) {
            let command = id.0;
            self.tell(
                News::CommandFailed { command },
                format!("command {command} was not sent: {why}"),
            );
        }
    }

    fn tell(&mut self, news: News, text: String) {
        self.outbox.tell(self.arm.now(), news, text);
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

    /// What a client calls itself.
    #[must_use]
    pub fn client_name(&self, client: ClientId) -> String {
        self.name(client)
    }

    fn name(&self, client: ClientId) -> String {
        self.leases.name(client)
    }

    /// Takes that a client came.
    pub fn handle_client(&mut self, now: Duration, name: &str, role: Role) -> ClientId {
        self.handle_time(now);
        self.outbox.note_change();
        self.leases.handle_client(name, role)
    }

    /// Takes that a client left, wanted or not: its lease ends, and what it held is let go.
    pub fn handle_left(&mut self, now: Duration, client: ClientId) {
        self.handle_time(now);
        let changes = self.leases.handle_left(client);
        self.follow_lease(changes);
        self.outbox.note_change();
    }

    fn follow_lease(&mut self, changes: impl IntoIterator<Item = Change>) {
        for change in changes {
            match change {
                Change::Ended { client, why } => self.lease_over(client, &why),
                Change::Taken(client) => {
                    let text = format!("{} has control", self.name(client));
                    self.tell(News::LeaseTaken { client }, text);
                }
                Change::Asked(client) => {
                    let text = format!("{} asks for control", self.name(client));
                    self.tell(News::LeaseAsked { client }, text);
                }
            }
        }
    }

    /// Nobody moves the arm who has no control: buttons are let go, what waits is forgotten, and
    /// the laser goes off. A drawing with a pen goes on; it is the station's.
    fn lease_over(&mut self, client: ClientId, why: &str) {
        self.arm.part_from_laser();
        self.disarm_laser(why);
        self.let_go();
        self.end_detection(why);
        if self.commands.any_of(client) {
            self.drop_waiting(why);
        }
        self.tell(News::LeaseFree, format!("nobody has control: {why}"));
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
