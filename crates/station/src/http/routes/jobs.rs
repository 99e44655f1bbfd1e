//! Jobs.

use std::sync::Arc;

use axum::Json;
use axum::extract::State;
use axum::response::Response;
use dobot_api::problem_kinds::{
    BAD_JOB, CANNOT_RESUME, COMMAND, ENDING, JOB_PHASE, JOURNAL, LOCKED, MALFORMED, NEEDS_PERSON,
    NO_JOB_RUNS, NO_LEASE, NO_SUCH_JOB, OUT_OF_RANGE, POLICY, SLOT, TOO_MANY,
};
use dobot_api::{JobPath, JobView, NewJob, Reply, Request};
use dobot_supervisor::Refusal;
use schemars::JsonSchema;
use serde::Deserialize;

use super::{ADJUSTS, DELETE, GET, MOVES, POST, PUT};
use crate::http::app::App;
use crate::http::exchange::answer::{Body, JOB, Maybe, NotDone, Nothing, Number, OfJob};
use crate::http::exchange::paging::{PAGES, Page};
use crate::http::exchange::requester::{Asker, queued};
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    [kept(), carried_out()].concat()
}

/// What is done with the list of jobs.
fn kept() -> Vec<Route> {
    vec![
        Route::new(
            GET,
            "/api/v1/jobs",
            "All jobs: the oldest first, unless queued ones were moved",
            all_jobs,
        )
        .queries(PAGES)
        .gives::<Vec<JobView>>(200, "the jobs")
        .problems(&[MALFORMED, OUT_OF_RANGE, JOURNAL, ENDING]),
        Route::new(POST, "/api/v1/jobs", "Queues a job", submit)
            .brings::<Body<NewJob, JOB>>()
            .example(JOB_EXAMPLE)
            .queues()
            .problems(&[BAD_JOB, POLICY, COMMAND, OUT_OF_RANGE, TOO_MANY, JOURNAL]),
        Route::new(GET, "/api/v1/jobs/{id}", "One job", one)
            .gives::<JobView>(200, "the job")
            .problems(&[MALFORMED, NO_SUCH_JOB, ENDING]),
        Route::new(
            GET,
            "/api/v1/jobs/{id}/path",
            "The way of a job, once through its commands, as it was planned",
            path,
        )
        .gives::<JobPath>(200, "the way")
        .problems(&[MALFORMED, NO_SUCH_JOB, BAD_JOB, JOURNAL, ENDING]),
        Route::asks(
            DELETE,
            "/api/v1/jobs/{id}",
            "Ends a job for good",
            |OfJob(job)| Request::CancelJob { job },
        )
        .gives::<Reply>(200, "the job is over")
        .problems(&[NO_LEASE, LOCKED, SLOT, NO_SUCH_JOB, JOB_PHASE, JOURNAL]),
        Route::new(
            POST,
            "/api/v1/jobs/{id}/again",
            "Queues what a job does once more, as a new job that is planned anew",
            again,
        )
        .brings::<OfJob>()
        .queues()
        .problems(&[
            NO_SUCH_JOB,
            BAD_JOB,
            POLICY,
            COMMAND,
            OUT_OF_RANGE,
            TOO_MANY,
            JOURNAL,
        ]),
        Route::new(
            PUT,
            "/api/v1/jobs/{id}/place",
            "Puts a queued job before another queued one, or behind all of them",
            place,
        )
        .brings::<Body<Place>>()
        .example(r#"{"before": 3}"#)
        .gives::<Reply>(200, "the job has its place")
        .problems(&[MALFORMED, NO_SUCH_JOB, JOB_PHASE, JOURNAL]),
        Route::asks(
            POST,
            "/api/v1/jobs/{id}/forget",
            "Forgets a job that is over, or that has not begun",
            |OfJob(job)| Request::ForgetJob { job },
        )
        .gives::<Reply>(200, "the job is forgotten")
        .problems(&[NO_SUCH_JOB, JOB_PHASE, JOURNAL]),
    ]
}

/// What is done with the job that the arm is at, or is to be at.
fn carried_out() -> Vec<Route> {
    vec![
        Route::asks(
            POST,
            "/api/v1/jobs/{id}/start",
            "Starts a queued job, or goes on with a paused one",
            |OfJob(job)| Request::StartJob { job },
        )
        .gives::<Reply>(200, "the job runs")
        .problems(MOVES)
        .problems(&[
            NO_SUCH_JOB,
            JOB_PHASE,
            BAD_JOB,
            CANNOT_RESUME,
            NEEDS_PERSON,
            JOURNAL,
        ]),
        Route::asks(
            POST,
            "/api/v1/jobs/{id}/confirm",
            "Says that a person has done what a paused job waits for; start it again then",
            |OfJob(job)| Request::ConfirmJob { job },
        )
        .gives::<Reply>(200, "the job may go on")
        .problems(&[NO_LEASE, LOCKED, SLOT]),
        Route::asks(
            POST,
            "/api/v1/jobs/{id}/step",
            "Does the next step of a queued or paused job, and pauses behind it",
            |OfJob(job)| Request::StepJob { job },
        )
        .gives::<Reply>(200, "the step is under way")
        .problems(MOVES)
        .problems(&[
            NO_SUCH_JOB,
            JOB_PHASE,
            BAD_JOB,
            CANNOT_RESUME,
            NEEDS_PERSON,
            JOURNAL,
        ]),
        Route::asks(
            POST,
            "/api/v1/jobs/pause",
            "Pauses the running job after what the arm has got already",
            |_: Maybe<Nothing>| Request::PauseJob,
        )
        .gives::<Reply>(200, "the job is paused")
        .problems(&[NO_LEASE, LOCKED, SLOT, NO_JOB_RUNS, JOURNAL]),
        Route::asks(
            PUT,
            "/api/v1/jobs/speed",
            "Draws the vectors of the job faster or slower than planned, from \
                the next one on that is not sent yet",
            |Body(new): Body<Speed>| Request::SetJobSpeed {
                percent: new.percent,
            },
        )
        .example(r#"{"percent": 80}"#)
        .gives::<Reply>(200, "the job goes at this speed")
        .problems(ADJUSTS),
        Route::asks(
            PUT,
            "/api/v1/jobs/height",
            "Draws the job higher or lower than planned, gently, from the next \
                command on that is not sent yet",
            |Body(new): Body<Height>| Request::SetJobHeight {
                offset_mm: new.offset_mm,
            },
        )
        .example(r#"{"offset_mm": 0.2}"#)
        .gives::<Reply>(200, "the job is drawn at this height")
        .problems(ADJUSTS)
        .problems(&[POLICY]),
    ]
}

const JOB_EXAMPLE: &str = r#"{"title": "there and back", "kind": "program", "commands": [{"type": "move_to", "x_mm": 200, "y_mm": 0, "z_mm": 50, "rotation_deg": 0, "suction": false, "mode": "jump", "gripper_deg": 0, "pause_s": 0}]}"#;

/// How fast a job is drawn.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Speed {
    /// In percent of the planned speed.
    #[schemars(range(min = 10.0, max = 200.0))]
    percent: f64,
}

/// How high a job is drawn.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Height {
    /// How far above the plan, in millimetres; below 0 is lower.
    #[schemars(range(min = -5.0, max = 5.0))]
    offset_mm: f64,
}

/// Where a queued job stands in the list.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Place {
    /// The number of the queued job that comes behind it; without it the job comes last.
    #[serde(default)]
    before: Option<u64>,
}

async fn place(
    asker: Asker,
    Number(job): Number,
    Body(Place { before }): Body<Place>,
) -> Result<Json<Reply>, NotDone> {
    asker.ask(Request::MoveJob { job, before }).await
}

async fn submit(asker: Asker, Body(job): Body<NewJob, JOB>) -> Result<Response, NotDone> {
    asker.queue(job).await
}

async fn again(asker: Asker, OfJob(job): OfJob) -> Result<Response, NotDone> {
    let key = asker.key.clone();
    let reply = asker.ask(Request::QueueAgain { job, key }).await?;
    Ok(queued(reply))
}

async fn all_jobs(State(app): State<Arc<App>>, page: Page) -> Result<Response, NotDone> {
    page.of(&app.handle.jobs().await?, |job| job.job.to_string())
}

async fn one(State(app): State<Arc<App>>, Number(job): Number) -> Result<Json<JobView>, NotDone> {
    let found = app
        .handle
        .jobs()
        .await?
        .into_iter()
        .find(|view| view.job == job);
    found
        .map(Json)
        .ok_or_else(|| Refusal::NoSuchJob(job).into())
}

async fn path(State(app): State<Arc<App>>, Number(job): Number) -> Result<Json<JobPath>, NotDone> {
    Ok(Json(app.handle.job_path(job).await?))
}
