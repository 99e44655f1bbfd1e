//! The page, which is embedded in the program: a route for each of its files.

use std::io::{self, Read};

use axum::http::header::{ACCEPT_ENCODING, CONTENT_ENCODING, CONTENT_TYPE, VARY};
use axum::http::{HeaderMap, HeaderValue, Method};
use axum::response::{IntoResponse, Response};
use dobot_page::{FILES, File};
use flate2::read::GzDecoder;

use crate::http::exchange::responses::RequestFailed;
use crate::http::route::Route;
use dobot_api::problem_kinds::INTERNAL;

pub(crate) fn all() -> Vec<Route> {
    FILES.iter().map(route).collect()
}

/// Whether a path belongs to the page or one of its files.
pub(crate) fn has(path: &str) -> bool {
    FILES.iter().any(|file| file.path == path)
}

fn route(file: &'static File) -> Route {
    let kind = file.content_type;
    let answer = move |headers: HeaderMap| async move { content(file, &headers) };
    let essence = kind.split(';').next().unwrap_or(kind);
    let summary = "A page to watch and move the arm";
    Route::new(Method::GET, file.path, summary, answer)
        .open()
        .gives_text(200, essence, "the page, or one of its files")
}

/// The content of a file; a compressed one is unpacked for a client that does not accept it.
fn content(file: &'static File, headers: &HeaderMap) -> Result<Response, RequestFailed> {
    let kind = (CONTENT_TYPE, file.content_type);
    if !file.is_gzip {
        return Ok(([kind], file.bytes).into_response());
    }
    let vary = (VARY, "accept-encoding");
    if headers.get_all(ACCEPT_ENCODING).iter().any(accepts_gzip) {
        let gzip = (CONTENT_ENCODING, "gzip");
        return Ok(([kind, vary, gzip], file.bytes).into_response());
    }
    let plain =
        unpacked(file.bytes).map_err(|error| RequestFailed(INTERNAL.problem(error.to_string())))?;
    Ok(([kind, vary], plain).into_response())
}

fn accepts_gzip(accepted: &HeaderValue) -> bool {
    let accepted = accepted.to_str().unwrap_or_default();
    accepted.split(',').any(|coding| {
        let (name, weight) = coding.split_once(';').unwrap_or((coding, ""));
        let is_refused = weight
            .trim()
            .strip_prefix("q=")
            .is_some_and(|q| q.parse() == Ok(0.0));
        name.trim().eq_ignore_ascii_case("gzip") && !is_refused
    })
}

/// Unpacks a compressed file.
pub(crate) fn unpacked(bytes: &[u8]) -> io::Result<Vec<u8>> {
    let mut plain = Vec::new();
    GzDecoder::new(bytes).read_to_end(&mut plain)?;
    Ok(plain)
}
