//! What a station is told when it starts.

use std::net::{Ipv4Addr, SocketAddr, SocketAddrV4};
use std::path::PathBuf;

use dobot_api::{Folders, Role};
use dobot_controller::Personality;
use dobot_host::{ArmSelection, PreparedArm};
use dobot_session::Address;
use dobot_sim::Speed;
use dobot_wire::Dialect;

use crate::StartError;

/// What a station is told when it starts.
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
    /// Where the arm is. When absent, the station takes the first arm that it finds, or a virtual
    /// one when there is none.
    pub arm: Option<Address>,
    /// How a virtual arm behaves.
    pub personality: Personality,
    /// How fast time passes for a virtual arm.
    pub speed: Speed,
    /// What the arm understands. When absent, it is what was found out about this arm before; a
    /// virtual arm speaks as its personality does, and any other one is undecided.
    pub dialect: Option<Dialect>,
    /// The file of the safety policy; the default policy when absent.
    pub policy: Option<PathBuf>,
    /// Where the station keeps what it has to remember.
    pub folders: Folders,
    /// Where page and API are served; port 0 takes a free one.
    pub http: SocketAddr,
    /// Where raw packets are served over TCP, if they are; port 0 takes a free one.
    pub raw: Option<SocketAddr>,
    /// Where a symbolic link to a virtual serial port with raw packets is made, if one is.
    pub pty: Option<PathBuf>,
    /// Where Foxglove looks on, if it does; port 0 takes a free one.
    pub foxglove: Option<SocketAddr>,
    /// Certificate and key of the page and the API. When absent, they are served without TLS on
    /// loopback, and with a certificate that the station makes for itself elsewhere.
    pub tls: Option<TlsFiles>,
    /// The program that guards the arm when it is started as `PROGRAM watchdog --note FILE`: it
    /// switches the laser off and lets go of buttons when the station is killed or stands still. No
    /// watchdog when absent, and on systems that are no Unix.
    pub watchdog: Option<PathBuf>,
    /// Whether the system that keeps services running is told that the thread that has the arm is at
    /// work, where it wants to know (systemd's `WatchdogSec`).
    pub is_service: bool,
    /// Names that the station goes by on the network, besides its addresses.
    pub names: Vec<String>,
    /// What those on this machine may do who come without a token; nothing when absent.
    pub without_token: Option<Role>,
}

/// A certificate and its key, as PEM files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TlsFiles {
    /// The chain of certificates, the server's own first.
    pub certificate: PathBuf,
    /// The private key.
    pub key: PathBuf,
}

/// Where page and API are served unless told otherwise.
pub const DEFAULT_HTTP: SocketAddr = SocketAddr::V4(SocketAddrV4::new(Ipv4Addr::LOCALHOST, 8642));

/// Where raw packets are served unless told otherwise: where the vendor's bridge was (note N26).
pub const DEFAULT_RAW: SocketAddr = dobot_sim::DEFAULT_TCP;

impl Config {
    /// Any arm, page and raw port on loopback, the default policy.
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

    /// Switches the laser of the arm off, before anything else of a station is there.
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
