//! TLS certificates.

use std::fs;
use std::io;
use std::net::IpAddr;
use std::path::Path;
use std::sync::Arc;

use dobot_api::write_private;
use rustls::ServerConfig;
use rustls::pki_types::pem::PemObject;
use rustls::pki_types::{CertificateDer, PrivateKeyDer};
use sha2::{Digest, Sha256};
pub(super) use tokio_rustls::TlsAcceptor;

use crate::TlsFiles;
use crate::http::access::tokens::hex;

/// A certificate for the server.
pub(crate) struct Certificate {
    pub(crate) acceptor: TlsAcceptor,
    /// Its SHA-256 digest in hexadecimal digits, for people to compare.
    pub(super) fingerprint: String,
}

impl Certificate {
    /// Reads a given certificate.
    ///
    /// # Errors
    ///
    /// [`TlsError`] if the files cannot be read or do not match.
    pub(super) fn read(files: &TlsFiles) -> Result<Self, TlsError> {
        let chain = CertificateDer::pem_file_iter(&files.certificate)
            .and_then(Iterator::collect::<Result<Vec<_>, _>>)
            .map_err(|source| TlsError::pem(&files.certificate, source))?;
        let key = PrivateKeyDer::from_pem_file(&files.key)
            .map_err(|source| TlsError::pem(&files.key, source))?;
        let first = chain.first().ok_or_else(|| TlsError::Empty {
            file: files.certificate.display().to_string(),
        })?;
        Ok(Self {
            fingerprint: hex(&Sha256::digest(first)),
            acceptor: acceptor(chain, key)?,
        })
    }

    /// Returns the station's self-signed certificate, creating it if there is none for these names.
    ///
    /// # Errors
    ///
    /// [`TlsError`] if it cannot be created, written or read.
    pub(crate) fn own(folder: &Path, names: &[String], address: IpAddr) -> Result<Self, TlsError> {
        let files = TlsFiles {
            certificate: folder.join("certificate.pem"),
            key: folder.join("key.pem"),
        };
        let subjects = subjects(names, address);
        let list = folder.join("names.txt");
        let made_for = fs::read_to_string(&list).unwrap_or_default();
        if !files.key.exists() || made_for.lines().ne(subjects.iter().map(String::as_str)) {
            make(&files, &subjects)?;
            write_private(&list, subjects.join("\n"))
                .map_err(|source| TlsError::write(&list, source))?;
        }
        Self::read(&files)
    }
}

/// The error returned when a station cannot be served with TLS.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TlsError {
    /// A file contains no certificate.
    #[error("{file} contains no certificate")]
    Empty {
        /// The file.
        file: String,
    },
    /// A file cannot be read.
    #[error("{file} cannot be read")]
    Pem {
        /// The file.
        file: String,
        /// The cause.
        #[source]
        source: rustls::pki_types::pem::Error,
    },
    /// A file cannot be written.
    #[error("{file} cannot be written")]
    Write {
        /// The file.
        file: String,
        /// The cause.
        #[source]
        source: io::Error,
    },
    /// A certificate cannot be created.
    #[error("cannot create a certificate")]
    Make(#[from] rcgen::Error),
    /// Certificate and key do not match, or are of an unsupported kind.
    #[error("the certificate and the key do not match or are not supported")]
    Use(#[from] rustls::Error),
}

impl TlsError {
    fn pem(file: &Path, source: rustls::pki_types::pem::Error) -> Self {
        let file = file.display().to_string();
        Self::Pem { file, source }
    }

    fn write(file: &Path, source: io::Error) -> Self {
        let file = file.display().to_string();
        Self::Write { file, source }
    }
}

/// Returns the names and addresses of the station.
fn subjects(names: &[String], address: IpAddr) -> Vec<String> {
    let mut all = vec!["localhost".into(), "127.0.0.1".into(), "::1".into()];
    if !address.is_unspecified() && !address.is_loopback() {
        all.push(address.to_string());
    }
    all.extend_from_slice(names);
    all
}

fn make(files: &TlsFiles, subjects: &[String]) -> Result<(), TlsError> {
    let made = rcgen::generate_simple_self_signed(subjects)?;
    let write = |file: &Path, text: String| {
        write_private(file, &text).map_err(|source| TlsError::write(file, source))
    };
    write(&files.key, made.signing_key.serialize_pem())?;
    write(&files.certificate, made.cert.pem())
}

fn acceptor(
    chain: Vec<CertificateDer<'static>>,
    key: PrivateKeyDer<'static>,
) -> Result<TlsAcceptor, TlsError> {
    let provider = Arc::new(rustls::crypto::ring::default_provider());
    let mut config = ServerConfig::builder_with_provider(provider)
        .with_safe_default_protocol_versions()?
        .with_no_client_auth()
        .with_single_cert(chain, key)?;
    config.alpn_protocols = vec![b"http/1.1".to_vec()];
    Ok(TlsAcceptor::from(Arc::new(config)))
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    const ANY: IpAddr = IpAddr::V4(std::net::Ipv4Addr::UNSPECIFIED);

    #[test]
    fn a_certificate_is_made_once_and_again_for_another_name() {
        let folder = tempfile::tempdir().unwrap();
        let made = |names: &[String]| {
            Certificate::own(folder.path(), names, ANY)
                .unwrap()
                .fingerprint
        };
        let first = made(&[]);
        assert_eq!(first.len(), 64);
        assert_eq!(made(&[]), first);
        assert_ne!(made(&["arm.local".into()]), first);
    }

    #[cfg(unix)]
    #[test]
    fn only_the_owner_can_read_the_key() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        Certificate::own(folder.path(), &[], ANY).unwrap();
        let key = fs::metadata(folder.path().join("key.pem")).unwrap();
        assert_eq!(key.permissions().mode() & 0o777, 0o600);
    }

    #[test]
    fn missing_and_empty_files_are_reported_by_name() {
        let folder = tempfile::tempdir().unwrap();
        let files = TlsFiles {
            certificate: folder.path().join("mine.pem"),
            key: folder.path().join("mine.key"),
        };
        let text = |error: TlsError| error.to_string();
        let error = Certificate::read(&files).err().map(text).unwrap();
        assert!(error.contains("mine.pem"), "{error}");
        Certificate::own(folder.path(), &[], ANY).unwrap();
        fs::copy(folder.path().join("key.pem"), &files.key).unwrap();
        fs::write(&files.certificate, "").unwrap();
        let error = Certificate::read(&files).err().map(text).unwrap();
        assert!(
            error.ends_with("mine.pem contains no certificate"),
            "{error}"
        );
    }
}
