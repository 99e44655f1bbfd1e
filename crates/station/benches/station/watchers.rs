//! A thousand watching clients: losses, latency, and cost.
//!
//! A station in a separate process has an arm at a pseudo-terminal that sends 12.5 statuses per
//! second. 1000 WebSocket clients, all in one thread of this process, get a state for each. The
//! latency is the time from the arm's writing of a status to a client's reading of its state. The
//! station's share of a core is that of its process.

use std::collections::HashMap;
use std::time::{Duration, Instant};

use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};

use super::support::{
    CountingArm, Crowd, StationProcess, Times, Watched, WebSocket, cpu_time, is_measuring, load,
};

pub(crate) fn measure() {
    let (clients, time) = if is_measuring() {
        (1000, Duration::from_secs(30))
    } else {
        (20, Duration::from_secs(1))
    };
    println!("{}", load());
    allow_descriptors();
    let arm = CountingArm::start();
    let station = StationProcess::start(&arm.port.path);
    let mut first = WebSocket::connect(&station.http, "notices=false");
    first.wait(|message| message["state"]["link"]["phase"] == "up");
    let crowd = Crowd::gather(clients, &station.http, "notices=false");
    // Lets all clients settle.
    std::thread::sleep(SETTLE);
    let (began, station_before, own_before) = (Instant::now(), cpu_time(station.pid()), own());
    std::thread::sleep(time);
    let (ended, station_after, own_after) = (Instant::now(), cpu_time(station.pid()), own());
    std::thread::sleep(SETTLE);
    let watched = crowd.leave();
    let sent = arm.end();
    let (lost, late) = judge(&watched, &sent, (began, ended));
    let dropped = watched.iter().filter(|watcher| watcher.dropped).count();
    println!("{clients} clients, {dropped} dropped, {lost} states lost");
    Times::new(late).print("from the arm's status to a client's state");
    let share = |cpu: Duration| 100.0 * cpu.as_secs_f64() / (ended - began).as_secs_f64();
    println!(
        "share of a core: station {:.0} % (at most 100 %), clients and arm {:.0} %",
        share(station_after.saturating_sub(station_before)),
        share(own_after.saturating_sub(own_before))
    );
    println!("{}", load());
    assert_eq!((lost, dropped), (0, 0), "nothing is to be lost");
}

/// Returns the number of lost states of that time, and the latency of each of the others.
fn judge(
    watched: &[Watched],
    sent: &[Instant],
    (began, ended): (Instant, Instant),
) -> (usize, Vec<Duration>) {
    let (mut lost, mut late) = (0, Vec::new());
    for client in watched {
        let mut seen = HashMap::new();
        for (at, number) in &client.states {
            // A repeated state, with other news, does not count.
            seen.entry(*number).or_insert(*at);
        }
        for (number, sent) in (0..).zip(sent) {
            if !(began..ended).contains(sent) {
                continue;
            }
            match seen.get(&number) {
                Some(at) => late.push(at.duration_since(*sent)),
                None => lost += 1,
            }
        }
    }
    (lost, late)
}

fn own() -> Duration {
    cpu_time(std::process::id())
}

/// Raises the limit of descriptors of this process and its station to the system's maximum.
fn allow_descriptors() {
    let Rlimit { maximum, .. } = getrlimit(Resource::Nofile);
    let all = Rlimit {
        current: maximum,
        maximum,
    };
    setrlimit(Resource::Nofile, all).expect("up to the maximum is allowed");
}

const SETTLE: Duration = Duration::from_millis(500);
