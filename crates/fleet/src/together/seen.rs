//! What is seen of a part: its job, as its station tells it.

use dobot_api::{JobPhase, JobView, LinkPhase, State};

use super::part::Part;

/// What is seen of a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Seen {
    /// Its job waits to be started.
    Queued,
    /// Its arm is at it, or still comes to rest.
    Running,
    /// Its arm rests at a barrier.
    AtBarrier {
        /// The name of that.
        name: String,
        /// How far its job is: cycles, and commands of this cycle. A later place is larger.
        progress: (u64, usize),
    },
    /// Its program waits for a person, with this text.
    AtPerson(String),
    /// Its job was paused on its way, for this reason.
    Paused(String),
    /// Its arm could not go on, for this reason; where its job is that does not say.
    Hindered(String),
    /// It has done its program.
    Done,
    /// Its job is over before it is done, for this reason.
    Ended(String),
}

impl Seen {
    /// What the job of a part and the state of its station show.
    pub(super) fn of(part: &Part, job: &JobView, state: &State) -> Self {
        let reason = || {
            job.reason
                .clone()
                .unwrap_or_else(|| "nobody says why".into())
        };
        match job.phase {
            JobPhase::Running => Self::Running,
            JobPhase::Done => Self::Done,
            JobPhase::Stopped | JobPhase::Failed => Self::Ended(reason()),
            JobPhase::Queued | JobPhase::Paused => match hurdle(state) {
                Some(hurdle) => Self::Hindered(hurdle),
                None if job.phase == JobPhase::Queued => Self::Queued,
                None => paused(part, job, &reason(), state),
            },
        }
    }
}

fn paused(part: &Part, job: &JobView, reason: &str, state: &State) -> Seen {
    if !rests(state) {
        return Seen::Running;
    }
    if let Some(name) = part.barrier_of(reason) {
        let cycles = job.program.as_ref().map_or(0, |it| it.cycles_done);
        return Seen::AtBarrier {
            name: name.into(),
            progress: (cycles, job.completed),
        };
    }
    if part.waits_for_person(reason) {
        return Seen::AtPerson(reason.into());
    }
    Seen::Paused(reason.into())
}

/// Why the arm could not go on, whatever its job says.
fn hurdle(state: &State) -> Option<String> {
    if let Some(stop) = &state.stop {
        return Some(stop.text());
    }
    if state.link.phase != LinkPhase::Up {
        let why = state.link.problem.clone();
        return Some(why.unwrap_or_else(|| "its station does not hear the arm".into()));
    }
    let why = state.trust.reason.clone().filter(|_| !state.trust.trusted);
    why.map(|it| format!("its pose is to be confirmed: {it}"))
}

/// Whether the arm has nothing more to do and is seen at rest.
fn rests(state: &State) -> bool {
    let queue = &state.queue;
    let moves = state.arm.as_ref().is_some_and(|it| it.moving);
    queue.waiting == 0 && queue.under_way == 0 && !moves
}
