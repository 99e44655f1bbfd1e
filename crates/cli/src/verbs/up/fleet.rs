//! The fleet that a station joins.

use std::path::PathBuf;

use dobot_station::Station;

use crate::failure::Failure;

/// How a station joins a fleet.
#[derive(Debug, Default, clap::Args)]
pub(super) struct JoinArgs {
    /// Join a fleet of stations under the first --name: those of this person on this machine, or with the certificate in
    /// FOLDER those of the network
    #[arg(long, value_name = "FOLDER", num_args = 0..=1, require_equals = true)]
    #[expect(
        clippy::option_option,
        reason = "it is given with a folder, without one, or not at all"
    )]
    fleet: Option<Option<PathBuf>>,
    /// A router by which it joins, as in quic/router.school:7447; may be given several times (default: it looks for the
    /// others by itself)
    #[arg(long, value_name = "ADDRESS", requires = "fleet")]
    connect: Vec<String>,
    /// A group of the fleet that it belongs to, as in room-2; may be given several times
    #[arg(long, value_name = "NAME", requires = "fleet")]
    group: Vec<String>,
    /// What it has for work, as in pen, laser or a5; may be given several times
    #[arg(long, value_name = "WORD", requires = "fleet")]
    offers: Vec<String>,
    /// Take work of the fleet: to queue it, so that a person starts it at the arm, or to start it too while nobody has
    /// control
    #[arg(long, value_name = "HOW", requires = "fleet", num_args = 0..=1, require_equals = true,
        default_missing_value = "queue")]
    takes_work: Option<TakeWork>,
    /// Give up to so many virtual arms to those of the fleet who have none, each with a page of its own; it takes a station
    /// whose own arm is a virtual one
    #[arg(long, value_name = "NUMBER", requires_all = ["fleet", "is_virtual"], value_parser = clap::value_parser!(u16).range(1..=200))]
    virtual_arms: Option<u16>,
}

/// What a station does with work of its fleet.
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

    /// The station's place in its fleet, if it has one.
    #[derive(Debug, Default)]
    pub(in super::super) struct Joined {
        name: Option<String>,
        fleet: Option<(FleetSession, Fleet)>,
        arms: Option<VirtualArms>,
    }

    /// A virtual arm that nobody looks at ends after so long: longer than a break between two lessons.
    const UNUSED: Duration = Duration::from_secs(1800);

    impl JoinArgs {
        /// Joins, if that was asked for.
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
                Failure::new(
                    anyhow!("a station of a fleet has a name"),
                    "give it one: `--name desk-3`",
                )
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
                takes_work: self.takes_work.map(|it| match it {
                    TakeWork::Queue => TakesWork::Queue,
                    TakeWork::Start => TakesWork::Start,
                }),
                gives_arms: self.virtual_arms,
                given_by: None,
            }
        }
    }

    impl Joined {
        /// What a person reads.
        pub(in super::super) fn told(&self) -> Option<String> {
            self.name.clone()
        }

        /// Leaves, if it has joined.
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

    /// No place in any fleet.
    #[derive(Debug)]
    pub(in super::super) struct Joined;

    impl JoinArgs {
        /// This program joins none.
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
                    "`cargo build --release --features fleet` builds one with them",
                )),
            }
        }
    }

    impl Joined {
        #[expect(clippy::unused_self, reason = "as where fleets are built")]
        pub(in super::super) const fn told(&self) -> Option<String> {
            None
        }

        #[expect(clippy::unused_async, reason = "as where fleets are built")]
        pub(in super::super) async fn leave(self) {}
    }
}
