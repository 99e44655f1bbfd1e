//! Responses, and extractors for requests.

use std::sync::Arc;
use std::time::Duration;

use axum::Json;
use axum::body::{Body as HttpBody, Bytes, HttpBody as _};
use axum::extract::{FromRequest, FromRequestParts, Path, Request};
use axum::http::header::{
    CACHE_CONTROL, CONTENT_SECURITY_POLICY, CONTENT_TYPE, HeaderName, REFERRER_POLICY, RETRY_AFTER,
    WWW_AUTHENTICATE, X_CONTENT_TYPE_OPTIONS,
};
use axum::http::request::Parts;
use axum::http::{HeaderValue, StatusCode};
use axum::response::{IntoResponse, Response};
use dobot_api::Problem;
use dobot_api::problem_kinds::{
    INTERNAL, MALFORMED, MEDIA_TYPE, TIMEOUT, TOO_LARGE, TOO_MANY_REQUESTS,
};
use dobot_host::{LongWorkError, run_long};
use dobot_supervisor::Refusal;
use futures_util::StreamExt;
use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::DeserializeOwned;

use crate::http::app::App;
use crate::http::exchange::strict_json;

/// The maximum size of a body, unless its route allows more.
pub(crate) const BODY: usize = 64 * 1024;

/// The maximum size of a job.
pub(crate) const JOB: usize = 64 * 1024 * 1024;

/// The timeout for receiving a body.
const BODY_WITHIN: Duration = Duration::from_secs(30);

/// The length from which a text is parsed in a separate thread.
const LONG: usize = 256 * 1024;

/// A failed request, answered with its problem.
#[derive(Debug)]
pub(crate) struct RequestFailed(pub(crate) Problem);

impl<T: Into<Problem>> From<T> for RequestFailed {
    fn from(why: T) -> Self {
        Self(why.into())
    }
}

impl IntoResponse for RequestFailed {
    fn into_response(self) -> Response {
        let status =
            StatusCode::from_u16(self.0.status).unwrap_or(StatusCode::INTERNAL_SERVER_ERROR);
        let mut response = (status, Json(self.0)).into_response();
        let headers = response.headers_mut();
        headers.insert(CONTENT_TYPE, PROBLEM_JSON);
        match status {
            StatusCode::UNAUTHORIZED => {
                headers.insert(
                    WWW_AUTHENTICATE,
                    HeaderValue::from_static("Bearer realm=\"dobot\""),
                );
            }
            StatusCode::TOO_MANY_REQUESTS => {
                headers.insert(RETRY_AFTER, HeaderValue::from_static("1"));
            }
            _ => {}
        }
        response
    }
}

const PROBLEM_JSON: HeaderValue = HeaderValue::from_static("application/problem+json");

/// A request above the rate limit; the next one is allowed after this time.
pub(crate) struct RateLimited(pub(crate) Duration);

impl IntoResponse for RateLimited {
    fn into_response(self) -> Response {
        let wait_s = self.0.as_secs_f64().ceil().max(1.0);
        let problem = TOO_MANY_REQUESTS.hinted(
            "requests from this address exceed the rate limit",
            format!("wait {wait_s} s"),
        );
        let mut response = RequestFailed(problem).into_response();
        let value = HeaderValue::from_str(&wait_s.to_string()).expect("a number is a header");
        response.headers_mut().insert(RETRY_AFTER, value);
        response
    }
}

/// Returns a response of serialised JSON.
pub(crate) fn json(text: impl Into<HttpBody>) -> Response {
    ([(CONTENT_TYPE, "application/json")], text.into()).into_response()
}

/// Adds the security headers for browsers.
pub(crate) fn guarded(mut response: Response) -> Response {
    let headers = response.headers_mut();
    for (name, value) in GUARDS {
        headers.insert(name, HeaderValue::from_static(value));
    }
    // A worker of the page may have its own.
    headers
        .entry(CONTENT_SECURITY_POLICY)
        .or_insert(HeaderValue::from_static(SECURITY_POLICY));
    // The files of the page say themselves how long they may be kept.
    headers
        .entry(CACHE_CONTROL)
        .or_insert(HeaderValue::from_static("no-store"));
    response
}

const SECURITY_POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; connect-src 'self'; manifest-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

const GUARDS: [(HeaderName, &str); 5] = [
    // The views Look and Talk ask for camera and microphone when a person opens them.
    (
        HeaderName::from_static("permissions-policy"),
        "camera=(self), microphone=(self), geolocation=(), display-capture=(), usb=(), serial=(), bluetooth=()",
    ),
    (X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (REFERRER_POLICY, "no-referrer"),
    (
        HeaderName::from_static("cross-origin-resource-policy"),
        "same-origin",
    ),
    (
        HeaderName::from_static("cross-origin-opener-policy"),
        "same-origin",
    ),
];

/// A JSON body of at most `LIMIT` bytes.
#[derive(Debug)]
pub(crate) struct Body<T, const LIMIT: usize = BODY>(pub(crate) T);

impl<T, const LIMIT: usize> FromRequest<Arc<App>> for Body<T, LIMIT>
where
    T: DeserializeOwned + JsonSchema + Send + 'static,
{
    type Rejection = RequestFailed;

    async fn from_request(request: Request, _: &Arc<App>) -> Result<Self, RequestFailed> {
        let text = required(request, LIMIT).await?;
        Ok(Self(read(text).await?))
    }
}

/// An optional JSON body.
#[derive(Debug)]
pub(crate) struct Maybe<T>(pub(crate) T);

impl<T> FromRequest<Arc<App>> for Maybe<T>
where
    T: DeserializeOwned + JsonSchema + Default + Send + 'static,
{
    type Rejection = RequestFailed;

    async fn from_request(request: Request, _: &Arc<App>) -> Result<Self, RequestFailed> {
        match optional(request, BODY).await? {
            Some(text) => Ok(Self(read(text).await?)),
            None => Ok(Self(T::default())),
        }
    }
}

/// Reads a required body.
async fn required(request: Request, limit: usize) -> Result<Bytes, Problem> {
    let (parts, body) = request.into_parts();
    let text = collect(body, limit).await?;
    check_type(&parts)?;
    Ok(text)
}

/// Reads an optional body.
async fn optional(request: Request, limit: usize) -> Result<Option<Bytes>, Problem> {
    let (parts, body) = request.into_parts();
    let text = collect(body, limit).await?;
    if text.is_empty() {
        return Ok(None);
    }
    check_type(&parts)?;
    Ok(Some(text))
}

pub(crate) async fn collect(body: HttpBody, limit: usize) -> Result<Bytes, Problem> {
    let arriving = collect_slowly(body, limit);
    let arrived = tokio::time::timeout(BODY_WITHIN, arriving).await;
    arrived.unwrap_or_else(|_| {
        let within_s = BODY_WITHIN.as_secs();
        Err(TIMEOUT.problem(format!("the body did not arrive within {within_s} s")))
    })
}

async fn collect_slowly(body: HttpBody, limit: usize) -> Result<Bytes, Problem> {
    let too_large = || {
        TOO_LARGE.problem(format!(
            "the body has more than {limit} bytes, the maximum for this request"
        ))
    };
    // A body with a too large declared size is not read.
    if body.size_hint().lower() > limit as u64 {
        return Err(too_large());
    }
    let mut chunks = body.into_data_stream();
    let mut all = Vec::new();
    while let Some(chunk) = chunks.next().await {
        let chunk =
            chunk.map_err(|error| MALFORMED.problem(format!("the body is incomplete: {error}")))?;
        if all.len() + chunk.len() > limit {
            return Err(too_large());
        }
        all.extend_from_slice(&chunk);
    }
    Ok(all.into())
}

fn check_type(parts: &Parts) -> Result<(), Problem> {
    let found = parts.headers.get(CONTENT_TYPE).map(HeaderValue::as_bytes);
    let essence = found.unwrap_or_default().split(|&byte| byte == b';').next();
    if essence
        .unwrap_or_default()
        .trim_ascii()
        .eq_ignore_ascii_case(b"application/json")
    {
        return Ok(());
    }
    let found = found.map_or("missing".into(), String::from_utf8_lossy);
    Err(MEDIA_TYPE.hinted(
        format!("the Content-Type is {found}; bodies are application/json"),
        "send `Content-Type: application/json`",
    ))
}

async fn read<T: DeserializeOwned + JsonSchema + Send + 'static>(
    text: Bytes,
) -> Result<T, Problem> {
    read_beside(text, strict_json::read).await?
}

/// Parses text, in a separate thread if it is long.
pub(crate) async fn read_beside<T: Send + 'static>(
    text: Bytes,
    read: fn(&[u8]) -> T,
) -> Result<T, Problem> {
    if text.len() < LONG {
        return Ok(read(&text));
    }
    beside(move || read(&text)).await
}

/// Runs a slow computation in a separate thread.
pub(crate) async fn beside<T: Send + 'static>(
    work: impl FnOnce() -> T + Send + 'static,
) -> Result<T, Problem> {
    run_long(work).await.map_err(|error| match error {
        LongWorkError::Ending => Refusal::Ending.into(),
        error => INTERNAL.problem(error.to_string()),
    })
}

/// The number in a path.
#[derive(Debug)]
pub(crate) struct Number(pub(crate) u64);

impl FromRequestParts<Arc<App>> for Number {
    type Rejection = RequestFailed;

    async fn from_request_parts(parts: &mut Parts, app: &Arc<App>) -> Result<Self, RequestFailed> {
        let Path(text) = Path::<String>::from_request_parts(parts, app)
            .await
            .map_err(|error| MALFORMED.problem(error.body_text()))?;
        number_in_path(&text).map(Self)
    }
}

/// Parses a number in a path.
pub(crate) fn number_in_path(text: &str) -> Result<u64, RequestFailed> {
    text.parse().map_err(|_| {
        let text: String = text.chars().take(40).collect();
        RequestFailed(MALFORMED.problem(format!("{text:?} in the path is not a number")))
    })
}

/// The number of a job in the path, without a body.
#[derive(Debug)]
pub(crate) struct OfJob(pub(crate) u64);

impl FromRequest<Arc<App>> for OfJob {
    type Rejection = RequestFailed;

    async fn from_request(request: Request, app: &Arc<App>) -> Result<Self, RequestFailed> {
        let (mut parts, body) = request.into_parts();
        let Number(job) = Number::from_request_parts(&mut parts, app).await?;
        let request = Request::from_parts(parts, body);
        let Maybe(Nothing {}) = Maybe::from_request(request, app).await?;
        Ok(Self(job))
    }
}

/// An empty object.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Nothing {}

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn work_that_panics_is_answered_as_a_bug_of_the_station() {
        let problem = beside(|| panic!("no width")).await;
        let problem = problem.map(|()| "no panic").expect_err("it panicked");
        assert_eq!(problem.status, 500);
        assert_eq!(problem.kind, INTERNAL.problem("").kind);
        assert!(
            problem.detail.contains("responses.rs:"),
            "{}",
            problem.detail
        );
        assert!(problem.detail.ends_with(": no width"), "{}", problem.detail);
    }
}
