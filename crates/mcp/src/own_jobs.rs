//! The jobs that an agent may resume: its own, unless a person has to check first.

use std::collections::HashMap;
use std::sync::{Mutex, MutexGuard, PoisonError};

use dobot_api::{JobPhase, JobView};

use crate::refused::Refused;

/// The jobs that agents have started, by number.
#[derive(Debug, Default)]
pub(crate) struct OwnJobs(Mutex<HashMap<u64, OwnJob>>);

#[derive(Debug)]
struct OwnJob {
    agent: String,
    /// The reason of the pause after this agent has paused it.
    paused: Option<String>,
}

impl OwnJobs {
    /// Records a job started by an agent.
    pub(crate) fn add(&self, agent: &str, job: u64) {
        let own = OwnJob {
            agent: agent.to_owned(),
            paused: None,
        };
        self.lock().insert(job, own);
    }

    /// Records a job paused by an agent.
    pub(crate) fn note_paused(&self, agent: &str, job: &JobView) {
        if let Some(own) = self
            .lock()
            .get_mut(&job.job)
            .filter(|own| own.agent == agent)
        {
            own.paused.clone_from(&job.reason);
        }
    }

    /// Checks that an agent may answer the question of a job: one that it has started, unless the
    /// question is for a person.
    ///
    /// # Errors
    ///
    /// `needs-a-person`.
    pub(crate) fn check_may_answer(&self, agent: &str, job: &JobView) -> Result<(), Refused> {
        let jobs = self.lock();
        let is_own = jobs.get(&job.job).is_some_and(|own| own.agent == agent);
        let pending = job.question.as_ref();
        let is_for_person = pending.is_some_and(|pending| pending.question.is_for_person());
        let why = match (is_own, is_for_person) {
            (false, _) => "another client queued it",
            (true, true) => "its question is for a person",
            (true, false) => return Ok(()),
        };
        let text = format!("job {} cannot be answered by an agent: {why}", job.job);
        Err(Refused::new("needs-a-person", text)
            .hinted("have a person answer on the station's page, or with `dobot jobs answer`"))
    }

    /// Checks that an agent may resume a job: only one that it has started and paused itself.
    ///
    /// # Errors
    ///
    /// `needs-a-person`.
    pub(crate) fn check_may_resume(&self, agent: &str, job: &JobView) -> Result<(), Refused> {
        let jobs = self.lock();
        let own = jobs.get(&job.job).filter(|own| own.agent == agent);
        let why = match own {
            None => "another client queued it".to_owned(),
            Some(_) if job.waits_for_person => "it waits for a person".to_owned(),
            Some(own) if job.phase == JobPhase::Paused && own.paused != job.reason => {
                "the agent did not pause it".to_owned()
            }
            Some(_) => return Ok(()),
        };
        let reason = job.reason.as_ref();
        let reason = reason.map_or_else(String::new, |reason| format!(" ({reason})"));
        Err(Refused::new(
            "needs-a-person",
            format!("job {}: {why}{reason}; only a person may resume it", job.job),
        )
        .hinted("ask the person at the arm to start it, on the station's page or with `dobot jobs start`"))
    }

    fn lock(&self) -> MutexGuard<'_, HashMap<u64, OwnJob>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
