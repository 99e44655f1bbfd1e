//! The page, which is embedded in the program: a route for each of its files.

use axum::http::Method;
use axum::http::header::CONTENT_TYPE;
use axum::response::IntoResponse;
use dobot_page::{FILES, File};

use crate::http::route::Route;

pub(crate) fn all() -> Vec<Route> {
    FILES.iter().map(route).collect()
}

/// Whether a path belongs to the page or one of its files.
pub(crate) fn has(path: &str) -> bool {
    FILES.iter().any(|file| file.path == path)
}

fn route(file: &'static File) -> Route {
    let kind = file.content_type;
    let answer = move || async move { ([(CONTENT_TYPE, kind)], file.bytes).into_response() };
    let essence = kind.split(';').next().unwrap_or(kind);
    let summary = "A page to watch and move the arm";
    Route::new(Method::GET, file.path, summary, answer)
        .open()
        .gives_text(200, essence, "the page, or one of its files")
}
