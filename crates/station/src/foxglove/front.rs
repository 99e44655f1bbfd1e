//! A proxy in front of Foxglove's server, which does not check the origin of a connection.

use std::io;
use std::net::{IpAddr, Ipv4Addr, SocketAddr};
use std::time::Duration;

use axum::http::Uri;
use tokio::io::{AsyncReadExt, AsyncWriteExt, copy_bidirectional};
use tokio::net::{TcpListener, TcpStream};
use tokio::task::JoinSet;
use tokio::time::timeout;

/// The maximum length of a request head; browsers send less.
const HEAD_LIMIT: usize = 16 * 1024;
const HEAD_TIMEOUT: Duration = Duration::from_secs(10);
/// The delay before a retry when the system is out of connections.
const RETRY_AFTER: Duration = Duration::from_millis(50);

/// Returns a loopback address for the server behind the proxy, which pages cannot guess.
///
/// On Linux all of 127.0.0.0/8 is loopback; elsewhere only the port is unknown.
pub(super) fn hidden_address() -> io::Result<Ipv4Addr> {
    let mut parts = [0; 3];
    if cfg!(target_os = "linux") {
        getrandom::fill(&mut parts).map_err(io::Error::other)?;
    }
    let [a, b, c] = parts;
    Ok(match parts {
        // The network address and its broadcast address.
        [0, 0, 0] | [255, 255, 255] => Ipv4Addr::LOCALHOST,
        _ => Ipv4Addr::new(127, a, b, c),
    })
}

/// Forwards connections of Foxglove and of this machine, and refuses all others, until it is
/// dropped.
pub(super) async fn serve(listener: TcpListener, inner: SocketAddr) {
    let mut open = JoinSet::new();
    loop {
        tokio::select! {
            accepted = listener.accept() => match accepted {
                Ok((client, _)) => {
                    open.spawn(async move {
                        if let Err(error) = pass(client, inner).await {
                            tracing::debug!(%error, "a connection to the port for Foxglove ended");
                        }
                    });
                }
                Err(_) => tokio::time::sleep(RETRY_AFTER).await,
            },
            Some(_) = open.join_next() => {}
        }
    }
}

async fn pass(mut client: TcpStream, inner: SocketAddr) -> io::Result<()> {
    let head = timeout(HEAD_TIMEOUT, read_head(&mut client)).await??;
    if let Err(refusal) = check(&head) {
        tracing::info!(refusal, "the port for Foxglove refused a connection");
        let answer = format!(
            "HTTP/1.1 403 Forbidden\r\ncontent-type: text/plain\r\ncontent-length: {}\r\nconnection: close\r\n\r\n{refusal}",
            refusal.len()
        );
        return client.write_all(answer.as_bytes()).await;
    }
    let mut server = TcpStream::connect(inner).await?;
    server.write_all(&head).await?;
    copy_bidirectional(&mut client, &mut server).await?;
    Ok(())
}

/// Reads up to the empty line; returns the head and any bytes after it.
async fn read_head(client: &mut TcpStream) -> io::Result<Vec<u8>> {
    let mut head = Vec::new();
    while !head.windows(4).any(|window| window == b"\r\n\r\n") {
        if client.read_buf(&mut head).await? == 0 || head.len() > HEAD_LIMIT {
            return Err(io::ErrorKind::InvalidData.into());
        }
    }
    Ok(head)
}

/// Checks the origin in the head of a request.
fn check(head: &[u8]) -> Result<(), &'static str> {
    let mut headers = [httparse::EMPTY_HEADER; 64];
    let mut request = httparse::Request::new(&mut headers);
    if !request
        .parse(head)
        .is_ok_and(|request| request.is_complete())
    {
        return Err("this is not an HTTP request");
    }
    let origins = request
        .headers
        .iter()
        .filter(|header| header.name.eq_ignore_ascii_case("origin"));
    let mut texts = origins.map(|header| str::from_utf8(header.value).unwrap_or_default());
    if texts.all(is_allowed) {
        Ok(())
    } else {
        Err("the connection comes from a page of another site")
    }
}

/// Whether the origin is Foxglove, in a browser or as an application, or a page of this machine.
fn is_allowed(origin: &str) -> bool {
    if origin == "file://" {
        return true;
    }
    let Ok(origin) = origin.parse::<Uri>() else {
        return false;
    };
    let host = origin.host().unwrap_or_default();
    match origin.scheme_str() {
        Some("https") if host == "foxglove.dev" || host.ends_with(".foxglove.dev") => true,
        Some("http" | "https") => {
            let bare = host.trim_start_matches('[').trim_end_matches(']');
            host == "localhost" || bare.parse::<IpAddr>().is_ok_and(|ip| ip.is_loopback())
        }
        _ => false,
    }
}
