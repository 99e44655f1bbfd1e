//! Requests that only the station that is asked can read, and answers that only it can give.
//!
//! Both sides give a key for one use: the asked one signs both keys, and so shows who it is, before anything secret
//! is sent. The asker signs them in the sealed request. A key is used once, so nothing can be sent again.

use std::collections::VecDeque;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use ring::aead::{Aad, CHACHA20_POLY1305, LessSafeKey, Nonce, UnboundKey};
use ring::agreement::{EphemeralPrivateKey, UnparsedPublicKey, X25519, agree_ephemeral};
use ring::hkdf::{HKDF_SHA256, Prk, Salt};

use crate::identity::{Identity, Peer, SIGNATURE, statement};

/// The length of a key for one use, in bytes.
pub(crate) const KEY: usize = 32;
/// So many stations may be about to ask; of more the oldest has to begin anew.
const ABOUT_TO_ASK: usize = 1024;
/// For so long a key may be used.
const USED_WITHIN: Duration = Duration::from_secs(10);

/// The half of an agreement that stays here.
pub(crate) struct Half {
    private: EphemeralPrivateKey,
    pub(crate) public: [u8; KEY],
}

/// What both sides have agreed on, for one request and its answer.
pub(crate) struct Agreed {
    /// The station that is asked and both public keys: what both sides sign.
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

    /// Whether the station under `key`, whose certificate is `asked`, has given its half for this one.
    pub(crate) fn is_met(&self, key: &str, asked: &Peer, theirs: &[u8], signature: &[u8]) -> bool {
        let transcript = transcript(key, &self.public, theirs);
        asked.has_signed(&statement("meet", &[&transcript]), signature)
    }

    /// What comes of both halves, once the asked station has signed them.
    pub(crate) fn agree(self, key: &str, theirs: &[u8]) -> Option<Agreed> {
        let transcript = transcript(key, &self.public, theirs);
        agree(self.private, theirs, transcript)
    }
}

impl Agreed {
    /// Seals a request, with the name of who asks.
    pub(crate) fn seal_request(&self, own: &Identity, request: &[u8]) -> Option<Vec<u8>> {
        let signature = own.sign(&statement("ask", &[&self.transcript, request]));
        let certificate = own.certificate();
        let length = u16::try_from(certificate.len()).ok()?;
        let parts: [&[u8]; 4] = [&signature, &length.to_be_bytes(), certificate, request];
        seal(&self.request, parts.concat())
    }

    /// Opens a request: who asks, and for what.
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
            return Err("the request is signed by somebody else");
        }
        Ok((peer, request.to_vec()))
    }

    /// The statement that a proof of a token covers: this request to this station, once.
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

/// What was agreed with those who are about to ask.
#[derive(Default)]
pub(crate) struct Meetings {
    all: Mutex<VecDeque<([u8; KEY], Instant, Agreed)>>,
}

impl Meetings {
    /// Gives a key to somebody who is about to ask the station under `key`: the key and its signature.
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

    /// What was agreed under a key: once.
    pub(crate) fn take(&self, public: &[u8]) -> Option<Agreed> {
        let mut all = self.all.lock().unwrap_or_else(PoisonError::into_inner);
        let at = all.iter().position(|(it, ..)| it == public)?;
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

// Each key seals one message, so one nonce is enough.
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
        let names = ["desk-1", "desk-2", "desk-3"].map(|it| it.parse().unwrap());
        let all = Credentials::make(folder.path(), &names).unwrap();
        [0, 1, 2].map(|it| all[it].identity().unwrap())
    }

    #[test]
    fn a_request_is_read_by_the_station_that_is_asked_and_only_once() {
        let [asker, asked, _] = identities();
        let meetings = Meetings::default();
        let half = Half::new(&asker).unwrap();
        let (key, signature) = meetings.meet(&asked, DESK, &half.public).unwrap();
        assert!(half.is_met(DESK, asked.own(), &key, &signature));
        let agreed = half.agree(DESK, &key).unwrap();
        let sealed = agreed.seal_request(&asker, b"a token").unwrap();
        assert!(!sealed.windows(7).any(|it| it == b"a token"));
        let theirs = meetings.take(&key).unwrap();
        let (peer, request) = theirs.open_request(&asked, &sealed).unwrap();
        assert_eq!((&*peer.name, &*request), ("desk-1", &b"a token"[..]));
        let answer = theirs.seal_answer(b"done".to_vec()).unwrap();
        assert_eq!(agreed.open_answer(&answer).unwrap(), b"done");
        // An answer is no request, and what was sent is not taken again.
        assert!(agreed.open_answer(&sealed).is_none());
        assert!(meetings.take(&key).is_none());
    }

    #[test]
    fn a_member_that_answers_for_another_one_is_told_nothing() {
        let [asker, asked, thief] = identities();
        let half = Half::new(&asker).unwrap();
        let (key, signature) = Meetings::default()
            .meet(&thief, DESK, &half.public)
            .unwrap();
        assert!(!half.is_met(DESK, asked.own(), &key, &signature));
        // Neither does what the asked station has signed for somebody else count.
        let [half, other] = [0, 1].map(|_| Half::new(&asker).unwrap());
        let (key, signature) = Meetings::default()
            .meet(&asked, DESK, &other.public)
            .unwrap();
        assert!(!half.is_met(DESK, asked.own(), &key, &signature));
    }

    #[test]
    fn a_request_of_a_stranger_is_refused_with_why() {
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
            "the authority of this fleet has not made it"
        );
    }

    #[test]
    fn a_flood_of_those_who_only_begin_leaves_room_for_one_who_asks() {
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
