//! `dobot replay`: serve a recording as a virtual arm.

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
use crate::output;
use crate::verbs::decode;
use crate::verbs::log::{Shelf, no_recording, open};

/// Play a recording back as a virtual arm, and compare what its client sends
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot replay dobot-2026-11-21T12-30-00Z.mcap     on TCP 127.0.0.1:5555
  dobot replay FILE --tcp 127.0.0.1:0 --speed 10   on a free port, ten times as fast

It sends what the arm sent, at the times at which it did, to its first client, and ends with it.
Each packet that the client sends is compared with what was recorded: if all are the same it succeeds,
so that a recording of something that went wrong is a test.")]
pub(crate) struct Args {
    /// A recording: a file, or its name in the folder
    file: PathBuf,
    #[command(flatten)]
    shelf: Shelf,
    /// Where to serve; port 0 takes a free one
    #[arg(long, value_name = "HOST:PORT", default_value_t = dobot_sim::DEFAULT_TCP)]
    tcp: SocketAddr,
    /// How fast time passes: 0.1 to 1000 times as fast as a clock
    #[arg(long, value_name = "FACTOR", default_value = "1", value_parser = speed)]
    speed: f64,
    /// Print JSON, one object
    #[arg(long)]
    json: bool,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let interrupt = interrupt();
    let path = args.shelf.find(&args.file)?;
    let mut recording = open(&path)?;
    recording.next();
    let dialect = recording.about().and_then(|it| it.dialect);
    let replay = Replay::open(&path).map_err(|error| no_recording(&path, error))?;
    let listener = TcpListener::bind(args.tcp).await.map_err(|error| {
        Failure::new(
            anyhow::Error::from(error).context(format!("cannot serve on {}", args.tcp)),
            "`--tcp 127.0.0.1:0` takes a free port",
        )
    })?;
    output::line(&format!(
        "tcp:{}   {}, played back to its first client",
        listener.local_addr()?,
        path.display()
    ))?;
    tokio::select! {
        served = serve(&listener, replay.clone(), args.speed) => served?,
        () = interrupt => return Err(anyhow!("interrupted").into()),
    }
    conclude(&replay.report(), dialect, args.json)
}

/// Serves the first client until it leaves or the recording is over.
async fn serve(listener: &TcpListener, mut replay: Replay, speed: f64) -> std::io::Result<()> {
    let (mut client, from) = listener.accept().await?;
    eprintln!("connected: {from}");
    // Small packets at once; without it they are only later.
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
    eprintln!("the recording is over");
    part(&mut client, &mut replay).await;
    Ok(())
}

/// Takes what the client still sends, once it was told that no more comes.
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

/// Lets time pass: what the arm sent up to now.
fn due(replay: &mut Replay, now: Duration) -> Vec<u8> {
    let mut bytes = Vec::new();
    while replay.poll_wakeup().is_some_and(|it| it <= now) {
        replay.receive(now, &mut bytes);
    }
    replay.receive(now, &mut bytes);
    bytes
}

fn conclude(report: &Report, dialect: Option<Dialect>, as_json: bool) -> Result<(), Failure> {
    let differences = report.differences.len() as u64 + report.more;
    if as_json {
        let shown: Vec<_> = report
            .differences
            .iter()
            .map(|it| json_of(it, dialect))
            .collect();
        output::json(&json!({
            "same": report.same,
            "different": differences,
            "differences": shown,
            "furthest_apart_s": report.furthest_apart.as_secs_f64(),
            "noise_bytes": report.noise_bytes,
            "recorded_noise_bytes": report.recorded_noise_bytes,
            "damage": report.damage.as_ref().map(ToString::to_string),
        }))?;
    } else {
        tell(report, dialect)?;
    }
    if report.is_same() {
        return Ok(());
    }
    let error = if differences == 0 {
        anyhow!(
            "the client sent {} bytes that belong to no packet; recorded were {}",
            report.noise_bytes,
            report.recorded_noise_bytes
        )
    } else {
        anyhow!("{differences} packets were not sent as recorded")
    };
    Err(error.into())
}

fn tell(report: &Report, dialect: Option<Dialect>) -> std::io::Result<()> {
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
        "{} packets as recorded, at most {:.3} s earlier or later",
        report.same,
        report.furthest_apart.as_secs_f64()
    ))
}

/// What a packet says, in the first dialect in which it says anything.
fn meaning(packet: Option<[u8; 42]>, dialect: Option<Dialect>) -> String {
    let Some(bytes) = packet else {
        return "nothing".to_owned();
    };
    let packet = Packet::from_bytes(&bytes).expect("the decoder gives nothing else");
    let readings = decode::readings(&packet, dialect);
    let reading = readings.iter().find_map(|it| it.command.as_ref().ok());
    reading.map_or_else(
        || format!("what is no command: {bytes:02x?}"),
        |command| format!("{}  {}", decode::kind(command), output::fields(command)),
    )
}

fn json_of(difference: &Difference, dialect: Option<Dialect>) -> Value {
    json!({
        "at_s": difference.at.as_secs_f64(),
        "sent": difference.sent.map(|it| meaning(Some(it), dialect)),
        "recorded": difference.recorded.map(|it| meaning(Some(it), dialect)),
    })
}

fn speed(text: &str) -> Result<f64, String> {
    let speed = text.parse().ok().filter(|it| (0.1..=1000.0).contains(it));
    speed.ok_or_else(|| {
        "allowed is a number from 0.1 to 1000, as many times as fast as a clock".to_owned()
    })
}

/// A client has so long to read, and to leave when the recording is over.
const PATIENCE: Duration = Duration::from_secs(1);
