//! `dobot arm`: serves a virtual arm.

use std::net::SocketAddr;
use std::path::PathBuf;

use anyhow::{Context, anyhow};
use dobot_api::{CalibrationFile, Zeros};
use dobot_controller::{Controller, Personality, Port, PowerUp};
use dobot_sim::world::{Scene, World};
use dobot_sim::{
    DEFAULT_TCP, DEFAULT_WORLD, Fault, SerialLine, Server, ServerEvent, Speed, VirtualArm,
};
use tokio::net::TcpListener;
use tokio::task::JoinSet;

use crate::failure::Failure;
use crate::interrupt::interrupt;
use crate::verbs::calibrate;
use crate::verbs::world::read_scene;
use crate::{open_files, output, stderr, values};

/// Serve a virtual arm on TCP and on a virtual serial port
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot arm                          on tcp:127.0.0.1:5555 and a serial port
  dobot arm --pty /tmp/dobot         only on a serial port with this name
  dobot arm --tcp 127.0.0.1:0        only on TCP, on a free port
  dobot arm --time-factor max        as fast as its client can follow
  dobot arm --fault drop=1% --fault reset@open
                                     a bad line; a reset when the port opens
  dobot arm --world desk.toml        with paper, tool and objects
  dobot arm --calibration arm.toml   with the errors of a calibrated arm
  dobot arm --count 30               thirty arms, on ports 5555 to 5584

It behaves like a real arm: one client at a time, 9600 baud, 12.5 statuses per
second. Refused packets and injected faults are printed. Ctrl-C ends it.

Faults: drop=1%, flip=0.1%, duplicate=1% (or a number of bytes; append :to or
:from for one direction), delay=50ms, withhold@10s..12s, close@12s..14s,
reset@12s, reset=rear:1.5,fore:-0.8@open, power@12s..15s, lose=rear:30,
lose=fore:1%, backlash=base:0.3, zero=fore:2.
Times: from @12s, @packet5 or @status100 on; or during @12s..15s,
@packet5..+2s.")]
pub(crate) struct Args {
    /// TCP address to serve on; port 0 picks a free port
    #[arg(long, value_name = "HOST:PORT", num_args = 0..=1, default_missing_value = "127.0.0.1:5555", value_parser = values::socket_address)]
    tcp: Option<SocketAddr>,
    /// Serve on a virtual serial port, with a symbolic link to it at LINK
    #[cfg(unix)]
    #[arg(long, value_name = "LINK", num_args = 0..=1, default_missing_value = "", conflicts_with = "count")]
    pty: Option<PathBuf>,
    /// Behaviour of the arm: specification, or firmware-1.1 for an arm as sold
    #[arg(long, value_name = "PERSONALITY", default_value = "specification")]
    personality: Personality,
    /// Port of a firmware-1.1 arm: usb or bluetooth
    #[arg(long, value_name = "PORT", default_value = "usb", value_parser = port, hide_short_help = true)]
    port: Port,
    /// Angles of rear arm and forearm at power-up, in degrees
    #[arg(long, value_name = "REAR,FORE", default_value = "45,45", value_parser = pose, allow_hyphen_values = true)]
    pose: (f64, f64),
    /// Simulation speed, 0.1 to 1000 times real time, or max
    ///
    /// With max, time advances to the next status, then waits until the client has answered, for up to a
    /// millisecond. Without a client it stands still.
    #[arg(long, value_name = "FACTOR", default_value = "1")]
    time_factor: Speed,
    /// Fault to inject, for example drop=1% or reset@12s; may be repeated
    #[arg(long = "fault", value_name = "FAULT")]
    faults: Vec<Fault>,
    /// Calibration file with the zeros and the backlash of the arm
    #[arg(long, value_name = "ARM.toml")]
    calibration: Option<PathBuf>,
    /// Random seed of the faults; the same seed gives the same faults
    #[arg(long, value_name = "N", default_value = "0", value_parser = values::whole_from(0), hide_short_help = true)]
    seed: u64,
    /// Number of arms, 1 to 10000, each on its own TCP port
    #[arg(long, value_name = "N", value_parser = values::number(1..=10_000_u16, "arms"))]
    count: Option<u16>,
    /// Scene file with the arm's surroundings: paper, tool, objects
    #[arg(long, value_name = "SCENE", conflicts_with = "count")]
    world: Option<PathBuf>,
    /// TCP address that serves the surroundings to `dobot world`; port 0 picks a free port
    #[arg(long, value_name = "HOST:PORT", requires = "world", default_value_t = DEFAULT_WORLD, value_parser = values::socket_address)]
    world_port: SocketAddr,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let interrupt = interrupt();
    let mut args = args;
    if let Some(file) = &args.calibration {
        args.faults.extend(faults_of(&calibrate::read(file)?));
    }
    let scene = args.world.as_deref().map(read_scene).transpose()?;
    let (tcp, pty) = args.places();
    let mut servers = Vec::new();
    for (number, address) in args.addresses(tcp)?.into_iter().enumerate() {
        let mut server =
            Server::new(args.arm(number as u64, scene.as_ref())).at_speed(args.time_factor);
        if let Some(address) = address {
            server = server.on_tcp(args.listen(address).await?);
        }
        servers.push(server);
    }
    #[cfg(unix)]
    if let Some(link) = pty {
        let link = Some(link).filter(|link| !link.as_os_str().is_empty());
        let pty = dobot_sim::Pty::open(link.as_deref())
            .map_err(|error| pty_failure(error, link.as_ref()))?;
        output::line(&format!("serial:{}   the same arm", pty.path().display()))?;
        let only = servers.pop().expect("there is at least one arm");
        servers.push(only.on_pty(pty));
    }
    if scene.is_some() {
        let listener = listen(args.world_port, "world-port").await?;
        output::line(&format!(
            "{}   its surroundings, for `dobot world --address`",
            listener.local_addr()?
        ))?;
        let only = servers.pop().expect("there is at least one arm");
        servers.push(only.on_world(listener));
    }
    tokio::select! {
        ended = serve(servers) => ended,
        () = interrupt => Ok(()),
    }
}

/// Runs all arms until one of them fails.
async fn serve(servers: Vec<Server>) -> Result<(), Failure> {
    let several = servers.len() > 1;
    let mut running = JoinSet::new();
    for (number, mut server) in (1..).zip(servers) {
        let name = if several {
            format!("arm {number}: ")
        } else {
            String::new()
        };
        running.spawn(async move {
            server
                .run(|event| stderr::line(&format!("{name}{}", text(&event))))
                .await
        });
    }
    match running.join_next().await {
        Some(Ok(ended)) => Ok(ended?),
        Some(Err(error)) => Err(error.into()),
        None => Ok(()),
    }
}

impl Args {
    /// The TCP address and the serial port to serve on; both by default. A virtual serial port without
    /// a link has an empty name.
    #[cfg(unix)]
    fn places(&self) -> (Option<SocketAddr>, Option<PathBuf>) {
        match (self.tcp, &self.pty) {
            (None, None) if self.count.is_some() => (Some(DEFAULT_TCP), None),
            (None, None) => (Some(DEFAULT_TCP), Some(PathBuf::new())),
            (tcp, pty) => (tcp, pty.clone()),
        }
    }

    #[cfg(not(unix))]
    fn places(&self) -> (Option<SocketAddr>, ()) {
        (self.tcp.or(Some(DEFAULT_TCP)), ())
    }

    /// The TCP address of each arm, if it is served on TCP.
    fn addresses(&self, tcp: Option<SocketAddr>) -> Result<Vec<Option<SocketAddr>>, Failure> {
        let Some(first) = tcp else {
            return Ok(vec![None]);
        };
        let count = self.count.unwrap_or(1);
        if count > MANY_ARMS {
            open_files::allow_many();
        }
        let port = |number| match first.port() {
            0 => Some(0),
            port => port.checked_add(number),
        };
        let at = |number| Some(Some(SocketAddr::new(first.ip(), port(number)?)));
        let addresses: Option<Vec<_>> = (0..count).map(at).collect();
        addresses.ok_or_else(|| {
            let last = 65_535 - (count - 1);
            Failure::usage(anyhow!("{count} arms from port {} on exceed port 65535; the first port may be up to {last}", first.port()))
        })
    }

    /// Creates the arm with a number; each has its own random sequence.
    fn arm(&self, number: u64, scene: Option<&Scene>) -> VirtualArm {
        let power_up = PowerUp::new(self.personality)
            .with_port(self.port)
            .with_tilt(self.pose.0, self.pose.1);
        let arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
        let arm = if self.faults.is_empty() {
            arm
        } else {
            arm.with_faults(power_up, &self.faults, self.seed.wrapping_add(number))
        };
        match scene {
            Some(scene) => arm.with_world(World::new(scene.clone())),
            None => arm,
        }
    }

    async fn listen(&self, address: SocketAddr) -> Result<TcpListener, Failure> {
        let listener = listen(address, "tcp").await?;
        let personality = self.personality;
        output::line(&format!(
            "tcp:{}   a virtual arm, personality {personality}",
            listener.local_addr()?
        ))?;
        Ok(listener)
    }
}

/// Converts the zeros and the backlash of a calibration to faults.
fn faults_of(known: &CalibrationFile) -> Vec<Fault> {
    let Zeros { base, rear, fore } = known.zeros;
    let [slack_base, slack_rear, slack_fore] = known.backlash_deg();
    [
        ("zero=base", base),
        ("zero=rear", rear),
        ("zero=fore", fore),
        ("backlash=base", slack_base),
        ("backlash=rear", slack_rear),
        ("backlash=fore", slack_fore),
    ]
    .into_iter()
    .filter(|(_, deg)| *deg != 0.0)
    .map(|(what, deg)| format!("{what}:{deg}").parse())
    .collect::<Result<_, _>>()
    .expect("a calibration holds only values that a fault allows")
}

/// Parses the name of a port of a stock arm.
pub(crate) fn port(text: &str) -> Result<Port, String> {
    match text {
        "usb" => Ok(Port::Usb),
        "bluetooth" => Ok(Port::Bluetooth),
        _ => Err("expected usb or bluetooth".to_owned()),
    }
}

fn pose(text: &str) -> Result<(f64, f64), String> {
    let angles = || {
        let (rear, fore) = text.split_once(',')?;
        Some((angle(rear, -5.0, 85.0)?, angle(fore, -10.0, 95.0)?))
    };
    angles().ok_or_else(|| {
        "expected two angles in degrees, -5 to 85 for the rear arm and -10 to 95 for the forearm, as in 45,45"
            .to_owned()
    })
}

fn angle(text: &str, least: f64, most: f64) -> Option<f64> {
    text.parse().ok().filter(|deg| (least..=most).contains(deg))
}

async fn listen(address: SocketAddr, option: &str) -> Result<TcpListener, Failure> {
    TcpListener::bind(address).await.map_err(|error| {
        let taken = error.kind() == std::io::ErrorKind::AddrInUse;
        let error = anyhow::Error::from(error).context(format!("cannot serve on {address}"));
        if taken {
            Failure::new(
                error,
                format!(
                    "use `--{option} 127.0.0.1:0` for a free port; another arm may be served on this one"
                ),
            )
        } else {
            error.into()
        }
    })
}

#[cfg(unix)]
fn pty_failure(error: std::io::Error, link: Option<&PathBuf>) -> Failure {
    let exists = error.kind() == std::io::ErrorKind::AlreadyExists;
    let Some(link) = link else {
        return anyhow::Error::from(error)
            .context("cannot make a virtual serial port")
            .into();
    };
    let result: Result<(), _> = Err(error);
    let error = result
        .with_context(|| format!("cannot make a virtual serial port at {}", link.display()))
        .expect_err("the result is an error");
    if exists {
        Failure::new(error, "remove the existing file, or choose another name")
    } else {
        error.into()
    }
}

fn text(event: &ServerEvent) -> String {
    match event {
        ServerEvent::TcpConnected(from) => format!("connected: {from}"),
        ServerEvent::TcpRefused(from) => {
            format!("connection refused: {from}; another client is connected")
        }
        ServerEvent::PtyOpened => "connected: virtual serial port".to_owned(),
        ServerEvent::PtyMoved(path) => format!(
            "the last client left the virtual serial port locked; it is now serial:{}",
            path.display()
        ),
        ServerEvent::Overrun => {
            "the client sends faster than 9600 baud; bytes are lost, as on a real line".to_owned()
        }
        ServerEvent::PortClosed(from) => {
            format!("connection refused: {from}; a fault has closed the port")
        }
        ServerEvent::Struck(struck) => struck.to_string(),
        ServerEvent::World(happened) => happened.to_string(),
        ServerEvent::Disconnected => "disconnected".to_owned(),
        ServerEvent::Refused(refused) => refused.to_string(),
        other => format!("{other:?}"),
    }
}

/// Above this number of arms, the limit of open files is raised.
const MANY_ARMS: u16 = 100;
