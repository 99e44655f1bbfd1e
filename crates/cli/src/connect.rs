//! From an address to an arm under its rules.

use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow};
use dobot_api::State;
use dobot_controller::{Personality, PowerUp};
use dobot_host::{LocalArm, StationClient};
use dobot_safety::Policy;
use dobot_session::Address;
use dobot_wire::Dialect;

use crate::bounded;
use crate::control::first_state;
use crate::failure::Failure;
use crate::reach::{Station, client_name, folders};

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
    /// Do not ask where the arm stands: a person has looked since its port was opened or it was reset
    #[arg(long, global = true)]
    pub(crate) pose_confirmed: bool,
    #[command(flatten)]
    pub(crate) station: Station,
}

impl To {
    /// Does something with the arm: through the station that is named, or that runs here and has this
    /// arm, and otherwise under the same rules in this process. Whatever comes of it, the arm is left
    /// in order.
    pub(crate) async fn with_arm<T>(
        &self,
        verb: &str,
        act: impl AsyncFnOnce(&mut StationClient) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        let mut station = if let Some(station) = self.find_station(verb).await? {
            station
        } else {
            if self.address.is_none() {
                eprintln!(
                    "no station runs: this uses a virtual arm of this process, and no real arm moves"
                );
            }
            self.open(verb).await?
        };
        let done = act(&mut station).await;
        station.end().await;
        done
    }

    /// The same for what only makes sense with an arm that outlives this process: there is no
    /// virtual one unless it is asked for.
    pub(crate) async fn with_lasting_arm<T>(
        &self,
        verb: &str,
        act: impl AsyncFnOnce(&mut StationClient) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        if self.address.is_none() {
            return act(&mut self.station.client(verb).await?).await;
        }
        self.with_arm(verb, act).await
    }

    async fn find_station(&self, verb: &str) -> Result<Option<StationClient>, Failure> {
        if self.address == Some(Address::Virtual) {
            return Ok(None);
        }
        let named = self.address.is_none() && self.station.is_named();
        let Some(address) = self.station.address().await? else {
            return Ok(None);
        };
        let mut station = match StationClient::connect(&address, &client_name(verb)).await {
            Ok(station) => station,
            // It was killed, and could not take back that it runs.
            Err(error) if error.is_not_running() && !named => return Ok(None),
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

    /// The policy that was given, or the default one.
    pub(crate) fn policy(&self) -> Result<Policy, Failure> {
        let file = self.policy.as_deref();
        file.map_or_else(|| Ok(Policy::default()), read_policy)
    }

    async fn open(&self, verb: &str) -> Result<StationClient, Failure> {
        let policy = self.policy()?;
        let name = client_name(verb);
        match &self.address {
            None | Some(Address::Virtual) => {
                let dialect = self.dialect.unwrap_or(Dialect::SPECIFICATION);
                let power_up = PowerUp::new(speaker(dialect));
                Ok(StationClient::with_virtual_arm(power_up, policy, &name))
            }
            Some(address) => {
                let arm = LocalArm {
                    address: address.clone(),
                    dialect: self.dialect,
                    policy,
                    folders: folders(None)?,
                    watchdog: std::env::current_exe().ok(),
                };
                Ok(StationClient::open(arm, &name).await?)
            }
        }
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

/// The controller that speaks a dialect.
pub(crate) fn speaker(dialect: Dialect) -> Personality {
    Personality::ALL
        .into_iter()
        .find(|it| it.dialect() == dialect)
        .expect("each dialect has a controller that speaks it")
}

/// Reads a policy file.
pub(crate) fn read_policy(file: &Path) -> Result<Policy, Failure> {
    let text = bounded::settings(file)
        .with_context(|| format!("the policy {} cannot be read", file.display()))?;
    Policy::from_toml(&text).map_err(|error| {
        Failure::new(
            anyhow!("{}: {error}", file.display()),
            "`dobot policy` prints the default policy with every key and a comment on each",
        )
    })
}
