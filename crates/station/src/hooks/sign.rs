//! Signatures of webhooks: HMAC-SHA256 (RFC 2104), without the crate `hmac`, which would be another package for
//! these lines.

use sha2::{Digest, Sha256};

/// Returns the signature of a time and a body, in hexadecimal: that of `TIME.BODY`.
pub(super) fn signature(secret: &str, time: &str, body: &[u8]) -> String {
    let message = [time.as_bytes(), b".", body].concat();
    data_encoding::HEXLOWER.encode(&hmac(secret.as_bytes(), &message))
}

fn hmac(key: &[u8], message: &[u8]) -> [u8; 32] {
    let mut block = [0; BLOCK];
    if key.len() > BLOCK {
        block[..32].copy_from_slice(&Sha256::digest(key));
    } else {
        block[..key.len()].copy_from_slice(key);
    }
    let inner = Sha256::new()
        .chain_update(block.map(|byte| byte ^ 0x36))
        .chain_update(message)
        .finalize();
    let outer = Sha256::new()
        .chain_update(block.map(|byte| byte ^ 0x5c))
        .chain_update(inner);
    outer.finalize().into()
}

/// The length of a block of SHA-256, in bytes.
const BLOCK: usize = 64;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signatures_are_those_of_rfc_4231() {
        let hex = |key: &[u8], message: &[u8]| data_encoding::HEXLOWER.encode(&hmac(key, message));
        assert_eq!(
            hex(b"Jefe", b"what do ya want for nothing?"),
            "5bdcc146bf60754e6a042426089575c75a003f089d2739839dec58b964ec3843"
        );
        assert_eq!(
            hex(
                &[0xaa; 131],
                b"Test Using Larger Than Block-Size Key - Hash Key First"
            ),
            "60e431591ee0b67f0d8a26aacbf5b77f8e0bc6213728c5140546040f0ee37f54"
        );
    }

    #[test]
    fn the_time_is_part_of_what_is_signed() {
        let one = signature("secret", "1", b"{}");
        assert_ne!(one, signature("secret", "2", b"{}"));
        assert_ne!(one, signature("secret", "1", b"{ }"));
        assert_ne!(one, signature("other", "1", b"{}"));
    }
}
