//! The whole web side on a real address.

use std::net::SocketAddr;

use dobot_api::{Folders, Role, Running, StationAddress, is_station};
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpStream;

use crate::http::fake::driver;
use crate::{ServeError, Tokens, Web, serve};

const LOOPBACK: SocketAddr =
    SocketAddr::new(std::net::IpAddr::V4(std::net::Ipv4Addr::LOCALHOST), 0);
const EVERYWHERE: SocketAddr =
    SocketAddr::new(std::net::IpAddr::V4(std::net::Ipv4Addr::UNSPECIFIED), 0);

async fn ask(mut stream: impl AsyncReadExt + AsyncWriteExt + Unpin, request: &str) -> String {
    stream.write_all(request.as_bytes()).await.unwrap();
    let mut answer = Vec::new();
    // A peer that closes without a close_notify has still sent everything.
    let _ = stream.read_to_end(&mut answer).await;
    String::from_utf8(answer).unwrap()
}

#[tokio::test]
async fn a_station_publishes_its_address_and_removes_it_at_its_end() {
    let folder = tempfile::tempdir().unwrap();
    let folders = Folders::at(folder.path());
    let served = serve(&Web::new(LOOPBACK, folders.clone()), driver().0)
        .await
        .unwrap();
    let running = Running::read(&folders.running()).unwrap().unwrap();
    assert_eq!(running.address, served.url());
    assert_eq!(running.pid, std::process::id());
    assert_eq!(served.url(), format!("http://{}", served.address()));
    let token = running.token.unwrap();
    let request = format!(
        "GET /api/v1/state HTTP/1.1\r\nHost: {}\r\nAuthorization: Bearer {token}\r\nConnection: close\r\n\r\n",
        served.address()
    );
    let answer = ask(
        TcpStream::connect(served.address()).await.unwrap(),
        &request,
    )
    .await;
    assert!(answer.starts_with("HTTP/1.1 200 "), "{answer}");
    let address = StationAddress::new(&running.address).unwrap();
    assert!(is_station(&address).await);
    served.end().await.unwrap();
    assert_eq!(Running::read(&folders.running()).unwrap(), None);
    assert!(!is_station(&address).await);
}

#[tokio::test]
async fn a_station_reachable_from_the_network_does_not_start_without_tokens() {
    let folder = tempfile::tempdir().unwrap();
    let web = Web::new(EVERYWHERE, Folders::at(folder.path()));
    let error = serve(&web, driver().0).await.unwrap_err();
    assert!(matches!(error, ServeError::NoTokens(_)), "{error}");
    assert_eq!(Running::read(&web.folders.running()).unwrap(), None);
}

#[cfg(not(feature = "full"))]
#[tokio::test]
async fn a_station_without_tls_is_not_served_to_other_machines() {
    let folder = tempfile::tempdir().unwrap();
    let web = Web::new(EVERYWHERE, Folders::at(folder.path()));
    let mut tokens = Tokens::open(&web.folders.tokens()).unwrap();
    tokens.add(Role::Watch, "me").unwrap();
    let error = serve(&web, driver().0).await.unwrap_err();
    assert!(matches!(error, ServeError::Tls(_)), "{error}");
    assert!(error.to_string().contains("built without TLS"), "{error}");
    assert_eq!(Running::read(&web.folders.running()).unwrap(), None);
}

#[cfg(feature = "full")]
#[tokio::test]
async fn a_station_reachable_from_the_network_uses_tls_with_its_own_certificate() {
    let folder = tempfile::tempdir().unwrap();
    let web = Web::new(EVERYWHERE, Folders::at(folder.path()));
    let token = Tokens::open(&web.folders.tokens())
        .unwrap()
        .add(Role::Watch, "me")
        .unwrap();
    let served = serve(&web, driver().0).await.unwrap();
    assert!(
        served.url().starts_with("https://127.0.0.1:"),
        "{}",
        served.url()
    );
    assert_eq!(served.fingerprint().unwrap().len(), 64);
    let port = served.address().port();
    let request = |more: &str| {
        format!(
            "GET /api/v1/state HTTP/1.1\r\nHost: localhost:{port}\r\n{more}Connection: close\r\n\r\n"
        )
    };
    let with_token = request(&format!("Authorization: Bearer {}\r\n", token.secret()));
    for (request, status) in [(with_token, "200"), (request(""), "401")] {
        let answer = ask(connect(&web, port).await, &request).await;
        assert!(
            answer.starts_with(&format!("HTTP/1.1 {status} ")),
            "{answer}"
        );
    }
    let plain = ask(
        TcpStream::connect(("127.0.0.1", port)).await.unwrap(),
        &request(""),
    )
    .await;
    assert!(!plain.contains("HTTP"), "{plain}");
}

#[cfg(feature = "full")]
/// A connection of a client that trusts only the station's certificate.
async fn connect(web: &Web, port: u16) -> tokio_rustls::client::TlsStream<TcpStream> {
    use rustls::pki_types::pem::PemObject;
    use rustls::pki_types::{CertificateDer, ServerName};
    let mut roots = rustls::RootCertStore::empty();
    let file = web.folders.tls().join("certificate.pem");
    roots
        .add(CertificateDer::from_pem_file(file).unwrap())
        .unwrap();
    let provider = std::sync::Arc::new(rustls::crypto::ring::default_provider());
    let config = rustls::ClientConfig::builder_with_provider(provider)
        .with_safe_default_protocol_versions()
        .unwrap()
        .with_root_certificates(roots)
        .with_no_client_auth();
    let stream = TcpStream::connect(("127.0.0.1", port)).await.unwrap();
    let name = ServerName::try_from("localhost").unwrap();
    let connector = tokio_rustls::TlsConnector::from(std::sync::Arc::new(config));
    connector.connect(name, stream).await.unwrap()
}

#[tokio::test]
async fn an_address_in_use_is_reported() {
    let folder = tempfile::tempdir().unwrap();
    let taken = tokio::net::TcpListener::bind(LOOPBACK).await.unwrap();
    let web = Web::new(taken.local_addr().unwrap(), Folders::at(folder.path()));
    let error = serve(&web, driver().0).await.unwrap_err();
    assert!(matches!(error, ServeError::Bind { .. }), "{error}");
}

#[tokio::test]
async fn noise_instead_of_a_request_is_survived() {
    let folder = tempfile::tempdir().unwrap();
    let served = serve(&Web::new(LOOPBACK, Folders::at(folder.path())), driver().0)
        .await
        .unwrap();
    for noise in [
        "\0\u{7f}\r\n\r\n",
        "GET / HTTP/9.9\r\n\r\n",
        "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n",
    ] {
        let answer = ask(TcpStream::connect(served.address()).await.unwrap(), noise).await;
        assert!(
            answer.is_empty() || answer.starts_with("HTTP/1.1 4"),
            "{answer}"
        );
    }
    let long = format!("GET / HTTP/1.1\r\nx: {}\r\n\r\n", "y".repeat(1_000_000));
    let mut stream = TcpStream::connect(served.address()).await.unwrap();
    // The station may close the connection before it has read everything.
    let _ = stream.write_all(long.as_bytes()).await;
    let mut answer = Vec::new();
    let _ = stream.read_to_end(&mut answer).await;
    assert!(!answer.starts_with(b"HTTP/1.1 200"));
}
