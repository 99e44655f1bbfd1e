//! The recordings of the station.

use std::sync::Arc;

use axum::Json;
use axum::extract::{Path, Query as Queries, State};
use axum::response::Response;
use dobot_api::problem_kinds::{
    ENDING, MALFORMED, NO_SUCH_RECORDING, NOT_RECORDED, OUT_OF_RANGE, RECORDING,
};
use dobot_api::{EpisodeMark, Reply, Request};
use schemars::{JsonSchema, SchemaGenerator};
use serde::Deserialize;

use super::{GET, POST};
use crate::http::app::App;
use crate::http::exchange::paging::{PAGES, Page};
use crate::http::exchange::responses::{Body, RequestFailed};
use crate::http::resources::recordings::{RecordedStates, RecordingView, Stretch};
use crate::http::route::{Query, Route};

pub(super) fn all() -> Vec<Route> {
    vec![
        Route::asks(
            POST,
            "/api/v1/episodes",
            "Marks the recording: an episode of a dataset begins or ends here, or is discarded",
            |Body(new): Body<NewMark>| Request::MarkEpisode {
                mark: new.mark,
                task: new.task,
            },
        )
        .example(r#"{"mark": "begin", "task": "Pick up the cube."}"#)
        .gives::<Reply>(200, "the mark is recorded")
        .problems(&[NOT_RECORDED]),
        Route::new(
            GET,
            "/api/v1/recordings",
            "The recordings of the station, the oldest first",
            list,
        )
        .queries(PAGES)
        .gives::<Vec<RecordingView>>(200, "the recordings")
        .problems(&[MALFORMED, OUT_OF_RANGE, RECORDING, ENDING]),
        Route::new(
            GET,
            "/api/v1/recordings/{name}",
            "A recording, as an MCAP file; of one that is being written the part so far",
            file,
        )
        .gives_text(200, "application/octet-stream", "the file")
        .problems(&[MALFORMED, NO_SUCH_RECORDING, RECORDING, ENDING]),
        Route::new(
            GET,
            "/api/v1/recordings/{name}/states",
            "The positions of the arm over a part of a recording; of a long one not all statuses",
            states,
        )
        .queries(STRETCH)
        .gives::<RecordedStates>(200, "the positions of the arm")
        .problems(&[
            MALFORMED,
            OUT_OF_RANGE,
            NO_SUCH_RECORDING,
            RECORDING,
            ENDING,
        ]),
    ]
}

/// A mark in the recording.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct NewMark {
    /// The mark.
    mark: EpisodeMark,
    /// What the arm does; only with `begin`. Cut to 200 characters.
    #[serde(default)]
    task: Option<String>,
}

const STRETCH: &[Query] = &[
    Query {
        name: "from_s",
        what: "Begin, in seconds since the origin of the recording (default: 0)",
        schema: SchemaGenerator::subschema_for::<f64>,
    },
    Query {
        name: "to_s",
        what: "End (default: the end of the recording)",
        schema: SchemaGenerator::subschema_for::<f64>,
    },
    Query {
        name: "most",
        what: "Maximum number of samples, 2 to 5000 (default: 2000)",
        schema: SchemaGenerator::subschema_for::<usize>,
    },
];

async fn list(State(app): State<Arc<App>>, page: Page) -> Result<Response, RequestFailed> {
    page.of(&app.recordings.list().await?, |recording| {
        recording.name.clone()
    })
}

async fn file(
    State(app): State<Arc<App>>,
    Path(name): Path<String>,
) -> Result<Response, RequestFailed> {
    Ok(app.recordings.file(&name).await?)
}

async fn states(
    State(app): State<Arc<App>>,
    Path(name): Path<String>,
    stretch: Result<Queries<Stretch>, axum::extract::rejection::QueryRejection>,
) -> Result<Json<RecordedStates>, RequestFailed> {
    let Queries(stretch) = stretch.map_err(|error| MALFORMED.problem(error.body_text()))?;
    stretch
        .check()
        .map_err(|found| OUT_OF_RANGE.problem(found))?;
    Ok(Json(app.recordings.states(&name, stretch).await?))
}
