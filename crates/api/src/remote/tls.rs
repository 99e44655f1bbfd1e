//! TLS to a station whose certificate is not issued by a public authority.

use std::io;
use std::path::Path;
use std::sync::Arc;

use rustls::client::danger::{HandshakeSignatureValid, ServerCertVerified, ServerCertVerifier};
use rustls::crypto::{CryptoProvider, ring, verify_tls12_signature, verify_tls13_signature};
use rustls::pki_types::pem::PemObject;
use rustls::pki_types::{CertificateDer, ServerName, UnixTime};
use rustls::{
    CertificateError, ClientConfig, DigitallySignedStruct, Error, RootCertStore, SignatureScheme,
};
use sha2::{Digest, Sha256};
use tokio::net::TcpStream;
use tokio_rustls::TlsConnector;

use super::stream::Bytes;
use super::{CertificateTrust, ConnectError, StationAddress, TrustError};

/// Encrypts a connection if the station has the trusted certificate.
pub(super) async fn encrypt(
    address: &StationAddress,
    trust: &CertificateTrust,
    tcp: TcpStream,
) -> Result<Box<dyn Bytes>, ConnectError> {
    let connector = TlsConnector::from(Arc::new(client_config(trust)?));
    let name = ServerName::try_from(address.host().to_owned());
    let name = name.map_err(|error| ConnectError::no_station(address, error))?;
    match connector.connect(name, tcp).await {
        Ok(stream) => Ok(Box::new(stream)),
        Err(source) if is_certificate(&source) => Err(ConnectError::Untrusted {
            address: address.to_string(),
            source,
        }),
        Err(source) => Err(ConnectError::no_station(address, source)),
    }
}

fn is_certificate(error: &io::Error) -> bool {
    let tls = error.get_ref().and_then(|source| source.downcast_ref());
    matches!(tls, Some(rustls::Error::InvalidCertificate(_)))
}

/// Returns the TLS configuration for this kind of trust.
fn client_config(trust: &CertificateTrust) -> Result<ClientConfig, TrustError> {
    let provider = Arc::new(ring::default_provider());
    let builder = ClientConfig::builder_with_provider(provider.clone())
        .with_safe_default_protocol_versions()
        .expect("the provider speaks the versions that it is built with");
    let builder = match trust {
        CertificateTrust::Fingerprint(digest) => builder
            .dangerous()
            .with_custom_certificate_verifier(Arc::new(Pinned {
                digest: *digest,
                provider,
            })),
        CertificateTrust::Authority(file) => builder.with_root_certificates(authorities(file)?),
    };
    Ok(builder.with_no_client_auth())
}

fn authorities(file: &Path) -> Result<RootCertStore, TrustError> {
    let unreadable = |why: String| TrustError::Unreadable {
        file: file.display().to_string(),
        why,
    };
    let certificates =
        CertificateDer::pem_file_iter(file).map_err(|error| unreadable(error.to_string()))?;
    let mut store = RootCertStore::empty();
    for certificate in certificates {
        let certificate = certificate.map_err(|error| unreadable(error.to_string()))?;
        let added = store.add(certificate);
        added.map_err(|error| unreadable(error.to_string()))?;
    }
    if store.is_empty() {
        return Err(TrustError::Empty {
            file: file.display().to_string(),
        });
    }
    Ok(store)
}

/// Trusts one certificate, whatever its issuer and name.
#[derive(Debug)]
struct Pinned {
    digest: [u8; 32],
    provider: Arc<CryptoProvider>,
}

impl ServerCertVerifier for Pinned {
    fn verify_server_cert(
        &self,
        end_entity: &CertificateDer<'_>,
        _: &[CertificateDer<'_>],
        _: &ServerName<'_>,
        _: &[u8],
        _: UnixTime,
    ) -> Result<ServerCertVerified, Error> {
        if Sha256::digest(end_entity)[..] == self.digest {
            Ok(ServerCertVerified::assertion())
        } else {
            Err(CertificateError::ApplicationVerificationFailure.into())
        }
    }

    fn verify_tls12_signature(
        &self,
        message: &[u8],
        certificate: &CertificateDer<'_>,
        signed: &DigitallySignedStruct,
    ) -> Result<HandshakeSignatureValid, Error> {
        let algorithms = &self.provider.signature_verification_algorithms;
        verify_tls12_signature(message, certificate, signed, algorithms)
    }

    fn verify_tls13_signature(
        &self,
        message: &[u8],
        certificate: &CertificateDer<'_>,
        signed: &DigitallySignedStruct,
    ) -> Result<HandshakeSignatureValid, Error> {
        let algorithms = &self.provider.signature_verification_algorithms;
        verify_tls13_signature(message, certificate, signed, algorithms)
    }

    fn supported_verify_schemes(&self) -> Vec<SignatureScheme> {
        self.provider
            .signature_verification_algorithms
            .supported_schemes()
    }
}
