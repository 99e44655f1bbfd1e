//! Virtual arms for programs that use a serial port, in real time.

use std::net::Ipv4Addr;
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, Mutex};
use std::thread::{self, JoinHandle};
use std::{io, process};

use dobot_sim::{Server, ServerEvent, Speed};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use tokio::net::TcpListener;
use tokio::sync::mpsc::{UnboundedReceiver, UnboundedSender, unbounded_channel};

use crate::failure::value_error;
use crate::virtual_arm::{VirtualSetup, world_json};
use crate::worker::lock;

/// A virtual arm on a virtual serial port and on TCP, run by a worker thread.
#[pyclass(frozen)]
pub(crate) struct Served {
    asked: Mutex<Option<UnboundedSender<Sender<Option<String>>>>>,
    thread: Mutex<Option<JoinHandle<()>>>,
    events: Events,
    #[pyo3(get)]
    serial: Option<String>,
    #[pyo3(get)]
    tcp: String,
    /// The process of the thread; a fork of it has no thread.
    pid: u32,
}

/// The events, the oldest first.
type Events = Arc<Mutex<Vec<String>>>;

#[pymethods]
impl Served {
    #[expect(
        clippy::similar_names,
        reason = "the names are those of Python's arguments"
    )]
    #[new]
    fn new(
        py: Python<'_>,
        personality: &str,
        scene: Option<&str>,
        faults: Vec<String>,
        seed: u64,
        speed: &str,
    ) -> PyResult<Self> {
        let arm = VirtualSetup::new(personality, scene, &faults, seed)?;
        let speed: Speed = speed.parse().map_err(|error| value_error(&error))?;
        let events = Events::default();
        let (asked, questions) = unbounded_channel();
        let (sender, places) = channel();
        let shared = Arc::clone(&events);
        let thread = thread::spawn(move || serve(&arm, speed, questions, &sender, &shared));
        let places = py.detach(move || places.recv());
        let places = places.map_err(|_| PyRuntimeError::new_err("its thread has ended"))?;
        let (serial, tcp) = places?;
        Ok(Self {
            asked: Mutex::new(Some(asked)),
            thread: Mutex::new(Some(thread)),
            events,
            serial,
            tcp,
            pid: process::id(),
        })
    }

    /// Returns the world as JSON; `None` if there is none.
    fn world(&self, py: Python<'_>) -> Option<String> {
        if process::id() != self.pid {
            return None;
        }
        py.detach(|| {
            let (answer, answered) = channel();
            let asked = lock(&self.asked).as_ref()?.send(answer).ok();
            asked.and_then(|()| answered.recv().ok().flatten())
        })
    }

    /// Returns refusals and faults, a sentence each, the oldest first.
    #[getter]
    fn events(&self) -> Vec<String> {
        lock(&self.events).clone()
    }

    /// Switches the arm off.
    fn close(&self, py: Python<'_>) {
        if process::id() != self.pid {
            return;
        }
        py.detach(|| {
            drop(lock(&self.asked).take());
            let thread = lock(&self.thread).take();
            if let Some(thread) = thread {
                let _ = thread.join();
            }
        });
    }
}

/// Its addresses: a virtual serial port, if the system has them, and TCP.
type Places = (Option<String>, String);

fn serve(
    setup: &VirtualSetup,
    speed: Speed,
    mut asks: UnboundedReceiver<Sender<Option<String>>>,
    sender: &Sender<io::Result<Places>>,
    events: &Events,
) {
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build();
    let begun = runtime.and_then(|runtime| {
        let begun = runtime.block_on(open(setup, speed))?;
        Ok((runtime, begun))
    });
    let (runtime, mut server, places) = match begun {
        Ok((runtime, (server, places))) => (runtime, server, places),
        Err(error) => {
            let _ = sender.send(Err(error));
            return;
        }
    };
    let _ = sender.send(Ok(places));
    runtime.block_on(async {
        loop {
            let asked = tokio::select! {
                biased;
                asked = asks.recv() => asked,
                _ = server.run(|event| note(events, &event)) => None,
            };
            let Some(answer) = asked else { return };
            let _ = answer.send(world_json(server.arm()));
        }
    });
}

async fn open(setup: &VirtualSetup, speed: Speed) -> io::Result<(Server, Places)> {
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).await?;
    let tcp = format!("tcp:{}", listener.local_addr()?);
    let server = Server::new(setup.arm()).at_speed(speed).on_tcp(listener);
    #[cfg(unix)]
    let (server, serial) = {
        let pty = dobot_sim::Pty::open(None)?;
        let serial = pty.path().display().to_string();
        (server.on_pty(pty), Some(serial))
    };
    #[cfg(not(unix))]
    let serial = None;
    Ok((server, (serial, tcp)))
}

fn note(events: &Events, event: &ServerEvent) {
    let text = match event {
        ServerEvent::Refused(refusal) => refusal.to_string(),
        ServerEvent::Struck(fault) => fault.to_string(),
        ServerEvent::Overrun => "the program sends faster than the line carries".to_owned(),
        _ => return,
    };
    lock(events).push(text);
}
