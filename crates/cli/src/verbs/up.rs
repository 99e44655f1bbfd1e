//! `dobot up`: starts the station.

mod browser;
mod fleet;
mod welcome;

use std::io::{ErrorKind, IsTerminal};
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use anyhow::anyhow;
use dobot_api::{Folders, LinkView, News, Notice, Remote, Role, running};
use dobot_controller::Personality;
use dobot_host::{Notification, ServiceManager};
use dobot_session::Address;
use dobot_sim::Speed;
#[cfg(feature = "full")]
use dobot_station::FoxglovePortError;
use dobot_station::{
    Config, DEFAULT_HTTP, DEFAULT_RAW, RawPortError, ServeError, StartError, Station, TlsFiles,
};
use dobot_wire::Dialect;
use tokio::sync::broadcast::Receiver;
use tokio::sync::broadcast::error::RecvError;

use self::browser::Surroundings;
use self::fleet::JoinArgs;
use self::welcome::Welcome;
use crate::failure::Failure;
use crate::interrupt::interrupt;
use crate::logging::LogFormat;
use crate::output::{self, clock};
use crate::reach::{client_name, folders};
use crate::{stderr, values};

#[expect(
    clippy::struct_excessive_bools,
    reason = "each is a switch of the command line"
)]
/// Start the station, which owns the arm (default without a command)
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot up                               the arm that is plugged in, or a virtual one
  dobot up --arm serial:/dev/ttyUSB0 --dialect firmware-1.1
  dobot up --virtual --personality firmware-1.1
  dobot up --http 0.0.0.0:8642           for the network: TLS and access tokens
  dobot up --pty /tmp/dobot              with a virtual serial port for old programs
  dobot up --fleet --name desk-3         one of several stations on this machine

The other commands go through the station while it runs. Ctrl-C ends it: the
laser goes off, and the arm comes to rest. An unfinished job can be resumed
after the next start. `dobot token` creates access tokens; docs/fleet.md
describes fleets.")]
pub(crate) struct Args {
    /// The arm's address.
    #[arg(
        long,
        value_name = "ADDRESS",
        help = "Address of the arm: virtual:, serial:PORT[@BAUD] or tcp:HOST:PORT (default: search for one, otherwise a virtual arm)"
    )]
    arm: Option<Address>,
    /// Use a virtual arm even if a real one is plugged in
    #[arg(long = "virtual", conflicts_with = "arm")]
    is_virtual: bool,
    /// Behaviour of a virtual arm: specification, or firmware-1.1 for an arm as sold
    #[arg(long, value_name = "PERSONALITY", default_value = "specification")]
    personality: Personality,
    /// Simulation speed of a virtual arm, 0.1 to 1000 times real time
    #[arg(
        long,
        value_name = "FACTOR",
        default_value = "1",
        hide_short_help = true
    )]
    time_factor: Speed,
    /// Protocol dialect of the arm: specification, or firmware-1.1 for an arm as sold
    #[arg(long, value_name = "DIALECT")]
    dialect: Option<Dialect>,
    /// Safety policy, a TOML file (default: as printed by `dobot policy`)
    #[arg(long, value_name = "FILE")]
    policy: Option<PathBuf>,
    /// Data folder of the station: jobs, recordings and tokens
    #[arg(long, value_name = "FOLDER")]
    data: Option<PathBuf>,
    /// Address of page and API; port 0 picks a free port
    #[arg(long, value_name = "HOST:PORT", default_value_t = DEFAULT_HTTP, value_parser = values::socket_address)]
    http: SocketAddr,
    /// Address for raw packets over TCP, or off; port 0 picks a free port (default: 127.0.0.1:5555; off with
    /// --token-required, because raw packets carry no token)
    #[arg(long, value_name = "HOST:PORT|off", value_parser = raw)]
    raw: Option<Raw>,
    /// Serve raw packets also on a virtual serial port, with a symbolic link to it at LINK
    #[cfg(unix)]
    #[arg(long, value_name = "LINK")]
    pty: Option<PathBuf>,
    /// Address for Foxglove, for watching only; port 0 picks a free port [without a value: 127.0.0.1:8765]
    #[arg(long, value_name = "HOST:PORT", num_args = 0..=1, require_equals = true, default_missing_value = "127.0.0.1:8765", value_parser = values::socket_address, hide_short_help = true)]
    foxglove: Option<SocketAddr>,
    /// Certificate of page and API, a PEM file (default: self-signed)
    #[arg(
        long,
        value_name = "FILE",
        requires = "tls_key",
        hide_short_help = true
    )]
    tls_cert: Option<PathBuf>,
    /// Private key of the certificate, a PEM file
    #[arg(
        long,
        value_name = "FILE",
        requires = "tls_cert",
        hide_short_help = true
    )]
    tls_key: Option<PathBuf>,
    /// Name by which others reach this machine, for example lab-pc.local; may be repeated
    #[arg(long = "name", value_name = "NAME")]
    names: Vec<String>,
    #[command(flatten)]
    fleet: JoinArgs,
    /// Require an access token on this machine, too
    #[arg(long)]
    token_required: bool,
    /// Open the page in a browser (default: at the first start in a terminal of a desktop)
    #[arg(long, overrides_with = "no_open", hide_short_help = true)]
    open: bool,
    /// Do not open the page in a browser
    #[arg(long, overrides_with = "open")]
    no_open: bool,
    /// Format of the log on standard error; the environment variable `RUST_LOG` sets its level
    #[arg(
        long,
        value_name = "FORMAT",
        value_enum,
        default_value_t,
        hide_short_help = true
    )]
    pub(crate) log_format: LogFormat,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let mut interrupt = std::pin::pin!(interrupt());
    let log = args.log_format;
    let config = args.config()?;
    let opens = args.opens_page(&config.folders);
    let data = config.folders.data().display().to_string();
    let station = tokio::select! {
        station = start(config.clone(), log) => station?,
        () = &mut interrupt => return Ok(()),
    };
    let notices = station.handle().notices();
    let fleet = match args.fleet.join(&args.names, &config, &station).await {
        Ok(fleet) => fleet,
        Err(failure) => {
            station.end().await?;
            return Err(failure);
        }
    };
    let mut welcome = welcome(&station, args.personality, data);
    welcome.fleet = fleet.name();
    if args.token_required && args.raw.is_none() {
        welcome.notes.push(NO_RAW.to_owned());
    }
    match log {
        LogFormat::Text => output::line(&welcome.text(std::io::stdout().is_terminal()))?,
        LogFormat::Json => welcome.log(),
    }
    if opens && let Err(error) = open::that_detached(station.url()) {
        log.report(&format!("no browser could be opened: {error}"));
    }
    let service_manager = ServiceManager::of_environment();
    service_manager.notify(Notification::Ready);
    tokio::select! {
        () = print_notices(notices, log) => {}
        () = &mut interrupt => {}
    }
    service_manager.notify(Notification::Stopping);
    log.report("stopping: the laser goes off, and the arm comes to rest");
    // The other stations still see the arm come to rest.
    let ended = async {
        let ended = station.end().await;
        fleet.leave().await;
        ended
    };
    tokio::select! {
        ended = ended => Ok(ended?),
        () = crate::interrupt::interrupt() => Ok(()),
    }
}

/// Starts the station unless another one runs. A running station answers quickly; the laser of the arm
/// is switched off after that time even without an answer.
async fn start(config: Config, log: LogFormat) -> Result<Station, Failure> {
    let folders = config.folders.clone();
    let mut alone = std::pin::pin!(check_alone(&folders));
    let known = tokio::time::timeout(PROMPT, &mut alone).await;
    let is_known = known.is_ok();
    let unreadable = match known.unwrap_or(Ok(())) {
        Ok(()) => None,
        Err(NotAlone::Running(failure)) => return Err(failure),
        Err(NotAlone::Unreadable(failure)) => Some(failure),
    };
    if config.arm.is_none() {
        log.report("looking for an arm");
    }
    let approach = config.approach().await.map_err(start_failure)?;
    // The laser is off by now, even if the data cannot be read.
    if let Some(failure) = unreadable {
        return Err(failure);
    }
    if !is_known {
        alone.await?;
    }
    Station::begin(config, approach)
        .await
        .map_err(start_failure)
}

impl Args {
    fn config(&self) -> Result<Config, Failure> {
        Ok(Config {
            arm: self.address(),
            personality: self.personality,
            speed: self.time_factor,
            dialect: self.dialect,
            policy: self.policy.clone(),
            http: self.http,
            raw: match self.raw {
                Some(Raw(raw)) => raw,
                None => (!self.token_required).then_some(DEFAULT_RAW),
            },
            #[cfg(unix)]
            pty: self.pty.clone(),
            foxglove: self.foxglove,
            tls: self.tls(),
            names: self.names.clone(),
            watchdog: std::env::current_exe().ok(),
            is_service: true,
            without_token: (!self.token_required).then_some(Role::Admin),
            ..Config::new(folders(self.data.clone())?)
        })
    }

    /// Whether the page is opened in a browser; to be called before the station creates its data folder.
    fn opens_page(&self, folders: &Folders) -> bool {
        match (self.open, self.no_open) {
            (true, _) => true,
            (_, true) => false,
            _ => !folders.data().exists() && Surroundings::detect().have_a_desktop(),
        }
    }

    /// The address of the arm, if an option gives it.
    fn address(&self) -> Option<Address> {
        let address = self.is_virtual.then_some(Address::Virtual);
        address.or_else(|| self.arm.clone())
    }

    fn tls(&self) -> Option<TlsFiles> {
        Some(TlsFiles {
            certificate: self.tls_cert.clone()?,
            key: self.tls_key.clone()?,
        })
    }
}

/// The reason why another station may own the arm.
enum NotAlone {
    /// Another station runs.
    Running(Failure),
    /// The file that names the running station cannot be read.
    Unreadable(Failure),
}

impl From<NotAlone> for Failure {
    fn from(why: NotAlone) -> Self {
        match why {
            NotAlone::Running(failure) | NotAlone::Unreadable(failure) => failure,
        }
    }
}

/// Checks that no other station runs.
async fn check_alone(folders: &Folders) -> Result<(), NotAlone> {
    let running = running(folders).map_err(|error| NotAlone::Unreadable(error.into()))?;
    let Some(other) = running else {
        return Ok(());
    };
    // A station that was killed leaves its file behind.
    if Remote::connect(&other, &client_name("up")).await.is_err() {
        return Ok(());
    }
    Err(NotAlone::Running(Failure::new(
        anyhow!("a station already runs at {other}"),
        "`dobot watch` shows it; to run a second one, give it its own folder and ports: \
         `--data FOLDER --http 127.0.0.1:0 --raw 127.0.0.1:0`",
    )))
}

fn welcome(station: &Station, personality: Personality, data: String) -> Welcome {
    let arm = match station.arm() {
        Some(Address::Virtual) => format!("virtual, {personality}"),
        Some(address) => match station.handle().state().state().dialect {
            Some(dialect) => format!("{address}, {dialect}"),
            None => format!("{address}; its dialect is unknown: run `dobot detect`"),
        },
        None => not_connected(&station.handle().state().state().link),
    };
    Welcome {
        page: station.url().to_owned(),
        fingerprint: station.fingerprint().map(str::to_owned),
        arm,
        raw: station.raw().map(|address| format!("tcp:{address}")),
        foxglove: station.foxglove().map(|address| format!("ws://{address}")),
        pty: station
            .pty()
            .map(|path| format!("serial:{}", path.display())),
        fleet: None,
        data,
        notes: station.notes().to_vec(),
    }
}

/// Why there is no arm and what to do, if known.
fn not_connected(link: &LinkView) -> String {
    let why = [&link.problem, &link.remedy].into_iter().flatten();
    let why = why.map(String::as_str).collect::<Vec<_>>().join("; ");
    if why.is_empty() {
        "not connected yet; a line below and `dobot watch` show why".to_owned()
    } else {
        format!("not connected: {why}")
    }
}

/// Prints notices until the station ends by itself.
async fn print_notices(mut notices: Receiver<Arc<Notice>>, log: LogFormat) {
    let shown = log.shows_notices();
    loop {
        match notices.recv().await {
            Ok(notice) if !shown || matches!(notice.news, News::CommandDone { .. }) => {}
            Ok(notice) => stderr::line(&format!("{:>10}  {}", clock(notice.at_s), notice.text)),
            Err(RecvError::Lagged(_)) if !shown => {}
            Err(RecvError::Lagged(missed)) => {
                stderr::line(&format!("{} not shown", output::count(missed, "notice")));
            }
            Err(RecvError::Closed) => return,
        }
    }
}

fn start_failure(error: StartError) -> Failure {
    let hint = match &error {
        StartError::Raw(RawPortError::InUse { .. }) => {
            "use `--raw 127.0.0.1:0` for a free port, or `--raw off`"
        }
        #[cfg(feature = "full")]
        StartError::Foxglove(FoxglovePortError::Listen { .. }) => {
            "use `--foxglove=127.0.0.1:0` for a free port; another program may use this one"
        }
        StartError::Http(ServeError::Bind { source, .. }) if is_taken(source) => {
            "use `--http 127.0.0.1:0` for a free port; another program uses this one"
        }
        StartError::Http(ServeError::NoTokens(_)) => "`dobot token add admin NAME`",
        StartError::PolicyFile { .. } | StartError::Policy { .. } => {
            "run `dobot policy check FILE` for details"
        }
        _ => return error.into(),
    };
    Failure::new(error, hint)
}

fn is_taken(error: &std::io::Error) -> bool {
    error.kind() == ErrorKind::AddrInUse
}

/// The time in which a running station of this machine answers.
const PROMPT: Duration = Duration::from_millis(300);

const NO_RAW: &str = "raw packets are not served, because they carry no token; `--raw 127.0.0.1:5555` serves them to every program on this machine";

/// The address for raw packets, or none.
#[derive(Clone, Copy, Debug)]
struct Raw(Option<SocketAddr>);

fn raw(text: &str) -> Result<Raw, &'static str> {
    if text == "off" {
        return Ok(Raw(None));
    }
    let address = text
        .parse()
        .map_err(|_| "expected HOST:PORT with a numeric host, as in 127.0.0.1:5555, or off");
    address.map(|address| Raw(Some(address)))
}
