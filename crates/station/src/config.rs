//! Configuration of a station.

use std::net::{Ipv4Addr, SocketAddr, SocketAddrV4};
use std::path::PathBuf;

use dobot_api::{Folders, Role};
use dobot_controller::Personality;
use dobot_host::{ArmSelection, PreparedArm};
use dobot_session::Address;
use dobot_sim::Speed;
use dobot_wire::Dialect;

use crate::StartError;

/// Configuration of a station.
///
/// ```
/// use dobot_api::Folders;
/// use dobot_station::Config;
///
/// let config = Config {
///     arm: Some("serial:/dev/ttyUSB0".parse()?),
///     ..Config::new(Folders::at("/srv/dobot"))
/// };
/// assert_eq!(config.http.to_string(), "127.0.0.1:8642");
/// # Ok::<(), dobot_session::AddressError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Config {
    /// The address of the arm. If absent, the station uses the first arm that it finds, or a
    /// virtual one if there is none.
    pub arm: Option<Address>,
    /// The behaviour of a virtual arm.
    pub personality: Personality,
    /// The simulation speed of a virtual arm.
    pub speed: Speed,
    /// The protocol dialect. If absent, the dialect that was detected earlier for this arm; a
    /// virtual arm uses that of its personality, and any other one is undecided.
    pub dialect: Option<Dialect>,
    /// The file of the safety policy; the default policy if absent.
    pub policy: Option<PathBuf>,
    /// The folders for the station's data.
    pub folders: Folders,
    /// The address for page and API; port 0 selects a free one.
    pub http: SocketAddr,
    /// The TCP address for raw packets, if any; port 0 selects a free one.
    pub raw: Option<SocketAddr>,
    /// The path of a symbolic link to a virtual serial port for raw packets, if any.
    pub pty: Option<PathBuf>,
    /// The address for Foxglove, if any; port 0 selects a free one.
    pub foxglove: Option<SocketAddr>,
    /// The certificate and key of page and API. If absent, they are served without TLS on loopback,
    /// and with a self-signed certificate elsewhere.
    pub tls: Option<TlsFiles>,
    /// The watchdog program, started as `PROGRAM watchdog --note FILE`: it switches the laser off
    /// and releases jog buttons when the station is killed or hangs. No watchdog if absent, and on
    /// systems other than Unix.
    pub watchdog: Option<PathBuf>,
    /// Whether to notify the service manager that the arm's thread is running, if it asks for that
    /// (systemd's `WatchdogSec`).
    pub is_service: bool,
    /// The names of the station on the network, besides its addresses.
    pub names: Vec<String>,
    /// The role of local clients without a token; none if absent.
    pub without_token: Option<Role>,
}

/// A certificate and its key, as PEM files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TlsFiles {
    /// The certificate chain, the server's own certificate first.
    pub certificate: PathBuf,
    /// The private key.
    pub key: PathBuf,
}

/// The default address of page and API.
pub const DEFAULT_HTTP: SocketAddr = SocketAddr::V4(SocketAddrV4::new(Ipv4Addr::LOCALHOST, 8642));

/// The default address for raw packets: that of the vendor's bridge (note N26).
pub const DEFAULT_RAW: SocketAddr = dobot_sim::DEFAULT_TCP;

impl Config {
    /// Any arm, page and raw port on loopback, default policy.
    #[must_use]
    pub fn new(folders: Folders) -> Self {
        Self {
            arm: None,
            personality: Personality::default(),
            speed: Speed::REAL,
            dialect: None,
            policy: None,
            folders,
            http: DEFAULT_HTTP,
            raw: Some(DEFAULT_RAW),
            pty: None,
            foxglove: None,
            tls: None,
            watchdog: None,
            is_service: false,
            names: Vec::new(),
            without_token: Some(Role::Admin),
        }
    }

    /// Switches the laser of the arm off, before the rest of the station starts.
    ///
    /// # Errors
    ///
    /// [`StartError::Thread`].
    ///
    /// # Panics
    ///
    /// Outside of a tokio runtime.
    pub async fn approach(&self) -> Result<PreparedArm, StartError> {
        let arm = ArmSelection {
            address: self.arm.clone(),
            personality: self.personality,
            speed: self.speed,
        };
        let approach = PreparedArm::new(&arm, &self.folders.watchdog()).await;
        approach.map_err(StartError::Thread)
    }
}
