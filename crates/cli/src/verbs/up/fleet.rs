//! Joining a fleet.

use std::path::PathBuf;

use dobot_station::Station;

use crate::failure::Failure;
use crate::values;

/// Options of a station that joins a fleet.
#[derive(Debug, Default, clap::Args)]
pub(super) struct JoinArgs {
    /// Join a fleet under the first --name: this person's stations on this machine, or with the certificate in
    /// FOLDER those of the network
    #[arg(long, value_name = "FOLDER", num_args = 0..=1, require_equals = true, help_heading = "Fleet")]
    #[expect(
        clippy::option_option,
        reason = "it is given with a folder, without one, or not at all"
    )]
    fleet: Option<Option<PathBuf>>,
    /// Router to connect to, for example quic/router.school:7447; may be repeated (default: multicast discovery)
    #[arg(
        long,
        value_name = "ADDRESS",
        requires = "fleet",
        help_heading = "Fleet",
        hide_short_help = true
    )]
    connect: Vec<String>,
    /// Group of the station, for example room-2; may be repeated
    #[arg(
        long,
        value_name = "NAME",
        requires = "fleet",
        hide_short_help = true,
        help_heading = "Fleet"
    )]
    group: Vec<String>,
    /// Equipment for queued work, for example pen, laser or a5; may be repeated
    #[arg(
        long,
        value_name = "WORD",
        requires = "fleet",
        hide_short_help = true,
        help_heading = "Fleet"
    )]
    offers: Vec<String>,
    /// Accept jobs from the fleet: `queue` (a person starts them at the arm) or `start` (start them when nobody
    /// has control) [without a value: queue]
    #[arg(long, value_name = "HOW", requires = "fleet", num_args = 0..=1, require_equals = true,
        default_missing_value = "queue", hide_short_help = true, help_heading = "Fleet")]
    takes_work: Option<TakeWork>,
    /// Host up to this many virtual arms, 1 to 200, each with its own page, for fleet members without an arm
    /// (requires --virtual)
    #[arg(long, value_name = "N", requires_all = ["fleet", "is_virtual"], value_parser = values::number(1..=200_u16, "arms"), hide_short_help = true, help_heading = "Fleet")]
    virtual_arms: Option<u16>,
}

/// How a station handles work of its fleet.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum TakeWork {
    Queue,
    Start,
}

#[cfg(feature = "fleet")]
mod joined {
    use std::time::Duration;

    use anyhow::anyhow;
    use dobot_api::{MemberAbout, TakesWork};
    use dobot_fleet::{
        Credentials, Fleet, FleetConfig, FleetSession, VirtualArms, VirtualArmsConfig, own_id,
        page_of,
    };
    use dobot_session::Address;
    use dobot_station::Config;

    use super::{Failure, JoinArgs, Station, TakeWork};

    /// The membership of a station in its fleet, if any.
    #[derive(Debug, Default)]
    pub(in super::super) struct Joined {
        name: Option<String>,
        fleet: Option<(FleetSession, Fleet)>,
        arms: Option<VirtualArms>,
    }

    /// The time after which an unused virtual arm ends: longer than a break between two lessons.
    const UNUSED: Duration = Duration::from_secs(1800);

    impl JoinArgs {
        /// Joins a fleet if the options ask for it.
        pub(in super::super) async fn join(
            &self,
            names: &[String],
            started: &Config,
            station: &Station,
        ) -> Result<Joined, Failure> {
            let folders = &started.folders;
            let Some(credentials) = &self.fleet else {
                return Ok(Joined::default());
            };
            let name = names.first().cloned().ok_or_else(|| {
                Failure::usage(anyhow!("a station needs a name to join a fleet"))
                    .with_hint("name it: `--name desk-3`")
            })?;
            let config = FleetConfig {
                about: self.about(&name, station),
                name,
                work: Some(folders.fleet_work()),
            };
            let id = own_id(&folders.fleet_id())?;
            let credentials = match credentials {
                Some(folder) => Credentials::read(folder)?,
                None => Credentials::of_person(&config.name)?,
            };
            if let Some(warning) = credentials.warning() {
                station.handle().try_report_trouble(warning);
            }
            let session = FleetSession::open(&self.connect, &credentials).await?;
            let fleet = Fleet::join(&session, &config, &id, station.api()).await?;
            let name = config.name.clone();
            let arms = self.virtual_arms.map(|most| {
                let config = VirtualArmsConfig {
                    most,
                    unused: UNUSED,
                    station: started.clone(),
                    fleet: config,
                    session: session.clone(),
                };
                VirtualArms::start(config, station.api())
            });
            Ok(Joined {
                name: Some(name),
                fleet: Some((session, fleet)),
                arms,
            })
        }

        fn about(&self, name: &str, station: &Station) -> MemberAbout {
            MemberAbout {
                version: env!("CARGO_PKG_VERSION").into(),
                page: Some(page_of(name, station)),
                groups: self.group.clone(),
                offers: self.offers.clone(),
                is_virtual: station.arm() == Some(&Address::Virtual),
                takes_work: self.takes_work.map(|how| match how {
                    TakeWork::Queue => TakesWork::Queue,
                    TakeWork::Start => TakesWork::Start,
                }),
                gives_arms: self.virtual_arms,
                given_by: None,
            }
        }
    }

    impl Joined {
        /// The name of the station in its fleet.
        pub(in super::super) fn name(&self) -> Option<String> {
            self.name.clone()
        }

        /// Leaves the fleet, if the station has joined one.
        pub(in super::super) async fn leave(self) {
            if let Some(arms) = self.arms {
                arms.end().await;
            }
            if let Some((session, fleet)) = self.fleet {
                fleet.leave().await;
                session.close().await;
            }
        }
    }
}

#[cfg(not(feature = "fleet"))]
mod joined {
    use anyhow::anyhow;

    use dobot_station::Config;

    use super::{Failure, JoinArgs, Station};

    /// No membership.
    #[derive(Debug)]
    pub(in super::super) struct Joined;

    impl JoinArgs {
        /// Refuses: this program was built without fleets.
        #[expect(clippy::unused_async, reason = "joining waits, where it is built")]
        pub(in super::super) async fn join(
            &self,
            _: &[String],
            _: &Config,
            _: &Station,
        ) -> Result<Joined, Failure> {
            match self {
                Self { fleet: None, .. } => Ok(Joined),
                Self { .. } => Err(Failure::new(
                    anyhow!("this program was built without fleets"),
                    "build one with `cargo build --release --features fleet`",
                )),
            }
        }
    }

    impl Joined {
        #[expect(clippy::unused_self, reason = "as where fleets are built")]
        pub(in super::super) const fn name(&self) -> Option<String> {
            None
        }

        #[expect(clippy::unused_async, reason = "as where fleets are built")]
        pub(in super::super) async fn leave(self) {}
    }
}
