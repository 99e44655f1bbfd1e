//! The latency of a stop while the arm draws.
//!
//! Measures the time from the call (`write` of a WebSocket client; `connect` of a client of `POST
//! /api/v1/stop`) to the last byte of the laser-off packet, with which every stop begins, at the
//! other end of the serial port. The station is a separate process, the arm a virtual one in real
//! time at a pseudo-terminal; it draws a job.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

use dobot_api::{JobKind, NewJob, Request};
use dobot_controller::Personality;
use dobot_wire::{Command, JointJog, JointJogAxis};

use super::support::{
    Arm, Port, START, StationProcess, Times, WebSocket, is_measuring, load, vector,
};

pub(crate) fn measure() {
    let stops = if is_measuring() { 100 } else { 2 };
    println!("{}", load());
    let arm = Arm::start(Personality::default());
    let station = StationProcess::start(&arm.port.path);
    let mut socket = WebSocket::connect(&station.http, "states=20");
    socket.take_control();
    let job = drawing(20 * stops + 100);
    let answer = socket.ask(&Request::SubmitJob { job, key: None });
    let job = answer["reply"]["job"]["job"].as_u64().expect("its number");
    let (mut by_socket, mut by_post) = (Vec::new(), Vec::new());
    for turn in 0..stops {
        draw(&mut socket, job, turn);
        if turn % 2 == 0 {
            by_socket.push(stop_by_socket(&mut socket, &arm.port));
        } else {
            by_post.push(stop_by_post(&station.http, &arm.port));
        }
        reset(&mut socket);
    }
    Times::new(by_socket).print("stop over the WebSocket (p99 at most 5 ms)");
    Times::new(by_post).print("POST /api/v1/stop (p99 at most 5 ms)");
    println!("{}", load());
}

/// Lets the arm draw for a while, so that a stop falls into any part of a vector.
fn draw(socket: &mut WebSocket, job: u64, turn: usize) {
    socket.ask(&Request::StartJob { job });
    socket.wait(|message| message["state"]["job"]["phase"] == "running");
    std::thread::sleep(Duration::from_millis(900 + (turn as u64 * 37) % 160));
}

fn stop_by_socket(socket: &mut WebSocket, port: &Port) -> Duration {
    let message = socket.message(&Request::Stop { reason: None });
    port.forget();
    let began = Instant::now();
    socket.send(message);
    let arrived = port.arrival_of(&laser_off());
    socket.answer();
    arrived.expect("the arm is told") - began
}

fn stop_by_post(station: &str, port: &Port) -> Duration {
    let request = format!(
        "POST /api/v1/stop HTTP/1.1\r\nHost: {station}\r\nContent-Length: 0\r\nConnection: close\r\n\r\n"
    );
    port.forget();
    let began = Instant::now();
    let mut stream = TcpStream::connect(station).expect("the station listens");
    stream.write_all(request.as_bytes()).expect("it reads");
    let arrived = port.arrival_of(&laser_off());
    let mut answer = String::new();
    stream.read_to_string(&mut answer).expect("it answers");
    assert!(answer.starts_with("HTTP/1.1 200"), "{answer}");
    arrived.expect("the arm is told") - began
}

/// Waits until the arm rests, and resets the stop.
fn reset(socket: &mut WebSocket) {
    socket.wait(|message| message["state"]["stop"]["at_rest"] == true);
    socket.ask(&Request::ResetStop);
}

/// A zigzag of strokes of 1 mm.
fn drawing(strokes: usize) -> NewJob {
    let ways = [[1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]];
    let vectors = ways.into_iter().cycle().take(strokes);
    let commands = std::iter::once(START.into()).chain(vectors.map(vector));
    NewJob {
        title: "zigzag".into(),
        kind: JobKind::Drawing,
        commands: commands.collect(),
        lift_mm: 0.0,
        pauses: Vec::new(),
        program: dobot_api::JobProgram::default(),
    }
}

fn laser_off() -> [u8; 42] {
    let command: Command = JointJog::new(JointJogAxis::LaserOff, 0.0).into();
    command.emit(&Personality::default().dialect()).to_bytes()
}
