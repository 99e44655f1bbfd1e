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
    let (summary, what) = words(essence);
    Route::new(Method::GET, file.path, summary, answer)
        .open()
        .gives_text(200, essence, what)
}

/// What the document says about a file of this type: what it is for, and what it is called.
fn words(essence: &str) -> (&'static str, &'static str) {
    match essence {
        "text/html" => ("A page to watch and move the arm", "the page"),
        "text/css" => ("How the page looks", "the style"),
        "text/javascript" => ("A part of what the page does", "the module"),
        "application/json" => ("The words of the page", "the words"),
        _ => ("The licence of a part of the page", "the text"),
    }
}
