//! A drawing over TCP, and what may happen to it on the way.

use std::io::{Read, Write};
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::process::Stdio;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;

use dobot_wire::{Command, Decoder, Dialect, JointJogAxis, WriteVector};
use rustix::process::{Pid, Signal, kill_process};

use super::arm::real_time_arm;
use super::program::{Outcome, command, example};

/// What happens to a drawing between the program and the arm.
#[derive(Clone, Copy)]
pub(crate) enum Trouble {
    /// The program gets a signal.
    Signal(Signal),
    /// No status reaches it any more.
    Silence,
}

/// A relay between the program and a virtual arm that causes trouble after this many write vectors.
/// Returns what came of the program, the commands before that and those after it.
pub(crate) fn troubled(vectors: usize, trouble: Trouble) -> (Outcome, Vec<Command>, Vec<Command>) {
    let mut arm = real_time_arm(&["--tcp", "127.0.0.1:0"]);
    let arm_address: SocketAddr = arm.address()[4..].parse().expect("it is one");
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let address = format!("tcp:{}", listener.local_addr().expect("it is bound"));
    // Its vectors are short: an arm may be silent for as long as those take that it has.
    let drawing = example("rosette.svg");
    let child = command(&[
        "draw",
        &drawing,
        "--to",
        &address,
        "--dialect",
        "specification",
        "--pose-confirmed",
    ])
    .stdout(Stdio::piped())
    .stderr(Stdio::piped())
    .spawn()
    .expect("the program starts");
    let pid = Pid::from_child(&child);
    let (mut client, _) = listener.accept().expect("the program connects");
    // It finds no listener when it connects again.
    drop(listener);
    let mut server = TcpStream::connect(arm_address).expect("the arm is served");
    let silent = Arc::new(AtomicBool::new(false));
    let back = (server.try_clone(), client.try_clone(), Arc::clone(&silent));
    thread::spawn(move || {
        pass_on(
            back.0.expect("it is open"),
            back.1.expect("it is open"),
            &back.2,
        );
    });
    let (mut before, mut after) = (Vec::new(), Vec::new());
    let mut packet = [0; 42];
    while client.read_exact(&mut packet).is_ok() {
        server.write_all(&packet).expect("the arm is served");
        let command = commands(&packet).remove(0);
        if before.iter().filter_map(vector).count() == vectors {
            after.push(command);
            continue;
        }
        before.push(command);
        if before.iter().filter_map(vector).count() == vectors {
            match trouble {
                Trouble::Signal(signal) => kill_process(pid, signal).expect("it runs"),
                Trouble::Silence => silent.store(true, Ordering::SeqCst),
            }
        }
    }
    let output = child.wait_with_output().expect("the program ends");
    (output.into(), before, after)
}

/// Passes on what comes, until it is to be silent.
fn pass_on(mut from: TcpStream, mut to: TcpStream, silent: &AtomicBool) {
    let mut bytes = [0; 256];
    while let Ok(count @ 1..) = from.read(&mut bytes) {
        if !silent.load(Ordering::SeqCst) && to.write_all(&bytes[..count]).is_err() {
            return;
        }
    }
}

pub(crate) fn commands(bytes: &[u8]) -> Vec<Command> {
    Decoder::commands()
        .feed(bytes)
        .map(|packet| Command::parse(&packet, &Dialect::SPECIFICATION).expect("it is allowed"))
        .collect()
}

pub(crate) fn is_laser_off(command: &Command) -> bool {
    matches!(command, Command::JointJog(jog) if jog.axis == JointJogAxis::LaserOff)
}

pub(crate) fn vector(command: &Command) -> Option<&WriteVector> {
    match command {
        Command::WriteVector(vector) => Some(vector),
        _ => None,
    }
}
