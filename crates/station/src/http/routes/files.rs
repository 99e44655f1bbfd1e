//! The files that the station stores.

use std::sync::Arc;

use axum::Json;
use axum::extract::rejection::QueryRejection;
use axum::extract::{Query as Queries, State};
use axum::http::StatusCode;
use axum::http::header::{CONTENT_DISPOSITION, CONTENT_TYPE, LOCATION};
use axum::response::{IntoResponse, Response};
use dobot_api::Role;
use dobot_api::problem_kinds::{
    BAD_DRAWING, ENDING, FILE_CHANGED, FILE_EXISTS, FILE_NAME, FILES_FULL, FILES_UNUSABLE,
    MALFORMED, NO_SUCH_FILE,
};
use schemars::SchemaGenerator;
use serde::Deserialize;

use super::{DELETE, GET, POST, PUT};
use crate::http::app::App;
use crate::http::exchange::requester::Requester;
use crate::http::exchange::responses::{Body, Number, RequestFailed};
use crate::http::resources::files::{ChangeFile, FileView, FilesView, NewFile};
use crate::http::resources::sketch::Sketch;
use crate::http::route::{Query, Route};

pub(super) fn all() -> Vec<Route> {
    let reads = [MALFORMED, FILES_UNUSABLE, ENDING];
    let writes = [
        BAD_DRAWING,
        FILE_NAME,
        FILE_EXISTS,
        FILES_FULL,
        FILES_UNUSABLE,
        ENDING,
    ];
    vec![
        Route::new(
            GET,
            "/api/v1/files",
            "The stored drawings, photos and programs, and their space",
            list,
        )
        .queries(SEARCH)
        .gives::<FilesView>(200, "the files")
        .problems(&reads),
        Route::new(POST, "/api/v1/files", "Stores a file", add)
            .brings::<Body<NewFile, FILE>>()
            .example(EXAMPLE)
            .gives::<FileView>(200, "the file was already there, with this content")
            .gives::<FileView>(
                201,
                "the file is stored; the header Location contains its path",
            )
            .problems(&writes),
        Route::new(GET, "/api/v1/files/{id}", "A stored file", view)
            .gives::<FileView>(200, "the file")
            .problems(&reads)
            .problems(&[NO_SUCH_FILE]),
        Route::new(
            GET,
            "/api/v1/files/{id}/content",
            "The content of a stored file",
            content,
        )
        .gives_text(200, "application/octet-stream", "the content")
        .problems(&reads)
        .problems(&[NO_SUCH_FILE]),
        Route::new(
            GET,
            "/api/v1/files/{id}/sketch",
            "A small picture of a stored drawing or photo; null until it is made",
            sketch,
        )
        .gives::<Option<Sketch>>(200, "the picture")
        .problems(&reads)
        .problems(&[NO_SUCH_FILE]),
        Route::new(
            PUT,
            "/api/v1/files/{id}",
            "Changes name, content or options of a stored file",
            change,
        )
        .brings::<Body<ChangeFile, FILE>>()
        .example(r#"{"revision": 1, "options": {"place": {"at": [200, 20]}}}"#)
        .gives::<FileView>(200, "the file")
        .problems(&writes)
        .problems(&[MALFORMED, NO_SUCH_FILE, FILE_CHANGED]),
        Route::new(
            DELETE,
            "/api/v1/files/{id}",
            "Deletes a stored file",
            remove,
        )
        .gives_nothing(204, "the file is deleted")
        .problems(&reads)
        .problems(&[NO_SUCH_FILE]),
    ]
}

/// The maximum size of a request: its content is a third larger in Base64.
const FILE: usize = 32 * 1024 * 1024;

const EXAMPLE: &str = r#"{"name": "dot.hpgl", "content": "SU47UFUwLDA7UEQ0MDAsMDtQVTs="}"#;

const SEARCH: &[Query] = &[Query {
    name: "search",
    what: "Text that the names contain, whatever its case (default: all files)",
    schema: SchemaGenerator::subschema_for::<String>,
}];

#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Search {
    search: String,
}

async fn list(
    State(app): State<Arc<App>>,
    search: Result<Queries<Search>, QueryRejection>,
) -> Result<Json<FilesView>, RequestFailed> {
    let Queries(Search { search }) =
        search.map_err(|error| MALFORMED.problem(error.body_text()))?;
    Ok(Json(app.files.list(search).await?))
}

async fn add(
    requester: Requester,
    Body(new): Body<NewFile, FILE>,
) -> Result<Response, RequestFailed> {
    requester.check_role(Role::Queue)?;
    let (view, is_new) = requester.app.files.add(new).await?;
    if !is_new {
        return Ok(Json(view).into_response());
    }
    draw(&requester.app, &view);
    let place = format!("/api/v1/files/{}", view.file);
    Ok((StatusCode::CREATED, [(LOCATION, place)], Json(view)).into_response())
}

async fn view(
    State(app): State<Arc<App>>,
    Number(file): Number,
) -> Result<Json<FileView>, RequestFailed> {
    Ok(Json(app.files.view(file).await?))
}

async fn content(
    State(app): State<Arc<App>>,
    Number(file): Number,
) -> Result<Response, RequestFailed> {
    let headers = [
        (CONTENT_TYPE, "application/octet-stream"),
        (CONTENT_DISPOSITION, "attachment"),
    ];
    Ok((headers, app.files.content(file).await?).into_response())
}

async fn sketch(
    State(app): State<Arc<App>>,
    Number(file): Number,
) -> Result<Json<Option<Sketch>>, RequestFailed> {
    Ok(Json(app.files.sketch(file).await?))
}

async fn change(
    requester: Requester,
    Number(file): Number,
    Body(change): Body<ChangeFile, FILE>,
) -> Result<Json<FileView>, RequestFailed> {
    requester.check_role(Role::Queue)?;
    let (view, is_new) = requester.app.files.change(file, change).await?;
    if is_new {
        draw(&requester.app, &view);
    }
    Ok(Json(view))
}

async fn remove(requester: Requester, Number(file): Number) -> Result<StatusCode, RequestFailed> {
    requester.check_role(Role::Queue)?;
    requester.app.files.remove(file).await?;
    Ok(StatusCode::NO_CONTENT)
}

/// Makes the picture of a new content, after the response.
fn draw(app: &Arc<App>, view: &FileView) {
    if view.is_drawn() {
        tokio::spawn(app.clone().sketch_file(view.clone()));
    }
}
