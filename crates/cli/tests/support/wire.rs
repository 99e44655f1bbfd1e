//! A wire between a station and its arm that records the packets.

use std::io::{ErrorKind, Read, Write};
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread;
use std::time::Instant;

use dobot_wire::{Command, Decoder, Dialect, Status};

/// What passes the wire, and when.
#[derive(Debug)]
pub(crate) enum Passed {
    /// The way to the arm was opened.
    Opened,
    ToArm(Instant, Command),
    FromArm(Instant, Status),
    /// The station's end was closed: nothing passes to the arm any more.
    Closed,
}

/// A wire to the arm that records the packets.
pub(crate) fn wire(arm: SocketAddr) -> (SocketAddr, Receiver<Passed>) {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let address = listener.local_addr().expect("it has an address");
    let (sender, passed) = mpsc::channel();
    thread::spawn(move || {
        for station in listener.incoming() {
            let station = station.expect("it comes");
            let arm = TcpStream::connect(arm).expect("the arm is there");
            send_all(&sender, [Passed::Opened]);
            let (from, to) = (arm.try_clone(), station.try_clone());
            let (from, to) = (from.expect("a handle"), to.expect("a handle"));
            let (forward, back) = (sender.clone(), sender.clone());
            thread::spawn(move || {
                let mut decoder = Decoder::statuses(|_| true);
                copy(from, to, |bytes| {
                    let frames = decoder.feed(bytes);
                    let statuses = frames.filter_map(|frame| Status::parse(&frame).ok());
                    send_all(
                        &back,
                        statuses.map(|status| Passed::FromArm(Instant::now(), status)),
                    );
                });
            });
            thread::spawn(move || {
                let mut decoder = Decoder::commands();
                copy(station, arm, |bytes| {
                    let packets = decoder.feed(bytes);
                    let parse = |packet| Command::parse(&packet, &Dialect::SPECIFICATION).ok();
                    let commands = packets.filter_map(parse);
                    send_all(
                        &forward,
                        commands.map(|command| Passed::ToArm(Instant::now(), command)),
                    );
                });
                send_all(&forward, [Passed::Closed]);
            });
        }
    });
    (address, passed)
}

fn send_all(sender: &Sender<Passed>, all: impl IntoIterator<Item = Passed>) {
    for passed in all {
        // A finished test no longer listens.
        let _ = sender.send(passed);
    }
}

/// Carries bytes until one end is gone, and closes the other one.
fn copy(mut from: TcpStream, mut to: TcpStream, mut look: impl FnMut(&[u8])) {
    let mut bytes = [0; 4096];
    loop {
        let read = match from.read(&mut bytes) {
            Err(error) if error.kind() == ErrorKind::Interrupted => continue,
            Ok(0) | Err(_) => break,
            Ok(read) => read,
        };
        look(&bytes[..read]);
        if to.write_all(&bytes[..read]).is_err() {
            break;
        }
    }
    let _ = to.shutdown(std::net::Shutdown::Both);
    let _ = from.shutdown(std::net::Shutdown::Both);
}
