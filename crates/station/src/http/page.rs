//! The page, which is part of the program: a route for each of its files.

use axum::http::Method;
use axum::http::header::CONTENT_TYPE;
use axum::response::IntoResponse;
use dobot_page::{FILES, File};

use super::route::Route;

pub(super) fn all() -> Vec<Route> {
    FILES.iter().map(route).collect()
}

fn route(file: &'static File) -> Route {
    let kind = file.content_type;
    let answer = move || async move { ([(CONTENT_TYPE, kind)], file.bytes).into_response() };
    let essence = kind.split(';').next().unwrap_or(kind);
    Route::new(Method::GET, file.path, file.summary, answer)
        .open()
        .gives_text(200, essence, what(essence))
}

/// What the document calls a file of this type.
fn what(essence: &str) -> &'static str {
    match essence {
        "text/html" => "the page",
        "text/css" => "the style",
        "text/javascript" => "the module",
        _ => "the file",
    }
}
