//! What people say while they hold a page's button to talk: from WebSockets to a listener.

use std::collections::VecDeque;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use axum::body::Bytes;
use data_encoding::BASE64;
use dobot_api::problem_kinds::{INVALID, NO_LISTENER};
use dobot_api::{ClientId, Problem};
use schemars::JsonSchema;
use serde::Serialize;
use tokio::sync::Notify;

/// The audio that the listener has not fetched.
#[derive(Debug, Default)]
pub(crate) struct Talk {
    waiting: Mutex<Waiting>,
    arrived: Notify,
}

#[derive(Debug, Default)]
struct Waiting {
    pieces: VecDeque<(ClientId, Bytes)>,
    bytes: usize,
    /// Until when a listener counts as running.
    listens_until: Duration,
}

/// A piece of what a client says.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct TalkPiece {
    /// The client.
    client: ClientId,
    /// Samples at 16 kHz, 16 bits, little-endian, one channel, as Base64; empty at the end of what is said.
    pcm: String,
}

impl Talk {
    /// Whether a listener runs.
    pub(crate) fn listens(&self, now: Duration) -> bool {
        now < self.waiting().listens_until
    }

    /// Takes a piece of audio from a client; empty at the end.
    pub(crate) fn add(&self, now: Duration, client: ClientId, pcm: Bytes) -> Result<(), Problem> {
        if pcm.len() > MAX_PIECE || !pcm.len().is_multiple_of(2) {
            return Err(INVALID.problem(format!(
                "the piece of audio has {} bytes; allowed are 0 to {MAX_PIECE}, two for each sample",
                pcm.len()
            )));
        }
        let mut waiting = self.waiting();
        if now >= waiting.listens_until {
            waiting.clear();
            let hint = "start `python -m dobot_arm.listen` next to the station";
            return Err(NO_LISTENER.hinted("nothing listens to the audio", hint));
        }
        if waiting.bytes + pcm.len() > MAX_WAITING {
            waiting.clear();
            return Err(NO_LISTENER.problem(format!(
                "the listener has left {MAX_WAITING} bytes of audio unread; say it again"
            )));
        }
        waiting.bytes += pcm.len();
        waiting.pieces.push_back((client, pcm));
        drop(waiting);
        self.arrived.notify_one();
        Ok(())
    }

    /// Notes that a listener runs.
    pub(crate) fn note_listener(&self, now: Duration) {
        self.waiting().listens_until = now + LISTENS_FOR;
    }

    /// Returns what has arrived, or waits for it for a while.
    pub(crate) async fn fetch(&self) -> Vec<TalkPiece> {
        let fetched = self.drain();
        if !fetched.is_empty() {
            return fetched;
        }
        // Without audio the listener asks again.
        let _ = tokio::time::timeout(FETCH_WITHIN, self.arrived.notified()).await;
        self.drain()
    }

    fn drain(&self) -> Vec<TalkPiece> {
        let mut waiting = self.waiting();
        waiting.bytes = 0;
        let piece = |(client, pcm): (ClientId, Bytes)| TalkPiece {
            client,
            pcm: BASE64.encode(&pcm),
        };
        waiting.pieces.drain(..).map(piece).collect()
    }

    fn waiting(&self) -> MutexGuard<'_, Waiting> {
        self.waiting.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Waiting {
    fn clear(&mut self) {
        self.pieces.clear();
        self.bytes = 0;
    }
}

/// The largest piece, in bytes: a second.
const MAX_PIECE: usize = 32_000;
/// The most audio that waits for the listener, in bytes: ten seconds.
const MAX_WAITING: usize = 10 * MAX_PIECE;
/// How long a request of the listener waits for audio.
const FETCH_WITHIN: Duration = Duration::from_secs(1);
/// How long a listener counts as running after its request.
const LISTENS_FOR: Duration = Duration::from_secs(4);

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    const START: Duration = Duration::from_secs(100);
    const ANNA: ClientId = ClientId(7);

    fn add(talk: &Talk, now: Duration, bytes: usize) -> Result<(), Problem> {
        talk.add(now, ANNA, Bytes::from(vec![1; bytes]))
    }

    #[tokio::test]
    async fn audio_reaches_the_listener_in_its_order_and_once() {
        let talk = Talk::default();
        talk.note_listener(START);
        talk.add(START, ANNA, Bytes::from_static(&[1, 2])).unwrap();
        talk.add(START, ANNA, Bytes::new()).unwrap();
        let fetched = serde_json::to_value(talk.fetch().await).unwrap();
        let expected = serde_json::json!([{"client": 7, "pcm": "AQI="}, {"client": 7, "pcm": ""}]);
        assert_eq!(fetched, expected);
        assert!(talk.drain().is_empty());
    }

    #[test]
    fn audio_is_refused_without_a_listener_and_when_it_is_none() {
        let talk = Talk::default();
        assert_eq!(add(&talk, START, 2).unwrap_err().name(), NO_LISTENER.name);
        talk.note_listener(START);
        add(&talk, START, 2).unwrap();
        assert_eq!(add(&talk, START, 3).unwrap_err().name(), INVALID.name);
        let large = add(&talk, START, MAX_PIECE + 2);
        assert_eq!(large.unwrap_err().name(), INVALID.name);
        let later = add(&talk, START + LISTENS_FOR, 2);
        assert_eq!(later.unwrap_err().name(), NO_LISTENER.name);
        assert!(talk.drain().is_empty());
    }

    #[test]
    fn a_listener_that_reads_nothing_gets_no_old_audio_later() {
        let talk = Talk::default();
        talk.note_listener(START);
        for _ in 0..MAX_WAITING / MAX_PIECE {
            add(&talk, START, MAX_PIECE).unwrap();
        }
        let full = add(&talk, START, 2);
        assert_eq!(full.unwrap_err().name(), NO_LISTENER.name);
        assert!(talk.drain().is_empty());
    }
}
