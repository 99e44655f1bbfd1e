//! Jobs.

use std::sync::Arc;

use axum::Json;
use axum::extract::{Path, State};
use axum::response::Response;
use dobot_api::problem_kinds::{
    BAD_ANSWER, BAD_JOB, CANNOT_RESUME, COMMAND, ENDING, JOB_PHASE, JOURNAL, LOCKED, MALFORMED,
    NEEDS_PERSON, NO_JOB_RUNS, NO_LEASE, NO_QUESTION, NO_SUCH_JOB, OUT_OF_RANGE, POLICY, SLOT,
    TOO_MANY,
};
use dobot_api::{Answer, GivenPlace, JobPath, JobView, NewJob, Reply, Request};
use dobot_supervisor::Refusal;
use schemars::JsonSchema;
use serde::Deserialize;

use super::{ADJUSTS, DELETE, GET, MOVES, POST, PUT};
use crate::http::app::App;
use crate::http::exchange::paging::{PAGES, Page};
use crate::http::exchange::requester::{Requester, queued};
use crate::http::exchange::responses::{
    Body, JOB, Maybe, Nothing, Number, OfJob, RequestFailed, beside, number_in_path,
};
use crate::http::resources::sketch::Sketch;
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    [kept(), carried_out(), answered()].concat()
}

/// Routes for the list of jobs.
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
            "The planned path of a job, once through its commands",
            path,
        )
        .gives::<JobPath>(200, "the way")
        .problems(&[MALFORMED, NO_SUCH_JOB, BAD_JOB, JOURNAL, ENDING]),
        Route::new(
            GET,
            "/api/v1/jobs/{id}/sketch",
            "A small picture of what a job draws, or of its path; null if it does not move",
            sketch,
        )
        .gives::<Option<Sketch>>(200, "the picture")
        .problems(&[MALFORMED, NO_SUCH_JOB, BAD_JOB, JOURNAL, ENDING]),
        Route::asks(
            DELETE,
            "/api/v1/jobs/{id}",
            "Ends a job for good",
            |OfJob(job)| Request::CancelJob { job },
        )
        .gives::<Reply>(200, "the job has ended")
        .problems(&[NO_LEASE, LOCKED, SLOT, NO_SUCH_JOB, JOB_PHASE, JOURNAL]),
        Route::new(
            POST,
            "/api/v1/jobs/{id}/again",
            "Queues a copy of a job, as a new job that is planned again",
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
            "Moves a queued job before another one, or to the end",
            place,
        )
        .brings::<Body<Place>>()
        .example(r#"{"before": 3}"#)
        .gives::<Reply>(200, "the job is moved")
        .problems(&[MALFORMED, NO_SUCH_JOB, JOB_PHASE, JOURNAL]),
        Route::asks(
            POST,
            "/api/v1/jobs/{id}/forget",
            "Deletes a job that has ended, or that has not begun",
            |OfJob(job)| Request::ForgetJob { job },
        )
        .gives::<Reply>(200, "the job is deleted")
        .problems(&[NO_SUCH_JOB, JOB_PHASE, JOURNAL]),
    ]
}

/// Routes for the questions of a running program.
fn answered() -> Vec<Route> {
    vec![
        Route::new(
            POST,
            "/api/v1/jobs/{id}/answer",
            "Answers the question of the running program, which continues with the steps of the answer",
            answer,
        )
        .brings::<Body<ChosenAnswer>>()
        .example(r#"{"answer": "red"}"#)
        .gives::<Reply>(200, "the program continues")
        .problems(&[MALFORMED, NO_SUCH_JOB, NO_QUESTION, BAD_ANSWER, JOURNAL]),
        Route::new(
            PUT,
            "/api/v1/jobs/{id}/places/{name}",
            "Gives the running program the position that it waits for, if the policy allows it",
            give_place,
        )
        .brings::<Body<GivenPlace>>()
        .example(r#"{"x_mm": 200, "y_mm": 50, "z_mm": -20}"#)
        .gives::<Reply>(200, "the program continues")
        .problems(&[MALFORMED, NO_SUCH_JOB, NO_QUESTION, BAD_ANSWER, JOURNAL]),
    ]
}

/// An answer to the question of a job.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ChosenAnswer {
    /// One of the possible answers.
    answer: String,
    /// The number of the question; an answer to an earlier one is refused.
    question: Option<u64>,
}

async fn answer(
    requester: Requester,
    Number(job): Number,
    Body(given): Body<ChosenAnswer>,
) -> Result<Json<Reply>, RequestFailed> {
    let answer = Answer::Choice(given.answer);
    let question = given.question;
    let request = Request::AnswerJob {
        job,
        question,
        answer,
    };
    requester.ask(request).await
}

async fn give_place(
    requester: Requester,
    Path((job, name)): Path<(String, String)>,
    Body(given): Body<GivenPlace>,
) -> Result<Json<Reply>, RequestFailed> {
    let job = number_in_path(&job)?;
    let answer = Answer::Place(GivenPlace {
        name: Some(name),
        ..given
    });
    let request = Request::AnswerJob {
        job,
        question: None,
        answer,
    };
    requester.ask(request).await
}

/// Routes for the current or next job.
fn carried_out() -> Vec<Route> {
    vec![
        Route::asks(
            POST,
            "/api/v1/jobs/{id}/start",
            "Starts a queued job, or resumes a paused one",
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
            "Confirms that a person has done what a paused job waits for; then resume it",
            |OfJob(job)| Request::ConfirmJob { job },
        )
        .gives::<Reply>(200, "the job can be resumed")
        .problems(&[NO_LEASE, LOCKED, SLOT]),
        Route::asks(
            POST,
            "/api/v1/jobs/{id}/step",
            "Runs the next step of a queued or paused job, and pauses after it",
            |OfJob(job)| Request::StepJob { job },
        )
        .gives::<Reply>(200, "the step is running")
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
            "Pauses the running job after the in-flight commands",
            |_: Maybe<Nothing>| Request::PauseJob,
        )
        .gives::<Reply>(200, "the job is paused")
        .problems(&[NO_LEASE, LOCKED, SLOT, NO_JOB_RUNS, JOURNAL]),
        Route::asks(
            PUT,
            "/api/v1/jobs/speed",
            "Changes the drawing speed of the job, from the next unsent \
                vector on",
            |Body(new): Body<Speed>| Request::SetJobSpeed {
                percent: new.percent,
            },
        )
        .example(r#"{"percent": 80}"#)
        .gives::<Reply>(200, "the job runs at this speed")
        .problems(ADJUSTS),
        Route::asks(
            PUT,
            "/api/v1/jobs/height",
            "Changes the drawing height of the job, gradually, from the next unsent \
                command on",
            |Body(new): Body<Height>| Request::SetJobHeight {
                offset_mm: new.offset_mm,
            },
        )
        .example(r#"{"offset_mm": 0.2}"#)
        .gives::<Reply>(200, "the job runs at this height")
        .problems(ADJUSTS)
        .problems(&[POLICY]),
    ]
}

const JOB_EXAMPLE: &str = r#"{"title": "there and back", "kind": "program", "commands": [{"type": "move_to", "x_mm": 200, "y_mm": 0, "z_mm": 50, "rotation_deg": 0, "suction": false, "mode": "jump", "gripper_deg": 0, "pause_s": 0}]}"#;

/// The drawing speed of a job.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Speed {
    /// The percentage of the planned speed.
    #[schemars(range(min = 10.0, max = 200.0))]
    percent: f64,
}

/// The drawing height of a job.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Height {
    /// The offset above the planned height, in millimetres; negative is lower.
    #[schemars(range(min = -5.0, max = 5.0))]
    offset_mm: f64,
}

/// The place of a queued job in the list.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Place {
    /// The number of the queued job that follows it; by default it becomes the last.
    #[serde(default)]
    before: Option<u64>,
}

async fn place(
    requester: Requester,
    Number(job): Number,
    Body(Place { before }): Body<Place>,
) -> Result<Json<Reply>, RequestFailed> {
    requester.ask(Request::MoveJob { job, before }).await
}

async fn submit(
    requester: Requester,
    Body(job): Body<NewJob, JOB>,
) -> Result<Response, RequestFailed> {
    requester.queue(job).await
}

async fn again(requester: Requester, OfJob(job): OfJob) -> Result<Response, RequestFailed> {
    let key = requester.key.clone();
    let reply = requester.ask(Request::QueueAgain { job, key }).await?;
    Ok(queued(reply))
}

async fn all_jobs(State(app): State<Arc<App>>, page: Page) -> Result<Response, RequestFailed> {
    page.of(&app.handle.jobs().await?, |job| job.job.to_string())
}

async fn one(
    State(app): State<Arc<App>>,
    Number(job): Number,
) -> Result<Json<JobView>, RequestFailed> {
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

async fn sketch(
    State(app): State<Arc<App>>,
    Number(job): Number,
) -> Result<Json<Option<Sketch>>, RequestFailed> {
    let path = app.handle.job_path(job).await?;
    Ok(Json(beside(move || Sketch::of_job(&path)).await?))
}

async fn path(
    State(app): State<Arc<App>>,
    Number(job): Number,
) -> Result<Json<JobPath>, RequestFailed> {
    Ok(Json(app.handle.job_path(job).await?))
}
