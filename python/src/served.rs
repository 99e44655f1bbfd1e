//! Virtual arms for programs that speak serial: on a port of their own, by a clock.

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

/// A virtual arm on a virtual serial port and on TCP, run by a thread of its own.
#[pyclass(frozen)]
pub(crate) struct Served {
    asked: Mutex<Option<UnboundedSender<Sender<Option<String>>>>>,
    thread: Mutex<Option<JoinHandle<()>>>,
    events: Events,
    #[pyo3(get)]
    serial: Option<String>,
    #[pyo3(get)]
    tcp: String,
    /// The process whose thread it is; a fork of it has none.
    pid: u32,
}

/// What was told, the oldest first.
type Events = Arc<Mutex<Vec<String>>>;

#[pymethods]
impl Served {
    #[new]
    fn new(
        py: Python<'_>,
        personality: &str,
        scene: Option<&str>,
        faults: Vec<String>,
        seed: u64,
        factor: &str,
    ) -> PyResult<Self> {
        let arm = VirtualSetup::new(personality, scene, &faults, seed)?;
        let factor: Speed = factor.parse().map_err(|error| value_error(&error))?;
        let events = Events::default();
        let (asked, questions) = unbounded_channel();
        let (tell, told) = channel();
        let heard = Arc::clone(&events);
        let thread = thread::spawn(move || serve(&arm, factor, questions, &tell, &heard));
        let places = py.detach(move || told.recv());
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

    /// What is around it, as JSON, and nothing where nothing is.
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

    /// What was refused, and which faults struck, each a sentence, the oldest first.
    #[getter]
    fn events(&self) -> Vec<String> {
        lock(&self.events).clone()
    }

    /// Switches it off.
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

/// Where it is served: a virtual serial port, where the system has them, and TCP.
type Places = (Option<String>, String);

fn serve(
    setup: &VirtualSetup,
    speed: Speed,
    mut asks: UnboundedReceiver<Sender<Option<String>>>,
    tell: &Sender<io::Result<Places>>,
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
            let _ = tell.send(Err(error));
            return;
        }
    };
    let _ = tell.send(Ok(places));
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
        ServerEvent::Refused(it) => it.to_string(),
        ServerEvent::Struck(it) => it.to_string(),
        ServerEvent::Overrun => "the program sends faster than the line carries".to_owned(),
        _ => return,
    };
    lock(events).push(text);
}
