//! Rehearsal: all parts with virtual arms on one clock.

use std::time::Duration;

use dobot_api::{ClientId, JobView, Request};
use dobot_controller::{Personality, PowerUp};
use dobot_host::VirtualStation;
use dobot_safety::Policy;
use dobot_supervisor::Refusal;
use serde::Serialize;

use super::barriers::Barriers;
use super::engine::{Action, Engine, EngineEvent, Start};
use super::observation::Observation;
use super::part::Part;

/// The result of a rehearsal.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Rehearsal {
    /// Each meeting at a barrier, in order.
    pub barriers: Vec<BarrierTime>,
    /// The times of the parts, in their order.
    pub parts: Vec<PartTime>,
}

/// A meeting at a barrier.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BarrierTime {
    /// The barrier.
    pub barrier: String,
    /// The time, in seconds since the start.
    pub at_s: f64,
    /// The waiting times, in the order of the parts.
    pub waits: Vec<Wait>,
}

/// The waiting time of a part at a barrier.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Wait {
    /// The arm.
    pub arm: String,
    /// The waiting time, in seconds; 0 for the last arrival.
    pub waited_s: f64,
}

/// The times of a part.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PartTime {
    /// The arm.
    pub arm: String,
    /// The end, in seconds since the start; `None` if it repeats until a person ends it.
    pub over_s: Option<f64>,
    /// The total waiting time at barriers, in seconds.
    pub waited_s: f64,
}

/// The error returned when a rehearsal cannot be completed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RehearseError {
    /// The rules refuse a job.
    #[error("{file}: {refusal}")]
    Refused {
        /// The file of the part.
        file: String,
        /// The refusal.
        refusal: Box<Refusal>,
    },
    /// A part cannot continue.
    #[error("{file}: stuck after {at_s:.1} s: {why}")]
    Held {
        /// The file of the part.
        file: String,
        /// The time, in seconds since the start.
        at_s: f64,
        /// The reason.
        why: String,
    },
    /// It takes too long.
    #[error(
        "the parts have not finished after {0} hours; rehearse a shorter program, with fewer repetitions"
    )]
    TooLong(u64),
}

/// Runs all parts with virtual arms, each under the rules of its own station, on one clock. Pauses
/// for persons are confirmed immediately. Endless programs run until each part has done its cycle
/// twice.
///
/// # Errors
///
/// [`RehearseError`].
pub fn rehearse(
    parts: &[Part],
    policy: &Policy,
    personality: Personality,
) -> Result<Rehearsal, RehearseError> {
    let stage = parts
        .iter()
        .map(|part| Actor::new(part, policy, personality));
    let mut stage = Stage {
        engine: Engine::new(parts.iter().map(Part::barriers).collect::<Vec<Barriers>>()),
        actors: stage.collect::<Result<_, _>>()?,
        now: Duration::ZERO,
        barriers: Vec::new(),
    };
    while !stage.is_over() {
        if stage.now > Duration::from_secs(LONGEST_H * 3600) {
            return Err(RehearseError::TooLong(LONGEST_H));
        }
        stage.step()?;
    }
    Ok(stage.rehearsal())
}

/// All parts on one clock.
struct Stage<'a> {
    actors: Vec<Actor<'a>>,
    engine: Engine,
    /// The time since the start.
    now: Duration,
    barriers: Vec<BarrierTime>,
}

/// A part with its virtual arm.
struct Actor<'a> {
    part: &'a Part,
    station: VirtualStation,
    client: ClientId,
    job: u64,
    /// The clock of its station at the start.
    began: Duration,
    /// The time since which it waits at a barrier.
    since: Option<Duration>,
    waited: Duration,
    over: Option<Duration>,
}

impl<'a> Actor<'a> {
    fn new(
        part: &'a Part,
        policy: &Policy,
        personality: Personality,
    ) -> Result<Self, RehearseError> {
        let refused = |refusal| refused(part, refusal);
        let mut station = VirtualStation::new(PowerUp::new(personality), policy.clone());
        station.run_for(SETTLED);
        let client = station.client("rehearsal");
        station.ask(client, Request::TakeLease).map_err(refused)?;
        let job = station.submit(&part.job()).map_err(refused)?;
        Ok(Self {
            part,
            began: station.now(),
            station,
            client,
            job,
            since: None,
            waited: Duration::ZERO,
            over: None,
        })
    }

    /// Advances the time and observes the job.
    fn observe(&mut self, now: Duration) -> Result<Observation, Refusal> {
        self.station.run_until(self.began + now, |_| false);
        let state = self.station.supervisor().state();
        let of_state = state.job.clone().filter(|job| job.job == self.job);
        let job = match of_state {
            Some(job) => job,
            None => self.kept()?,
        };
        Ok(Observation::of(self.part, &job, &state))
    }

    /// Returns its job from the journal.
    fn kept(&mut self) -> Result<JobView, Refusal> {
        let jobs = self.station.jobs()?;
        let found = jobs.into_iter().find(|job| job.job == self.job);
        found.ok_or(Refusal::NoSuchJob(self.job))
    }

    fn start(&mut self) -> Result<(), Refusal> {
        let job = self.job;
        self.station.ask(self.client, Request::ConfirmJob { job })?;
        let until = self.station.now() + RESTS_WITHIN;
        loop {
            match self.station.ask(self.client, Request::StartJob { job }) {
                Ok(_) => return Ok(()),
                Err(Refusal::StillMoving { .. }) if self.station.now() < until => {
                    self.station.run_for(TICK);
                }
                Err(refusal) => return Err(refusal),
            }
        }
    }

    /// Whether it has run enough cycles of an endless program.
    fn has_shown_its_cycle(&mut self) -> bool {
        let job = self.station.supervisor().job();
        let program = job.and_then(|job| job.program);
        self.part.never_ends() && program.is_some_and(|program| program.cycles_done >= CYCLES)
    }
}

impl Stage<'_> {
    fn step(&mut self) -> Result<(), RehearseError> {
        self.now += TICK;
        for (part, actor) in self.actors.iter_mut().enumerate() {
            let of_part = actor.part;
            let refused = |refusal| refused(of_part, refusal);
            let seen = actor.observe(self.now).map_err(refused)?;
            self.engine.handle_state(self.now, part, &seen);
            if matches!(seen, Observation::AtPerson(_)) {
                actor.start().map_err(refused)?;
            }
        }
        self.follow()?;
        while let Some(action) = self.engine.poll_action() {
            let Action::Start { barrier, parts } = action else {
                // Only a part that is stuck holds the others.
                continue;
            };
            self.note_release(barrier, &parts);
            let starts: Vec<_> = parts
                .into_iter()
                .map(|part| (part, self.start(part)))
                .collect();
            self.engine.handle_starts(&starts);
        }
        self.follow()
    }

    fn start(&mut self, part: usize) -> Start {
        match self.actors[part].start() {
            Ok(()) => Start::Done,
            Err(refusal) => Start::Refused(refusal.to_string()),
        }
    }

    fn note_release(&mut self, barrier: Option<String>, parts: &[usize]) {
        let mut waits = Vec::new();
        for &part in parts {
            let actor = &mut self.actors[part];
            let since = actor.since.take().unwrap_or(self.now);
            let waited = self.now.saturating_sub(since);
            actor.waited += waited;
            waits.push(Wait {
                arm: actor.part.arm.clone(),
                waited_s: waited.as_secs_f64(),
            });
        }
        if let Some(barrier) = barrier {
            self.barriers.push(BarrierTime {
                barrier,
                at_s: self.now.as_secs_f64(),
                waits,
            });
        }
    }

    fn follow(&mut self) -> Result<(), RehearseError> {
        while let Some(news) = self.engine.poll_news() {
            match news {
                EngineEvent::Arrived { part, .. } => self.actors[part].since = Some(self.now),
                EngineEvent::Done { part } => self.actors[part].over = Some(self.now),
                EngineEvent::Held { part, why, .. } => {
                    return Err(RehearseError::Held {
                        file: self.actors[part].part.file.clone(),
                        at_s: self.now.as_secs_f64(),
                        why,
                    });
                }
                EngineEvent::SetOut { .. } | EngineEvent::WaitsForPerson { .. } => {}
            }
        }
        Ok(())
    }

    fn is_over(&mut self) -> bool {
        let mut actors = self.actors.iter_mut();
        actors.all(|actor| actor.over.is_some() || actor.has_shown_its_cycle())
    }

    fn rehearsal(self) -> Rehearsal {
        let parts = self.actors.into_iter().map(|actor| PartTime {
            arm: actor.part.arm.clone(),
            over_s: actor.over.map(|time| time.as_secs_f64()),
            waited_s: actor.waited.as_secs_f64(),
        });
        Rehearsal {
            barriers: self.barriers,
            parts: parts.collect(),
        }
    }
}

fn refused(part: &Part, refusal: Refusal) -> RehearseError {
    RehearseError::Refused {
        file: part.file.clone(),
        refusal: Box::new(refusal),
    }
}

/// The interval of observations: one tick of the controller.
const TICK: Duration = Duration::from_millis(20);
/// The time within which the station also sees that the arm is at rest.
const RESTS_WITHIN: Duration = Duration::from_secs(1);
/// The time until a virtual arm has reported its position.
const SETTLED: Duration = Duration::from_secs(1);
/// The number of cycles of an endless part.
const CYCLES: u64 = 2;
/// The maximum duration of a rehearsal.
const LONGEST_H: u64 = 24;
