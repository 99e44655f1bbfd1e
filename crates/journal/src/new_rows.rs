//! New jobs as rows.

use redb::{ReadableTable, WriteTransaction};

use crate::journal::finite;
use crate::rows::{self, JobRow};
use crate::store::{COMMANDS, FACTS, JOBS, NEXT_JOB_FACT, STEPS};
use crate::{JournalError, PlannedJob};

/// The rows of a job that is not in the journal yet.
pub(crate) struct NewRows {
    row: Vec<u8>,
    packets: Vec<u8>,
    steps: Vec<u8>,
}

impl NewRows {
    /// Returns the rows of a new queued job.
    pub(crate) fn of(job: &PlannedJob) -> Result<Self, JournalError> {
        finite("the planned time", job.planned_s)?;
        Ok(Self {
            row: JobRow::new(job)?.to_bytes(),
            packets: rows::packets(&job.commands, &job.dialect)?,
            steps: rows::steps_bytes(&job.program),
        })
    }

    /// Inserts them into the journal; returns the job's number.
    pub(crate) fn insert(&self, change: &WriteTransaction) -> Result<u64, redb::Error> {
        let mut facts = change.open_table(FACTS)?;
        let id = facts.get(NEXT_JOB_FACT)?.map_or(0, |id| id.value());
        facts.insert(NEXT_JOB_FACT, id + 1)?;
        let packets = self.packets.as_slice();
        change.open_table(COMMANDS)?.insert(id, packets)?;
        if !self.steps.is_empty() {
            let steps = self.steps.as_slice();
            change.open_table(STEPS)?.insert(id, steps)?;
        }
        change.open_table(JOBS)?.insert(id, self.row.as_slice())?;
        Ok(id)
    }
}
