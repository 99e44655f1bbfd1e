//! Messages from a station, read by a background task until they are taken.
//!
//! The task answers the station's pings and keeps reading while the client is planning, simulating
//! or waiting for a person; otherwise the station would drop the client after some seconds.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use tokio::sync::Notify;
use tokio::task::JoinHandle;

use super::{Incoming, RemoteError, StationEvent, receive, refused};
use crate::{Reply, ToClient};

/// Aborts its task when dropped.
pub(super) struct Inbox {
    shared: Arc<Shared>,
    task: JoinHandle<()>,
}

#[derive(Default)]
struct Shared {
    received: Mutex<Received>,
    /// Notified when something arrives.
    arrived: Notify,
}

/// What arrived and has not been taken.
#[derive(Default)]
struct Received {
    /// Oldest first.
    events: VecDeque<Result<StationEvent, RemoteError>>,
    /// The request whose answer is awaited.
    expected: Option<u64>,
    answer: Option<Result<Reply, RemoteError>>,
    /// Whether nothing more comes.
    ended: bool,
    /// The reason, until it has been reported.
    why: Option<RemoteError>,
}

impl Inbox {
    pub(super) fn listening_to(mut incoming: Incoming) -> Self {
        let shared = Arc::<Shared>::default();
        let sender = shared.clone();
        let task = tokio::spawn(async move {
            let mut more = true;
            while more {
                let message = receive(&mut incoming).await;
                more = sender.received().note(message);
                sender.arrived.notify_one();
            }
        });
        Self { shared, task }
    }

    /// Starts keeping the answer to this request, and no other.
    pub(super) fn expect(&mut self, question: u64) {
        let mut received = self.shared.received();
        received.expected = Some(question);
        received.answer = None;
        received.keep_last_state();
    }

    /// Waits for the answer to the request expected last.
    pub(super) async fn answer(&mut self) -> Result<Reply, RemoteError> {
        self.wait_for(|received| received.answer.take()).await
    }

    /// Waits for the next unsolicited event. A cancelled request is forgotten.
    pub(super) async fn next(&mut self) -> Result<StationEvent, RemoteError> {
        self.shared.received().expected = None;
        self.wait_for(|received| received.events.pop_front()).await
    }

    /// Returns the reason if nothing more comes.
    pub(super) fn ended(&mut self) -> Option<RemoteError> {
        let mut received = self.shared.received();
        received.ended.then(|| received.why())
    }

    async fn wait_for<T>(
        &mut self,
        pick: impl Fn(&mut Received) -> Option<Result<T, RemoteError>>,
    ) -> Result<T, RemoteError> {
        loop {
            {
                let mut received = self.shared.received();
                if let Some(taken) = pick(&mut received) {
                    return taken;
                }
                if received.ended {
                    return Err(received.why());
                }
            }
            self.shared.arrived.notified().await;
        }
    }
}

impl Drop for Inbox {
    fn drop(&mut self) {
        self.task.abort();
    }
}

impl Shared {
    fn received(&self) -> MutexGuard<'_, Received> {
        self.received.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Received {
    /// Records a message or an error; returns whether more may come.
    fn note(&mut self, message: Result<ToClient<'_>, RemoteError>) -> bool {
        match message {
            Ok(ToClient::State { state }) => {
                self.events.push_back(Ok(StationEvent::State(state)));
                let states = self.events.iter().filter(|event| is_state(event)).count();
                if self.expected.is_some() || states > MAX_STATES {
                    self.keep_last_state();
                }
            }
            Ok(ToClient::Notice { notice }) => {
                let notice = StationEvent::Notice(notice.into_owned());
                self.events.push_back(Ok(notice));
            }
            Ok(ToClient::Reply { id, reply }) => self.note_answer(Some(id), Ok(reply)),
            Ok(ToClient::Problem { id, problem }) => self.note_answer(id, Err(refused(problem))),
            Ok(ToClient::Hello { .. }) => {}
            Err(why @ (RemoteError::Closed(_) | RemoteError::Broken(_))) => {
                self.ended = true;
                self.why = Some(why);
            }
            Err(error) => self.note_answer(None, Err(error)),
        }
        !self.ended
    }

    fn keep_last_state(&mut self) {
        let last = self.events.iter().rposition(is_state);
        let mut at = 0..;
        self.events
            .retain(|event| at.next() == last || !is_state(event));
    }

    fn why(&mut self) -> RemoteError {
        self.why.take().unwrap_or(RemoteError::Closed(None))
    }

    /// An answer without a request number goes to the pending request, otherwise it becomes an
    /// event. An answer to a cancelled request is dropped.
    fn note_answer(&mut self, id: Option<u64>, answer: Result<Reply, RemoteError>) {
        if self.expected.is_some() && (id.is_none() || id == self.expected) {
            self.expected = None;
            self.answer = Some(answer);
        } else if let (None, Err(error)) = (id, answer) {
            self.events.push_back(Err(error));
        }
    }
}

const fn is_state(event: &Result<StationEvent, RemoteError>) -> bool {
    matches!(event, Ok(StationEvent::State(_)))
}

/// The maximum number of states in a burst, about one second's; a slower client gets only the
/// latest one.
const MAX_STATES: usize = 16;
