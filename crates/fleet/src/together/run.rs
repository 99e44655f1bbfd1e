//! Runs the parts at the stations of a fleet: each is a job of its station, requested through its
//! API, under its rules.

mod home;

use std::time::{Duration, Instant};

use dobot_api::{JobView, Reply, State};
use serde::Serialize;
use serde_json::json;
use tokio::sync::mpsc;
use tokio::task::JoinSet;
use tokio::time::{MissedTickBehavior, interval, sleep, timeout};

pub use self::home::Home;
use self::home::{AskError, Asked};
use super::engine::{Action, Engine, EngineEvent, Start};
use super::observation::Observation;
use super::part::Part;
use crate::id::new_id;

/// A person's decision during a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// All parts hold.
    Hold,
    /// The holding parts resume.
    Resume,
    /// Holding parts stay paused, and the run ends.
    Leave,
}

/// An event of a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum RunEvent {
    /// The jobs of the parts, in their order: all are queued, and nothing has moved.
    Queued(Vec<u64>),
    /// An event of the engine.
    News(EngineEvent),
    /// All parts at a barrier continue, or all parts begin.
    Started {
        /// The barrier; `None` at the beginning.
        barrier: Option<String>,
        /// The maximum time between the starts, in milliseconds: from the first request to the last
        /// response, by the clock of this program alone.
        within_ms: f64,
    },
    /// A part cannot resume, although a person requested it.
    Hindered {
        /// The part.
        part: usize,
        /// The reason.
        why: String,
    },
}

/// The outcome of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// All parts have finished.
    Done,
    /// Some hold: their jobs stay paused at their stations.
    Held,
}

/// The error returned when a run cannot begin.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RunError {
    /// A station refuses its part.
    #[error("{arm}: {why}")]
    Part {
        /// The arm.
        arm: String,
        /// The reason.
        why: String,
    },
    /// The system has no random numbers.
    #[error("the system has no random numbers: {0}")]
    Random(String),
}

/// Queues the parts at their stations, starts them simultaneously, and keeps them in step until
/// they finish or a person ends the run; without a person, until nothing continues. On an error,
/// nothing has moved.
///
/// # Errors
///
/// [`RunError`].
pub async fn run(
    home: &Home,
    parts: &[Part],
    is_attended: bool,
    mut orders: mpsc::Receiver<Order>,
    mut report: impl FnMut(RunEvent),
) -> Result<Outcome, RunError> {
    let jobs = queue(home, parts).await?;
    report(RunEvent::Queued(jobs.clone()));
    let mut run = Run {
        actors: actors(home, parts, &jobs),
        engine: Engine::new(parts.iter().map(Part::barriers).collect()),
        since: Instant::now(),
        is_to_go_on: false,
    };
    let mut looks = interval(LOOK_EVERY);
    looks.set_missed_tick_behavior(MissedTickBehavior::Delay);
    let mut has_orders = true;
    loop {
        tokio::select! {
            order = orders.recv(), if has_orders => match order {
                None => has_orders = false,
                Some(Order::Hold) => run.engine.hold_all("held on request"),
                Some(Order::Resume) => run.is_to_go_on = true,
                Some(Order::Leave) => return Ok(Outcome::Held),
            },
            _ = looks.tick() => {
                run.resume(&mut report);
                run.look().await;
            }
        }
        run.act(&mut report).await;
        if run.engine.is_over() {
            return Ok(Outcome::Done);
        }
        if !is_attended && run.engine.all_hold() {
            return Ok(Outcome::Held);
        }
    }
}

/// Queues all parts, or none.
async fn queue(home: &Home, parts: &[Part]) -> Result<Vec<u64>, RunError> {
    let id = new_id().map_err(|error| RunError::Random(error.to_string()))?;
    let mut jobs = Vec::new();
    for part in parts {
        match queue_one(home, part, &id).await {
            Ok(job) => jobs.push(job),
            Err(why) => {
                for (part, job) in parts.iter().zip(&jobs) {
                    let path = format!("/api/v1/jobs/{job}/forget");
                    // A job that stays queued moves nothing; its station lists it.
                    let forgotten = home.ask::<Reply>(&part.arm, &Asked::post(&path)).await;
                    drop(forgotten);
                }
                let arm = part.arm.clone();
                return Err(RunError::Part { arm, why });
            }
        }
    }
    Ok(jobs)
}

async fn queue_one(home: &Home, part: &Part, id: &str) -> Result<u64, String> {
    let program = json!({ "program": { "text": part.text, "files": part.files } });
    let asked = Asked {
        key: Some(format!("together-{id}")),
        body: Some(program),
        ..Asked::post("/api/v1/programs/jobs")
    };
    let reply = home.ask(&part.arm, &asked).await;
    match reply.map_err(|error| error.to_string())? {
        Reply::Job { job } => Ok(job.job),
        _ => Err("its station sent an unreadable response".to_owned()),
    }
}

fn actors(home: &Home, parts: &[Part], jobs: &[u64]) -> Vec<Actor> {
    let parts = parts.iter().zip(jobs);
    let actors = parts.map(|(part, job)| Actor {
        home: home.clone(),
        part: part.clone(),
        job: *job,
        is_unsure: true,
    });
    actors.collect()
}

/// A part at its station.
#[derive(Clone, Debug)]
struct Actor {
    home: Home,
    part: Part,
    job: u64,
    /// Whether a request was sent after the last received state, which is therefore outdated.
    is_unsure: bool,
}

struct Run {
    actors: Vec<Actor>,
    engine: Engine,
    since: Instant,
    /// Whether a resume was requested; first all parts come to rest.
    is_to_go_on: bool,
}

impl Run {
    /// Observes all parts.
    async fn look(&mut self) {
        let seen = self.all(0..self.actors.len(), Actor::observe).await;
        let now = self.since.elapsed();
        for (part, seen) in seen {
            match seen {
                Ok(seen) => {
                    self.actors[part].is_unsure = false;
                    self.engine.handle_state(now, part, &seen);
                }
                Err(error) => self.engine.handle_silent(now, part, &error.to_string()),
            }
        }
    }

    /// Carries out the pending actions.
    async fn act(&mut self, report: &mut impl FnMut(RunEvent)) {
        self.report_events(report);
        let actions: Vec<Action> = std::iter::from_fn(|| self.engine.poll_action()).collect();
        let pauses = actions.iter().filter_map(|action| match action {
            Action::Pause(part) => Some(*part),
            Action::Start { .. } => None,
        });
        self.pause(pauses.collect()).await;
        for action in actions {
            if let Action::Start { barrier, parts } = action
                && let Some(within_ms) = self.start(&parts).await
            {
                report(RunEvent::Started { barrier, within_ms });
            }
        }
        self.report_events(report);
    }

    fn report_events(&mut self, report: &mut impl FnMut(RunEvent)) {
        while let Some(news) = self.engine.poll_news() {
            report(RunEvent::News(news));
        }
    }

    fn resume(&mut self, report: &mut impl FnMut(RunEvent)) {
        if !self.is_to_go_on || !self.engine.is_at_rest() {
            return;
        }
        self.is_to_go_on = false;
        for (part, why) in self.engine.resume() {
            report(RunEvent::Hindered { part, why });
        }
    }

    async fn pause(&mut self, parts: Vec<usize>) {
        for (part, paused) in self.all(parts, Actor::pause).await {
            self.actors[part].is_unsure = true;
            // A job that does not run any more need not be paused.
            if matches!(paused, Err(AskError::Unclear(_))) {
                self.engine.handle_not_paused(part);
            }
        }
    }

    /// Takes control of all arms, starts all jobs simultaneously, then releases control, so that a
    /// person at an arm may pause it. Returns the time that the starts took, in milliseconds, if
    /// all were started.
    async fn start(&mut self, parts: &[usize]) -> Option<f64> {
        let leases = self.all(parts.iter().copied(), Actor::take_control).await;
        let has_failed = leases.iter().any(|entry| entry.1.is_err());
        let asked = Instant::now();
        let starts = if has_failed {
            leases
                .iter()
                .map(|entry| (entry.0, not_started(&entry.1)))
                .collect()
        } else {
            let started = |actor: Actor, part: usize| {
                let lease = leases.iter().find(|entry| entry.0 == part);
                let lease = lease.and_then(|entry| entry.1.as_ref().ok().cloned());
                async move { actor.start(lease).await }
            };
            let mut all = JoinSet::new();
            for &part in parts {
                let started = started(self.actors[part].clone(), part);
                all.spawn(async move { (part, started.await) });
            }
            all.join_all().await
        };
        let within_ms = asked.elapsed().as_secs_f64() * 1e3;
        for &(part, _) in &starts {
            self.actors[part].is_unsure = true;
        }
        self.give_back(leases).await;
        self.engine.handle_starts(&starts);
        let all_run = starts.iter().all(|entry| entry.1 == Start::Done);
        all_run.then_some(within_ms)
    }

    async fn give_back(&self, leases: Vec<(usize, Result<String, AskError>)>) {
        let mut all = JoinSet::new();
        for (part, lease) in leases {
            if let Ok(lease) = lease {
                let actor = self.actors[part].clone();
                // An unused lease expires.
                all.spawn(async move { drop(actor.give_back(lease).await) });
            }
        }
        all.join_all().await;
    }

    /// Runs a request for several parts concurrently.
    async fn all<T: Send + 'static, F>(
        &self,
        parts: impl IntoIterator<Item = usize>,
        ask: impl Fn(Actor) -> F,
    ) -> Vec<(usize, T)>
    where
        F: Future<Output = T> + Send + 'static,
    {
        let mut all = JoinSet::new();
        for part in parts {
            let answer = ask(self.actors[part].clone());
            all.spawn(async move { (part, answer.await) });
        }
        all.join_all().await
    }
}

impl Actor {
    /// Returns the state of the part, within a timeout.
    async fn observe(self) -> Result<Observation, AskError> {
        let within_s = STATE_TIMEOUT.as_secs();
        let late = |_| AskError::Unclear(format!("no response within {within_s} s"));
        timeout(STATE_TIMEOUT, self.look()).await.map_err(late)?
    }

    async fn look(self) -> Result<Observation, AskError> {
        // A response about a job is newer than all previous requests.
        let known = if self.is_unsure {
            Some(self.look_up().await?)
        } else {
            None
        };
        let state: State = self.ask(Asked::get("/api/v1/state")).await?;
        let of_state = state.job.clone().filter(|job| job.job == self.job);
        let job = match (of_state, known) {
            (Some(job), _) | (None, Some(Some(job))) => Some(job),
            (None, Some(None)) => None,
            (None, None) => self.look_up().await?,
        };
        Ok(match job {
            Some(job) => Observation::of(&self.part, &job, &state),
            None => Observation::Ended("its station does not know its job any more".into()),
        })
    }

    /// Returns its job; `None` if its station does not know it any more.
    async fn look_up(&self) -> Result<Option<JobView>, AskError> {
        let path = format!("/api/v1/jobs/{}", self.job);
        match self.ask(Asked::get(&path)).await {
            Ok(job) => Ok(Some(job)),
            Err(error) if error.is("no-such-job") => Ok(None),
            Err(error) => Err(error),
        }
    }

    async fn pause(self) -> Result<(), AskError> {
        let _: Reply = self.ask(Asked::post("/api/v1/jobs/pause")).await?;
        Ok(())
    }

    /// Takes control and returns the token of the lease.
    async fn take_control(self) -> Result<String, AskError> {
        let asked = Asked {
            body: Some(json!({ "name": "dobot fleet together" })),
            ..Asked::post("/api/v1/lease")
        };
        let granted: serde_json::Value = self.ask(asked).await?;
        let token = granted["token"].as_str();
        token
            .map(str::to_owned)
            .ok_or_else(|| AskError::Unclear("its station sent an unreadable response".to_owned()))
    }

    async fn start(self, lease: Option<String>) -> Start {
        let post = |action| Asked {
            lease: lease.clone(),
            ..Asked::post(&format!("/api/v1/jobs/{}/{action}", self.job))
        };
        // The job waits for the other arms here, as for a person.
        if let Err(error) = self.ask::<Reply>(post("confirm")).await {
            return error.start();
        }
        let asked = post("start");
        let until = Instant::now() + RESTS_WITHIN;
        loop {
            match self.ask::<Reply>(asked.clone()).await {
                Ok(_) => return Start::Done,
                Err(error) if error.is("still-moving") && Instant::now() < until => {
                    sleep(LOOK_EVERY).await;
                }
                Err(error) => return error.start(),
            }
        }
    }

    async fn give_back(self, lease: String) -> Result<(), AskError> {
        let asked = Asked {
            method: "DELETE",
            lease: Some(lease),
            ..Asked::get("/api/v1/lease")
        };
        self.ask::<serde_json::Value>(asked).await.map(|_| ())
    }

    async fn ask<T: serde::de::DeserializeOwned>(&self, asked: Asked) -> Result<T, AskError> {
        self.home.ask(&self.part.arm, &asked).await
    }
}

impl AskError {
    fn start(self) -> Start {
        match self {
            Self::Refused { detail, .. } => Start::Refused(detail),
            Self::Unclear(why) => Start::Unclear(why),
        }
    }
}

/// The result for all parts if control of one arm is missing.
fn not_started(lease: &Result<String, AskError>) -> Start {
    match lease {
        Ok(_) => Start::NotTried,
        Err(error) => Start::Refused(error.to_string()),
    }
}

/// The timeout of an observation; meanwhile the other parts are not neglected.
const STATE_TIMEOUT: Duration = Duration::from_secs(2);
/// The time within which the station also sees that the arm is at rest.
const RESTS_WITHIN: Duration = Duration::from_secs(5);
/// The interval of observations.
const LOOK_EVERY: Duration = Duration::from_millis(100);
