//! Job offers of other stations: answers are final.
//!
//! Each offer has a key. Once the journal has an answer for a key, every repeated request gets the
//! same one, whatever was lost or killed in between. So a job refused here can be offered
//! elsewhere, even if a request for it is still in transit.

use dobot_api::JobState;
use redb::{ReadableTable, WriteTransaction};
use serde::{Deserialize, Serialize};

use crate::new_rows::NewRows;
use crate::rows::JobRow;
use crate::store::{JOBS, OFFERS, REFUSALS, REFUSED_FACT, Store};
use crate::{JobId, Journal, JournalError, PlannedJob};

/// The answer to an offer.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Offered {
    /// It was accepted.
    Taken {
        /// The job's number.
        job: u64,
        /// Its final state when the job itself was removed; `None` while the journal has the job.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        left: Option<JobState>,
    },
    /// It was refused: no job will result from it.
    Refused {
        /// The reason.
        reason: String,
        /// Whether it may be accepted later, when offered again: for example, other work was in the
        /// way.
        busy: bool,
    },
}

/// The number of latest refusals kept. A station that has got one does not ask again; they are kept
/// for requests still in transit, which arrive within minutes.
const REFUSALS_KEPT: u64 = 10_000;

impl Journal {
    /// Accepts and queues a job offered with a key; refuses it if any other job is unfinished. A
    /// repeated offer gets its earlier answer.
    ///
    /// # Errors
    ///
    /// [`JournalError`] if a command or the lift is invalid, or the storage fails; then there is no
    /// answer.
    pub fn take(&self, key: &str, job: &PlannedJob) -> Result<Offered, JournalError> {
        let rows = NewRows::of(job)?;
        let mut store = self.store();
        if let Some(answered) = store.offered(key)? {
            return Ok(answered);
        }
        let jobs = store.jobs()?;
        if let Some(other) = jobs.iter().find(|job| !job.state.is_over()) {
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

    /// Refuses the offer with a key, whenever it comes; a repeated offer gets its earlier answer.
    ///
    /// # Errors
    ///
    /// [`JournalError`] if the storage fails; then there is no answer.
    pub fn refuse(&self, key: &str, reason: &str, busy: bool) -> Result<Offered, JournalError> {
        let mut store = self.store();
        match store.offered(key)? {
            Some(answered) => Ok(answered),
            None => store.refuse(key, reason.to_owned(), busy),
        }
    }

    /// Withdraws an offer: it is refused whenever it comes, and a job that resulted from it ends if
    /// it has not started.
    ///
    /// # Errors
    ///
    /// [`JournalError`] if the storage fails.
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

    /// Returns the answer to an offer, if any.
    ///
    /// # Errors
    ///
    /// [`JournalError`] if the storage fails.
    pub fn offered(&self, key: &str) -> Result<Option<Offered>, JournalError> {
        self.store().offered(key)
    }
}

impl Store {
    fn offered(&mut self, key: &str) -> Result<Option<Offered>, JournalError> {
        let row = self.read(|look| {
            let row = look.open_table(OFFERS)?.get(key)?;
            Ok(row.map(|row| from_bytes(row.value())))
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
                Some(old) => refusals.remove(old)?.map(|key| key.value().to_owned()),
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

/// Keeps the final state of a removed job for the station that offered it.
pub(crate) fn keep_outcome(change: &WriteTransaction, job: JobId) -> Result<(), redb::Error> {
    let row = change
        .open_table(JOBS)?
        .get(job.0)?
        .map(|row| row.value().to_vec());
    // An invalid row does not show the outcome.
    let Some(row) = row.and_then(|row| JobRow::from_bytes(&row).ok()) else {
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
    let last = last.map_or(0, |last| last.value());
    facts.insert(REFUSED_FACT, last + 1)?;
    Ok(last + 1)
}

fn to_bytes(offered: &Offered) -> Vec<u8> {
    serde_json::to_vec(offered).expect("strings and numbers are always JSON")
}

fn from_bytes(bytes: &[u8]) -> Result<Offered, String> {
    serde_json::from_slice(bytes).map_err(|error| format!("a row of an offer: {error}"))
}
