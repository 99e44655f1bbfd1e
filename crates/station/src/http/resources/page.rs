//! The page, which is embedded in the program: a route for each of its files.

use axum::body::Body;
use axum::http::header::{
    ACCEPT_ENCODING, CACHE_CONTROL, CONTENT_ENCODING, CONTENT_SECURITY_POLICY, CONTENT_TYPE, ETAG,
    IF_NONE_MATCH, VARY,
};
use axum::http::{HeaderMap, HeaderName, HeaderValue, Method, StatusCode};
use axum::response::{IntoResponse, Response};
use dobot_api::problem_kinds::INTERNAL;
use dobot_page::{FILES, File};

use crate::http::exchange::responses::RequestFailed;
use crate::http::route::Route;

pub(crate) fn all() -> Vec<Route> {
    FILES.iter().map(route).collect()
}

/// Whether a path belongs to the page or one of its files.
pub(crate) fn has(path: &str) -> bool {
    FILES.iter().any(|file| file.path == path)
}

fn route(file: &'static File) -> Route {
    let answer = move |headers: HeaderMap| async move {
        let mut answer = answer(file, &headers)?;
        if let Some(policy) = own_security_policy(file.path) {
            answer.headers_mut().insert(CONTENT_SECURITY_POLICY, policy);
        }
        Ok::<_, RequestFailed>(answer)
    };
    let kind = file.content_type;
    let essence = kind.split(';').next().unwrap_or(kind);
    let summary = "A page to watch and move the arm";
    Route::new(Method::GET, file.path, summary, answer)
        .open()
        .gives_text(200, essence, "the page, or one of its files")
        .gives_nothing(304, "the file is the one that the browser has")
}

fn answer(file: &File, headers: &HeaderMap) -> Result<Response, RequestFailed> {
    // Weak: compressed and plain contents have the same one.
    let tag = format!("W/\"{}\"", file.digest);
    let keep = if file.is_kept {
        "public, max-age=31536000, immutable"
    } else {
        "no-cache"
    };
    let about = [
        (ETAG, &*tag),
        (CACHE_CONTROL, keep),
        (VARY, "accept-encoding"),
    ];
    if values(headers, IF_NONE_MATCH).any(|known| known == tag || known == "*") {
        return Ok((StatusCode::NOT_MODIFIED, about).into_response());
    }
    let kind = [(CONTENT_TYPE, file.content_type)];
    if values(headers, ACCEPT_ENCODING).any(is_gzip) {
        let encoding = [(CONTENT_ENCODING, "gzip")];
        return Ok((about, kind, encoding, Body::from(file.gzip)).into_response());
    }
    let plain = file
        .content()
        .map_err(|error| RequestFailed(INTERNAL.problem(error.to_string())))?;
    Ok((about, kind, Body::from(plain)).into_response())
}

/// Returns the security policy of a file that needs its own: the worker that looks for hands runs
/// compiled code, and nothing else may.
fn own_security_policy(path: &str) -> Option<HeaderValue> {
    let policy = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; connect-src 'self'";
    path.ends_with("/vision/hands_worker.js")
        .then_some(HeaderValue::from_static(policy))
}

/// Returns the items of a header that is a list.
fn values(headers: &HeaderMap, name: HeaderName) -> impl Iterator<Item = &str> {
    let lines = headers.get_all(name).iter();
    lines
        .filter_map(|line| line.to_str().ok())
        .flat_map(|line| line.split(','))
        .map(str::trim)
}

/// Whether an accepted encoding is gzip; with a quality of 0 it is excluded.
fn is_gzip(encoding: &str) -> bool {
    let (name, quality) = encoding.split_once(';').unwrap_or((encoding, ""));
    let quality = quality
        .trim()
        .trim_start_matches("q=")
        .trim_matches(['0', '.']);
    let is_excluded = encoding.contains("q=") && quality.is_empty();
    name.trim().eq_ignore_ascii_case("gzip") && !is_excluded
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_browser_that_accepts_gzip_gets_it() {
        for accepted in ["gzip", "GZIP", "gzip;q=1.0", "gzip; q=0.5"] {
            assert!(is_gzip(accepted), "{accepted}");
        }
        for other in ["br", "gzip;q=0", "gzip; q=0.000", "identity", "x-gzip", ""] {
            assert!(!is_gzip(other), "{other}");
        }
    }
}
