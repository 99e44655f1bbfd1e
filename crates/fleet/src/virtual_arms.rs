//! Virtual arms for members without an arm: stations in this process, each with a page and a
//! membership in the fleet.

use std::fmt::Display;
use std::io::ErrorKind;
use std::net::SocketAddr;
use std::path::Path;
use std::time::Duration;

use dobot_api::problem_kinds::{ALL_ARMS_GIVEN, ARM_NOT_STARTED, NAME_TAKEN, NO_SUCH_ARM};
use dobot_api::{GivenArm, GivenArms, JobPhase, LinkPhase, MemberAbout, Problem};
use dobot_host::StationHandle;
use dobot_session::Address;
use dobot_station::{ArmCommand, ArmSelection, ArmsPort, Config, Station, StationApi};
use tokio::sync::{mpsc, oneshot};
use tokio::task::{JoinHandle, JoinSet};
use tokio::time::{Instant, MissedTickBehavior, interval, timeout};

use crate::{Fleet, FleetConfig, FleetSession, own_id};

/// Configuration of hosted virtual arms.
#[derive(Clone, Debug)]
pub struct VirtualArmsConfig {
    /// The maximum number of arms.
    pub most: u16,
    /// The time after which an unused arm ends: without a client and without a job. Greater than
    /// zero.
    pub unused: Duration,
    /// The configuration of the hosting station: the arms differ in their folders and ports.
    pub station: Config,
    /// The configuration of its membership.
    pub fleet: FleetConfig,
    /// The session of the hosting station, which its arms share.
    pub session: FleetSession,
}

/// The host of virtual arms; they end with it.
#[derive(Debug)]
pub struct VirtualArms {
    ends: oneshot::Sender<()>,
    serving: JoinHandle<()>,
}

impl VirtualArms {
    /// Makes the station of this API host virtual arms.
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

    /// Ends all arms.
    pub async fn end(self) {
        // The task may have ended already.
        let _ = self.ends.send(());
        let _ = self.serving.await;
    }
}

/// Returns the address of a station's page for others: with the computer's name, if it is served on
/// all interfaces.
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

/// The running host.
struct Giving {
    config: VirtualArmsConfig,
    /// The hosting station.
    handle: StationHandle,
    given: Vec<Given>,
    /// Arms that are shutting down.
    ending: JoinSet<()>,
}

/// A hosted virtual arm.
struct Given {
    view: GivenArm,
    station: Station,
    fleet: Fleet,
    used: Instant,
}

/// The interval at which unused arms are searched.
const LOOK_EVERY: Duration = Duration::from_secs(5);
/// The time to wait for the link to a new virtual arm, which takes milliseconds.
const LINKS_WITHIN: Duration = Duration::from_secs(5);

impl Giving {
    async fn serve(
        mut self,
        mut wishes: mpsc::Receiver<ArmCommand>,
        mut ended: oneshot::Receiver<()>,
    ) {
        let mut looks = interval(LOOK_EVERY.min(self.config.unused));
        looks.set_missed_tick_behavior(MissedTickBehavior::Delay);
        loop {
            tokio::select! {
                // The requester may be gone.
                Some(wish) = wishes.recv() => match wish {
                    ArmCommand::List(reply) => drop(reply.send(self.list())),
                    ArmCommand::Give(wanted, reply) => drop(reply.send(self.give(wanted).await)),
                    ArmCommand::End(name, reply) => drop(reply.send(self.end(&name))),
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
            arms: self.given.iter().map(|arm| arm.view.clone()).collect(),
        }
    }

    async fn give(&mut self, wanted: ArmSelection) -> Result<GivenArm, Problem> {
        let ArmSelection { name, seen } = wanted;
        if let Some(given) = self.given.iter_mut().find(|arm| arm.view.name == name) {
            given.used = Instant::now();
            return Ok(given.view.clone());
        }
        // An arm that was hosted here before may still be listed.
        let folders = self.config.station.folders.of_virtual_arm(&name);
        let was_given = |id: &str| {
            folders.data().is_dir() && own_id(&folders.fleet_id()).is_ok_and(|own| own == id)
        };
        if let Some(other) = seen.filter(|other| !was_given(&other.id)) {
            let detail = format!(
                "the name {:?} is already used by a station of the fleet",
                other.name
            );
            return Err(NAME_TAKEN.hinted(detail, "choose another name"));
        }
        self.check_room()?;
        // Its predecessor may still be shutting down in the same folder.
        while self.ending.join_next().await.is_some() {}
        let given = self.start(&name).await?;
        let view = given.view.clone();
        self.given.push(given);
        Ok(view)
    }

    fn check_room(&self) -> Result<(), Problem> {
        let most = usize::from(self.config.most);
        if self.given.len() < most {
            return Ok(());
        }
        let detail = format!("this station hosts at most {most} virtual arms, and all are in use");
        Err(ALL_ARMS_GIVEN.hinted(detail, "end an unused one, or use another station"))
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
        // A stop of the fleet holds it from the start. A station that is ending does not answer.
        if let Ok((stops, _)) = self.handle.adopt_fleet_stops(Vec::new()).await {
            let _ = station.handle().adopt_fleet_stops(stops).await;
        }
        let mut states = station.handle().states();
        let is_up =
            states.wait_for(|snapshot| matches!(snapshot.state().link.phase, LinkPhase::Up));
        // The arm is usable immediately; if the link takes longer, the page shows why.
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
                // Report the cause, not a failed shutdown.
                let _ = station.end().await;
                Err(problem)
            }
        }
    }

    fn end(&mut self, name: &str) -> Result<(), Problem> {
        let Some(at) = self.given.iter().position(|arm| arm.view.name == name) else {
            let name: String = name.chars().take(40).collect();
            return Err(NO_SUCH_ARM.problem(format!("this station hosts no virtual arm {name:?}")));
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
        let is_unused = |given: &mut Given| now - given.used >= unused;
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
        state.clients > 0 || state.job.as_ref().is_some_and(|job| works(job.phase))
    }

    async fn end(self) {
        // The arm is virtual: the way it ends does not matter.
        let _ = self.station.end().await;
        self.fleet.leave().await;
    }
}

/// Checks that there is space for the data of one more arm.
fn check_room(all: &Path, own: &Path) -> Result<(), Problem> {
    if own.is_dir() {
        return Ok(());
    }
    let kept = match std::fs::read_dir(all) {
        Ok(kept) => kept.count(),
        Err(error) if error.kind() == ErrorKind::NotFound => 0,
        Err(error) => return Err(not_started(&error)),
    };
    if kept < MAX_KEPT {
        return Ok(());
    }
    let detail = format!(
        "{} contains the jobs and recordings of {kept} virtual arms; at most {MAX_KEPT} are allowed",
        all.display()
    );
    Err(ARM_NOT_STARTED.hinted(detail, "remove the folders of unused arms"))
}

/// The maximum number of arms whose data are kept.
const MAX_KEPT: usize = 1000;

fn not_started(error: &dyn Display) -> Problem {
    ARM_NOT_STARTED.problem(format!("the virtual arm cannot be started: {error}"))
}
