//! Stations that are served over https, for a client without TLS.

use dobot_api::{CertificateTrust, ConnectError, Remote, StationAddress};
use tokio::net::TcpListener;

#[tokio::test]
async fn a_client_without_tls_explains_how_to_get_it() {
    let listener = TcpListener::bind("127.0.0.1:0").await.unwrap();
    let port = listener.local_addr().unwrap().port();
    let mut address = StationAddress::new(&format!("https://localhost:{port}")).unwrap();
    address.trust = Some(CertificateTrust::Fingerprint([7; 32]));
    let error = Remote::connect(&address, "test").await.unwrap_err();
    assert!(matches!(error, ConnectError::NotBuilt { .. }), "{error:?}");
    assert!(error.hint().unwrap().contains("--features full"));
}
