//! The thread that owns the client of the rules.

use std::fmt;
use std::process;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use dobot_api::{
    JobPhase, Jog, Problem, RemoteError, Reply, Request, State, StationEvent, StationSearch,
};
use dobot_controller::PowerUp;
use dobot_draw::{DrawingRequest, WITHOUT_ARM_Z_MM};
use dobot_rules::{JobWatch, LocalArm, NoArm, Rules, StationClient, drawing_job};
use dobot_safety::Policy;
use dobot_wire::{Command, Status};
use tokio::sync::mpsc::{UnboundedReceiver, UnboundedSender, unbounded_channel};
use tokio::time::timeout;

use crate::mailbox::{Mailbox, Teller};

/// Where the rules are kept.
pub(crate) enum Where {
    /// In this process, with an arm in virtual time.
    Virtual(PowerUp),
    /// In a station that runs.
    Station(StationSearch),
    /// In this process, for an arm at an address.
    Local(Box<LocalArm>),
}

/// What the arm is to do.
pub(crate) enum Operation {
    /// Nothing: whoever asks waits for the connection.
    Connected,
    Status,
    /// A command made from how the arm stands.
    CarryOut(Box<dyn FnOnce(&Status) -> Command + Send>),
    Draw(Box<DrawingRequest>),
    Wait(Duration),
    /// Hold a jog button until it is released, and at most so long.
    Press(Jog, Duration),
    Release,
    /// Let time pass until this mailbox holds something.
    Hear(Arc<Mailbox<Status>>),
    /// What takes control of the arm.
    Controlled(Request),
    /// What takes none.
    Plain(Request),
}

/// What comes of it: the arm's last status, where it told one.
pub(crate) type Answer = Result<Option<Status>, Failure>;

/// What is heard of an operation.
pub(crate) enum Told {
    /// So many commands of so many are over.
    Progress(usize, usize),
    Over(Answer),
}

/// Why something was not done.
#[derive(Debug)]
pub(crate) enum Failure {
    Refused(Box<Problem>),
    Failed { text: String, hint: Option<String> },
    LinkLost { text: String, hint: Option<String> },
    Stopped,
    Closed,
    Forked,
    Unheard,
}

impl Failure {
    /// The name of its exception.
    pub(crate) const fn class(&self) -> &'static str {
        match self {
            Self::Refused(_) => "Refused",
            Self::Failed { .. } => "Failed",
            Self::LinkLost { .. } => "LinkLost",
            Self::Stopped => "Stopped",
            Self::Closed | Self::Forked | Self::Unheard => "Closed",
        }
    }

    /// What to do about it.
    pub(crate) fn hint(&self) -> Option<&str> {
        match self {
            Self::Refused(problem) => problem.hint.as_deref(),
            Self::Failed { hint, .. } | Self::LinkLost { hint, .. } => hint.as_deref(),
            Self::Stopped => Some("when it may move again: `arm.reset_stop()`"),
            Self::Closed | Self::Forked | Self::Unheard => {
                Some("connect again: `dobot_arm.connect(...)`")
            }
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Refused(problem) => f.write_str(&problem.detail),
            Self::Failed { text, .. } | Self::LinkLost { text, .. } => f.write_str(text),
            Self::Stopped => f.write_str("the arm was stopped while this was under way"),
            Self::Closed => f.write_str("the arm was let go of"),
            Self::Unheard => f.write_str(
                "there are no more statuses: the arm was let go of, or more than an hour of them was not taken",
            ),
            Self::Forked => f.write_str(
                "the arm belongs to the process that connected to it, and this is a fork of it",
            ),
        }
    }
}

impl From<RemoteError> for Failure {
    fn from(error: RemoteError) -> Self {
        let hint = error.hint();
        let text = error.to_string();
        match error {
            RemoteError::Refused(problem) => Self::Refused(problem),
            RemoteError::Failed(_) => Self::Failed { text, hint },
            _ => Self::LinkLost { text, hint },
        }
    }
}

impl From<NoArm> for Failure {
    fn from(error: NoArm) -> Self {
        match error {
            NoArm::Silent(error) => error.into(),
            other => Self::LinkLost {
                text: other.to_string(),
                hint: other.hint(),
            },
        }
    }
}

struct Job {
    operation: Operation,
    answer: Teller<Told>,
}

struct Stop {
    reason: Option<String>,
    answer: Teller<Told>,
}

struct Doors {
    jobs: UnboundedSender<Job>,
    stops: UnboundedSender<Stop>,
}

/// Those who want to hear every status.
type Ears = Arc<Mutex<Vec<Teller<Status>>>>;

pub(crate) struct Worker {
    doors: Mutex<Option<Doors>>,
    thread: Mutex<Option<JoinHandle<()>>>,
    ears: Ears,
    /// The process whose thread it is; a fork of it has none.
    pid: u32,
}

impl Worker {
    /// Starts the thread, which connects first.
    pub(crate) fn start(at: Where, name: String) -> Self {
        let (jobs, wanted) = unbounded_channel();
        let (stops, stopped) = unbounded_channel();
        let ears = Ears::default();
        let heard = Arc::clone(&ears);
        let thread = thread::spawn(move || run(at, &name, &heard, wanted, stopped));
        Self {
            doors: Mutex::new(Some(Doors { jobs, stops })),
            thread: Mutex::new(Some(thread)),
            ears,
            pid: process::id(),
        }
    }

    /// Asks for something; nothing is heard where the thread has ended.
    pub(crate) fn ask(&self, operation: Operation) -> Arc<Mailbox<Told>> {
        let (answer, told) = Mailbox::new();
        if process::id() != self.pid {
            answer.tell(Told::Over(Err(Failure::Forked)));
        } else if let Some(doors) = &*lock(&self.doors) {
            let _ = doors.jobs.send(Job { operation, answer });
        }
        told
    }

    /// Stops the arm, before anything else that was asked for.
    pub(crate) fn stop(&self, reason: Option<String>) -> Arc<Mailbox<Told>> {
        let (answer, told) = Mailbox::new();
        if process::id() != self.pid {
            answer.tell(Told::Over(Err(Failure::Forked)));
        } else if let Some(doors) = &*lock(&self.doors) {
            let _ = doors.stops.send(Stop { reason, answer });
        }
        told
    }

    /// Hears every status from now on.
    pub(crate) fn listen(&self) -> Arc<Mailbox<Status>> {
        let (teller, heard) = Mailbox::new();
        lock(&self.ears).push(teller);
        heard
    }

    /// Lets go of the arm and waits until that is done.
    pub(crate) fn close(&self) {
        if process::id() != self.pid {
            return;
        }
        drop(lock(&self.doors).take());
        let thread = lock(&self.thread).take();
        if let Some(thread) = thread {
            let _ = thread.join();
        }
        lock(&self.ears).clear();
    }
}

fn lock<T>(it: &Mutex<T>) -> MutexGuard<'_, T> {
    it.lock().unwrap_or_else(PoisonError::into_inner)
}

fn run(
    at: Where,
    name: &str,
    ears: &Ears,
    mut jobs: UnboundedReceiver<Job>,
    stops: UnboundedReceiver<Stop>,
) {
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build();
    let served = match runtime {
        Err(error) => Err(failed(format!("no runtime can be started: {error}"))),
        Ok(runtime) => runtime.block_on(async {
            let session = Session {
                client: connect(at, name).await?,
                ears: Arc::clone(ears),
                held: None,
            };
            session.serve(&mut jobs, stops).await;
            Ok(())
        }),
    };
    if let Err(failure) = served
        && let Some(job) = jobs.blocking_recv()
    {
        job.answer.tell(Told::Over(Err(failure)));
    }
    lock(ears).clear();
}

async fn connect(at: Where, name: &str) -> Result<StationClient, Failure> {
    match at {
        Where::Virtual(power_up) => Ok(StationClient::with_virtual_arm(
            power_up,
            Policy::default(),
            name,
        )),
        Where::Station(search) => {
            let found = search.find().await.map_err(|it| lost(&it, None))?;
            let address = found.ok_or_else(|| Failure::LinkLost {
                text: "no station runs on this machine".to_owned(),
                hint: Some("`dobot up` starts one".to_owned()),
            })?;
            let client = StationClient::connect(&address, name).await;
            client.map_err(|it| lost(&it, it.hint()))
        }
        Where::Local(arm) => {
            let client = StationClient::open(*arm, name).await;
            client.map_err(|it| lost(&it, None))
        }
    }
}

fn lost(error: &dyn std::error::Error, hint: Option<String>) -> Failure {
    let text = error.to_string();
    Failure::LinkLost { text, hint }
}

/// A jog button that is held.
struct Held {
    jog: Jog,
    /// When it is said again, by the arm's clock.
    next: Duration,
    /// When it is let go.
    until: Duration,
    /// Why it is not held any more.
    over: Option<Failure>,
}

/// The client, and what goes on.
struct Session {
    client: StationClient,
    ears: Ears,
    held: Option<Held>,
}

impl Session {
    /// Does what is asked for, one after the other. The connection with a station is read in between, too;
    /// virtual time passes only while somebody waits.
    async fn serve(
        mut self,
        jobs: &mut UnboundedReceiver<Job>,
        mut stops: UnboundedReceiver<Stop>,
    ) {
        let is_virtual = self.client.virtual_arm().is_some();
        let mut listens = !is_virtual;
        loop {
            let beats = self.held.as_ref().is_some_and(|it| it.over.is_none()) && !is_virtual;
            let beat = self.time_to_beat();
            tokio::select! {
                biased;
                Some(it) = stops.recv() => self.stop(it).await,
                job = jobs.recv() => {
                    let Some(Job { operation, answer }) = job else { break };
                    let stopped = tokio::select! {
                        biased;
                        Some(it) = stops.recv() => it,
                        done = self.act(operation, &answer) => {
                            answer.tell(Told::Over(done));
                            continue;
                        }
                    };
                    self.stop(stopped).await;
                    answer.tell(Told::Over(Err(Failure::Stopped)));
                }
                () = tokio::time::sleep(beat), if beats => self.beat().await,
                // A connection that broke is told to whoever asks next.
                heard = self.client.next(), if listens => match heard {
                    Ok(event) => self.hear(&event),
                    Err(_) => listens = false,
                },
            }
        }
        self.client.end().await;
    }

    async fn stop(&mut self, Stop { reason, answer }: Stop) {
        let done = self.client.request(Request::Stop { reason }).await;
        if let Some(held) = &mut self.held {
            held.over = Some(Failure::Stopped);
        }
        answer.tell(Told::Over(done.map(|_| None).map_err(Failure::from)));
    }

    async fn act(&mut self, operation: Operation, told: &Teller<Told>) -> Answer {
        let moves = matches!(
            operation,
            Operation::CarryOut(_) | Operation::Draw(_) | Operation::Press(..)
        );
        if moves && self.held.is_some() {
            return Err(Failure::Failed {
                text: "a jog button is held".to_owned(),
                hint: Some("leave the `with` of `arm.jog(...)` first".to_owned()),
            });
        }
        match operation {
            Operation::Connected => {}
            Operation::Status => return Ok(Some(self.status().await?)),
            Operation::CarryOut(command) => {
                let command = command(&self.status().await?);
                self.carry_out(command).await?;
                return Ok(Some(self.status().await?));
            }
            Operation::Draw(request) => self.draw(*request, told).await?,
            Operation::Wait(time) => self.wait(time).await?,
            Operation::Press(jog, at_most) => self.press(jog, at_most).await?,
            Operation::Release => self.release().await?,
            Operation::Hear(mailbox) => {
                while mailbox.len() == 0 {
                    self.pass(BEAT).await?;
                }
            }
            Operation::Controlled(request) => {
                self.client.request(Request::TakeLease).await?;
                self.client.request_at_rest(request).await?;
            }
            Operation::Plain(request) => {
                // There is no pose before the arm has told one.
                if matches!(request, Request::ConfirmPose) {
                    self.status().await?;
                }
                self.client.request_at_rest(request).await?;
            }
        }
        Ok(None)
    }

    async fn carry_out(&mut self, command: Command) -> Result<(), Failure> {
        self.client.request(Request::TakeLease).await?;
        let request = Request::Command { command };
        if let Reply::Accepted { command, .. } = self.client.request_at_rest(request).await? {
            let ears = &self.ears;
            let see = |state: &State| tell(ears, state);
            self.client.finished_watched(command, see).await?;
        }
        Ok(())
    }

    /// What the arm tells next.
    async fn status(&mut self) -> Result<Status, Failure> {
        if self.held.is_none() {
            let state = self.client.heard().await?;
            tell(&self.ears, &state);
            let arm = state.arm.ok_or(RemoteError::Silent)?;
            return Ok(arm.status);
        }
        let (teller, heard) = Mailbox::new();
        lock(&self.ears).push(teller);
        loop {
            if let crate::mailbox::Taken::It(status) = heard.take(Duration::ZERO) {
                return Ok(status);
            }
            self.pass(BEAT).await?;
        }
    }

    async fn wait(&mut self, time: Duration) -> Result<(), Failure> {
        let until = self.client.now().saturating_add(time);
        while self.client.now() < until {
            let left = until.saturating_sub(self.client.now());
            self.pass(BEAT.min(left)).await?;
        }
        Ok(())
    }

    /// Lets a little time pass: no more than this, and less where something is told. A button stays held.
    async fn pass(&mut self, time: Duration) -> Result<(), Failure> {
        if self.client.virtual_arm().is_some() {
            self.client.wait(time).await;
            while let Some(event) = self.client.told() {
                self.hear(&event);
            }
            // A stop gets its turn.
            tokio::task::yield_now().await;
        } else if let Ok(event) = timeout(time, self.client.next()).await {
            self.hear(&event?);
        }
        if self.time_to_beat().is_zero() {
            self.beat().await;
        }
        Ok(())
    }

    /// The first press waits until an arm that runs down has come to rest.
    async fn press(&mut self, jog: Jog, at_most: Duration) -> Result<(), Failure> {
        self.client.request(Request::TakeLease).await?;
        self.client.request_at_rest(Request::Jog { jog }).await?;
        let now = self.client.now();
        self.held = Some(Held {
            jog,
            next: now + BEAT,
            until: now + at_most,
            over: None,
        });
        Ok(())
    }

    /// Lets go of the button, and waits until the arm rests.
    async fn release(&mut self) -> Result<(), Failure> {
        let Some(held) = self.held.take() else {
            return Ok(());
        };
        if let Some(failure) = held.over {
            return Err(failure);
        }
        self.client.request(Request::Release).await?;
        let until = self.client.now() + REST;
        loop {
            let state = self.client.state().await?;
            tell(&self.ears, &state);
            let moves = state.arm.is_some_and(|it| it.moving);
            if !moves || self.client.now() >= until {
                return Ok(());
            }
        }
    }

    /// How long until the button is said again.
    fn time_to_beat(&self) -> Duration {
        match &self.held {
            Some(Held {
                next, over: None, ..
            }) => next.saturating_sub(self.client.now()),
            _ => Duration::MAX,
        }
    }

    /// Says the button again, or lets it go when its time is over.
    async fn beat(&mut self) {
        let now = self.client.now();
        let Some(held) = self.held.as_mut().filter(|it| it.over.is_none()) else {
            return;
        };
        if now >= held.until {
            let released = self.client.request(Request::Release).await;
            held.over = Some(match released {
                Ok(_) => Failure::Failed {
                    text: "the button was let go of before its `with` ended: its time was over"
                        .to_owned(),
                    hint: Some("`at_most` says how long it may be held, in seconds".to_owned()),
                },
                Err(error) => error.into(),
            });
            return;
        }
        held.next = now + BEAT;
        let jog = held.jog;
        if let Err(error) = self.client.request(Request::Jog { jog }).await {
            held.over = Some(error.into());
        }
    }

    fn hear(&self, event: &StationEvent) {
        if let StationEvent::State(state) = event {
            tell(&self.ears, state);
        }
    }

    /// Plans it for this arm, and draws it as a job.
    async fn draw(&mut self, request: DrawingRequest, told: &Teller<Told>) -> Result<(), Failure> {
        let title = request.title.clone();
        let (plan, armed_for_s) = self.plan(request).await?;
        let client = &mut self.client;
        if plan.burns() && client.virtual_arm().is_none() && armed_for_s <= 0.0 {
            return Err(Failure::Failed {
                text: "the laser is disarmed".to_owned(),
                hint: Some("put the goggles on, then arm it on the station's page".to_owned()),
            });
        }
        client.request(Request::TakeLease).await?;
        let job = drawing_job(&plan, &title);
        let job = client.submit(job).await?;
        if let Err(error) = client.request_at_rest(Request::StartJob { job }).await {
            client.forget_unbegun(job).await;
            return Err(error.into());
        }
        if !plan.burns() {
            // Whoever is there may change its speed.
            client.request(Request::ReleaseLease).await?;
        }
        self.follow(job, told).await
    }

    /// The plan for this arm as it stands, and for how long its laser is armed.
    async fn plan(&mut self, request: DrawingRequest) -> Result<(dobot_plan::Plan, f64), Failure> {
        let client = &mut self.client;
        let state = client.heard().await?;
        let arm = state.arm.as_ref().ok_or(RemoteError::Silent)?;
        // A virtual arm in this process has its own paper.
        let (standing_z_mm, calibration) = if client.virtual_arm().is_some() {
            (WITHOUT_ARM_Z_MM, None)
        } else {
            let z_mm = arm.status.z_mm.into();
            let rules = Rules::of(&Policy::default());
            let planned_for = client.planned_for(rules, &state).await;
            let planned_for = planned_for.map_err(|it| failed(it.to_string()))?;
            (z_mm, planned_for.calibration)
        };
        let dialect = state.dialect;
        // A stop is heard meanwhile.
        let planning = tokio::task::spawn_blocking(move || {
            request
                .calibrated(calibration)
                .prepare(dialect, standing_z_mm)
        });
        let (prepared, _) = planning
            .await
            .map_err(|it| failed(it.to_string()))?
            .map_err(|it| failed(it.to_string()))?;
        Ok((prepared.plan, state.laser.armed_for_s))
    }

    /// Until the job does not run any more.
    async fn follow(&mut self, job: u64, told: &Teller<Told>) -> Result<(), Failure> {
        let mut watch = JobWatch::new(job);
        loop {
            match self.client.next().await? {
                StationEvent::State(state) => {
                    tell(&self.ears, &state);
                    if let Some(it) = state.job.as_ref().filter(|it| it.job == job) {
                        told.tell(Told::Progress(it.completed, it.commands));
                    }
                }
                StationEvent::Notice(notice) => match watch.handle_notice(&notice) {
                    None => {}
                    Some((JobPhase::Done, _)) => return Ok(()),
                    Some((JobPhase::Paused, text)) => {
                        let hint =
                            Some("go on with it on the station's page, or cancel it".to_owned());
                        return Err(Failure::Failed { text, hint });
                    }
                    Some((_, text)) => return Err(failed(text)),
                },
            }
        }
    }
}

const fn failed(text: String) -> Failure {
    Failure::Failed { text, hint: None }
}

/// Tells all who listen. Who does not take what is told is not told any more, and finds that out.
fn tell(ears: &Ears, state: &State) {
    let Some(arm) = &state.arm else { return };
    let mut ears = lock(ears);
    ears.retain(|it| !it.is_alone() && it.untaken() < LONGEST);
    for ear in &*ears {
        ear.tell(arm.status);
    }
}

/// A third of the time after which a station lets a button go.
const BEAT: Duration = Duration::from_millis(50);
/// No motion takes longer to run down.
const REST: Duration = Duration::from_secs(5);
/// So many statuses are kept for one who does not take them: more than an hour of them.
const LONGEST: usize = 65_536;
