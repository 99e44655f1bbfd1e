//! Stops of all arms, and the packets that the arms got.

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

/// Stops all arms so many times while they rest.
pub(crate) async fn at_rest(
    stations: &Stations,
    presses: usize,
) -> Result<(), Box<dyn Error + Send + Sync>> {
    let mut times = Vec::new();
    for _ in 0..presses {
        times.push(press(stations).await?);
        each(stations, |teacher| async move { let_move(&teacher).await }).await?;
    }
    tell("stop all, arms at rest", &times);
    Ok(())
}

/// Stops all arms so many times while each of them burns.
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
    tell("stop all, all lasers burning", &times);
    Ok(())
}

fn tell(what: &str, presses: &[Press]) {
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
    Times::new(answered.collect()).print(&format!("{what}: the answer"));
    let silent: usize = presses.iter().map(|press| press.silent).sum();
    if silent > 0 {
        let asked: usize = presses.iter().map(|press| press.packets.len()).sum();
        println!(
            "{what}: {silent} of {asked} stopped after it was answered that they cannot be reached"
        );
    }
}

/// What came of a stop of all arms, counted from before the connection to the station was made.
struct Press {
    /// When each arm's line was given its laser-off packet.
    packets: Vec<Duration>,
    /// When whoever pressed was told of all of them.
    answered: Duration,
    /// How many had not answered by then.
    silent: usize,
}

/// So long it is waited for the last packet, however busy the computer is.
const STOPS_WITHIN: Duration = Duration::from_secs(60);

/// Presses stop once at the first station.
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
        return Err(format!("{} did not take the stop, as {first:?}", refused.len()).into());
    }
    if answers.len() != stations.all.len() {
        return Err(format!("{} of {} were asked", answers.len(), stations.all.len()).into());
    }
    let arrived = timeout(STOPS_WITHIN, listening.join_all()).await;
    let arrived = arrived.map_err(|_| "an arm was not told to switch its laser off")?;
    let arrived: Option<Vec<_>> = arrived.into_iter().collect();
    let arrived = arrived.ok_or("too many packets passed at once to see all of them")?;
    Ok(Press {
        packets: arrived.into_iter().map(|at| at - began).collect(),
        answered,
        silent: late.len(),
    })
}

/// Whether a station was not heard of in time; it may stop later.
fn is_late(it: &MemberAnswer) -> bool {
    it.answer.body["type"] == "/api/v1/problems/member-away"
}

/// Waits for the answer as long as it takes: two cores with a thousand stations take longer than a client waits.
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

/// When the laser-off packet was handed to the arm's line.
async fn laser_off(mut packets: Receiver<PassedPacket>) -> Option<Instant> {
    let wanted = LASER_OFF.emit(&Dialect::SPECIFICATION).to_bytes();
    while let Ok(packet) = packets.recv().await {
        if packet.to_arm && packet.bytes == wanted {
            return Some(Instant::now());
        }
    }
    None
}

/// Does something as the teacher at each station, all at the same time.
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

/// Waits until a stopped arm rests, and lets it move again.
async fn let_move(teacher: &Client) -> Result<(), Box<dyn Error + Send + Sync>> {
    until(teacher.handle(), |state| {
        state.stop.as_ref().is_some_and(|stop| stop.at_rest)
    })
    .await?;
    teacher.request(Request::ResetStop).await?;
    Ok(())
}

/// Begins to burn a zigzag, and waits until the laser is on.
async fn burn(teacher: &Client) -> Result<u64, Box<dyn Error + Send + Sync>> {
    teacher.request(Request::TakeLease).await?;
    teacher.request(Request::ArmLaser { for_s: 60.0 }).await?;
    let job = zigzag();
    let submitted = teacher.request(Request::SubmitJob { job, key: None });
    let Reply::Job { job } = submitted.await? else {
        return Err("a job that was submitted has a number".into());
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

/// Ten minutes of light.
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
