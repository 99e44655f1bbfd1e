//! Virtual arms for the tests of other programs: each serves the protocol on a TCP port of its own.

use std::collections::BTreeMap;
use std::io;
use std::net::IpAddr;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use dobot_api::Problem;
use dobot_api::problem_kinds::{
    ALL_ARMS_GIVEN, ARM_NOT_STARTED, BAD_FAULT, BAD_SCENE, INVALID, NO_SUCH_ARM,
};
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_sim::world::{Scene, World};
use dobot_sim::{Fault, FaultError, SerialLine, Server, ServerEvent, Speed, VirtualArm};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tokio::net::TcpListener;
use tokio::sync::mpsc;
use tokio::task::AbortHandle;
use tokio::time::timeout;

/// The running arms.
#[derive(Debug, Default)]
pub(crate) struct TestArms {
    running: Arc<Mutex<Running>>,
}

#[derive(Debug, Default)]
struct Running {
    /// The number of the last arm.
    last: u64,
    arms: BTreeMap<u64, (TestArm, AbortHandle)>,
}

/// A virtual arm for the test of a program.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub(crate) struct TestArm {
    /// Its number, for `DELETE`.
    arm: u64,
    /// Its TCP port, at the address of the station.
    port: u16,
}

/// The virtual arm to start.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct NewTestArm {
    /// Its behaviour: `specification` (default), or `firmware-1.1` for an arm as sold.
    personality: String,
    /// The simulation speed: 0.1 to 1000 times real time, or `max`; default 1.
    time_factor: String,
    /// Its faults, in the format of `dobot arm --fault`.
    faults: Vec<String>,
    /// The random seed of the faults; default 0.
    seed: u64,
    /// The TOML text of its surroundings, as those of `examples/scenes`.
    scene: Option<String>,
}

impl Default for NewTestArm {
    fn default() -> Self {
        Self {
            personality: Personality::default().to_string(),
            time_factor: Speed::default().to_string(),
            faults: Vec::new(),
            seed: 0,
            scene: None,
        }
    }
}

impl TestArms {
    /// Returns the running arms.
    pub(crate) fn list(&self) -> Vec<TestArm> {
        let arms = &self.running().arms;
        arms.values().map(|(arm, _)| arm.clone()).collect()
    }

    /// Starts an arm on a free port. It ends with its first connection, or if nobody connects within
    /// a minute.
    pub(crate) async fn start(&self, new: &NewTestArm, ip: IpAddr) -> Result<TestArm, Problem> {
        let (arm, speed) = new.arm()?;
        let not_started = |error: io::Error| ARM_NOT_STARTED.problem(error.to_string());
        let listener = TcpListener::bind((ip, 0)).await.map_err(not_started)?;
        let port = listener.local_addr().map_err(not_started)?;
        let mut running = self.running();
        if running.arms.len() >= MAX_ARMS {
            return Err(ALL_ARMS_GIVEN.problem(format!(
                "{MAX_ARMS} virtual arms run, the most allowed; end one first"
            )));
        }
        running.last += 1;
        let started = TestArm {
            arm: running.last,
            port: port.port(),
        };
        let server = Server::new(arm).at_speed(speed).on_tcp(listener);
        let (arms, number) = (Arc::clone(&self.running), started.arm);
        let task = tokio::spawn(async move {
            serve(server).await;
            lock(&arms).arms.remove(&number);
        });
        let entry = (started.clone(), task.abort_handle());
        running.arms.insert(number, entry);
        Ok(started)
    }

    /// Ends an arm and closes its connection.
    pub(crate) fn end(&self, arm: u64) -> Result<(), Problem> {
        let ended = self.running().arms.remove(&arm);
        let (_, task) = ended.ok_or_else(|| {
            NO_SUCH_ARM.problem(format!("there is no virtual arm {arm}; it may have ended"))
        })?;
        task.abort();
        Ok(())
    }

    fn running(&self) -> MutexGuard<'_, Running> {
        lock(&self.running)
    }
}

impl Drop for TestArms {
    fn drop(&mut self) {
        for (_, task) in self.running().arms.values() {
            task.abort();
        }
    }
}

impl NewTestArm {
    /// The arm and its speed.
    fn arm(&self) -> Result<(VirtualArm, Speed), Problem> {
        let invalid = |field: &str, why: String| INVALID.problem(format!("{field}: {why}"));
        let personality: Personality =
            self.personality
                .parse()
                .map_err(|error: dobot_controller::UnknownPersonality| {
                    invalid("personality", error.to_string())
                })?;
        let speed = self.time_factor.parse();
        let speed = speed
            .map_err(|error: dobot_sim::SpeedError| invalid("time_factor", error.to_string()))?;
        let faults = self.faults.iter().map(|fault| fault.parse());
        let faults: Result<Vec<Fault>, FaultError> = faults.collect();
        let faults = faults.map_err(|error| BAD_FAULT.problem(error.to_string()))?;
        let scene = self.scene.as_deref().map(Scene::parse).transpose();
        let scene = scene.map_err(|error| BAD_SCENE.problem(error.to_string()))?;
        let power_up = PowerUp::new(personality);
        let mut arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
        if !faults.is_empty() {
            arm = arm.with_faults(power_up, &faults, self.seed);
        }
        if let Some(scene) = scene {
            arm = arm.with_world(World::new(scene));
        }
        Ok((arm, speed))
    }
}

fn lock(running: &Mutex<Running>) -> MutexGuard<'_, Running> {
    running.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Serves an arm until its first client has left, or nobody has come.
async fn serve(mut server: Server) {
    let (comes_or_goes, mut comings) = mpsc::unbounded_channel();
    let report = move |event| {
        if matches!(
            event,
            ServerEvent::TcpConnected(_) | ServerEvent::Disconnected
        ) {
            // The task ends with the receiver.
            let _ = comes_or_goes.send(());
        }
    };
    let over = async {
        if timeout(UNUSED, comings.recv()).await.is_ok() {
            comings.recv().await;
        }
    };
    tokio::select! {
        _ = server.run(report) => {}
        () = over => {}
    }
}

/// The largest number of running arms.
const MAX_ARMS: usize = 100;
/// An arm without a client ends after this time.
const UNUSED: Duration = Duration::from_secs(60);
