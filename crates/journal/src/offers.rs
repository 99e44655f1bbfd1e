//! Jobs that another station offers: what was answered holds for good.
//!
//! An offer has a key of its own. Once the journal has an answer under a key, everyone who asks again gets the same
//! one, whatever was lost or killed in between. So a job that was refused here can be offered elsewhere, even where a
//! request for it is still on its way.

use dobot_api::JobState;
use redb::{ReadableTable, WriteTransaction};
use serde::{Deserialize, Serialize};

use crate::new_rows::NewRows;
use crate::rows::JobRow;
use crate::store::{JOBS, OFFERS, REFUSALS, REFUSED_FACT, Store};
use crate::{JobId, Journal, JournalError, PlannedJob};

/// What was answered to an offer.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Offered {
    /// It was taken.
    Taken {
        /// The job's number.
        job: u64,
        /// What had become of it when the job itself was forgotten; `None` while the journal has it.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        left: Option<JobState>,
    },
    /// It was refused: no job comes of it any more.
    Refused {
        /// Why.
        reason: String,
        /// Whether it may be taken later, when it is offered anew: it was other work, say, that stood in the way.
        busy: bool,
    },
}

/// So many refusals are kept, the latest ones. Who has got one does not ask again; they are kept for requests that are
/// still on their way then, and those arrive within minutes.
const REFUSALS_KEPT: u64 = 10_000;

impl Journal {
    /// Takes a job that is offered under a key, which is queued then; refuses it where any other job is not over. What
    /// was answered before is answered again.
    ///
    /// # Errors
    ///
    /// [`JournalError`] where a command or the lift makes no sense, or the storage fails; nothing is answered then.
    pub fn take(&self, key: &str, job: &PlannedJob) -> Result<Offered, JournalError> {
        let rows = NewRows::of(job)?;
        let mut store = self.store();
        if let Some(answered) = store.offered(key)? {
            return Ok(answered);
        }
        let jobs = store.jobs()?;
        if let Some(other) = jobs.iter().find(|it| !it.state.is_over()) {
            let reason = format!("job {} is {} here", other.id, other.state);
            return store.refuse(key, reason, true);
        }
        let mut taken = 0;
        store.write(|change| {
            taken = rows.insert(change)?;
            let row = to_bytes(&Offered::Taken {
                job: taken,
                left: None,
            });
            change.open_table(OFFERS)?.insert(key, row.as_slice())?;
            Ok(())
        })?;
        Ok(Offered::Taken {
            job: taken,
            left: None,
        })
    }

    /// Refuses what is offered under a key, whenever it comes; what was answered before is answered again.
    ///
    /// # Errors
    ///
    /// [`JournalError`] where the storage fails; nothing is answered then.
    pub fn refuse(&self, key: &str, reason: &str, busy: bool) -> Result<Offered, JournalError> {
        let mut store = self.store();
        match store.offered(key)? {
            Some(answered) => Ok(answered),
            None => store.refuse(key, reason.to_owned(), busy),
        }
    }

    /// Takes an offer back: it is refused whenever it comes, and a job that has come of it ends if it has not begun.
    ///
    /// # Errors
    ///
    /// [`JournalError`] where the storage fails.
    pub fn withdraw(&self, key: &str, reason: &str) -> Result<Offered, JournalError> {
        let answered = self.refuse(key, reason, false)?;
        if let Offered::Taken { job, left: None } = answered {
            self.change(JobId(job), |row| {
                if row.state == JobState::Queued {
                    let reason = reason.to_owned();
                    row.state = JobState::Stopped { reason };
                }
                Ok(())
            })?;
        }
        Ok(answered)
    }

    /// What was answered to an offer, if anything was.
    ///
    /// # Errors
    ///
    /// [`JournalError`] where the storage fails.
    pub fn offered(&self, key: &str) -> Result<Option<Offered>, JournalError> {
        self.store().offered(key)
    }
}

impl Store {
    fn offered(&mut self, key: &str) -> Result<Option<Offered>, JournalError> {
        let row = self.read(|look| {
            let row = look.open_table(OFFERS)?.get(key)?;
            Ok(row.map(|it| from_bytes(it.value())))
        })?;
        row.transpose().map_err(|found| self.damaged(found))
    }

    fn refuse(&mut self, key: &str, reason: String, busy: bool) -> Result<Offered, JournalError> {
        let refused = Offered::Refused { reason, busy };
        self.write(|change| {
            let number = next(change)?;
            let mut offers = change.open_table(OFFERS)?;
            let mut refusals = change.open_table(REFUSALS)?;
            offers.insert(key, to_bytes(&refused).as_slice())?;
            refusals.insert(number, key)?;
            let old = number.checked_sub(REFUSALS_KEPT);
            let old = match old {
                Some(old) => refusals.remove(old)?.map(|it| it.value().to_owned()),
                None => None,
            };
            if let Some(old) = old {
                offers.remove(old.as_str())?;
            }
            Ok(())
        })?;
        Ok(refused)
    }
}

/// Keeps what has become of a job that is forgotten, for the station that offered it.
pub(crate) fn keep_outcome(change: &WriteTransaction, job: JobId) -> Result<(), redb::Error> {
    let row = change
        .open_table(JOBS)?
        .get(job.0)?
        .map(|it| it.value().to_vec());
    // A row that makes no sense tells nothing of what became of it.
    let Some(row) = row.and_then(|it| JobRow::from_bytes(&it).ok()) else {
        return Ok(());
    };
    let Some(key) = row.key else {
        return Ok(());
    };
    let mut offers = change.open_table(OFFERS)?;
    let is_offered = offers.get(key.as_str())?.is_some();
    if is_offered {
        let outcome = Offered::Taken {
            job: job.0,
            left: Some(row.state),
        };
        offers.insert(key.as_str(), to_bytes(&outcome).as_slice())?;
    }
    Ok(())
}

fn next(change: &WriteTransaction) -> Result<u64, redb::Error> {
    let mut facts = change.open_table(crate::store::FACTS)?;
    let last = facts.get(REFUSED_FACT)?;
    let last = last.map_or(0, |it| it.value());
    facts.insert(REFUSED_FACT, last + 1)?;
    Ok(last + 1)
}

fn to_bytes(offered: &Offered) -> Vec<u8> {
    serde_json::to_vec(offered).expect("strings and numbers are always JSON")
}

fn from_bytes(bytes: &[u8]) -> Result<Offered, String> {
    serde_json::from_slice(bytes).map_err(|error| format!("a row of an offer: {error}"))
}
