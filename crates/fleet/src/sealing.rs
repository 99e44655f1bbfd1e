//! Sealed requests: only the receiver can read them, and only it can send the response.
//!
//! Both sides send an ephemeral key. The receiver signs both keys, and so authenticates before
//! anything secret is sent. The requester signs them in the sealed request. A key is used once,
//! which prevents replay.

use std::collections::VecDeque;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use ring::aead::{Aad, CHACHA20_POLY1305, LessSafeKey, Nonce, UnboundKey};
use ring::agreement::{EphemeralPrivateKey, UnparsedPublicKey, X25519, agree_ephemeral};
use ring::hkdf::{HKDF_SHA256, Prk, Salt};

use crate::identity::{Identity, Peer, SIGNATURE, statement};

/// The length of an ephemeral key, in bytes.
pub(crate) const KEY: usize = 32;
/// The maximum number of pending handshakes; beyond it the oldest is dropped.
const ABOUT_TO_ASK: usize = 1024;
/// The lifetime of an ephemeral key.
const USED_WITHIN: Duration = Duration::from_secs(10);

/// The secret half of a handshake.
pub(crate) struct Half {
    private: EphemeralPrivateKey,
    pub(crate) public: [u8; KEY],
}

/// The keys of one request and its response, agreed by both sides.
pub(crate) struct Agreed {
    /// The receiver and both public keys: the bytes that both sides sign.
    transcript: Vec<u8>,
    request: LessSafeKey,
    answer: LessSafeKey,
}

impl Half {
    pub(crate) fn new(own: &Identity) -> Option<Self> {
        let private = EphemeralPrivateKey::generate(&X25519, own.random()).ok()?;
        let public = private.compute_public_key().ok()?;
        let public = public.as_ref().try_into().ok()?;
        Some(Self { private, public })
    }

    /// Whether the station under `key`, whose certificate is `asked`, has signed its half.
    pub(crate) fn is_met(&self, key: &str, asked: &Peer, theirs: &[u8], signature: &[u8]) -> bool {
        let transcript = transcript(key, &self.public, theirs);
        asked.has_signed(&statement("meet", &[&transcript]), signature)
    }

    /// Derives the shared keys, after the receiver has signed both halves.
    pub(crate) fn agree(self, key: &str, theirs: &[u8]) -> Option<Agreed> {
        let transcript = transcript(key, &self.public, theirs);
        agree(self.private, theirs, transcript)
    }
}

impl Agreed {
    /// Seals a request, with the name of the requester.
    pub(crate) fn seal_request(&self, own: &Identity, request: &[u8]) -> Option<Vec<u8>> {
        let signature = own.sign(&statement("ask", &[&self.transcript, request]));
        let certificate = own.certificate();
        let length = u16::try_from(certificate.len()).ok()?;
        let parts: [&[u8]; 4] = [&signature, &length.to_be_bytes(), certificate, request];
        seal(&self.request, parts.concat())
    }

    /// Opens a request: returns the requester and the request.
    pub(crate) fn open_request(
        &self,
        own: &Identity,
        sealed: &[u8],
    ) -> Result<(Peer, Vec<u8>), &'static str> {
        const BROKEN: &str = "the request is not sealed for this station";
        let opened = open(&self.request, sealed).ok_or(BROKEN)?;
        let (signature, rest) = opened.split_at_checked(SIGNATURE).ok_or(BROKEN)?;
        let (length, rest) = rest.split_first_chunk::<2>().ok_or(BROKEN)?;
        let length = usize::from(u16::from_be_bytes(*length));
        let (certificate, request) = rest.split_at_checked(length).ok_or(BROKEN)?;
        let peer = own.peer(certificate)?;
        if !peer.has_signed(&statement("ask", &[&self.transcript, request]), signature) {
            return Err("the signature is not that of the requester");
        }
        Ok((peer, request.to_vec()))
    }

    /// Returns the statement that a token proof covers: this request to this station, once.
    pub(crate) fn statement(&self, request: &[u8]) -> Vec<u8> {
        statement("token", &[&self.transcript, request])
    }

    pub(crate) fn seal_answer(&self, answer: Vec<u8>) -> Option<Vec<u8>> {
        seal(&self.answer, answer)
    }

    pub(crate) fn open_answer(&self, sealed: &[u8]) -> Option<Vec<u8>> {
        open(&self.answer, sealed)
    }
}

/// Pending handshakes.
#[derive(Default)]
pub(crate) struct Meetings {
    all: Mutex<VecDeque<([u8; KEY], Instant, Agreed)>>,
}

impl Meetings {
    /// Answers a handshake with the station under `key`: returns a public key and its signature.
    pub(crate) fn meet(
        &self,
        own: &Identity,
        key: &str,
        theirs: &[u8],
    ) -> Option<([u8; KEY], [u8; SIGNATURE])> {
        let half = Half::new(own)?;
        let public = half.public;
        let transcript = transcript(key, theirs, &public);
        let signature = own.sign(&statement("meet", &[&transcript]));
        let agreed = agree(half.private, theirs, transcript)?;
        let mut all = self.all.lock().unwrap_or_else(PoisonError::into_inner);
        if all.len() >= ABOUT_TO_ASK {
            all.pop_front();
        }
        all.push_back((public, Instant::now(), agreed));
        Some((public, signature))
    }

    /// Takes the agreement under a public key.
    pub(crate) fn take(&self, public: &[u8]) -> Option<Agreed> {
        let mut all = self.all.lock().unwrap_or_else(PoisonError::into_inner);
        let at = all.iter().position(|(key, ..)| key == public)?;
        let (_, since, agreed) = all.remove(at)?;
        (since.elapsed() <= USED_WITHIN).then_some(agreed)
    }
}

fn transcript(key: &str, asker: &[u8], asked: &[u8]) -> Vec<u8> {
    statement("sealed", &[key.as_bytes(), asker, asked])
}

fn agree(private: EphemeralPrivateKey, theirs: &[u8], transcript: Vec<u8>) -> Option<Agreed> {
    let theirs = UnparsedPublicKey::new(&X25519, theirs);
    let secret = agree_ephemeral(private, &theirs, |shared| {
        Salt::new(HKDF_SHA256, b"dobot fleet").extract(shared)
    })
    .ok()?;
    Some(Agreed {
        request: key(&secret, &transcript, b"request")?,
        answer: key(&secret, &transcript, b"answer")?,
        transcript,
    })
}

fn key(secret: &Prk, transcript: &[u8], what: &[u8]) -> Option<LessSafeKey> {
    let info = [transcript, what];
    let key = secret.expand(&info, &CHACHA20_POLY1305).ok()?;
    Some(LessSafeKey::new(UnboundKey::from(key)))
}

// Each key seals one message, so a constant nonce is enough.
fn nonce() -> Nonce {
    Nonce::assume_unique_for_key([0; 12])
}

fn seal(key: &LessSafeKey, mut text: Vec<u8>) -> Option<Vec<u8>> {
    let sealed = key.seal_in_place_append_tag(nonce(), Aad::empty(), &mut text);
    sealed.ok().map(|()| text)
}

fn open(key: &LessSafeKey, sealed: &[u8]) -> Option<Vec<u8>> {
    let mut text = sealed.to_vec();
    let length = key
        .open_in_place(nonce(), Aad::empty(), &mut text)
        .ok()?
        .len();
    text.truncate(length);
    Some(text)
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use crate::credentials::Credentials;

    const DESK: &str = "dobot/2/desk-2/00112233445566778899aabbccddeeff/sealed";

    fn identities() -> [Identity; 3] {
        let folder = tempfile::tempdir().unwrap();
        let names = ["desk-1", "desk-2", "desk-3"].map(|name| name.parse().unwrap());
        let all = Credentials::make(folder.path(), &names).unwrap();
        [0, 1, 2].map(|index| all[index].identity().unwrap())
    }

    #[test]
    fn a_request_is_read_only_once_and_only_by_its_recipient() {
        let [asker, asked, _] = identities();
        let meetings = Meetings::default();
        let half = Half::new(&asker).unwrap();
        let (key, signature) = meetings.meet(&asked, DESK, &half.public).unwrap();
        assert!(half.is_met(DESK, asked.own(), &key, &signature));
        let agreed = half.agree(DESK, &key).unwrap();
        let sealed = agreed.seal_request(&asker, b"a token").unwrap();
        assert!(!sealed.windows(7).any(|window| window == b"a token"));
        let theirs = meetings.take(&key).unwrap();
        let (peer, request) = theirs.open_request(&asked, &sealed).unwrap();
        assert_eq!((&*peer.name, &*request), ("desk-1", &b"a token"[..]));
        let answer = theirs.seal_answer(b"done".to_vec()).unwrap();
        assert_eq!(agreed.open_answer(&answer).unwrap(), b"done");
        // A response is not a request, and a request cannot be replayed.
        assert!(agreed.open_answer(&sealed).is_none());
        assert!(meetings.take(&key).is_none());
    }

    #[test]
    fn a_member_that_answers_for_another_one_learns_nothing() {
        let [asker, asked, thief] = identities();
        let half = Half::new(&asker).unwrap();
        let (key, signature) = Meetings::default()
            .meet(&thief, DESK, &half.public)
            .unwrap();
        assert!(!half.is_met(DESK, asked.own(), &key, &signature));
        // A signature of the receiver for another requester is not valid either.
        let [half, other] = [0, 1].map(|_| Half::new(&asker).unwrap());
        let (key, signature) = Meetings::default()
            .meet(&asked, DESK, &other.public)
            .unwrap();
        assert!(!half.is_met(DESK, asked.own(), &key, &signature));
    }

    #[test]
    fn a_request_of_a_stranger_is_refused_with_the_reason() {
        let [_, asked, _] = identities();
        let [stranger, ..] = identities();
        let meetings = Meetings::default();
        let half = Half::new(&stranger).unwrap();
        let (key, signature) = meetings.meet(&asked, DESK, &half.public).unwrap();
        assert!(half.is_met(DESK, asked.own(), &key, &signature));
        let agreed = half.agree(DESK, &key).unwrap();
        let sealed = agreed.seal_request(&stranger, b"{}").unwrap();
        let refused = meetings.take(&key).unwrap().open_request(&asked, &sealed);
        assert_eq!(
            refused.unwrap_err(),
            "it was not issued by the authority of this fleet"
        );
    }

    #[test]
    fn a_flood_of_unfinished_handshakes_leaves_room_for_a_real_request() {
        let [asker, asked, _] = identities();
        let meetings = Meetings::default();
        let flood = Half::new(&asker).unwrap().public;
        for _ in 0..ABOUT_TO_ASK + 10 {
            meetings.meet(&asked, DESK, &flood).unwrap();
        }
        let half = Half::new(&asker).unwrap();
        let (key, _) = meetings.meet(&asked, DESK, &half.public).unwrap();
        assert!(meetings.take(&key).is_some());
        assert_eq!(meetings.all.lock().unwrap().len(), ABOUT_TO_ASK - 1);
    }
}
