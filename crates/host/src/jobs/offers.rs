//! Job offers from other stations.

use dobot_api::{JobKind, JobState, JobView};
use dobot_journal::{Journal, JournalError, Offered, PlannedJob};
use dobot_motion::Model;
use dobot_safety::Policy;
use dobot_supervisor::{Refusal, plain};

use super::{check_key, find, journal_refusal, planned, view};
use crate::handle::{OfferAnswer, OfferRequest};

/// Answers another station. Anything but its own journal that keeps the station from accepting a
/// job results in a final refusal.
pub(crate) fn answer(
    journal: &Journal,
    policy: &Policy,
    key: &str,
    ask: OfferRequest,
    model: Result<Model, Refusal>,
    now_ms: i64,
) -> Result<OfferAnswer, Refusal> {
    check_key(key)?;
    let known = journal
        .offered(key)
        .map_err(|error| journal_refusal(&error))?;
    let answered = match (ask, known) {
        (OfferRequest::Withdraw { by }, _) => {
            let by = plain(&by, LONGEST_NAME);
            journal.withdraw(key, &format!("{WITHDRAWN}{by}")).map(Some)
        }
        (_, Some(known)) => Ok(Some(known)),
        (OfferRequest::Look, None) => Ok(None),
        (OfferRequest::Refuse { reason, busy }, None) => {
            journal.refuse(key, &reason, busy).map(Some)
        }
        (OfferRequest::Take { job, made_for }, None) => match model {
            // The arm may be connected, or its dialect known, later.
            Err(refusal) => journal.refuse(key, &refusal.to_string(), true).map(Some),
            Ok(model) if made_for.is_some_and(|made_for| !made_for.is_same(&model.calibration)) => {
                journal.refuse(key, OTHER_ARM, false).map(Some)
            }
            Ok(model) => {
                let job = planned(policy, *job, Some(key.into()), model, now_ms);
                take(journal, key, job).map(Some)
            }
        },
    };
    match answered.map_err(|error| journal_refusal(&error))? {
        None => Ok(OfferAnswer::Unknown),
        Some(Offered::Refused { reason, busy }) => Ok(OfferAnswer::Refused { reason, busy }),
        Some(Offered::Taken { job, left: None }) => {
            Ok(OfferAnswer::Taken(Box::new(view(&find(journal, job)?))))
        }
        Some(Offered::Taken {
            job,
            left: Some(state),
        }) => Ok(OfferAnswer::Taken(Box::new(forgotten(job, &state)))),
    }
}

fn take(
    journal: &Journal,
    key: &str,
    job: Result<PlannedJob, Refusal>,
) -> Result<Offered, JournalError> {
    let refused = match job {
        Ok(job) => match journal.take(key, &job) {
            Ok(answered) => return Ok(answered),
            Err(error) => error.to_string(),
        },
        Err(refusal) => refusal.to_string(),
    };
    // An invalid job is refused for good; if the journal cannot be written, there is no answer.
    journal.refuse(key, &refused, false)
}

/// A removed job of which only the final state is known.
fn forgotten(job: u64, state: &JobState) -> JobView {
    JobView {
        job,
        title: String::new(),
        kind: JobKind::Drawing,
        created_ms: 0,
        phase: state.phase(),
        reason: state.reason().map(str::to_owned),
        waits_for_person: false,
        commands: 0,
        completed: 0,
        planned_s: None,
        left_s: None,
        took_s: None,
        speed_percent: 100.0,
        height_mm: 0.0,
        program: None,
        question: None,
    }
}

/// The reason of a job withdrawn before its arm started it begins with this, followed by the name
/// of the station.
pub const WITHDRAWN: &str = "withdrawn by ";
/// Why a job for an arm with another calibration is not accepted.
const OTHER_ARM: &str = "its commands were made for an arm with another calibration: submit the drawing itself, which is planned at the arm that draws it";
/// The maximum number of characters shown of a station's name.
const LONGEST_NAME: usize = 40;
