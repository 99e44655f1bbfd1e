//! A served arm, over real pseudo-terminals and real TCP connections, in real time.

#![cfg(unix)]

#[path = "../common/mod.rs"]
mod common;

mod at_the_greatest_speed;
mod in_time;
mod links;
mod on_a_virtual_serial_port;
mod on_both;
mod over_tcp;
mod with_faults;

use std::fs::{File, OpenOptions};
use std::future::Future;
use std::io::Write;
use std::net::{Ipv4Addr, SocketAddr};
use std::os::unix::fs::symlink;
use std::path::Path;
use std::time::Duration;

use common::{POWER_UP_X_MM, button, move_to, ms, virtual_arm};
use dobot_controller::PowerUp;
use dobot_session::{Connection, plausible};
use dobot_sim::{FaultEffect, Pty, Server, ServerEvent, Speed};
use dobot_wire::{Command, Decoder, Dialect, JointJogAxis, MoveTo, MovingMode, Status};
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::mpsc::{UnboundedReceiver, unbounded_channel};

/// What the server tells.
struct ServerEvents(UnboundedReceiver<ServerEvent>);

impl ServerEvents {
    /// Waits for an event and skips those before it.
    async fn until(&mut self, wanted: impl Fn(&ServerEvent) -> bool) -> ServerEvent {
        loop {
            let event = self.0.recv().await.expect("the server runs");
            if wanted(&event) {
                return event;
            }
        }
    }

    async fn refusal(&mut self) {
        self.until(|it| matches!(it, ServerEvent::Refused(_))).await;
    }

    async fn disconnected(&mut self) {
        self.until(|it| *it == ServerEvent::Disconnected).await;
    }
}

/// Serves the arm while a test does something with it.
async fn serve<F: Future<Output = ()>>(server: &mut Server, test: impl FnOnce(ServerEvents) -> F) {
    let (sender, events) = unbounded_channel();
    tokio::select! {
        ended = server.run(|event| {
            // A test that has seen enough listens no more.
            let _ = sender.send(event);
        }) => panic!("the server ended: {ended:?}"),
        () = test(ServerEvents(events)) => {}
        () = tokio::time::sleep(HANGS) => panic!("the test hangs"),
    }
}

async fn listen() -> (TcpListener, SocketAddr) {
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0))
        .await
        .expect("a port is free");
    let address = listener.local_addr().expect("it is bound");
    (listener, address)
}

/// A served arm on TCP.
async fn on_tcp() -> (Server, SocketAddr) {
    let (listener, address) = listen().await;
    (Server::new(virtual_arm()).on_tcp(listener), address)
}

/// A served arm on a virtual serial port, and its name.
fn on_pty() -> (Server, String) {
    let pty = Pty::open(None).expect("there is one more");
    let path = pty.path().to_str().expect("the name is text").to_owned();
    (Server::new(virtual_arm()).on_pty(pty), path)
}

async fn connect(address: &str) -> Connection {
    let address = address.parse().expect("it is an address");
    let mut arm = Connection::open(&address, Some(Dialect::SPECIFICATION))
        .await
        .expect("it can be opened");
    arm.session_mut().confirm_pose();
    arm
}

fn bytes(command: impl Into<Command>) -> [u8; 42] {
    command.into().emit(&Dialect::SPECIFICATION).to_bytes()
}

fn there() -> MoveTo {
    move_to(MovingMode::MovL, 250.0, 10.0, 0.0)
}

/// What the controller refuses, and so says that it has come to it.
fn marker() -> [u8; 42] {
    bytes(move_to(MovingMode::MovL, 900.0, 0.0, 0.0))
}

fn plain_open(path: &str) -> File {
    OpenOptions::new()
        .read(true)
        .write(true)
        .open(path)
        .expect("it is there")
}

#[track_caller]
fn assert_at(status: &Status, x_mm: f32, y_mm: f32, z_mm: f32) {
    for (found, expected) in [
        (status.x_mm, x_mm),
        (status.y_mm, y_mm),
        (status.z_mm, z_mm),
    ] {
        let tolerance = 1e-3;
        assert!(
            (found - expected).abs() < tolerance,
            "{found} is not {expected}, tolerance {tolerance}: {status:?}"
        );
    }
}

/// Reads that many statuses, of which none is damaged; the first bytes may be the end of one.
async fn read_statuses(mut from: impl AsyncReadExt + Unpin, count: usize) -> Vec<Status> {
    let mut decoder = Decoder::statuses(plausible);
    let mut statuses = Vec::new();
    let mut skipped = None;
    while statuses.len() < count {
        // Never more than one packet, so that none comes beyond those asked for.
        let mut some = [0; 42];
        let len = from.read(&mut some).await.expect("the link is open");
        assert!(len > 0, "closed after {statuses:?}");
        let frames: Vec<_> = decoder.feed(&some[..len]).collect();
        statuses.extend(
            frames
                .iter()
                .map(|it| Status::parse(it).expect("it is one")),
        );
        if !frames.is_empty() {
            let now = decoder.counts().skipped_bytes;
            assert_eq!(*skipped.get_or_insert(now), now, "bytes were lost");
            assert!(now < 42, "{now} bytes before the first status");
        }
    }
    statuses
}

/// Nothing here takes nearly as long.
const HANGS: Duration = Duration::from_secs(60);
