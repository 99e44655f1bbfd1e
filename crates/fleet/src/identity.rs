//! The identity of a member: its certificate and its signatures.

use std::collections::BTreeSet;
use std::sync::{Arc, PoisonError, RwLock};
use std::time::{SystemTime, UNIX_EPOCH};

use dobot_api::is_fleet_name;
use ring::rand::SystemRandom;
use ring::signature::{
    ECDSA_P256_SHA256_ASN1, ECDSA_P256_SHA256_FIXED, ECDSA_P256_SHA256_FIXED_SIGNING, EcdsaKeyPair,
    UnparsedPublicKey,
};
use x509_parser::prelude::{FromDer, X509Certificate};

use crate::CredentialsError;

/// A member of the fleet, as named by its certificate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Peer {
    /// The station for which the certificate was issued, as in `desk-3`.
    pub(crate) name: String,
    /// The unique common name of the certificate, as in `desk-3.1a2b3c4d`.
    pub(crate) common_name: String,
    /// The expiry of the certificate, in seconds since 1970-01-01T00:00:00Z.
    pub(crate) expires_s: i64,
    public_key: Vec<u8>,
}

/// Signs the messages of this program and verifies the certificates of others.
#[derive(Debug)]
pub(crate) struct Identity {
    peer: Arc<Peer>,
    certificate: Vec<u8>,
    key: EcdsaKeyPair,
    authority: Vec<u8>,
    revoked: RwLock<BTreeSet<String>>,
    random: SystemRandom,
}

/// The length of a signature in bytes (P-256, SHA-256).
pub(crate) const SIGNATURE: usize = 64;

impl Peer {
    /// Parses a certificate of any authority.
    pub(crate) fn of(certificate: &[u8]) -> Option<Self> {
        Self::read(&X509Certificate::from_der(certificate).ok()?.1)
    }

    fn read(certificate: &X509Certificate<'_>) -> Option<Self> {
        let common_name = certificate.subject().iter_common_name().next()?;
        let common_name = common_name.as_str().ok()?.to_owned();
        let name = common_name.split('.').next()?.to_owned();
        is_fleet_name(&name).then(|| Self {
            name,
            common_name,
            expires_s: certificate.validity().not_after.timestamp(),
            public_key: certificate.public_key().subject_public_key.data.to_vec(),
        })
    }

    /// Whether this member has signed a statement.
    pub(crate) fn has_signed(&self, statement: &[u8], signature: &[u8]) -> bool {
        let key = UnparsedPublicKey::new(&ECDSA_P256_SHA256_FIXED, &self.public_key);
        key.verify(statement, signature).is_ok()
    }
}

impl Identity {
    /// Returns the identity of a certificate and its key, both DER, in the fleet of an authority.
    pub(crate) fn new(
        authority: &[u8],
        certificate: Vec<u8>,
        key: &[u8],
        revoked: BTreeSet<String>,
    ) -> Result<Self, CredentialsError> {
        let random = SystemRandom::new();
        let unusable = |what| CredentialsError::Unusable(what);
        let key = EcdsaKeyPair::from_pkcs8(&ECDSA_P256_SHA256_FIXED_SIGNING, key, &random);
        let (_, authority) = X509Certificate::from_der(authority)
            .map_err(|_| unusable("authority.pem contains no certificate"))?;
        let identity = Self {
            peer: Peer::of(&certificate)
                .ok_or(unusable("certificate.pem names no station"))?
                .into(),
            key: key.map_err(|_| unusable("key.pem contains no P-256 key"))?,
            authority: authority.public_key().subject_public_key.data.to_vec(),
            certificate,
            revoked: RwLock::new(revoked),
            random,
        };
        let own = identity.peer(&identity.certificate);
        own.map_err(|why| CredentialsError::NotAccepted {
            certificate: identity.peer.common_name.clone(),
            why,
        })?;
        let statement = statement("own", &[]);
        if !identity
            .peer
            .has_signed(&statement, &identity.sign(&statement))
        {
            return Err(unusable("key.pem is not the key of certificate.pem"));
        }
        Ok(identity)
    }

    /// Returns this member.
    pub(crate) const fn own(&self) -> &Arc<Peer> {
        &self.peer
    }

    pub(crate) fn certificate(&self) -> &[u8] {
        &self.certificate
    }

    /// Verifies a certificate and returns its member.
    pub(crate) fn peer(&self, certificate: &[u8]) -> Result<Peer, &'static str> {
        let (_, parsed) =
            X509Certificate::from_der(certificate).map_err(|_| "it is not a certificate")?;
        let peer = Peer::read(&parsed).ok_or("it names no station")?;
        let authority = UnparsedPublicKey::new(&ECDSA_P256_SHA256_ASN1, &self.authority);
        let signed = parsed.tbs_certificate.as_ref();
        let signature = &parsed.signature_value.data;
        if authority.verify(signed, signature).is_err() {
            return Err("it was not issued by the authority of this fleet");
        }
        self.check(&peer)?;
        Ok(peer)
    }

    /// Checks that a member still belongs to the fleet. Called on each use.
    pub(crate) fn check(&self, peer: &Peer) -> Result<(), &'static str> {
        if peer.expires_s <= now_s() {
            return Err("it has expired");
        }
        let revoked = self.revoked.read().unwrap_or_else(PoisonError::into_inner);
        if revoked.contains(&peer.common_name) {
            return Err("it is revoked");
        }
        Ok(())
    }

    /// Revokes more certificates, until the program ends.
    pub(crate) fn revoke(&self, more: BTreeSet<String>) {
        let mut revoked = self.revoked.write().unwrap_or_else(PoisonError::into_inner);
        revoked.extend(more);
    }

    /// Signs a statement.
    pub(crate) fn sign(&self, statement: &[u8]) -> [u8; SIGNATURE] {
        let signed = self.key.sign(&self.random, statement);
        let signed = signed.expect("the system has random numbers");
        let bytes = signed.as_ref().try_into();
        bytes.expect("a signature of this kind has a fixed length")
    }

    /// Random bytes.
    pub(crate) const fn random(&self) -> &SystemRandom {
        &self.random
    }
}

/// Returns the bytes to be signed: the purpose, and each part with its length, so that no two
/// statements have the same bytes.
pub(crate) fn statement(purpose: &str, parts: &[&[u8]]) -> Vec<u8> {
    let mut statement = format!("dobot fleet {purpose}\0").into_bytes();
    for part in parts {
        statement.extend((part.len() as u64).to_be_bytes());
        statement.extend_from_slice(part);
    }
    statement
}

/// Returns the time in seconds since 1970-01-01T00:00:00Z.
pub(crate) fn now_s() -> i64 {
    let now = SystemTime::now().duration_since(UNIX_EPOCH);
    now.map_or(0, |elapsed| {
        i64::try_from(elapsed.as_secs()).unwrap_or(i64::MAX)
    })
}
