//! The thread that owns the client of the rules.

use std::fmt;
use std::sync::mpsc::{self, Receiver, Sender};
use std::sync::{Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use dobot_api::{Problem, RemoteError, Reply, Request, StationAddress};
use dobot_controller::PowerUp;
use dobot_rules::StationClient;
use dobot_safety::Policy;
use dobot_wire::{Command, Status};
use tokio::sync::mpsc::{UnboundedReceiver, UnboundedSender, unbounded_channel};

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
    Wait(Duration),
    ConfirmPose,
    ResetStop,
}

/// What comes of it: the arm's last status, where it told one.
pub(crate) type Answer = Result<Option<Status>, Failure>;

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
    answer: Sender<Answer>,
}

struct Stop {
    reason: Option<String>,
    answer: Sender<Answer>,
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
    pub(crate) fn start(at: Where, name: String) -> (Self, Mutex<Receiver<Answer>>) {
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
    pub(crate) fn ask(&self, operation: Operation) -> Mutex<Receiver<Answer>> {
        let (answer, told) = mpsc::channel();
        if let Some(doors) = &*self.doors.lock().unwrap_or_else(PoisonError::into_inner) {
            let _ = doors.jobs.send(Job { operation, answer });
        }
        Mutex::new(told)
    }

    /// Stops the arm, before anything else that was asked for.
    pub(crate) fn stop(&self, reason: Option<String>) -> Mutex<Receiver<Answer>> {
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
    connected: &Sender<Answer>,
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
            let _ = connected.send(Err(Failure::Failed { text, hint: None }));
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
                    let _ = connected.send(Err(Failure::LinkLost { text, hint: None }));
                    return;
                }
            },
        };
        let _ = connected.send(Ok(None));
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
                    done = act(&mut client, operation) => {
                        let _ = answer.send(done.map_err(Failure::from));
                        continue;
                    }
                };
                stop(&mut client, stopped).await;
                let _ = answer.send(Err(Failure::Stopped));
            }
            // A connection that broke is told to whoever asks next.
            heard = client.next(), if listens => listens = heard.is_ok(),
        }
    }
    client.end().await;
}

async fn stop(client: &mut StationClient, Stop { reason, answer }: Stop) {
    let done = client.request(Request::Stop { reason }).await;
    let _ = answer.send(done.map(|_| None).map_err(Failure::from));
}

async fn act(
    client: &mut StationClient,
    operation: Operation,
) -> Result<Option<Status>, RemoteError> {
    match operation {
        Operation::Status => return status(client).await.map(Some),
        Operation::CarryOut(command) => {
            let command = command(&status(client).await?);
            client.request(Request::TakeLease).await?;
            if let Reply::Accepted { command, .. } =
                client.request_at_rest(Request::Command { command }).await?
            {
                client.finished(command).await?;
            }
            return status(client).await.map(Some);
        }
        Operation::Wait(time) => client.wait(time).await,
        Operation::ConfirmPose => drop(client.request(Request::ConfirmPose).await?),
        Operation::ResetStop => drop(client.request_at_rest(Request::ResetStop).await?),
    }
    Ok(None)
}

/// What the arm tells next.
async fn status(client: &mut StationClient) -> Result<Status, RemoteError> {
    let state = client.state().await?;
    state.arm.map(|it| it.status).ok_or(RemoteError::Silent)
}
