//! `dobot replay`: serves a recording as a virtual arm.

use std::net::SocketAddr;
use std::path::PathBuf;
use std::time::Duration;

use anyhow::anyhow;
use dobot_record::{Difference, Replay, Report};
use dobot_session::Peer;
use dobot_wire::{Dialect, Packet};
use serde_json::{Value, json};
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::{TcpListener, TcpStream};
use tokio::time::{Instant, sleep_until, timeout};

use crate::failure::Failure;
use crate::interrupt::interrupt;
use crate::verbs::decode;
use crate::verbs::log::{Shelf, open, recording_failure};
use crate::{output, values};

/// Serve a recording as a virtual arm, and compare what its client sends
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot replay dobot-2026-11-21T12-30-00Z.mcap      on tcp:127.0.0.1:5555
  dobot replay FILE --tcp 127.0.0.1:0 --time-factor 10
                                                    on a free port, ten times as fast

The first client receives what the arm sent, at the recorded times. Each packet
that it sends is compared with the recording. The exit code is 0 if all packets
match, so that a recording of a failure can serve as a test.")]
pub(crate) struct Args {
    /// Recording: a file, or its name in the folder of recordings
    file: PathBuf,
    #[command(flatten)]
    shelf: Shelf,
    /// TCP address to serve on; port 0 picks a free port
    #[arg(long, value_name = "HOST:PORT", default_value_t = dobot_sim::DEFAULT_TCP, value_parser = values::socket_address)]
    tcp: SocketAddr,
    /// Replay speed, 0.1 to 1000 times real time
    #[arg(long, value_name = "FACTOR", default_value = "1", value_parser = values::number(0.1..=1000.0, "times real time"))]
    time_factor: f64,
    /// Print JSON, one object
    #[arg(long)]
    json: bool,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let interrupt = interrupt();
    let path = args.shelf.find(&args.file)?;
    let mut recording = open(&path)?;
    recording.next();
    let dialect = recording.about().and_then(|about| about.dialect);
    let replay = Replay::open(&path).map_err(|error| recording_failure(&path, error))?;
    let listener = TcpListener::bind(args.tcp).await.map_err(|error| {
        Failure::new(
            anyhow::Error::from(error).context(format!("cannot serve on {}", args.tcp)),
            "use `--tcp 127.0.0.1:0` for a free port",
        )
    })?;
    output::line(&format!(
        "tcp:{}   {}, replayed to the first client",
        listener.local_addr()?,
        path.display()
    ))?;
    tokio::select! {
        served = serve(&listener, replay.clone(), args.time_factor) => served?,
        () = interrupt => return Err(anyhow!("interrupted").into()),
    }
    conclude(&replay.report(), dialect, args.json)
}

/// Serves the first client until it leaves or the recording is over.
async fn serve(listener: &TcpListener, mut replay: Replay, speed: f64) -> std::io::Result<()> {
    let (mut client, from) = listener.accept().await?;
    eprintln!("connected: {from}");
    // Best effort: without it small packets are only delayed.
    let _ = client.set_nodelay(true);
    let start = Instant::now();
    let mut incoming = Vec::new();
    while let Some(wakeup) = replay.poll_wakeup() {
        let left = tokio::select! {
            () = sleep_until(start + wakeup.div_f64(speed)) => false,
            count = client.read_buf(&mut incoming) => count.unwrap_or(0) == 0,
        };
        let outgoing = due(&mut replay, start.elapsed().mul_f64(speed));
        replay.send(&incoming);
        incoming.clear();
        let sent = timeout(PATIENCE, client.write_all(&outgoing)).await;
        if left || !matches!(sent, Ok(Ok(()))) {
            eprintln!("disconnected");
            return Ok(());
        }
    }
    eprintln!("end of the recording");
    part(&mut client, &mut replay).await;
    Ok(())
}

/// Reads what the client still sends after the end of the recording.
async fn part(client: &mut TcpStream, replay: &mut Replay) {
    let _ = client.shutdown().await;
    let mut incoming = Vec::new();
    let _ = timeout(PATIENCE, async {
        while client.read_buf(&mut incoming).await.unwrap_or(0) > 0 {
            replay.send(&incoming);
            incoming.clear();
        }
    })
    .await;
}

/// Advances the replay, and returns what the arm sent until now.
fn due(replay: &mut Replay, now: Duration) -> Vec<u8> {
    let mut bytes = Vec::new();
    while replay.poll_wakeup().is_some_and(|wakeup| wakeup <= now) {
        replay.receive(now, &mut bytes);
    }
    replay.receive(now, &mut bytes);
    bytes
}

fn conclude(report: &Report, dialect: Option<Dialect>, as_json: bool) -> Result<(), Failure> {
    let differences = count(report);
    if as_json {
        output::json(&fields(report, dialect))?;
    } else {
        print(report, dialect)?;
    }
    if report.is_same() {
        return Ok(());
    }
    let error = if differences == 0 {
        anyhow!(
            "the client sent {} outside packets; the recording has {}",
            output::count(report.noise_bytes, "byte"),
            report.recorded_noise_bytes
        )
    } else {
        anyhow!(
            "{} not sent as recorded",
            output::many(differences, "packet was", "packets were")
        )
    };
    Err(error.into())
}

/// Returns the number of all differences.
fn count(report: &Report) -> u64 {
    report.differences.len() as u64 + report.more
}

fn fields(report: &Report, dialect: Option<Dialect>) -> Value {
    let shown: Vec<_> = report
        .differences
        .iter()
        .map(|difference| json_of(difference, dialect))
        .collect();
    json!({
        "same": report.same,
        "different": count(report),
            "differences": shown,
            "furthest_apart_s": report.furthest_apart.as_secs_f64(),
            "noise_bytes": report.noise_bytes,
            "recorded_noise_bytes": report.recorded_noise_bytes,
            "damage": report.damage.as_ref().map(ToString::to_string),
    })
}

fn print(report: &Report, dialect: Option<Dialect>) -> std::io::Result<()> {
    for difference in &report.differences {
        output::line(&format!(
            "{:10.3}  sent      {}",
            difference.at.as_secs_f64(),
            meaning(difference.sent, dialect)
        ))?;
        output::line(&format!(
            "{:10}  recorded  {}",
            "",
            meaning(difference.recorded, dialect)
        ))?;
    }
    if report.more > 0 {
        output::line(&format!("and {} more", report.more))?;
    }
    if let Some(damage) = &report.damage {
        output::line(&format!("the file is damaged: {damage}"))?;
    }
    output::line(&format!(
        "{} as recorded, at most {:.3} s early or late",
        output::count(report.same, "packet"),
        report.furthest_apart.as_secs_f64()
    ))
}

/// Describes a packet in the first dialect in which it is a command.
fn meaning(packet: Option<[u8; 42]>, dialect: Option<Dialect>) -> String {
    let Some(bytes) = packet else {
        return "nothing".to_owned();
    };
    let packet = Packet::from_bytes(&bytes).expect("the decoder returns only whole packets");
    let readings = decode::readings(&packet, dialect);
    let reading = readings
        .iter()
        .find_map(|reading| reading.command.as_ref().ok());
    reading.map_or_else(
        || format!("not a command: {bytes:02x?}"),
        |command| format!("{}  {}", decode::kind(command), output::fields(command)),
    )
}

fn json_of(difference: &Difference, dialect: Option<Dialect>) -> Value {
    json!({
        "at_s": difference.at.as_secs_f64(),
        "sent": difference.sent.map(|packet| meaning(Some(packet), dialect)),
        "recorded": difference.recorded.map(|packet| meaning(Some(packet), dialect)),
    })
}

/// The time that a client has to read, and to leave at the end of the recording.
const PATIENCE: Duration = Duration::from_secs(1);
