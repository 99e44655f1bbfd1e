//! The events, and their form as JSON.

use dobot_api::{JobPhase, JobView, News, Notice};
use jiff::Timestamp;
use serde::{Deserialize, Serialize};

/// An event, ready to be delivered.
#[derive(Clone, Debug)]
pub(super) struct Event {
    pub(super) kind: EventKind,
    /// Its number, the same in each repetition.
    pub(super) id: String,
    /// The event as JSON.
    pub(super) body: Vec<u8>,
}

/// The kind of an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum EventKind {
    /// A job is over: done, stopped or failed.
    JobDone,
    /// A job waits for a person: another pen, or an answer.
    NeedsPerson,
    /// The link to the arm was lost.
    LinkLost,
}

impl EventKind {
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::JobDone => "job-done",
            Self::NeedsPerson => "needs-person",
            Self::LinkLost => "link-lost",
        }
    }
}

/// The body of an event.
#[derive(Debug, Serialize)]
struct Body<'a> {
    event: EventKind,
    id: &'a str,
    time: Timestamp,
    /// The address of the station's page.
    station: &'a str,
    text: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    job: Option<JobView>,
}

/// Returns the event of a notice and the job that it is about, if it is one.
pub(super) fn event(notice: &Notice, job: Option<JobView>, station: &str) -> Option<Event> {
    let kind = match notice.news {
        News::Job { phase, .. } if phase.is_over() => EventKind::JobDone,
        News::Job {
            phase: JobPhase::Paused,
            ..
        } if job.as_ref().is_some_and(|job| job.waits_for_person) => EventKind::NeedsPerson,
        News::JobAsks { .. } if job.as_ref().is_some_and(asks_person) => EventKind::NeedsPerson,
        News::LinkLost => EventKind::LinkLost,
        _ => return None,
    };
    let id = event_id(notice);
    let body = Body {
        event: kind,
        id: &id,
        time: Timestamp::now(),
        station,
        text: &notice.text,
        job,
    };
    let body = serde_json::to_vec(&body).expect("its numbers are finite");
    Some(Event { kind, id, body })
}

/// Returns a random number, or without random numbers that of the notice, which identifies it since the
/// start of the station.
fn event_id(notice: &Notice) -> String {
    let mut id = [0; 16];
    match getrandom::fill(&mut id) {
        Ok(()) => data_encoding::HEXLOWER.encode(&id),
        Err(_) => notice.number.to_string(),
    }
}

fn asks_person(job: &JobView) -> bool {
    let pending = job.question.as_ref();
    pending.is_some_and(|pending| pending.question.is_for_person())
}
