//! Single HTTP requests, for what the WebSocket does not offer.

use serde::Serialize;
use serde::de::DeserializeOwned;
use tokio::io::{AsyncReadExt, AsyncWriteExt};

use super::stream::{open, soon};
use super::{ConnectError, StationAddress};
use crate::{Problem, State};

/// Fetches an API document, such as `/api/v1/jobs`.
///
/// # Errors
///
/// [`ConnectError`] if the station cannot be reached or refuses.
pub async fn fetch<T: DeserializeOwned>(
    address: &StationAddress,
    path: &str,
) -> Result<T, ConnectError> {
    answered(address, &question(address, "GET", path, "")).await
}

/// Fetches a file from the API, such as `/api/v1/files/4/content`.
///
/// # Errors
///
/// [`ConnectError`] if the station cannot be reached or refuses.
pub async fn fetch_bytes(address: &StationAddress, path: &str) -> Result<Vec<u8>, ConnectError> {
    content(address, &question(address, "GET", path, "")).await
}

/// Sends a document to the API, such as a program to `/api/v1/programs/check`.
///
/// # Errors
///
/// [`ConnectError`] if the station cannot be reached or refuses.
pub async fn post<T: DeserializeOwned>(
    address: &StationAddress,
    path: &str,
    document: &impl Serialize,
) -> Result<T, ConnectError> {
    let body = serde_json::to_string(document);
    let body = body.map_err(|error| ConnectError::no_station(address, error))?;
    answered(address, &question(address, "POST", path, &body)).await
}

/// Sends a DELETE request.
///
/// # Errors
///
/// [`ConnectError`] if the station cannot be reached or refuses.
pub async fn delete<T: DeserializeOwned>(
    address: &StationAddress,
    path: &str,
) -> Result<T, ConnectError> {
    answered(address, &question(address, "DELETE", path, "")).await
}

async fn answered<T: DeserializeOwned>(
    address: &StationAddress,
    question: &str,
) -> Result<T, ConnectError> {
    let body = content(address, question).await?;
    let text = if body.is_empty() { b"null" } else { &*body };
    serde_json::from_slice(text).map_err(|error| ConnectError::no_station(address, error))
}

/// Returns the body of an answer with success.
async fn content(address: &StationAddress, question: &str) -> Result<Vec<u8>, ConnectError> {
    let mut answer = soon(address, ask(address, question)).await?;
    let (status, body) = split(&answer).ok_or_else(|| ConnectError::no_station(address, SPEECH))?;
    if !(200..300).contains(&status) {
        return Err(refused(address, status, body));
    }
    let head = answer.len() - body.len();
    answer.drain(..head);
    Ok(answer)
}

/// Returns whether a station answers at an address, whatever access it allows.
pub async fn is_station(address: &StationAddress) -> bool {
    let answer = fetch::<State>(address, "/api/v1/state").await;
    matches!(answer, Ok(_) | Err(ConnectError::Refused(_)))
}

/// Returns the error for an answer without success.
pub(super) fn refused(address: &StationAddress, status: u16, body: &[u8]) -> ConnectError {
    match serde_json::from_slice::<Problem>(body) {
        Ok(problem) => ConnectError::Refused(Box::new(problem)),
        Err(_) => ConnectError::no_station(address, format!("it answers with status {status}")),
    }
}

/// Sends one HTTP 1.0 request on its own connection; the answer ends with the connection.
async fn ask(address: &StationAddress, question: &str) -> Result<Vec<u8>, ConnectError> {
    let broken = |error| ConnectError::no_station(address, error);
    let mut stream = open(address).await?;
    stream
        .write_all(question.as_bytes())
        .await
        .map_err(broken)?;
    let mut answer = Vec::new();
    let mut most = stream.take(MAX_BYTES);
    most.read_to_end(&mut answer).await.map_err(broken)?;
    Ok(answer)
}

fn question(address: &StationAddress, method: &str, path: &str, body: &str) -> String {
    let host = address.authority();
    let authorization = match &address.token {
        Some(token) => format!("Authorization: Bearer {token}\r\n"),
        None => String::new(),
    };
    let content = match body.len() {
        0 => String::new(),
        length => format!("Content-Type: application/json\r\nContent-Length: {length}\r\n"),
    };
    format!(
        "{method} {path} HTTP/1.0\r\nHost: {host}\r\nAccept: application/json\r\n{content}{authorization}\r\n{body}"
    )
}

/// Splits an answer into status and body.
fn split(answer: &[u8]) -> Option<(u16, &[u8])> {
    let end = answer.windows(4).position(|window| window == b"\r\n\r\n")?;
    let head = std::str::from_utf8(&answer[..end]).ok()?;
    let status = head.strip_prefix("HTTP/1.")?.get(2..5)?.parse().ok()?;
    Some((status, &answer[end + 4..]))
}

const SPEECH: &str = "it does not speak HTTP";
const MAX_BYTES: u64 = 32 << 20;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn status_and_body_are_distinguished() {
        let answer = b"HTTP/1.1 404 Not Found\r\nContent-Length: 2\r\n\r\n{}";
        assert_eq!(split(answer), Some((404, &b"{}"[..])));
        assert_eq!(split(b"SSH-2.0-OpenSSH\r\n\r\n"), None);
    }

    proptest! {
        #[test]
        fn no_answer_makes_it_panic(answer: Vec<u8>, tail in "HTTP/1.1 [0-9]{0,4}.{0,4}\r\n\r\n") {
            let _ = split(&answer);
            let _ = split(tail.as_bytes());
        }
    }
}
