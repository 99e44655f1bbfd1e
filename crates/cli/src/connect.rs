//! Connecting to an arm, through a station or directly.

use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow};
use dobot_api::State;
use dobot_controller::PowerUp;
use dobot_host::{LocalArm, PlannedFor, Rules, StationClient, personality_of};
use dobot_safety::Policy;
use dobot_session::Address;
use dobot_wire::Dialect;

use crate::bounded;
use crate::control::{self, first_state};
use crate::failure::Failure;
use crate::reach::{Station, client_name, folders};

/// The arm, and the connection to it.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct To {
    /// The arm's address.
    #[arg(
        id = "to",
        long = "to",
        value_name = "ADDRESS",
        global = true,
        conflicts_with = "station",
        help_heading = "Connection",
        help = "Address of the arm: virtual:, serial:PORT[@BAUD] or tcp:HOST:PORT",
        long_help = "Address of the arm: virtual:, serial:PORT[@BAUD] or tcp:HOST:PORT\n\n\
            Default: the running station, or a virtual arm in this process if no station runs."
    )]
    pub(crate) address: Option<Address>,
    /// Protocol dialect of the arm: specification, or firmware-1.1 for an arm as sold
    ///
    /// Default for a virtual arm: specification. For a real arm it must be given or detected; until then,
    /// commands that depend on it are refused. A station knows the dialect of its arm.
    #[arg(
        long,
        value_name = "DIALECT",
        global = true,
        help_heading = "Connection"
    )]
    pub(crate) dialect: Option<Dialect>,
    /// Safety policy, a TOML file (default: as printed by `dobot policy`); a station has its own
    #[arg(
        long,
        value_name = "FILE",
        global = true,
        hide_short_help = true,
        help_heading = "Connection"
    )]
    pub(crate) policy: Option<PathBuf>,
    /// Confirm the arm's pose without being asked; a person must have looked since it was reset
    #[arg(
        long,
        global = true,
        hide_short_help = true,
        help_heading = "Connection"
    )]
    pub(crate) pose_confirmed: bool,
    #[command(flatten)]
    pub(crate) station: Station,
}

impl To {
    /// Runs `act` on the arm: through the station that is named, or that runs on this machine and owns
    /// the arm, and otherwise under the same rules in this process. The arm is released afterwards.
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
                    "no station runs; using a virtual arm in this process, no real arm moves"
                );
            }
            self.open(verb).await?
        };
        let done = act(&mut station).await;
        station.end().await;
        done
    }

    /// Runs `act` on an arm that outlives this process, and on a virtual arm only if `--to` asks for it.
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

    /// Returns the arm to plan for, and a line that describes it: the arm of the station, if one runs,
    /// otherwise an assumed one. Opens no port. `--policy` and `--dialect` replace those of the station.
    pub(crate) async fn planned_for(&self, verb: &str) -> Result<(PlannedFor, String), Failure> {
        let to = Self {
            dialect: None,
            policy: None,
            ..self.clone()
        };
        let Some(mut station) = to.find_station(verb).await? else {
            return self.assumed();
        };
        let planned = control::planned_for(&mut station).await;
        station.end().await;
        let mut arm = planned?;
        arm.dialect = self.dialect.or(arm.dialect);
        if self.policy.is_some() {
            let calibrations = arm.rules.calibrations.clone();
            arm.rules = Rules::with_calibrations(&self.policy()?, calibrations).into();
        }
        let line = format!(
            "for the station's {} arm, from its current position",
            arm.dialect()
        );
        Ok((arm, line))
    }

    /// Returns an arm to plan for while no station runs, and a line that describes it.
    fn assumed(&self) -> Result<(PlannedFor, String), Failure> {
        let arm = PlannedFor::any(Rules::of(&self.policy()?).into(), self.dialect);
        let line = format!(
            "no station runs: assumed a {} arm that was just switched on",
            arm.dialect()
        );
        Ok((arm, line))
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
            // A killed station leaves its file behind.
            Err(error) if error.is_not_running() && !named => return Ok(None),
            Err(error) => return Err(error.into()),
        };
        if self.address.is_none() && self.dialect.is_none() && self.policy.is_none() {
            return Ok(Some(station));
        }
        let state = first_state(&mut station).await?;
        if self.address.as_ref().is_some_and(|to| !owns(&state, to)) {
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
            anyhow!("a station runs, which has its own policy"),
            "leave out `--policy`, or start the station with it: `dobot up --policy FILE`",
        ))
    }

    /// Checks that the station uses the dialect of `--dialect`.
    fn check_dialect(&self, state: &State) -> Result<(), Failure> {
        let Some(wanted) = self
            .dialect
            .filter(|dialect| state.dialect != Some(*dialect))
        else {
            return Ok(());
        };
        let known = state.dialect.map(|dialect| dialect.to_string());
        let known = known.unwrap_or_else(|| "unknown".to_owned());
        Err(Failure::new(
            anyhow!("--dialect is {wanted}; the dialect of the station's arm is {known}"),
            format!(
                "leave out `--dialect`, or start the station with it: `dobot up --dialect {wanted}`"
            ),
        ))
    }

    /// The policy of `--policy`, or the default one.
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
                let power_up = PowerUp::new(personality_of(dialect));
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

/// Whether a station owns the arm at an address.
fn owns(state: &State, address: &Address) -> bool {
    let owned = state.link.address.as_ref();
    let Some(Ok(owned)) = owned.map(|owned| owned.parse::<Address>()) else {
        return false;
    };
    match (&owned, address) {
        (Address::Serial { path: owned, .. }, Address::Serial { path, .. }) => {
            device(owned) == device(path)
        }
        _ => owned == *address,
    }
}

/// Resolves the links to a device.
fn device(path: &str) -> PathBuf {
    std::fs::canonicalize(path).unwrap_or_else(|_| path.into())
}

/// Reads a policy file.
pub(crate) fn read_policy(file: &Path) -> Result<Policy, Failure> {
    let text = bounded::settings(file)
        .with_context(|| format!("cannot read the policy {}", file.display()))?;
    Policy::from_toml(&text).map_err(|error| {
        Failure::new(
            anyhow!("{}: {error}", file.display()),
            "run `dobot policy` for the default policy with a comment on each key",
        )
    })
}
