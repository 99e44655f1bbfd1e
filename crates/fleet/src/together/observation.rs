//! The observed state of a part: its job, as reported by its station.

use dobot_api::{JobPhase, JobView, LinkPhase, State};

use super::part::Part;

/// The observed state of a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Observation {
    /// Its job waits to be started.
    Queued,
    /// Its job runs, or its arm is coming to rest.
    Running,
    /// Its arm rests at a barrier.
    AtBarrier {
        /// The name of the barrier.
        name: String,
        /// The progress of its job: cycles, and commands of this cycle. A later place is larger.
        progress: (u64, usize),
    },
    /// Its program waits for a person, with this message.
    AtPerson(String),
    /// Its job was paused, for this reason.
    Paused(String),
    /// Its arm could not continue, for this reason; the place of its job does not show it.
    Hindered(String),
    /// It has finished its program.
    Done,
    /// Its job ended before it was done, for this reason.
    Ended(String),
}

impl Observation {
    /// Derives the state from the part's job and the state of its station.
    pub(super) fn of(part: &Part, job: &JobView, state: &State) -> Self {
        let reason = || {
            job.reason
                .clone()
                .unwrap_or_else(|| "no reason given".into())
        };
        match job.phase {
            JobPhase::Running => Self::Running,
            JobPhase::Done => Self::Done,
            JobPhase::Stopped | JobPhase::Failed => Self::Ended(reason()),
            JobPhase::Queued | JobPhase::Paused => match obstacle(state) {
                Some(obstacle) => Self::Hindered(obstacle),
                None if job.phase == JobPhase::Queued => Self::Queued,
                None => paused(part, job, &reason(), state),
            },
        }
    }
}

fn paused(part: &Part, job: &JobView, reason: &str, state: &State) -> Observation {
    if !rests(state) {
        return Observation::Running;
    }
    if let Some(name) = part.barrier_of(reason) {
        let cycles = job
            .program
            .as_ref()
            .map_or(0, |program| program.cycles_done);
        return Observation::AtBarrier {
            name: name.into(),
            progress: (cycles, job.completed),
        };
    }
    if part.waits_for_person(reason) {
        return Observation::AtPerson(reason.into());
    }
    Observation::Paused(reason.into())
}

/// Returns the reason why the arm could not continue, whatever the place of its job.
fn obstacle(state: &State) -> Option<String> {
    if let Some(stop) = &state.stop {
        return Some(stop.text());
    }
    if state.link.phase != LinkPhase::Up {
        let why = state.link.problem.clone();
        return Some(why.unwrap_or_else(|| "its station has no connection to the arm".into()));
    }
    let why = state.trust.reason.clone().filter(|_| !state.trust.trusted);
    why.map(|reason| format!("its pose must be confirmed: {reason}"))
}

fn rests(state: &State) -> bool {
    state.arm.as_ref().is_none_or(|arm| !arm.moving)
}
