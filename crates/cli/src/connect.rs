//! From an address to a connection.

use std::path::PathBuf;

use anyhow::anyhow;
use dobot_client::{Address, Connection};
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_safety::Policy;
use dobot_sim::{InProcess, Line, VirtualArm};
use dobot_station::{Remote, State};
use dobot_wire::Dialect;

use crate::control::first_state;
use crate::failure::Failure;
use crate::policy;
use crate::reach::{Station, client_name};

/// Which arm, and by which way.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct To {
    /// The arm's address.
    #[arg(
        id = "to",
        long = "to",
        value_name = "ADDRESS",
        global = true,
        conflicts_with = "station",
        help = "The arm's address: virtual:, serial:PORT[@BAUD] or tcp:HOST:PORT",
        long_help = "The arm's address: virtual:, serial:PORT[@BAUD] or tcp:HOST:PORT\n\n\
            Without it, the running station is asked; when none runs, it is virtual:, an arm in this process."
    )]
    pub(crate) address: Option<Address>,
    /// What the arm understands: specification, or firmware-1.1 for an arm as it was sold
    ///
    /// A virtual arm speaks the specification unless told otherwise; over a port nobody knows until it is
    /// told here, and what depends on it is refused. A station knows it already.
    #[arg(long, value_name = "DIALECT", global = true)]
    pub(crate) dialect: Option<Dialect>,
    /// The safety policy, a TOML file (default: the one that `dobot policy` shows); a station has its own
    #[arg(long, value_name = "FILE", global = true)]
    pub(crate) policy: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) station: Station,
}

/// The way to an arm.
pub(crate) enum Reached {
    /// Through a station.
    Station(Box<Remote>),
    /// From this process.
    Arm(Box<Connected>),
}

/// A connection, and the virtual arm at its other end if it is one in this process.
pub(crate) struct Connected {
    pub(crate) arm: Connection,
    pub(crate) virtual_arm: Option<InProcess>,
    pub(crate) policy: Policy,
}

impl To {
    /// Whether the arm, when it is reached from this process, is a virtual one.
    pub(crate) const fn is_virtual(&self) -> bool {
        matches!(self.address, None | Some(Address::Virtual))
    }

    /// The way to the arm: through the station that is named, or that runs here and has this arm,
    /// and otherwise from this process.
    pub(crate) async fn reach(&self, verb: &str) -> Result<Reached, Failure> {
        match self.find_station(verb).await? {
            Some(station) => Ok(Reached::Station(Box::new(station))),
            None => Ok(Reached::Arm(Box::new(self.connect().await?))),
        }
    }

    async fn find_station(&self, verb: &str) -> Result<Option<Remote>, Failure> {
        if self.address == Some(Address::Virtual) {
            return Ok(None);
        }
        let named = self.address.is_none() && self.station.is_named();
        let Some(address) = self.station.address()? else {
            return Ok(None);
        };
        let mut station = match Remote::connect(&address, &client_name(verb)).await {
            Ok(station) => station,
            // It was killed, and could not take back that it runs.
            Err(error) if error.is_nobody() && !named => return Ok(None),
            Err(error) => return Err(error.into()),
        };
        if self.address.is_none() && self.dialect.is_none() && self.policy.is_none() {
            return Ok(Some(station));
        }
        let state = first_state(&mut station).await?;
        if let Some(to) = &self.address
            && !owns(&state, to)
        {
            return Ok(None);
        }
        self.check_policy()?;
        self.check_dialect(&state)?;
        Ok(Some(station))
    }

    fn check_policy(&self) -> Result<(), Failure> {
        if self.policy.is_none() {
            return Ok(());
        }
        Err(Failure::new(
            anyhow!("a station runs, and it has a policy of its own"),
            "leave `--policy` out, or start the station with it: `dobot up --policy FILE`",
        ))
    }

    /// A station that knows another dialect would read what is sent otherwise.
    fn check_dialect(&self, state: &State) -> Result<(), Failure> {
        let Some(wanted) = self.dialect.filter(|it| state.dialect != Some(*it)) else {
            return Ok(());
        };
        let known = state.dialect.map(|it| format!("that the arm speaks {it}"));
        let known = known.unwrap_or_else(|| "no dialect of the arm".to_owned());
        Err(Failure::new(
            anyhow!("the dialect is {wanted}; the station knows {known}"),
            format!(
                "leave `--dialect` out, or start the station with it: `dobot up --dialect {wanted}`"
            ),
        ))
    }

    async fn connect(&self) -> Result<Connected, Failure> {
        let policy = self
            .policy
            .as_deref()
            .map_or(Ok(Policy::default()), policy::read)?;
        if let Some(address) = self.address.as_ref().filter(|_| !self.is_virtual()) {
            let mut arm = Connection::open(address, self.dialect).await?;
            // Who gives one command to an arm without a station has looked where it stands.
            arm.session_mut().confirm_pose();
            return Ok(Connected {
                arm,
                virtual_arm: None,
                policy,
            });
        }
        let dialect = self.dialect.unwrap_or(Dialect::SPECIFICATION);
        let virtual_arm = InProcess::new(virtual_arm(speaker(dialect)));
        Ok(Connected {
            arm: Connection::over_peer(virtual_arm.clone(), Some(dialect)),
            virtual_arm: Some(virtual_arm),
            policy,
        })
    }
}

/// Whether the arm of a station is the one at this address.
fn owns(state: &State, address: &Address) -> bool {
    let owned = state.link.address.as_ref();
    let Some(Ok(owned)) = owned.map(|it| it.parse::<Address>()) else {
        return false;
    };
    match (&owned, address) {
        (Address::Serial { path: owned, .. }, Address::Serial { path, .. }) => {
            device(owned) == device(path)
        }
        _ => owned == *address,
    }
}

/// The device behind the names that it may have.
fn device(path: &str) -> PathBuf {
    std::fs::canonicalize(path).unwrap_or_else(|_| path.into())
}

/// A virtual arm at the end of a line as slow as that of a stock arm.
pub(crate) fn virtual_arm(personality: Personality) -> VirtualArm {
    let controller = Controller::power_up(PowerUp::new(personality));
    VirtualArm::new(controller, Line::STOCK)
}

/// The controller that speaks a dialect.
pub(crate) fn speaker(dialect: Dialect) -> Personality {
    Personality::ALL
        .into_iter()
        .find(|it| it.dialect() == dialect)
        .expect("each dialect has a controller that speaks it")
}
