//! Proofs that a client holds a token. A station that verifies a proof cannot create another one
//! from it.

use ring::signature::{ED25519, Ed25519KeyPair, KeyPair, UnparsedPublicKey};
use sha2::{Digest, Sha256};

use crate::http::access::tokens::hex;

/// The length of a proof, in bytes.
pub const PROOF: usize = 64;

/// Signs a statement with a token (Ed25519), as a proof that the sender holds it.
///
/// # Panics
///
/// Never: a signature has 64 bytes.
#[must_use]
pub fn prove(token: &str, statement: &[u8]) -> [u8; PROOF] {
    let signature = key_pair(token).sign(statement);
    let bytes = signature.as_ref().try_into();
    bytes.expect("a signature of Ed25519 has 64 bytes")
}

/// Returns the key that verifies proofs of a token, in hexadecimal digits.
pub(super) fn public_key(token: &str) -> String {
    hex(key_pair(token).public_key().as_ref())
}

/// Whether a proof for a statement is made with the token of this public key.
pub(super) fn is_proved(public_key: &str, statement: &[u8], proof: &[u8]) -> bool {
    let key = data_encoding::HEXLOWER.decode(public_key.as_bytes());
    key.is_ok_and(|key| {
        let key = UnparsedPublicKey::new(&ED25519, key);
        key.verify(statement, proof).is_ok()
    })
}

fn key_pair(token: &str) -> Ed25519KeyPair {
    // Not the stored digest of the token, which must not suffice for a proof.
    let seed = Sha256::new()
        .chain_update(b"dobot token proof\0")
        .chain_update(token.to_ascii_lowercase())
        .finalize();
    Ed25519KeyPair::from_seed_unchecked(&seed).expect("any 32 bytes are a seed")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_proof_counts_for_its_token_and_statement_only() {
        let [one, other] = ["a", "b"].map(|digit| digit.repeat(64));
        let proof = prove(&one, b"stop");
        assert!(is_proved(&public_key(&one), b"stop", &proof));
        assert!(!is_proved(&public_key(&one), b"go", &proof));
        assert!(!is_proved(&public_key(&other), b"stop", &proof));
        assert!(!is_proved("no key", b"stop", &proof));
        assert!(!is_proved(&public_key(&one), b"stop", &[0; PROOF]));
    }
}
