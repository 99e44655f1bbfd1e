//! Webhooks: an event is a signed POST request, repeated until it is answered.

use std::time::Duration;

use jiff::Timestamp;
use tokio::io::{AsyncRead, AsyncReadExt, AsyncWrite, AsyncWriteExt};
use tokio::net::TcpStream;

use super::config::{Authorities, WebHook};
use super::event::Event;
use super::sign::signature;

/// Sends an event, and repeats it after each of these pauses.
///
/// # Errors
///
/// Why it was not delivered, in one line.
pub(super) async fn send(
    hook: &WebHook,
    event: &Event,
    retries: &[Duration],
) -> Result<(), String> {
    let mut pauses = retries.iter();
    loop {
        let sent = tokio::time::timeout(WITHIN, once(hook, event)).await;
        let why = match sent {
            Ok(Ok(200..300)) => return Ok(()),
            // It will not be accepted later either.
            Ok(Ok(status @ (300..=407 | 409..=428 | 430..=499))) => {
                return Err(format!("it answered with status {status}"));
            }
            Ok(Ok(status)) => format!("it answered with status {status}"),
            Ok(Err(why)) => why,
            Err(_) => format!("it did not answer within {} s", WITHIN.as_secs()),
        };
        let Some(pause) = pauses.next() else {
            let times = retries.len() + 1;
            return Err(format!("tried {times} times: {why}"));
        };
        tokio::time::sleep(*pause).await;
    }
}

/// Sends an event once; returns the status of the answer.
async fn once(hook: &WebHook, event: &Event) -> Result<u16, String> {
    let tcp = TcpStream::connect((&*hook.host, hook.port))
        .await
        .map_err(|error| format!("cannot connect: {error}"))?;
    let request = request(hook, event);
    match &hook.tls {
        Some(authorities) => {
            let stream = encrypted(authorities, &hook.host, tcp).await?;
            exchange(stream, &request).await
        }
        None => exchange(tcp, &request).await,
    }
}

/// Returns the request: HTTP 1.0, whose answer ends with the connection.
fn request(hook: &WebHook, event: &Event) -> Vec<u8> {
    let time = Timestamp::now().as_second().to_string();
    let signature = signature(&hook.secret, &time, &event.body);
    let head = format!(
        "POST {} HTTP/1.0\r\nHost: {}\r\nUser-Agent: dobot/{}\r\nContent-Type: application/json\r\n\
        Content-Length: {}\r\nDobot-Event: {}\r\nDobot-Delivery: {}\r\nDobot-Timestamp: {time}\r\n\
        Dobot-Signature: sha256={signature}\r\n\r\n",
        hook.path,
        hook.authority,
        env!("CARGO_PKG_VERSION"),
        event.body.len(),
        event.kind.name(),
        event.id,
    );
    [head.as_bytes(), &event.body].concat()
}

async fn exchange(
    mut stream: impl AsyncRead + AsyncWrite + Unpin,
    request: &[u8],
) -> Result<u16, String> {
    let broken = |error| format!("the connection broke: {error}");
    stream.write_all(request).await.map_err(broken)?;
    let mut answer = Vec::new();
    while !answer.windows(2).any(|pair| pair == b"\r\n") && answer.len() < LONGEST_LINE {
        if stream.read_buf(&mut answer).await.map_err(broken)? == 0 {
            break;
        }
    }
    status(&answer).ok_or_else(|| "it does not speak HTTP".into())
}

/// Returns the status in the first line of an answer.
fn status(answer: &[u8]) -> Option<u16> {
    let line = answer.split(|&byte| byte == b'\r').next()?;
    let status = std::str::from_utf8(line).ok()?.strip_prefix("HTTP/1.")?;
    status.get(2..5)?.parse().ok()
}

#[cfg(feature = "full")]
async fn encrypted(
    Authorities(file): &Authorities,
    host: &str,
    tcp: TcpStream,
) -> Result<tokio_rustls::client::TlsStream<TcpStream>, String> {
    use std::sync::Arc;

    use rustls::ClientConfig;
    use rustls::pki_types::ServerName;

    let trusted = trusted(file)?;
    let provider = Arc::new(rustls::crypto::ring::default_provider());
    let config = ClientConfig::builder_with_provider(provider)
        .with_safe_default_protocol_versions()
        .map_err(|error| error.to_string())?
        .with_root_certificates(trusted)
        .with_no_client_auth();
    let name = ServerName::try_from(host.to_owned()).map_err(|error| error.to_string())?;
    let connector = tokio_rustls::TlsConnector::from(Arc::new(config));
    let connected = connector.connect(name, tcp).await;
    connected.map_err(|error| format!("cannot connect: {error}"))
}

/// Reads the certificates of the authorities in a file.
#[cfg(feature = "full")]
fn trusted(file: &std::path::Path) -> Result<rustls::RootCertStore, String> {
    use rustls::pki_types::CertificateDer;
    use rustls::pki_types::pem::PemObject;

    let unusable = |error: String| format!("{}: {error}", file.display());
    let mut trusted = rustls::RootCertStore::empty();
    let certificates =
        CertificateDer::pem_file_iter(file).map_err(|error| unusable(error.to_string()))?;
    // A system's file may have certificates that this library does not know.
    trusted.add_parsable_certificates(certificates.flatten());
    if trusted.is_empty() {
        return Err(unusable("it has no certificate".into()));
    }
    Ok(trusted)
}

#[cfg(not(feature = "full"))]
#[expect(clippy::unused_async, reason = "with the feature `full` it waits")]
async fn encrypted(none: &Authorities, _: &str, _: TcpStream) -> Result<TcpStream, String> {
    match *none {}
}

/// The time for one attempt.
const WITHIN: Duration = Duration::from_secs(10);
const LONGEST_LINE: usize = 1024;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_status_of_an_answer_is_in_its_first_line() {
        assert_eq!(status(b"HTTP/1.1 204 No Content\r\n\r\n"), Some(204));
        for other in [
            &b""[..],
            b"SSH-2.0\r\n",
            b"HTTP/1.1 \r\n",
            b"HTTP/1.1 abc\r\n",
        ] {
            assert_eq!(status(other), None);
        }
    }
}
