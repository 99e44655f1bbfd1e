//! The thread that owns the client of the rules.

use std::fmt;
use std::sync::mpsc::{self, Receiver, Sender};
use std::sync::{Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use dobot_api::{
    JobPhase, JobView, Problem, RemoteError, Reply, Request, StationAddress, StationEvent,
};
use dobot_controller::PowerUp;
use dobot_draw::DrawingRequest;
use dobot_rules::{JobWatch, Rules, StationClient, drawing_job};
use dobot_safety::Policy;
use dobot_wire::{Command, Status};
use tokio::sync::mpsc::{UnboundedReceiver, UnboundedSender, unbounded_channel};

use crate::drawing::WITHOUT_ARM_Z_MM;

/// Where the rules are kept.
pub(crate) enum Where {
    /// In this process, with an arm in virtual time.
    Virtual(PowerUp),
    /// In a station that runs.
    Station(StationAddress),
}

/// What the arm is to do.
pub(crate) enum Operation {
    Status,
    /// A command made from how the arm stands.
    CarryOut(Box<dyn FnOnce(&Status) -> Command + Send>),
    Draw(Box<DrawingRequest>),
    Wait(Duration),
    ConfirmPose,
    ResetStop,
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
}

impl Failure {
    /// The name of its exception.
    pub(crate) const fn class(&self) -> &'static str {
        match self {
            Self::Refused(_) => "Refused",
            Self::Failed { .. } => "Failed",
            Self::LinkLost { .. } => "LinkLost",
            Self::Stopped => "Stopped",
            Self::Closed | Self::Forked => "Closed",
        }
    }

    /// What to do about it.
    pub(crate) fn hint(&self) -> Option<&str> {
        match self {
            Self::Refused(problem) => problem.hint.as_deref(),
            Self::Failed { hint, .. } | Self::LinkLost { hint, .. } => hint.as_deref(),
            Self::Stopped => Some("when it may move again: `arm.reset_stop()`"),
            Self::Closed | Self::Forked => Some("connect again: `dobot_arm.connect(...)`"),
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

struct Job {
    operation: Operation,
    answer: Sender<Told>,
}

struct Stop {
    reason: Option<String>,
    answer: Sender<Told>,
}

struct Doors {
    jobs: UnboundedSender<Job>,
    stops: UnboundedSender<Stop>,
}

pub(crate) struct Worker {
    doors: Mutex<Option<Doors>>,
    thread: Mutex<Option<JoinHandle<()>>>,
}

impl Worker {
    /// Starts the thread, which tells when it is connected.
    pub(crate) fn start(at: Where, name: String) -> (Self, Mutex<Receiver<Told>>) {
        let (jobs, wanted) = unbounded_channel();
        let (stops, stopped) = unbounded_channel();
        let (connected, told) = mpsc::channel();
        let thread = thread::spawn(move || run(at, &name, &connected, wanted, stopped));
        let worker = Self {
            doors: Mutex::new(Some(Doors { jobs, stops })),
            thread: Mutex::new(Some(thread)),
        };
        (worker, Mutex::new(told))
    }

    /// Asks for something; nothing is heard where the thread has ended.
    pub(crate) fn ask(&self, operation: Operation) -> Mutex<Receiver<Told>> {
        let (answer, told) = mpsc::channel();
        if let Some(doors) = &*self.doors.lock().unwrap_or_else(PoisonError::into_inner) {
            let _ = doors.jobs.send(Job { operation, answer });
        }
        Mutex::new(told)
    }

    /// Stops the arm, before anything else that was asked for.
    pub(crate) fn stop(&self, reason: Option<String>) -> Mutex<Receiver<Told>> {
        let (answer, told) = mpsc::channel();
        if let Some(doors) = &*self.doors.lock().unwrap_or_else(PoisonError::into_inner) {
            let _ = doors.stops.send(Stop { reason, answer });
        }
        Mutex::new(told)
    }

    /// Lets go of the arm and waits until that is done.
    pub(crate) fn close(&self) {
        drop(
            self.doors
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
                .take(),
        );
        let thread = self
            .thread
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .take();
        if let Some(thread) = thread {
            let _ = thread.join();
        }
    }
}

fn run(
    at: Where,
    name: &str,
    connected: &Sender<Told>,
    jobs: UnboundedReceiver<Job>,
    stops: UnboundedReceiver<Stop>,
) {
    let runtime = match tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build()
    {
        Ok(runtime) => runtime,
        Err(error) => {
            let text = format!("no runtime can be started: {error}");
            let _ = connected.send(Told::Over(Err(Failure::Failed { text, hint: None })));
            return;
        }
    };
    runtime.block_on(async {
        let lives = matches!(at, Where::Station(_));
        let client = match at {
            Where::Virtual(power_up) => {
                StationClient::with_virtual_arm(power_up, Policy::default(), name)
            }
            Where::Station(address) => match StationClient::connect(&address, name).await {
                Ok(client) => client,
                Err(error) => {
                    let text = error.to_string();
                    let _ = connected.send(Told::Over(Err(Failure::LinkLost { text, hint: None })));
                    return;
                }
            },
        };
        let _ = connected.send(Told::Over(Ok(None)));
        serve(client, lives, jobs, stops).await;
    });
}

/// Does what is asked for, one after the other. The connection with a station is read in between, too;
/// virtual time passes only while somebody waits.
async fn serve(
    mut client: StationClient,
    mut listens: bool,
    mut jobs: UnboundedReceiver<Job>,
    mut stops: UnboundedReceiver<Stop>,
) {
    loop {
        tokio::select! {
            biased;
            Some(it) = stops.recv() => stop(&mut client, it).await,
            job = jobs.recv() => {
                let Some(Job { operation, answer }) = job else { break };
                let stopped = tokio::select! {
                    biased;
                    Some(it) = stops.recv() => it,
                    done = act(&mut client, operation, &answer) => {
                        let _ = answer.send(Told::Over(done));
                        continue;
                    }
                };
                stop(&mut client, stopped).await;
                let _ = answer.send(Told::Over(Err(Failure::Stopped)));
            }
            // A connection that broke is told to whoever asks next.
            heard = client.next(), if listens => listens = heard.is_ok(),
        }
    }
    client.end().await;
}

async fn stop(client: &mut StationClient, Stop { reason, answer }: Stop) {
    let done = client.request(Request::Stop { reason }).await;
    let _ = answer.send(Told::Over(done.map(|_| None).map_err(Failure::from)));
}

async fn act(client: &mut StationClient, operation: Operation, told: &Sender<Told>) -> Answer {
    match operation {
        Operation::Status => return Ok(Some(status(client).await?)),
        Operation::CarryOut(command) => {
            let command = command(&status(client).await?);
            client.request(Request::TakeLease).await?;
            if let Reply::Accepted { command, .. } =
                client.request_at_rest(Request::Command { command }).await?
            {
                client.finished(command).await?;
            }
            return Ok(Some(status(client).await?));
        }
        Operation::Draw(request) => draw(client, *request, told).await?,
        Operation::Wait(time) => client.wait(time).await,
        Operation::ConfirmPose => drop(client.request(Request::ConfirmPose).await?),
        Operation::ResetStop => drop(client.request_at_rest(Request::ResetStop).await?),
    }
    Ok(None)
}

/// Plans it for this arm, and draws it as a job.
async fn draw(
    client: &mut StationClient,
    request: DrawingRequest,
    told: &Sender<Told>,
) -> Result<(), Failure> {
    let title = request.title.clone();
    let (plan, armed_for_s) = plan(client, request).await?;
    if plan.burns() && client.virtual_arm().is_none() && armed_for_s <= 0.0 {
        return Err(Failure::Failed {
            text: "the laser is disarmed".to_owned(),
            hint: Some("put the goggles on, then arm it on the station's page".to_owned()),
        });
    }
    client.request(Request::TakeLease).await?;
    let job = drawing_job(&plan, &title);
    let reply = client
        .request(Request::SubmitJob { job, key: None })
        .await?;
    let Reply::Job {
        job: JobView { job, .. },
    } = reply
    else {
        return Err(failed(format!(
            "the station answers {reply:?} to a new job"
        )));
    };
    if let Err(error) = client.request_at_rest(Request::StartJob { job }).await {
        // Why it was refused is what counts.
        let _ = client.request(Request::CancelJob { job }).await;
        return Err(error.into());
    }
    if !plan.burns() {
        // Whoever is there may change its speed.
        client.request(Request::ReleaseLease).await?;
    }
    follow(client, job, told).await
}

/// The plan for this arm as it stands, and for how long its laser is armed.
async fn plan(
    client: &mut StationClient,
    request: DrawingRequest,
) -> Result<(dobot_plan::Plan, f64), Failure> {
    let state = client.state().await?;
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
async fn follow(client: &mut StationClient, job: u64, told: &Sender<Told>) -> Result<(), Failure> {
    let mut watch = JobWatch::new(job);
    loop {
        match client.next().await? {
            StationEvent::State(state) => {
                if let Some(it) = state.job.as_ref().filter(|it| it.job == job) {
                    let _ = told.send(Told::Progress(it.completed, it.commands));
                }
            }
            StationEvent::Notice(notice) => match watch.handle_notice(&notice) {
                None => {}
                Some((JobPhase::Done, _)) => return Ok(()),
                Some((JobPhase::Paused, text)) => {
                    let hint = Some("go on with it on the station's page, or cancel it".to_owned());
                    return Err(Failure::Failed { text, hint });
                }
                Some((_, text)) => return Err(failed(text)),
            },
        }
    }
}

const fn failed(text: String) -> Failure {
    Failure::Failed { text, hint: None }
}

/// What the arm tells next.
async fn status(client: &mut StationClient) -> Result<Status, RemoteError> {
    let state = client.state().await?;
    state.arm.map(|it| it.status).ok_or(RemoteError::Silent)
}
