//! Offers of jobs by other stations of the fleet.

use std::sync::{Arc, PoisonError};

use axum::Json;
use axum::extract::{FromRequestParts, Path};
use axum::http::request::Parts;
use dobot_api::problem_kinds::{
    ARM_BUSY, DRAWING_PHASE, INVALID, MALFORMED, NO_SUCH_WORK, WORK_REFUSED,
};
use dobot_api::{
    JobPhase, JobView, NewJob, Problem, Request, Role, State, TakesWork, is_same_person,
};
use dobot_arm::Calibration;
use dobot_host::{OfferAnswer, OfferRequest, StationHandle};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::http::app::{App, Peer};
use crate::http::exchange::requester::Requester;
use crate::http::exchange::responses::{Body, JOB, RequestFailed};
use crate::http::resources::drawings::NewDrawing;
use crate::{FleetPort, UNSETTLED, work_hurdle};

/// A job that a station offers: a drawing or a list of commands.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct FleetOffer {
    /// The name of the offering station.
    pub(crate) by: String,
    /// The student who owns the job.
    pub(crate) student: String,
    /// A drawing, which is planned here.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) drawing: Option<NewDrawing>,
    /// A job.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) job: Option<NewJob>,
    /// The calibration of the arm for which the job's positions were computed, as ten numbers.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) made_for: Option<Vec<f64>>,
}

/// A caller that may offer jobs: a station of the fleet if the owner of this one has allowed it
/// (`dobot up --takes-work`), or a caller that may queue jobs.
#[derive(Debug)]
pub(crate) struct Offerer(Requester);

impl FromRequestParts<Arc<App>> for Offerer {
    type Rejection = RequestFailed;

    async fn from_request_parts(parts: &mut Parts, app: &Arc<App>) -> Result<Self, RequestFailed> {
        let by_fleet = parts
            .extensions
            .get::<Peer>()
            .is_some_and(|token| token.by_fleet);
        let requester = Requester::from_request_parts(parts, app).await?;
        if !by_fleet {
            requester.check_role(Role::Queue)?;
        }
        Ok(Self(requester))
    }
}

/// Accepts a job if the arm is free for it, or refuses it for good under this key.
pub(crate) async fn offer(
    Offerer(requester): Offerer,
    Body(offered): Body<FleetOffer, JOB>,
) -> Result<Json<JobView>, RequestFailed> {
    let app = &requester.app;
    offered.drawing.as_ref().map_or(Ok(()), NewDrawing::check)?;
    let port = app.fleet()?;
    let key = requester
        .key
        .clone()
        .ok_or_else(|| MALFORMED.problem("an offer needs a key in the header Idempotency-Key"))?;
    let known = app.handle.offer(&key, OfferRequest::Look).await?;
    if known != OfferAnswer::Unknown {
        return Ok(Json(answered(known)?));
    }
    let student = offered.student.clone();
    let ask = response(app, port, offered, &key).await?;
    let job = answered(app.handle.offer(&key, ask).await?)?;
    if job.phase == JobPhase::Queued && port.takes_work() == Some(TakesWork::Start) {
        tokio::spawn(start(app.handle.clone(), job.job, student));
    }
    Ok(Json(job))
}

/// Returns the request to the driver: to take the job, or to refuse it under this key.
async fn response(
    app: &App,
    port: &FleetPort,
    offered: FleetOffer,
    key: &str,
) -> Result<OfferRequest, Problem> {
    let Some(takes_work) = port.takes_work() else {
        return Ok(OfferRequest::Refuse {
            busy: false,
            reason: format!(
                "{} accepts no jobs of its fleet; allow it with `dobot up --takes-work`",
                port.name()
            ),
        });
    };
    match not_now(app, port, takes_work, &offered.student) {
        Some(reason) => Ok(OfferRequest::Refuse { reason, busy: true }),
        None => offered.ask(app, key).await,
    }
}

/// Returns the state of an offer.
pub(crate) async fn look(
    Offerer(requester): Offerer,
    Path(key): Path<String>,
) -> Result<Json<JobView>, RequestFailed> {
    let answer = requester.app.handle.offer(&key, OfferRequest::Look).await?;
    Ok(Json(answered(answer)?))
}

/// Withdraws an offer: no job is created from it any more, and an existing one ends if it has not
/// begun.
pub(crate) async fn withdraw(
    Offerer(requester): Offerer,
    Path(key): Path<String>,
) -> Result<Json<JobView>, RequestFailed> {
    let by = requester.caller.name.clone();
    let ask = OfferRequest::Withdraw { by };
    Ok(Json(answered(
        requester.app.handle.offer(&key, ask).await?,
    )?))
}

fn answered(answer: OfferAnswer) -> Result<JobView, Problem> {
    match answer {
        OfferAnswer::Taken(job) => Ok(*job),
        OfferAnswer::Refused { reason, busy: true } => Err(ARM_BUSY.problem(reason)),
        OfferAnswer::Refused { reason, .. } => Err(WORK_REFUSED.problem(reason)),
        OfferAnswer::Unknown => {
            Err(NO_SUCH_WORK.problem("nothing was offered here under this key"))
        }
    }
}

impl FleetOffer {
    /// Returns the request to the driver, after planning a drawing.
    async fn ask(self, app: &App, key: &str) -> Result<OfferRequest, Problem> {
        let (mut job, made_for) = match (self.drawing, self.job) {
            (None, Some(job)) => (job, calibration(self.made_for)?),
            (Some(drawing), None) => {
                let planned_for = app.planned_for();
                let made_for = planned_for.arm();
                let _planning = Planning::begin(app, key)?;
                match app.drawings.plan(drawing, planned_for).await {
                    Ok(job) => (job, made_for),
                    // A temporary obstacle, such as too many other plans, is not a final refusal.
                    Err(problem) if problem.status != 422 => return Err(problem),
                    Err(problem) => {
                        let reason = problem.detail;
                        let busy = false;
                        return Ok(OfferRequest::Refuse { reason, busy });
                    }
                }
            }
            _ => return Err(INVALID.problem("an offer must have a drawing or a job, not both")),
        };
        job.title = title_by(&job.title, &self.student);
        Ok(OfferRequest::Take {
            job: Box::new(job),
            made_for: Some(made_for),
        })
    }
}

/// Adds the student to the title of a job, which is cut if necessary.
fn title_by(title: &str, student: &str) -> String {
    let by = format!(" ({student})");
    let room = LONGEST_TITLE.saturating_sub(by.chars().count());
    title.chars().take(room).chain(by.chars()).collect()
}

fn calibration(numbers: Option<Vec<f64>>) -> Result<Calibration, Problem> {
    let Some(numbers) = numbers else {
        return Ok(Calibration::NONE);
    };
    let numbers: [f64; 10] = numbers.try_into().map_err(|numbers: Vec<f64>| {
        let found = numbers.len();
        INVALID.problem(format!("made_for has {found} numbers; allowed are 10"))
    })?;
    Ok(Calibration::from_numbers(numbers))
}

/// A drawing that is being planned for an offer: repeated offers do not plan it again.
struct Planning<'a> {
    app: &'a App,
    key: String,
}

impl<'a> Planning<'a> {
    fn begin(app: &'a App, key: &str) -> Result<Self, Problem> {
        let key = key.to_owned();
        let mut all = app.planning.lock().unwrap_or_else(PoisonError::into_inner);
        if !all.insert(key.clone()) {
            return Err(
                DRAWING_PHASE.hinted("the drawing is being planned", "retry in some seconds")
            );
        }
        Ok(Self { app, key })
    }
}

impl Drop for Planning<'_> {
    fn drop(&mut self) {
        let mut all = self
            .app
            .planning
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        all.remove(&self.key);
    }
}

/// Returns why a job of this student is not accepted now: the arm could not start it, or another
/// student's time slot is active.
fn not_now(app: &App, port: &FleetPort, takes_work: TakesWork, student: &str) -> Option<String> {
    if !port.is_settled() {
        return Some(UNSETTLED.into());
    }
    let snapshot = app.handle.state();
    let state = snapshot.state();
    work_hurdle(state, takes_work).or_else(|| others_time(state, student))
}

/// Returns why a job of this student is not accepted now because of another student's time slot.
fn others_time(state: &State, student: &str) -> Option<String> {
    let now = state.slots.as_ref()?.now.as_ref()?;
    let is_others = !is_same_person(&now.student, student);
    is_others.then(|| format!("it is the time of {} at this arm", now.student))
}

/// Starts a job of the fleet if the owner has allowed it and nobody has control; otherwise a person
/// has to start it.
async fn start(handle: StationHandle, job: u64, student: String) {
    let coming = handle.client_of("work of the fleet", Role::Control, &student);
    let Ok(client) = coming.await else {
        return;
    };
    for request in [Request::TakeLease, Request::StartJob { job }] {
        if let Err(refusal) = client.request(request).await {
            tracing::info!(%refusal, job, "work of the fleet waits for a person");
            return;
        }
    }
    // The lease is held until the job rests.
    let mut states = handle.states();
    let rests = states.wait_for(|snapshot| {
        let at = snapshot.state().job.as_ref().filter(|view| view.job == job);
        at.is_none_or(|view| view.phase != JobPhase::Running)
    });
    drop(rests.await);
}

const LONGEST_TITLE: usize = 200;
