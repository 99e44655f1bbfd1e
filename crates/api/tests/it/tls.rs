//! Stations that are served over https.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use dobot_api::{CertificateTrust, ConnectError, Remote, StationAddress};
use rustls::pki_types::pem::PemObject;
use rustls::pki_types::{CertificateDer, PrivateKeyDer};
use sha2::{Digest, Sha256};
use tokio::net::TcpListener;
use tokio_rustls::TlsAcceptor;

use crate::remote::Fake;

/// A server with one of the self-signed certificates in `tests/data`, which are valid until 2126.
fn acceptor(name: &str) -> (CertificateDer<'static>, TlsAcceptor) {
    let certificate = CertificateDer::from_pem_file(data(&format!("{name}.pem"))).unwrap();
    let key = PrivateKeyDer::from_pem_file(data(&format!("{name}.key.pem"))).unwrap();
    let provider = Arc::new(rustls::crypto::ring::default_provider());
    let config = rustls::ServerConfig::builder_with_provider(provider)
        .with_safe_default_protocol_versions()
        .unwrap()
        .with_no_client_auth()
        .with_single_cert(vec![certificate.clone()], key)
        .unwrap();
    (certificate, TlsAcceptor::from(Arc::new(config)))
}

fn data(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/data")
        .join(file)
}

/// Connects over TLS, trusting for this reason.
async fn over_tls(
    acceptor: TlsAcceptor,
    trust: Option<CertificateTrust>,
) -> Result<Remote, ConnectError> {
    let listener = TcpListener::bind("127.0.0.1:0").await.unwrap();
    let port = listener.local_addr().unwrap().port();
    let mut address = StationAddress::new(&format!("https://localhost:{port}")).unwrap();
    address.trust = trust;
    let serve = tokio::spawn(async move {
        let stream = listener.accept().await.unwrap().0;
        if let Ok(stream) = acceptor.accept(stream).await {
            let mut fake = Fake::welcome(stream).await.0;
            fake.receive().await;
        }
    });
    let remote = Remote::connect(&address, "test").await;
    serve.abort();
    remote
}

#[tokio::test]
async fn a_certificate_is_trusted_by_its_fingerprint_and_no_other_certificate_is() {
    let (certificate, acceptor) = acceptor("station");
    let digest: [u8; 32] = Sha256::digest(certificate).into();
    let pinned = |digest| Some(CertificateTrust::Fingerprint(digest));
    over_tls(acceptor.clone(), pinned(digest)).await.unwrap();
    let error = over_tls(acceptor.clone(), pinned([7; 32]))
        .await
        .unwrap_err();
    assert!(matches!(error, ConnectError::Untrusted { .. }), "{error:?}");
    let error = over_tls(acceptor, None).await.unwrap_err();
    assert!(error.hint().unwrap().contains("--fingerprint"), "{error:?}");
}

#[tokio::test]
async fn a_certificate_is_trusted_by_its_issuer() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("ca.pem");
    let (_, station) = acceptor("station");
    std::fs::copy(data("station.pem"), &file).unwrap();
    let authority = || Some(CertificateTrust::Authority(file.clone()));
    over_tls(station, authority()).await.unwrap();
    let (_, other) = acceptor("other");
    let error = over_tls(other.clone(), authority()).await.unwrap_err();
    assert!(matches!(error, ConnectError::Untrusted { .. }), "{error:?}");
    std::fs::write(&file, "").unwrap();
    let error = over_tls(other, authority()).await.unwrap_err().to_string();
    assert!(error.contains("no certificate in"), "{error}");
}
