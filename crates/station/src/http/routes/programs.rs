//! Taught programs: checked, edited, converted to jobs.

use std::sync::Arc;

use axum::Json;
use axum::extract::State;
use axum::response::Response;
use dobot_api::problem_kinds::{
    BAD_JOB, BAD_PROGRAM, COMMAND, ENDING, JOURNAL, OUT_OF_RANGE, POLICY, TOO_MANY,
};

use super::POST;
use crate::http::app::App;
use crate::http::exchange::requester::Requester;
use crate::http::exchange::responses::{Body, JOB, RequestFailed, beside};
use crate::http::resources::programs::{
    self, ConvertProgram, ConvertedProgram, EditProgram, EditedProgram, NewProgram, ProgramReport,
    ProgramText,
};
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    vec![
        Route::new(
            POST,
            "/api/v1/programs/check",
            "Checks a whole program: its steps, their durations, and all problems",
            check,
        )
        .brings::<Body<ProgramText, JOB>>()
        .example(CHECK_EXAMPLE)
        .gives::<ProgramReport>(200, "the report, also of a program with problems")
        .problems(&[ENDING]),
        Route::new(
            POST,
            "/api/v1/programs/edit",
            "Edits the text of a program; unchanged parts keep their comments and their format",
            edit,
        )
        .brings::<Body<EditProgram, JOB>>()
        .example(EDIT_EXAMPLE)
        .gives::<EditedProgram>(200, "the text")
        .problems(&[BAD_PROGRAM, OUT_OF_RANGE, ENDING]),
        Route::new(
            POST,
            "/api/v1/programs/convert",
            "Converts a file of the vendor's software (`PlayBackPoints.xml`, `.play`) into the text of a program, or the text \
                into such a file; reports what the target format cannot represent",
            convert,
        )
        .brings::<Body<ConvertProgram, JOB>>()
        .example(CONVERT_EXAMPLE)
        .gives::<ConvertedProgram>(200, "the text")
        .problems(&[BAD_PROGRAM, ENDING]),
        Route::new(
            POST,
            "/api/v1/programs/jobs",
            "Queues a program as a job, unless it has problems",
            submit,
        )
        .brings::<Body<NewProgram, JOB>>()
        .example(JOB_EXAMPLE)
        .queues()
        .problems(&[BAD_PROGRAM, BAD_JOB, POLICY, COMMAND, OUT_OF_RANGE, TOO_MANY, JOURNAL]),
    ]
}

const CHECK_EXAMPLE: &str =
    r#"{"text": "title = \"there\"\n\n[[steps]]\ngo = { x = 200, y = 0, z = 50 }\n"}"#;
const EDIT_EXAMPLE: &str = r#"{"text": "[[steps]]\ngo = { x = 200, y = 0, z = 50 }\n", "edits": [{"type": "insert", "at": 1, "step": {"suction": true, "pause": 0.5}}]}"#;
const CONVERT_EXAMPLE: &str =
    r#"{"text": "[[steps]]\ngo = { base = 0, rear = 40, fore = 45 }\n", "to": "xml"}"#;
const JOB_EXAMPLE: &str = r#"{"program": {"text": "title = \"there\"\n\n[[steps]]\ngo = { x = 200, y = 0, z = 50 }\n"}, "times": {"count": 3}}"#;

async fn check(
    State(app): State<Arc<App>>,
    Body(program): Body<ProgramText, JOB>,
) -> Result<Json<ProgramReport>, RequestFailed> {
    let report = beside(move || programs::report(&program, &app.planned_for()));
    Ok(Json(report.await?))
}

async fn edit(Body(asked): Body<EditProgram, JOB>) -> Result<Json<EditedProgram>, RequestFailed> {
    Ok(Json(beside(move || programs::edit(asked)).await??))
}

async fn convert(
    State(app): State<Arc<App>>,
    Body(asked): Body<ConvertProgram, JOB>,
) -> Result<Json<ConvertedProgram>, RequestFailed> {
    let converted = beside(move || programs::convert(&asked, &app.planned_for())).await??;
    Ok(Json(converted))
}

async fn submit(
    requester: Requester,
    Body(new): Body<NewProgram, JOB>,
) -> Result<Response, RequestFailed> {
    let app = requester.app.clone();
    let made = new.stored.map(|file| (file, None));
    let job = beside(move || programs::job(&new, &app.planned_for()));
    let job = job.await??;
    requester.queue_of_file(job, made).await
}
