//! Stops of all arms, and their packets.

use std::error::Error;
use std::time::{Duration, Instant};

use dobot_api::{JobKind, JobProgram, MemberAnswer, NewJob, Reply, Request, State, StationAddress};
use dobot_arm::Tool;
use dobot_host::{Client, PassedPacket, StationHandle};
use dobot_motion::LASER_OFF;
use dobot_wire::{Command, Configuration, Dialect, MoveTo, MovingMode, WriteVector};
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpStream;
use tokio::sync::broadcast::Receiver;
use tokio::task::JoinSet;
use tokio::time::timeout;

use super::stations::Stations;
use super::times::Times;

/// Stops all arms this many times while they rest.
pub(crate) async fn at_rest(
    stations: &Stations,
    presses: usize,
) -> Result<(), Box<dyn Error + Send + Sync>> {
    let mut times = Vec::new();
    for _ in 0..presses {
        times.push(press(stations).await?);
        each(stations, |teacher| async move { let_move(&teacher).await }).await?;
    }
    print("stop all, arms at rest", &times);
    Ok(())
}

/// Stops all arms this many times while each laser is on.
pub(crate) async fn while_all_burn(
    stations: &Stations,
    presses: usize,
) -> Result<(), Box<dyn Error + Send + Sync>> {
    let mut times = Vec::new();
    for _ in 0..presses {
        let mut burning = each(stations, |teacher| async move {
            let job = burn(&teacher).await?;
            Ok((teacher, job))
        })
        .await?;
        times.push(press(stations).await?);
        for (teacher, job) in burning.drain(..) {
            let_move(&teacher).await?;
            teacher.request(Request::CancelJob { job }).await?;
        }
    }
    print("stop all, all lasers burning", &times);
    Ok(())
}

fn print(what: &str, presses: &[Press]) {
    if presses.is_empty() {
        return;
    }
    let all = presses
        .iter()
        .flat_map(|press| press.packets.clone())
        .collect();
    Times::new(all).print(&format!("{what}: each laser-off packet"));
    let last = presses
        .iter()
        .filter_map(|press| press.packets.iter().max().copied());
    Times::new(last.collect()).print(&format!("{what}: the last one"));
    let answered = presses.iter().map(|press| press.answered);
    Times::new(answered.collect()).print(&format!("{what}: the response"));
    let silent: usize = presses.iter().map(|press| press.silent).sum();
    if silent > 0 {
        let asked: usize = presses.iter().map(|press| press.packets.len()).sum();
        println!(
            "{what}: {silent} of {asked} stopped after the response reported them as unreachable"
        );
    }
}

/// The result of a stop of all arms; times count from before the connection to the station.
struct Press {
    /// When each arm's line was given its laser-off packet.
    packets: Vec<Duration>,
    /// When the response with all members arrived.
    answered: Duration,
    /// The number of members that had not responded by then.
    silent: usize,
}

/// The timeout for the last packet, on a busy computer.
const STOPS_WITHIN: Duration = Duration::from_secs(60);

/// Stops all arms once, through the first station.
async fn press(stations: &Stations) -> Result<Press, Box<dyn Error + Send + Sync>> {
    let mut listening = JoinSet::new();
    for desk in &stations.all {
        listening.spawn(laser_off(desk.station.handle().passed()));
    }
    let first = stations.first();
    let began = Instant::now();
    let answers = stop(&first).await?;
    let answered = began.elapsed();
    let failed = answers.iter().filter(|answer| !answer.answer.is_success());
    let (late, refused): (Vec<_>, Vec<_>) = failed.partition(|answer| is_late(answer));
    if let [first, ..] = &*refused {
        return Err(format!("{} refused the stop, for example {first:?}", refused.len()).into());
    }
    if answers.len() != stations.all.len() {
        return Err(format!(
            "{} of {} received the request",
            answers.len(),
            stations.all.len()
        )
        .into());
    }
    let arrived = timeout(STOPS_WITHIN, listening.join_all()).await;
    let arrived = arrived.map_err(|_| "an arm got no laser-off packet")?;
    let arrived: Option<Vec<_>> = arrived.into_iter().collect();
    let arrived = arrived.ok_or("packets were missed")?;
    Ok(Press {
        packets: arrived.into_iter().map(|at| at - began).collect(),
        answered,
        silent: late.len(),
    })
}

/// Whether a station did not respond in time; it may stop later.
fn is_late(answer: &MemberAnswer) -> bool {
    answer.answer.body["type"] == "/api/v1/problems/member-away"
}

/// Waits for the response without a timeout: with a thousand stations on two cores it takes longer
/// than that of a client.
async fn stop(station: &StationAddress) -> Result<Vec<MemberAnswer>, Box<dyn Error + Send + Sync>> {
    let (host, port) = (station.host(), station.port());
    let body = r#"{"reason": "a fire drill"}"#;
    let request = format!(
        "POST /api/v1/fleet/stop HTTP/1.1\r\nHost: {host}:{port}\r\nContent-Type: application/json\r\nContent-Length: {}\r\nConnection: close\r\n\r\n{body}",
        body.len()
    );
    let mut stream = TcpStream::connect((host, port)).await?;
    stream.write_all(request.as_bytes()).await?;
    let mut answer = String::new();
    stream.read_to_string(&mut answer).await?;
    let (_, answer) = answer.split_once("\r\n\r\n").ok_or("no answer")?;
    Ok(serde_json::from_str(answer)?)
}

/// Returns when the laser-off packet was handed to the arm's line.
async fn laser_off(mut packets: Receiver<PassedPacket>) -> Option<Instant> {
    let wanted = LASER_OFF.emit(&Dialect::SPECIFICATION).to_bytes();
    while let Ok(packet) = packets.recv().await {
        if packet.to_arm && packet.bytes == wanted {
            return Some(Instant::now());
        }
    }
    None
}

/// Runs something with the teacher's token at each station, concurrently.
async fn each<T, F>(
    stations: &Stations,
    does: impl Fn(Client) -> F,
) -> Result<Vec<T>, Box<dyn Error + Send + Sync>>
where
    T: Send + 'static,
    F: Future<Output = Result<T, Box<dyn Error + Send + Sync>>> + Send + 'static,
{
    let mut doing = JoinSet::new();
    for desk in &stations.all {
        doing.spawn(does(desk.teacher().await?));
    }
    doing.join_all().await.into_iter().collect()
}

/// Waits until a stopped arm is at rest, and resets the stop.
async fn let_move(teacher: &Client) -> Result<(), Box<dyn Error + Send + Sync>> {
    until(teacher.handle(), |state| {
        state.stop.as_ref().is_some_and(|stop| stop.at_rest)
    })
    .await?;
    teacher.request(Request::ResetStop).await?;
    Ok(())
}

/// Starts to burn a zigzag, and waits until the laser is on.
async fn burn(teacher: &Client) -> Result<u64, Box<dyn Error + Send + Sync>> {
    teacher.request(Request::TakeLease).await?;
    teacher.request(Request::ArmLaser { for_s: 60.0 }).await?;
    let job = zigzag();
    let submitted = teacher.request(Request::SubmitJob { job, key: None });
    let Reply::Job { job } = submitted.await? else {
        return Err("expected a job number".into());
    };
    teacher.request(Request::StartJob { job: job.job }).await?;
    until(teacher.handle(), |state| state.laser.on).await?;
    Ok(job.job)
}

async fn until(
    handle: &StationHandle,
    is_so: impl Fn(&State) -> bool,
) -> Result<(), Box<dyn Error + Send + Sync>> {
    handle
        .states()
        .wait_for(|snapshot| is_so(snapshot.state()))
        .await?;
    Ok(())
}

/// A job of ten minutes with the laser on.
fn zigzag() -> NewJob {
    let tool = Configuration::EndEffector {
        tool: Tool::Laser.into(),
    };
    let start = MoveTo::to(200.0, 0.0, 50.0).with_mode(MovingMode::MovJ);
    let ways = [[20.0, 1.0], [-20.0, 1.0], [20.0, -1.0], [-20.0, -1.0]];
    let vectors = ways.into_iter().cycle().take(600);
    let vectors = vectors.map(|[x, y]| Command::from(WriteVector::by(x, y, 0.0, 20.0).burning()));
    NewJob {
        title: "zigzag".into(),
        kind: JobKind::Drawing,
        commands: [tool.into(), start.into()]
            .into_iter()
            .chain(vectors)
            .collect(),
        lift_mm: 0.0,
        pauses: Vec::new(),
        program: JobProgram::default(),
    }
}
