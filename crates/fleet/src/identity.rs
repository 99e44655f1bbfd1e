//! Who a member is: what its certificate says, and what it signs.

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

/// A member of the fleet, as its certificate names it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Peer {
    /// The station that the certificate was made for, as in `desk-3`.
    pub(crate) name: String,
    /// What only this certificate is called, as in `desk-3.1a2b3c4d`.
    pub(crate) common_name: String,
    /// When the certificate ends, in seconds since 1970-01-01T00:00:00Z.
    pub(crate) expires_s: i64,
    public_key: Vec<u8>,
}

/// By what this program signs, and looks who else belongs to the fleet.
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
    /// What a certificate says, by whomever it was made.
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
    /// The identity of a certificate and its key, both DER, in the fleet of an authority.
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
            .map_err(|_| unusable("authority.pem holds no certificate"))?;
        let identity = Self {
            peer: Peer::of(&certificate)
                .ok_or(unusable("certificate.pem names no station"))?
                .into(),
            key: key.map_err(|_| unusable("key.pem holds no P-256 key"))?,
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

    /// This member itself.
    pub(crate) const fn own(&self) -> &Arc<Peer> {
        &self.peer
    }

    pub(crate) fn certificate(&self) -> &[u8] {
        &self.certificate
    }

    /// The member that a certificate names, where it is one of this fleet, now.
    pub(crate) fn peer(&self, certificate: &[u8]) -> Result<Peer, &'static str> {
        let (_, parsed) = X509Certificate::from_der(certificate).map_err(|_| "it is none")?;
        let peer = Peer::read(&parsed).ok_or("it names no station")?;
        let authority = UnparsedPublicKey::new(&ECDSA_P256_SHA256_ASN1, &self.authority);
        let signed = parsed.tbs_certificate.as_ref();
        let signature = &parsed.signature_value.data;
        if authority.verify(signed, signature).is_err() {
            return Err("the authority of this fleet has not made it");
        }
        self.check(&peer)?;
        Ok(peer)
    }

    /// Whether a member still belongs to the fleet: checked on each use.
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

    /// Revokes more certificates. What is revoked stays so while the program runs.
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

/// What is signed: for which purpose, and each part with its length, so that no two statements have the same bytes.
pub(crate) fn statement(purpose: &str, parts: &[&[u8]]) -> Vec<u8> {
    let mut statement = format!("dobot fleet {purpose}\0").into_bytes();
    for part in parts {
        statement.extend((part.len() as u64).to_be_bytes());
        statement.extend_from_slice(part);
    }
    statement
}

/// The time in seconds since 1970-01-01T00:00:00Z.
pub(crate) fn now_s() -> i64 {
    let now = SystemTime::now().duration_since(UNIX_EPOCH);
    now.map_or(0, |it| i64::try_from(it.as_secs()).unwrap_or(i64::MAX))
}
