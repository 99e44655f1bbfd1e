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
    file(
        "text/javascript; charset=utf-8",
        include_str!("../../page/page.js"),
    )
}

fn file(kind: &'static str, text: &'static str) -> Response {
    ([(CONTENT_TYPE, kind)], text).into_response()
}
