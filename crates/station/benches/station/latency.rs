//! The latency that the station adds between a command and the serial port, compared with a plain
//! byte bridge.
//!
//! Measures the time from a client's call of `write` to the last of the 42 bytes at the other end
//! of the serial port (a pseudo-terminal), alternately through the station's WebSocket, its raw
//! port, and `socat`. Station and `socat` are separate processes. The station checks every command
//! against the policy, records it, and has 100 clients that watch 12.5 states per second. The arm
//! is a virtual one in real time; the commands are vectors of 0.2 mm, which finish before the next
//! one is sent, so that each finds a permit.

use std::io::Write;
use std::net::{TcpListener, TcpStream};
use std::process::{Child, Command as Program, Stdio};
use std::time::{Duration, Instant};

use dobot_api::Request;
use dobot_controller::Personality;
use dobot_wire::{Command, Dialect};

use super::support::{
    Arm, Crowd, Port, START, StationProcess, Times, WebSocket, is_measuring, load, vector,
};

const CROWD: usize = 100;

pub(crate) fn measure() {
    let samples = if is_measuring() { 1000 } else { 5 };
    let crowd = if is_measuring() { CROWD } else { 3 };
    println!("{}", load());
    let arm = Arm::start(Personality::default());
    let station = StationProcess::start(&arm.port.path);
    let mut socket = WebSocket::connect(&station.http, "states=1");
    get_ready(&mut socket);
    let crowd = Crowd::gather(crowd, &station.http, "states=12.5&notices=false");
    let mut bridge = Bridge::start();
    let mut words = Words::new();
    let in_turn = |way: &mut dyn Way, bridge: &mut Option<Bridge>, words: &mut Words| {
        (0..samples)
            .map(|turn| one_turn(turn, way, bridge.as_mut(), words))
            .unzip::<_, _, Vec<_>, Vec<_>>()
    };
    let mut by_socket = BySocket(socket, &arm.port);
    let web = in_turn(&mut by_socket, &mut bridge, &mut words);
    by_socket.0.ask(&Request::ReleaseLease);
    let mut by_raw = ByTcp(connect(station.raw), &arm.port);
    let raw = in_turn(&mut by_raw, &mut bridge, &mut words);
    report("WebSocket", web);
    report("raw port", raw);
    let watched = crowd.leave();
    assert!(
        watched.iter().all(|watched| !watched.dropped),
        "nobody was dropped"
    );
    println!("{}", load());
}

/// One command through the station and one through the bridge, in alternating order.
fn one_turn(
    turn: usize,
    way: &mut dyn Way,
    mut bridge: Option<&mut Bridge>,
    words: &mut Words,
) -> (Duration, Option<Duration>) {
    let command = words.next();
    // Statuses arrive every 80 ms; the pauses cover all phases of that period.
    let pause = Duration::from_millis(50 + (turn as u64 * 7) % 20);
    let mut beside = None;
    if turn.is_multiple_of(2) {
        std::thread::sleep(pause);
        beside = bridge.as_mut().map(|bridge| bridge.way.time(&command));
    }
    std::thread::sleep(pause);
    let time = way.time(&command);
    if turn % 2 == 1 {
        std::thread::sleep(pause);
        beside = bridge.as_mut().map(|bridge| bridge.way.time(&command));
    }
    // A status permits one command: the next one is sent more than a period after this.
    std::thread::sleep(Duration::from_millis(40));
    (time, beside)
}

fn report(what: &str, (through, beside): (Vec<Duration>, Vec<Option<Duration>>)) {
    let through = Times::new(through);
    through.print(&format!("through the station's {what}"));
    let beside: Vec<_> = beside.into_iter().flatten().collect();
    if beside.is_empty() {
        return;
    }
    let beside = Times::new(beside);
    beside.print("through socat");
    let ratio = |a: Duration, b: Duration| a.as_secs_f64() / b.as_secs_f64();
    println!(
        "the station's {what} to socat: median {:.2} (at most 2), p99 {:.2} (at most 3)",
        ratio(through.median(), beside.median()),
        ratio(through.p99(), beside.p99()),
    );
}

/// A path for a command to a serial port.
trait Way {
    /// Returns the time of one command.
    fn time(&mut self, command: &Command) -> Duration;
}

struct BySocket<'a>(WebSocket, &'a Port);

impl Way for BySocket<'_> {
    fn time(&mut self, command: &Command) -> Duration {
        let request = Request::Command { command: *command };
        let message = self.0.message(&request);
        let packet = command.emit(&dialect()).to_bytes();
        self.1.forget();
        let began = Instant::now();
        self.0.send(message);
        let arrived = self.1.arrival_of(&packet);
        let answer = self.0.answer();
        assert!(answer["problem"].is_null(), "{answer}");
        arrived.expect("the packet arrives") - began
    }
}

struct ByTcp<'a>(TcpStream, &'a Port);

impl Way for ByTcp<'_> {
    fn time(&mut self, command: &Command) -> Duration {
        time_tcp(&mut self.0, self.1, command)
    }
}

fn time_tcp(stream: &mut TcpStream, port: &Port, command: &Command) -> Duration {
    let packet = command.emit(&dialect()).to_bytes();
    port.forget();
    let began = Instant::now();
    stream.write_all(&packet).expect("somebody listens");
    port.arrival_of(&packet).expect("the packet arrives") - began
}

/// `socat` between a TCP port and a serial port.
struct Bridge {
    child: Child,
    way: OwnTcp,
}

struct OwnTcp(TcpStream, Port);

impl Way for OwnTcp {
    fn time(&mut self, command: &Command) -> Duration {
        time_tcp(&mut self.0, &self.1, command)
    }
}

impl Bridge {
    /// Starts it, if it is installed.
    fn start() -> Option<Self> {
        let port = Port::open(None);
        let free = TcpListener::bind("127.0.0.1:0").and_then(|listener| listener.local_addr());
        let free = free.expect("there is a free port");
        let child = Program::new("socat")
            .arg(format!("TCP-LISTEN:{},bind=127.0.0.1,nodelay", free.port()))
            .arg(format!("OPEN:{},raw,echo=0", port.path))
            .stdin(Stdio::null())
            .spawn();
        let Ok(child) = child else {
            println!("socat is not installed, no comparison (apt-get install socat)");
            return None;
        };
        let way = OwnTcp(connect(free), port);
        Some(Self { child, way })
    }
}

impl Drop for Bridge {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Connects to a program that is about to listen.
fn connect(address: std::net::SocketAddr) -> TcpStream {
    for _ in 0..500 {
        if let Ok(stream) = TcpStream::connect(address) {
            stream.set_nodelay(true).expect("it is TCP");
            return stream;
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    panic!("nobody listens at {address}");
}

/// Waits for the arm, and moves it to a position where it can write.
fn get_ready(socket: &mut WebSocket) {
    socket.take_control();
    let command = START.into();
    let answer = socket.ask(&Request::Command { command });
    let number = answer["reply"]["command"].clone();
    socket.wait(|message| {
        let news = &message["notice"];
        assert_ne!(news["type"], "command_failed", "{message}");
        news["type"] == "command_done" && news["command"] == number
    });
}

/// Commands of which no two in a row are equal.
struct Words(u32);

impl Words {
    const fn new() -> Self {
        Self(0)
    }

    fn next(&mut self) -> Command {
        self.0 += 1;
        let x_mm = if self.0.is_multiple_of(2) { 0.2 } else { -0.2 };
        vector([x_mm, 0.0])
    }
}

fn dialect() -> Dialect {
    Personality::default().dialect()
}
