//! The thread that owns the client of the rules.

use std::process;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use dobot_api::{Answer as JobAnswer, Jog, Request, Sense, State, StationSearch};
use dobot_controller::PowerUp;
use dobot_draw::DrawingRequest;
use dobot_host::{LocalArm, StationClient};
use dobot_safety::Policy;
use dobot_sim::VirtualArm;
use dobot_wire::{Command, Status};
use tokio::sync::mpsc::{UnboundedReceiver, UnboundedSender, unbounded_channel};

use crate::failure::{Failure, failed, lost};
use crate::follow::Follow;
use crate::mailbox::{Mailbox, Sender};
use crate::program::{Run, Source};
use crate::session::Session;
use crate::virtual_arm::VirtualSetup;

/// The place where the rules are applied.
pub(crate) enum Where {
    /// In this process, with an arm in virtual time.
    Virtual(Box<VirtualSetup>),
    /// In a running station.
    Station(StationSearch),
    /// In this process, for an arm at an address.
    Local(Box<LocalArm>),
}

/// An operation of the arm.
pub(crate) enum Operation {
    /// Nothing: waits for the connection.
    Connected,
    /// The next status.
    NextStatus,
    /// Everything that the station knows, as JSON.
    State,
    /// A computed command, and the sense that it comes from, if any.
    CarryOut(Box<CommandFor>, Option<Sense>),
    Draw(Box<DrawingRequest>),
    Run(Box<Run>),
    /// Move through points without a stop in between.
    Follow(Box<Follow>),
    /// Check a program for this arm.
    Check(Arc<Source>),
    /// Inspect or change the virtual arm of this process.
    Inspect(Box<Inspect>),
    /// Resume the paused job; whether a person has done what it waits for.
    Resume {
        as_person: bool,
    },
    /// Cancel the paused job.
    Cancel,
    Wait(Duration),
    /// Hold a jog button until it is released, within a maximum time.
    Press(Jog, Duration),
    Release,
    /// Let time pass until this mailbox has a message.
    Subscribe(Arc<Mailbox<Seen>>),
    /// Take control, or ask its holder for it and wait.
    RequestControl(Duration),
    /// A request that needs control of the arm.
    Controlled(Request),
    /// A request without control.
    Plain(Request),
}

/// Computes a command from the current status and the state that contains it.
pub(crate) type CommandFor = dyn FnOnce(&Status, &State) -> Command + Send;

/// Inspects or changes a virtual arm, given its power-up state.
pub(crate) type Inspect = dyn FnOnce(&mut VirtualArm, PowerUp) -> Result<Outcome, String> + Send;

/// The result of an operation.
pub(crate) type Answer = Result<Outcome, Failure>;

/// The value of a finished operation.
pub(crate) enum Outcome {
    Nothing,
    Status(Seen),
    /// A JSON value.
    Json(String),
}

/// A message about an operation.
pub(crate) enum Report {
    Progress(Progress),
    /// The question of a running program, as JSON.
    Question(String),
    Over(Answer),
}

/// The progress of a job.
#[derive(Clone, Copy)]
pub(crate) enum Progress {
    /// The number of completed commands and the number of commands.
    Commands { completed: usize, commands: usize },
    /// The step, the number of steps, the cycle and the number of cycles, counted from 1.
    Steps {
        step: usize,
        steps: usize,
        cycle: u64,
        cycles: Option<u64>,
    },
}

/// An operation, and the sender for its messages.
pub(crate) struct Job {
    pub(crate) operation: Operation,
    pub(crate) answer: Sender<Report>,
}

/// A request to stop the arm, and the sender for its messages.
pub(crate) struct Stop {
    pub(crate) reason: Option<String>,
    pub(crate) answer: Sender<Report>,
}

struct Channels {
    jobs: UnboundedSender<Job>,
    stops: UnboundedSender<Stop>,
    answers: UnboundedSender<JobAnswer>,
}

/// A received status.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seen {
    pub(crate) status: Status,
    /// The time since the station started, in seconds.
    pub(crate) at_s: f64,
    /// Whether the arm moves or may still move.
    pub(crate) moving: bool,
}

impl Seen {
    /// Returns the status of a state, if it has one.
    pub(crate) fn of(state: &State) -> Option<Self> {
        let arm = state.arm.as_ref()?;
        Some(Self {
            status: arm.status,
            at_s: state.at_s,
            moving: arm.moving,
        })
    }
}

/// The last status, and the subscribers of all statuses.
#[derive(Default)]
pub(crate) struct Statuses {
    pub(crate) last: Option<Seen>,
    pub(crate) subscribers: Vec<Sender<Seen>>,
}

pub(crate) type SharedStatuses = Arc<Mutex<Statuses>>;

pub(crate) struct Worker {
    channels: Mutex<Option<Channels>>,
    thread: Mutex<Option<JoinHandle<()>>>,
    statuses: SharedStatuses,
    /// The process of the thread; a fork of it has no thread.
    pid: u32,
}

impl Worker {
    /// Starts the thread, which connects first.
    pub(crate) fn start(at: Where, name: String) -> Self {
        let (jobs, wanted) = unbounded_channel();
        let (stops, stopped) = unbounded_channel();
        let (answers, answered) = unbounded_channel();
        let statuses = SharedStatuses::default();
        let shared = Arc::clone(&statuses);
        let thread = thread::spawn(move || run(at, &name, &shared, wanted, stopped, answered));
        Self {
            channels: Mutex::new(Some(Channels {
                jobs,
                stops,
                answers,
            })),
            thread: Mutex::new(Some(thread)),
            statuses,
            pid: process::id(),
        }
    }

    /// Requests an operation; there are no messages if the thread has ended.
    pub(crate) fn ask(&self, operation: Operation) -> Arc<Mailbox<Report>> {
        let (answer, reports) = Mailbox::new();
        if process::id() != self.pid {
            answer.send(Report::Over(Err(Failure::Forked)));
        } else if let Some(channels) = &*lock(&self.channels) {
            let _ = channels.jobs.send(Job { operation, answer });
        }
        reports
    }

    /// Stops the arm, before all other requests.
    pub(crate) fn stop(&self, reason: Option<String>) -> Arc<Mailbox<Report>> {
        let (answer, reports) = Mailbox::new();
        if process::id() != self.pid {
            answer.send(Report::Over(Err(Failure::Forked)));
        } else if let Some(channels) = &*lock(&self.channels) {
            let _ = channels.stops.send(Stop { reason, answer });
        }
        reports
    }

    /// Answers the question of the running program.
    pub(crate) fn answer(&self, answer: JobAnswer) {
        if let Some(channels) = &*lock(&self.channels) {
            let _ = channels.answers.send(answer);
        }
    }

    /// Subscribes to all statuses from now on.
    pub(crate) fn subscribe(&self) -> Arc<Mailbox<Seen>> {
        let (sender, statuses) = Mailbox::new();
        lock(&self.statuses).subscribers.push(sender);
        statuses
    }

    /// Returns the last known status, if there is one.
    pub(crate) fn last(&self) -> Result<Option<Seen>, Failure> {
        if process::id() != self.pid {
            return Err(Failure::Forked);
        }
        if lock(&self.channels).is_none() {
            return Err(Failure::Closed);
        }
        Ok(lock(&self.statuses).last)
    }

    /// Disconnects and waits until that is done.
    pub(crate) fn close(&self) {
        if process::id() != self.pid {
            return;
        }
        drop(lock(&self.channels).take());
        let thread = lock(&self.thread).take();
        if let Some(thread) = thread {
            let _ = thread.join();
        }
        lock(&self.statuses).subscribers.clear();
    }
}

pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

fn run(
    at: Where,
    name: &str,
    statuses: &SharedStatuses,
    mut jobs: UnboundedReceiver<Job>,
    stops: UnboundedReceiver<Stop>,
    answers: UnboundedReceiver<JobAnswer>,
) {
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build();
    let served = match runtime {
        Err(error) => Err(failed(format!("cannot start a runtime: {error}"))),
        Ok(runtime) => runtime.block_on(async {
            let power_up = match &at {
                Where::Virtual(setup) => Some(setup.power_up),
                Where::Station(_) | Where::Local(_) => None,
            };
            let client = connect(at, name).await?;
            let session = Session::new(client, power_up, Arc::clone(statuses), answers);
            session.serve(&mut jobs, stops).await;
            Ok(())
        }),
    };
    if let Err(failure) = served
        && let Some(job) = jobs.blocking_recv()
    {
        job.answer.send(Report::Over(Err(failure)));
    }
    lock(statuses).subscribers.clear();
}

async fn connect(at: Where, name: &str) -> Result<StationClient, Failure> {
    match at {
        Where::Virtual(setup) => Ok(StationClient::with_custom_virtual_arm(
            setup.arm(),
            setup.power_up,
            Policy::default(),
            name,
        )),
        Where::Station(search) => {
            let found = search.find().await.map_err(|error| lost(&error, None))?;
            let address = found.ok_or_else(|| Failure::LinkLost {
                text: "no station runs on this machine".to_owned(),
                hint: Some(
                    "start one with `dobot up`, or name its data folder in the environment variable DOBOT_DATA"
                        .to_owned(),
                ),
            })?;
            Ok(StationClient::connect(&address, name).await?)
        }
        Where::Local(arm) => {
            let client = StationClient::open(*arm, name).await;
            client.map_err(|error| lost(&error, None))
        }
    }
}
