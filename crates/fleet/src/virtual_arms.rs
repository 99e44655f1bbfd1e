//! Virtual arms for those who have none: stations in this process, each with a page and a place in the fleet.

use std::fmt::Display;
use std::io::ErrorKind;
use std::net::SocketAddr;
use std::path::Path;
use std::time::Duration;

use dobot_api::problem_kinds::{ALL_ARMS_GIVEN, ARM_NOT_STARTED, NAME_TAKEN, NO_SUCH_ARM};
use dobot_api::{GivenArm, GivenArms, JobPhase, LinkPhase, MemberAbout, Problem};
use dobot_host::StationHandle;
use dobot_session::Address;
use dobot_station::{ArmSelection, ArmWish, ArmsPort, Config, Station, StationApi};
use tokio::sync::{mpsc, oneshot};
use tokio::task::{JoinHandle, JoinSet};
use tokio::time::{Instant, MissedTickBehavior, interval, timeout};

use crate::{Fleet, FleetConfig, FleetSession, own_id};

/// How a station gives virtual arms.
#[derive(Clone, Debug)]
pub struct VirtualArmsConfig {
    /// So many at a time.
    pub most: u16,
    /// One that nobody looks at, and that does no job, ends after so long; more than nothing.
    pub unused: Duration,
    /// The station that gives them, as it was started: theirs differ in their folders and ports.
    pub station: Config,
    /// How it joined its fleet.
    pub fleet: FleetConfig,
    /// By what it joined; theirs join by the same.
    pub session: FleetSession,
}

/// What gives virtual arms; they end with it.
#[derive(Debug)]
pub struct VirtualArms {
    ends: oneshot::Sender<()>,
    serving: JoinHandle<()>,
}

impl VirtualArms {
    /// Lets the station of this API give virtual arms.
    #[must_use]
    pub fn start(config: VirtualArmsConfig, api: &StationApi) -> Self {
        let (port, wishes) = ArmsPort::new();
        api.give_arms(port);
        let (ends, ended) = oneshot::channel();
        let giving = Giving {
            config,
            handle: api.handle().clone(),
            given: Vec::new(),
            ending: JoinSet::new(),
        };
        Self {
            ends,
            serving: tokio::spawn(giving.serve(wishes, ended)),
        }
    }

    /// Ends all of them.
    pub async fn end(self) {
        // What has ended already gives none.
        let _ = self.ends.send(());
        let _ = self.serving.await;
    }
}

/// Where others find a station's page: under the name of its computer, where it is served for all.
#[must_use]
pub fn page_of(computer: &str, station: &Station) -> String {
    let address = station.address();
    let scheme = station.url().split("://").next().unwrap_or("http");
    if address.ip().is_unspecified() {
        format!("{scheme}://{computer}:{}", address.port())
    } else {
        station.url().to_owned()
    }
}

/// At work.
struct Giving {
    config: VirtualArmsConfig,
    /// The station that gives them.
    handle: StationHandle,
    given: Vec<Given>,
    /// Those that come to rest.
    ending: JoinSet<()>,
}

/// A virtual arm that was given.
struct Given {
    view: GivenArm,
    station: Station,
    fleet: Fleet,
    used: Instant,
}

/// So often it is looked who is used.
const LOOK_EVERY: Duration = Duration::from_secs(5);
/// So long it is waited for the link to a new virtual arm, which takes milliseconds.
const LINKS_WITHIN: Duration = Duration::from_secs(5);

impl Giving {
    async fn serve(
        mut self,
        mut wishes: mpsc::Receiver<ArmWish>,
        mut ended: oneshot::Receiver<()>,
    ) {
        let mut looks = interval(LOOK_EVERY.min(self.config.unused));
        looks.set_missed_tick_behavior(MissedTickBehavior::Delay);
        loop {
            tokio::select! {
                // Whoever asked may be gone.
                Some(wish) = wishes.recv() => match wish {
                    ArmWish::List(reply) => drop(reply.send(self.list())),
                    ArmWish::Give(wanted, reply) => drop(reply.send(self.give(wanted).await)),
                    ArmWish::End(name, reply) => drop(reply.send(self.end(&name))),
                },
                Some(_) = self.ending.join_next() => {}
                _ = looks.tick() => self.end_unused(),
                _ = &mut ended => break,
            }
        }
        for arm in std::mem::take(&mut self.given) {
            self.ending.spawn(arm.end());
        }
        while self.ending.join_next().await.is_some() {}
    }

    fn list(&self) -> GivenArms {
        GivenArms {
            most: self.config.most,
            unused_s: self.config.unused.as_secs(),
            arms: self.given.iter().map(|it| it.view.clone()).collect(),
        }
    }

    async fn give(&mut self, wanted: ArmSelection) -> Result<GivenArm, Problem> {
        let ArmSelection { name, seen } = wanted;
        if let Some(given) = self.given.iter_mut().find(|it| it.view.name == name) {
            given.used = Instant::now();
            return Ok(given.view.clone());
        }
        // One that was given here before may still be seen.
        let folders = self.config.station.folders.of_virtual_arm(&name);
        let was_given = |id: &str| {
            folders.data().is_dir() && own_id(&folders.fleet_id()).is_ok_and(|own| own == id)
        };
        if let Some(other) = seen.filter(|it| !was_given(&it.id)) {
            let detail = format!("a station of the fleet is called {:?} already", other.name);
            return Err(NAME_TAKEN.hinted(detail, "take another name"));
        }
        let most = usize::from(self.config.most);
        if self.given.len() >= most {
            let detail =
                format!("this station gives {most} virtual arms at a time, and all are given");
            return Err(
                ALL_ARMS_GIVEN.hinted(detail, "end one that nobody needs, or ask another station")
            );
        }
        // Its last one may still come to rest, in the same folder.
        while self.ending.join_next().await.is_some() {}
        let given = self.start(&name).await?;
        let view = given.view.clone();
        self.given.push(given);
        Ok(view)
    }

    async fn start(&self, name: &str) -> Result<Given, Problem> {
        let VirtualArmsConfig {
            station,
            fleet,
            session,
            ..
        } = &self.config;
        let folders = station.folders.of_virtual_arm(name);
        check_room(&station.folders.virtual_arms(), folders.data())?;
        folders.make_data().map_err(|error| not_started(&error))?;
        let config = Config {
            arm: Some(Address::Virtual),
            dialect: None,
            policy: None,
            folders: folders.clone(),
            http: SocketAddr::new(station.http.ip(), 0),
            raw: None,
            pty: None,
            foxglove: None,
            watchdog: None,
            is_service: false,
            ..station.clone()
        };
        let station = Station::start(config)
            .await
            .map_err(|error| not_started(&error))?;
        // A stop of the fleet holds it from the start on. Stations that end answer nothing more.
        if let Ok((stops, _)) = self.handle.adopt_fleet_stops(Vec::new()).await {
            let _ = station.handle().adopt_fleet_stops(stops).await;
        }
        let mut states = station.handle().states();
        let is_up = states.wait_for(|it| matches!(it.state().link.phase, LinkPhase::Up));
        // Whoever is given an arm may use it at once; one that takes longer says on its page what it waits for.
        let _ = timeout(LINKS_WITHIN, is_up).await;
        let page = page_of(&fleet.name, &station);
        let config = FleetConfig {
            name: name.to_owned(),
            about: MemberAbout {
                version: fleet.about.version.clone(),
                page: Some(page.clone()),
                groups: fleet.about.groups.clone(),
                is_virtual: true,
                given_by: Some(fleet.name.clone()),
                ..MemberAbout::default()
            },
            work: None,
        };
        let joined = match own_id(&folders.fleet_id()) {
            Ok(id) => Fleet::join(session, &config, &id, station.api())
                .await
                .map_err(|error| not_started(&error)),
            Err(error) => Err(not_started(&error)),
        };
        match joined {
            Ok(fleet) => Ok(Given {
                view: GivenArm {
                    name: name.to_owned(),
                    page,
                },
                station,
                fleet,
                used: Instant::now(),
            }),
            Err(problem) => {
                // Why it is not there is what counts.
                let _ = station.end().await;
                Err(problem)
            }
        }
    }

    fn end(&mut self, name: &str) -> Result<(), Problem> {
        let Some(at) = self.given.iter().position(|it| it.view.name == name) else {
            let name: String = name.chars().take(40).collect();
            return Err(NO_SUCH_ARM.problem(format!("this station gives no virtual arm {name:?}")));
        };
        self.ending.spawn(self.given.swap_remove(at).end());
        Ok(())
    }

    fn end_unused(&mut self) {
        let now = Instant::now();
        for given in &mut self.given {
            if given.is_used() {
                given.used = now;
            }
        }
        let unused = self.config.unused;
        let is_unused = |it: &mut Given| now - it.used >= unused;
        for given in self.given.extract_if(.., is_unused) {
            self.ending.spawn(given.end());
        }
    }
}

impl Given {
    fn is_used(&self) -> bool {
        let state = self.station.handle().state();
        let state = state.state();
        let works = |phase| matches!(phase, JobPhase::Running | JobPhase::Paused);
        state.clients > 0 || state.job.as_ref().is_some_and(|it| works(it.phase))
    }

    async fn end(self) {
        // The arm is a virtual one: nothing depends on how it ends.
        let _ = self.station.end().await;
        self.fleet.leave().await;
    }
}

/// Whether there is room for the data of one more.
fn check_room(all: &Path, own: &Path) -> Result<(), Problem> {
    if own.is_dir() {
        return Ok(());
    }
    let kept = match std::fs::read_dir(all) {
        Ok(kept) => kept.count(),
        Err(error) if error.kind() == ErrorKind::NotFound => 0,
        Err(error) => return Err(not_started(&error)),
    };
    if kept < MOST_KEPT {
        return Ok(());
    }
    let detail = format!(
        "{} keeps the jobs and recordings of {kept} virtual arms, and {MOST_KEPT} are allowed",
        all.display()
    );
    Err(ARM_NOT_STARTED.hinted(detail, "remove the folders of those that nobody needs"))
}

/// The data of so many virtual arms are kept.
const MOST_KEPT: usize = 1000;

fn not_started(error: &dyn Display) -> Problem {
    ARM_NOT_STARTED.problem(format!("the virtual arm cannot be started: {error}"))
}
