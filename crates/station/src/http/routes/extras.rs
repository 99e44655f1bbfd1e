//! Optional parts of the page.

use std::fs;
use std::sync::Arc;

use axum::Json;
use axum::extract::{Path, State};
use axum::http::header::{CACHE_CONTROL, CONTENT_TYPE};
use axum::response::{IntoResponse, Response};
use dobot_api::problem_kinds::NO_SUCH_FILE;
use tokio::task::spawn_blocking;

use super::GET;
use crate::EXTRAS;
use crate::http::app::App;
use crate::http::exchange::responses::RequestFailed;
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    vec![
        Route::new(
            GET,
            "/api/v1/extras",
            "The optional parts of the page that are installed (`dobot extras`)",
            installed,
        )
        .gives::<Vec<String>>(200, "their names"),
        Route::new(
            GET,
            "/extras/{extra}/{file}",
            "A file of an optional part of the page",
            file,
        )
        .open()
        .gives_text(200, "application/octet-stream", "the file")
        .problems(&[NO_SUCH_FILE]),
    ]
}

async fn installed(State(app): State<Arc<App>>) -> Json<Vec<&'static str>> {
    let installed = EXTRAS.iter().filter(|it| it.is_installed(&app.extras));
    Json(installed.map(|extra| extra.name).collect())
}

async fn file(
    State(app): State<Arc<App>>,
    Path((extra, name)): Path<(String, String)>,
) -> Result<Response, RequestFailed> {
    let extra = EXTRAS.iter().find(|it| it.name == extra);
    let path = extra.and_then(|extra| extra.file(&app.extras, &name));
    let read = spawn_blocking(move || path.and_then(|path| fs::read(path).ok()));
    let content = read.await.ok().flatten();
    let content = content.ok_or_else(|| {
        let name: String = name.chars().take(80).collect();
        let hint = "`dobot extras` says how to install optional parts";
        RequestFailed(NO_SUCH_FILE.hinted(format!("there is no file {name:?} here"), hint))
    })?;
    let about = [
        (CONTENT_TYPE, content_type(&name)),
        (CACHE_CONTROL, "no-cache"),
    ];
    Ok((about, content).into_response())
}

fn content_type(name: &str) -> &'static str {
    match name.rsplit('.').next() {
        Some("js") => "text/javascript; charset=utf-8",
        Some("wasm") => "application/wasm",
        _ => "application/octet-stream",
    }
}
