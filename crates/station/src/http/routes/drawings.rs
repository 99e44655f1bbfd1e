//! Drawings: planned, shown, converted to jobs.

use std::sync::Arc;

use axum::Json;
use axum::extract::State;
use axum::http::StatusCode;
use axum::http::header::LOCATION;
use axum::response::{IntoResponse, Response};
use dobot_api::Role;
use dobot_api::problem_kinds::{
    BAD_DRAWING, BAD_JOB, COMMAND, DRAWING_PHASE, ENDING, FILES_UNUSABLE, JOURNAL, MALFORMED,
    NO_SUCH_DRAWING, NO_SUCH_FILE, OUT_OF_RANGE, POLICY, TOO_MANY,
};
use dobot_draw::{FORMATS, Format};
use schemars::JsonSchema;
use serde::Deserialize;

use super::{DELETE, GET, POST};
use crate::http::app::App;
use crate::http::exchange::requester::Requester;
use crate::http::exchange::responses::{Body, Maybe, Number, RequestFailed, json};
use crate::http::resources::drawings::{self, DrawingPart, DrawingView, MaterialView, NewDrawing};
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    vec![
        Route::new(
            POST,
            "/api/v1/drawings",
            "Starts to plan a file or a text as a drawing; the 16 latest are kept",
            begin,
        )
        .brings::<Body<NewDrawing, FILE>>()
        .example(EXAMPLE)
        .gives::<DrawingView>(
            202,
            "the drawing is being planned; the header Location contains its path",
        )
        .problems(&[BAD_DRAWING, TOO_MANY, NO_SUCH_FILE, FILES_UNUSABLE]),
        Route::new(
            GET,
            "/api/v1/drawings/{id}",
            "A drawing, as soon as it is planned, or its state after a second",
            view,
        )
        .gives::<DrawingView>(200, "the drawing")
        .problems(&[MALFORMED, NO_SUCH_DRAWING]),
        Route::new(
            DELETE,
            "/api/v1/drawings/{id}",
            "Deletes a drawing; a running plan is cancelled",
            forget,
        )
        .gives_nothing(204, "the drawing is deleted")
        .problems(&[MALFORMED, NO_SUCH_DRAWING]),
        Route::new(
            POST,
            "/api/v1/drawings/{id}/jobs",
            "Queues a planned drawing as a job, or its outline with the laser off",
            submit,
        )
        .brings::<Maybe<DrawingJob>>()
        .example(r#"{"part": "whole"}"#)
        .queues()
        .problems(&[MALFORMED, NO_SUCH_DRAWING, DRAWING_PHASE, BAD_DRAWING])
        .problems(&[
            BAD_JOB,
            POLICY,
            COMMAND,
            OUT_OF_RANGE,
            TOO_MANY,
            JOURNAL,
            ENDING,
        ]),
        Route::new(
            GET,
            "/api/v1/materials",
            "The pens and materials for drawings",
            materials,
        )
        .gives::<Vec<MaterialView>>(200, "the pens and materials"),
        Route::new(
            GET,
            "/api/v1/formats",
            "The supported file formats",
            formats,
        )
        .gives::<Vec<Format>>(200, "the formats"),
    ]
}

/// The maximum size of a drawing: its file is a third larger in Base64.
const FILE: usize = 32 * 1024 * 1024;

const EXAMPLE: &str =
    r#"{"options": {"what": {"text": "Hello"}, "place": {"at": [210, 0], "pen_down": -40}}}"#;

/// The part of a drawing to be queued as a job.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
struct DrawingJob {
    /// The part.
    part: DrawingPart,
}

async fn begin(
    requester: Requester,
    Body(mut new): Body<NewDrawing, FILE>,
) -> Result<Response, RequestFailed> {
    requester.check_role(Role::Queue)?;
    let app = &requester.app;
    if let Some(file) = new.stored() {
        new.check()?;
        let name = app.files.view(file).await?.name;
        new.read(name, app.files.content(file).await?)?;
    }
    let view = app.drawings.begin(new, app.planned_for())?;
    let place = format!("/api/v1/drawings/{}", view.drawing);
    Ok((StatusCode::ACCEPTED, [(LOCATION, place)], Json(view)).into_response())
}

async fn view(
    State(app): State<Arc<App>>,
    Number(drawing): Number,
) -> Result<Response, RequestFailed> {
    Ok(json(app.drawings.view(drawing).await?))
}

async fn forget(
    requester: Requester,
    Number(drawing): Number,
) -> Result<StatusCode, RequestFailed> {
    requester.check_role(Role::Queue)?;
    requester.app.drawings.forget(drawing)?;
    Ok(StatusCode::NO_CONTENT)
}

async fn submit(
    requester: Requester,
    Number(drawing): Number,
    Maybe(DrawingJob { part }): Maybe<DrawingJob>,
) -> Result<Response, RequestFailed> {
    let app = &requester.app;
    let job = app.drawings.job(drawing, part)?;
    let made = match part {
        DrawingPart::Whole => app.drawings.stored(drawing),
        DrawingPart::Frame => None,
    };
    let made = made.map(|(file, options)| (file, Some(options)));
    requester.queue_of_file(job, made).await
}

async fn materials() -> Json<Vec<MaterialView>> {
    Json(drawings::materials())
}

async fn formats() -> Json<&'static [Format]> {
    Json(&FORMATS)
}
