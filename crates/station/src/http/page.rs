//! The page, which is part of the program.

use axum::http::header::CONTENT_TYPE;
use axum::response::{IntoResponse, Response};

pub(super) async fn html() -> Response {
    file(
        "text/html; charset=utf-8",
        include_str!("../../page/index.html"),
    )
}

pub(super) async fn css() -> Response {
    file(
        "text/css; charset=utf-8",
        include_str!("../../page/page.css"),
    )
}

pub(super) async fn js() -> Response {
    script(include_str!("../../page/page.js"))
}

pub(super) async fn preview() -> Response {
    script(include_str!("../../page/preview.js"))
}

pub(super) async fn look() -> Response {
    script(include_str!("../../page/look.js"))
}

pub(super) async fn reader() -> Response {
    script(include_str!("../../page/reader.js"))
}

pub(super) async fn sketch() -> Response {
    script(include_str!("../../page/sketch.js"))
}

pub(super) async fn timeline() -> Response {
    script(include_str!("../../page/timeline.js"))
}

fn script(text: &'static str) -> Response {
    file("text/javascript; charset=utf-8", text)
}

fn file(kind: &'static str, text: &'static str) -> Response {
    ([(CONTENT_TYPE, kind)], text).into_response()
}
