//! The thread that owns the client of the rules.

use std::process;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use dobot_api::{Jog, Request, StationSearch};
use dobot_controller::PowerUp;
use dobot_draw::DrawingRequest;
use dobot_host::{LocalArm, StationClient};
use dobot_safety::Policy;
use dobot_sim::VirtualArm;
use dobot_wire::{Command, Status};
use tokio::sync::mpsc::{UnboundedReceiver, UnboundedSender, unbounded_channel};

use crate::failure::{Failure, failed, lost};
use crate::mailbox::{Mailbox, Teller};
use crate::program::{Run, Source};
use crate::session::Session;
use crate::virtual_arm::VirtualSetup;

/// Where the rules are kept.
pub(crate) enum Where {
    /// In this process, with an arm in virtual time.
    Virtual(Box<VirtualSetup>),
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
    Run(Box<Run>),
    /// Look at a program for this arm.
    Check(Arc<Source>),
    /// Look at the virtual arm of this process, or do something to it.
    Look(Box<Look>),
    /// Go on with the job that rests; a person has done what it waits for, or not.
    Resume {
        as_person: bool,
    },
    /// Give up the job that rests.
    Cancel,
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

/// Looks at a virtual arm, whose controller was switched on so; or why it cannot.
pub(crate) type Look = dyn FnOnce(&mut VirtualArm, PowerUp) -> Result<Outcome, String> + Send;

/// What comes of it.
pub(crate) type Answer = Result<Outcome, Failure>;

/// What is told at the end.
pub(crate) enum Outcome {
    Nothing,
    /// The arm's last status.
    Status(Status),
    /// A JSON value.
    Json(String),
}

/// What is heard of an operation.
pub(crate) enum Told {
    Progress(Progress),
    Over(Answer),
}

/// How far a job is.
#[derive(Clone, Copy)]
pub(crate) enum Progress {
    /// So many commands of so many are over.
    Commands { completed: usize, commands: usize },
    /// It is at this step of so many, in this cycle of so many; all of them are counted from 1.
    Steps {
        step: usize,
        steps: usize,
        cycle: u64,
        cycles: Option<u64>,
    },
}

/// An operation, and who hears of it.
pub(crate) struct Job {
    pub(crate) operation: Operation,
    pub(crate) answer: Teller<Told>,
}

/// That the arm is to stop, and who hears of it.
pub(crate) struct Stop {
    pub(crate) reason: Option<String>,
    pub(crate) answer: Teller<Told>,
}

struct Doors {
    jobs: UnboundedSender<Job>,
    stops: UnboundedSender<Stop>,
}

/// Those who want to hear every status.
pub(crate) type Ears = Arc<Mutex<Vec<Teller<Status>>>>;

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

pub(crate) fn lock<T>(it: &Mutex<T>) -> MutexGuard<'_, T> {
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
            let power_up = match &at {
                Where::Virtual(setup) => Some(setup.power_up),
                Where::Station(_) | Where::Local(_) => None,
            };
            let client = connect(at, name).await?;
            let session = Session::new(client, power_up, Arc::clone(ears));
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
        Where::Virtual(setup) => Ok(StationClient::with_custom_virtual_arm(
            setup.arm(),
            setup.power_up,
            Policy::default(),
            name,
        )),
        Where::Station(search) => {
            let found = search.find().await.map_err(|it| lost(&it, None))?;
            let address = found.ok_or_else(|| Failure::LinkLost {
                text: "no station runs on this machine".to_owned(),
                hint: Some("`dobot up` starts one".to_owned()),
            })?;
            Ok(StationClient::connect(&address, name).await?)
        }
        Where::Local(arm) => {
            let client = StationClient::open(*arm, name).await;
            client.map_err(|it| lost(&it, None))
        }
    }
}
