//! `dobot up`: the station.

mod browser;
mod fleet;
mod welcome;

use std::io::{ErrorKind, IsTerminal};
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use anyhow::anyhow;
use dobot_api::{Folders, News, Notice, Remote, Role, running};
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
use crate::stderr;

#[expect(
    clippy::struct_excessive_bools,
    reason = "each is a switch of the command line"
)]
/// Start the station: the one program that owns the arm, for all others (`dobot` alone does it, too)
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot up                                    the arm that is plugged in, or a virtual one
  dobot up --arm serial:/dev/ttyUSB0 --dialect firmware-1.1
  dobot up --virtual --personality firmware-1.1
  dobot up --http 0.0.0.0:8642                for the whole network: with TLS, and tokens of `dobot token`
  dobot up --pty /tmp/dobot                   a virtual serial port, too, for old programs
  dobot up --fleet --name desk-3              one of several stations of this machine (docs/fleet.md)

The other verbs go through the station as long as it runs. Ctrl-C ends it: the laser goes off, and the arm comes
to rest. A job that was not over can be gone on with after the next start.")]
pub(crate) struct Args {
    /// The arm's address.
    #[arg(
        long,
        value_name = "ADDRESS",
        help = "The arm's address: virtual:, serial:PORT[@BAUD] or tcp:HOST:PORT (default: the one that is found, or a virtual one)"
    )]
    arm: Option<Address>,
    /// A virtual arm, even if one is plugged in
    #[arg(long = "virtual", conflicts_with = "arm")]
    is_virtual: bool,
    /// How a virtual arm behaves: specification, or firmware-1.1 as the arms that were sold do
    #[arg(long, value_name = "PERSONALITY", default_value = "specification")]
    personality: Personality,
    /// How fast time passes for a virtual arm: 0.1 to 1000 times as fast as a clock
    #[arg(long, value_name = "FACTOR", default_value = "1")]
    speed: Speed,
    /// What the arm understands: specification, or firmware-1.1 for an arm as it was sold
    #[arg(long, value_name = "DIALECT")]
    dialect: Option<Dialect>,
    /// The safety policy, a TOML file (default: the policy that `dobot policy` shows)
    #[arg(long, value_name = "FILE")]
    policy: Option<PathBuf>,
    /// Where jobs, recordings and tokens are kept
    #[arg(long, value_name = "FOLDER")]
    data: Option<PathBuf>,
    /// Where page and API are served; port 0 takes a free one
    #[arg(long, value_name = "HOST:PORT", default_value_t = DEFAULT_HTTP)]
    http: SocketAddr,
    /// Where raw packets are served over TCP, or off; port 0 takes a free one (default: 127.0.0.1:5555; off with
    /// --token-required, for raw packets know no tokens)
    #[arg(long, value_name = "HOST:PORT|off", value_parser = raw)]
    raw: Option<Raw>,
    /// Serve raw packets on a virtual serial port, too, with a symbolic link to it at LINK
    #[cfg(unix)]
    #[arg(long, value_name = "LINK")]
    pty: Option<PathBuf>,
    /// Let Foxglove look on, on this machine; port 0 takes a free one [with no value: 127.0.0.1:8765]
    #[arg(long, value_name = "HOST:PORT", num_args = 0..=1, require_equals = true, default_missing_value = "127.0.0.1:8765")]
    foxglove: Option<SocketAddr>,
    /// The certificate of page and API, a PEM file (default: one that the station makes for itself)
    #[arg(long, value_name = "FILE", requires = "tls_key")]
    tls_cert: Option<PathBuf>,
    /// The certificate's private key, a PEM file
    #[arg(long, value_name = "FILE", requires = "tls_cert")]
    tls_key: Option<PathBuf>,
    /// A name by which others reach this machine, as in lab-pc.local; may be given several times
    #[arg(long = "name", value_name = "NAME")]
    names: Vec<String>,
    #[command(flatten)]
    fleet: JoinArgs,
    /// Ask for a token on this machine, too
    #[arg(long)]
    token_required: bool,
    /// Open the page in the desktop's browser (default: at the first start in a terminal of a desktop)
    #[arg(long, overrides_with = "no_open")]
    open: bool,
    /// Do not open the page in a browser
    #[arg(long, overrides_with = "open")]
    no_open: bool,
    /// How the log on standard error is written; the environment variable `RUST_LOG` tells how much
    #[arg(long, value_name = "FORMAT", value_enum, default_value_t)]
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
    welcome.fleet = fleet.told();
    if args.token_required && args.raw.is_none() {
        welcome.notes.push(NO_RAW.to_owned());
    }
    match log {
        LogFormat::Text => output::line(&welcome.text(std::io::stdout().is_terminal()))?,
        LogFormat::Json => welcome.log(),
    }
    if opens && let Err(error) = open::that_detached(station.url()) {
        log.tell(&format!("no browser could be opened: {error}"));
    }
    let service_manager = ServiceManager::of_environment();
    service_manager.notify(Notification::Ready);
    tokio::select! {
        () = tell(notices, log) => {}
        () = &mut interrupt => {}
    }
    service_manager.notify(Notification::Stopping);
    log.tell("ending: the laser goes off, and the arm comes to rest");
    // The others still see how it comes to rest.
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

/// Starts the station, if there is no other one. A station that lives answers at once; the arm waits
/// no longer than that for its laser to be switched off.
async fn start(config: Config, log: LogFormat) -> Result<Station, Failure> {
    let folders = config.folders.clone();
    let mut alone = std::pin::pin!(check_alone(&folders));
    let known = tokio::time::timeout(AT_ONCE, &mut alone).await;
    let is_known = known.is_ok();
    let unreadable = match known.unwrap_or(Ok(())) {
        Ok(()) => None,
        Err(NotAlone::Running(failure)) => return Err(failure),
        Err(NotAlone::Unreadable(failure)) => Some(failure),
    };
    if config.arm.is_none() {
        log.tell("looking for an arm");
    }
    let approach = config.approach().await.map_err(no_start)?;
    // The laser is off by now, whatever is wrong with the data.
    if let Some(failure) = unreadable {
        return Err(failure);
    }
    if !is_known {
        alone.await?;
    }
    Station::begin(config, approach).await.map_err(no_start)
}

impl Args {
    fn config(&self) -> Result<Config, Failure> {
        Ok(Config {
            arm: self.address(),
            personality: self.personality,
            speed: self.speed,
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

    /// Whether the page is opened in a browser. To be asked before the station begins to keep something.
    fn opens_page(&self, folders: &Folders) -> bool {
        match (self.open, self.no_open) {
            (true, _) => true,
            (_, true) => false,
            _ => !folders.data().exists() && Surroundings::of_this_process().have_a_desktop(),
        }
    }

    /// The arm that is named; otherwise the station looks for one.
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

/// Why another station may have the arm.
enum NotAlone {
    /// One runs.
    Running(Failure),
    /// Whether one runs cannot be read.
    Unreadable(Failure),
}

impl From<NotAlone> for Failure {
    fn from(why: NotAlone) -> Self {
        match why {
            NotAlone::Running(failure) | NotAlone::Unreadable(failure) => failure,
        }
    }
}

/// Two stations would quarrel about the arm.
async fn check_alone(folders: &Folders) -> Result<(), NotAlone> {
    let running = running(folders).map_err(|error| NotAlone::Unreadable(error.into()))?;
    let Some(other) = running else {
        return Ok(());
    };
    // One that was killed could not take back that it runs.
    if Remote::connect(&other, &client_name("up")).await.is_err() {
        return Ok(());
    }
    Err(NotAlone::Running(Failure::new(
        anyhow!("a station runs already at {other}"),
        "`dobot watch` shows it; another one beside it needs a folder and ports of its own: \
         `--data FOLDER --http 127.0.0.1:0 --raw 127.0.0.1:0`",
    )))
}

fn welcome(station: &Station, personality: Personality, data: String) -> Welcome {
    let arm = match station.arm() {
        Some(Address::Virtual) => format!("a virtual one, {personality}"),
        Some(address) => address.to_string(),
        None => "not there yet; `dobot watch` tells what the station waits for".to_owned(),
    };
    Welcome {
        page: station.url().to_owned(),
        fingerprint: station.fingerprint().map(str::to_owned),
        arm,
        raw: station.raw().map(|it| format!("tcp:{it}")),
        foxglove: station.foxglove().map(|it| format!("ws://{it}")),
        pty: station.pty().map(|it| format!("serial:{}", it.display())),
        fleet: None,
        data,
        notes: station.notes().to_vec(),
    }
}

/// Tells what happens, until the station ends by itself.
async fn tell(mut notices: Receiver<Arc<Notice>>, log: LogFormat) {
    let shown = log.shows_notices();
    loop {
        match notices.recv().await {
            Ok(notice) if !shown || matches!(notice.news, News::CommandDone { .. }) => {}
            Ok(notice) => stderr::line(&format!("{:>10}  {}", clock(notice.at_s), notice.text)),
            Err(RecvError::Lagged(_)) if !shown => {}
            Err(RecvError::Lagged(missed)) => {
                stderr::line(&format!("{missed} notices were not shown"));
            }
            Err(RecvError::Closed) => return,
        }
    }
}

fn no_start(error: StartError) -> Failure {
    let hint = match &error {
        StartError::Raw(RawPortError::InUse { .. }) => {
            "`--raw 127.0.0.1:0` takes a free port, `--raw off` does without"
        }
        #[cfg(feature = "full")]
        StartError::Foxglove(FoxglovePortError::Listen { .. }) => {
            "another program may have the port; `--foxglove=127.0.0.1:0` takes a free one"
        }
        StartError::Http(ServeError::Bind { source, .. }) if is_taken(source) => {
            "another program has the port; `--http 127.0.0.1:0` takes a free one"
        }
        StartError::Http(ServeError::NoTokens(_)) => "`dobot token add admin NAME`",
        StartError::PolicyFile { .. } | StartError::Policy { .. } => {
            "`dobot policy check FILE` tells all about it"
        }
        _ => return error.into(),
    };
    Failure::new(error, hint)
}

fn is_taken(error: &std::io::Error) -> bool {
    error.kind() == ErrorKind::AddrInUse
}

/// So soon a station of this machine answers that lives.
const AT_ONCE: Duration = Duration::from_millis(300);

const NO_RAW: &str = "raw packets are not served, for they know no tokens; `--raw 127.0.0.1:5555` serves them to everybody on this machine";

/// Where raw packets are served, if they are.
#[derive(Clone, Copy, Debug)]
struct Raw(Option<SocketAddr>);

fn raw(text: &str) -> Result<Raw, &'static str> {
    if text == "off" {
        return Ok(Raw(None));
    }
    let address = text.parse().map_err(
        |_| "allowed are HOST:PORT with a number for a host, as in 127.0.0.1:5555, and off",
    );
    address.map(|it| Raw(Some(it)))
}
