//! The rate of a client's states.

use std::sync::Arc;
use std::time::Duration;

use axum::extract::ws::Utf8Bytes;
use dobot_host::Snapshot;
use tokio::sync::broadcast;
use tokio::sync::broadcast::error::RecvError;
use tokio::time::{Instant, sleep_until};

/// The states of one client, at the requested rate.
#[derive(Debug)]
pub(crate) struct StateStream {
    states: broadcast::Receiver<Arc<Snapshot>>,
    rate: Rate,
    /// The newest state, which waits until it is due.
    held: Option<Arc<Snapshot>>,
    due: Instant,
}

#[derive(Clone, Copy, Debug)]
enum Rate {
    None,
    Every,
    Spaced(Duration),
}

impl StateStream {
    /// Limits the stream to `per_s` states per second, or to none.
    pub(crate) fn new(states: broadcast::Receiver<Arc<Snapshot>>, per_s: Option<f64>) -> Self {
        let rate = match per_s {
            None => Rate::Every,
            Some(per_s) if per_s > 0.0 => spaced(1.0 / per_s),
            Some(_) => Rate::None,
        };
        Self {
            states,
            rate,
            held: None,
            due: Instant::now(),
        }
    }

    /// Whether states are requested.
    pub(crate) fn is_wanted(&self) -> bool {
        !matches!(self.rate, Rate::None)
    }

    /// Returns the next state to send. Cancel-safe.
    ///
    /// # Errors
    ///
    /// If the client lags until states are lost, or there are no more states.
    pub(crate) async fn next(&mut self) -> Result<Utf8Bytes, RecvError> {
        let spacing = match self.rate {
            Rate::None => std::future::pending().await,
            Rate::Every => return self.states.recv().await.map(|state| message(&state)),
            Rate::Spaced(spacing) => spacing,
        };
        loop {
            match self.held.take() {
                None => self.held = Some(self.newest().await?),
                Some(held) => {
                    let message = message(&held);
                    self.held = Some(held);
                    tokio::select! {
                        () = sleep_until(self.due) => {
                            self.held = None;
                            self.due = (self.due + spacing).max(Instant::now());
                            return Ok(message);
                        }
                        newer = self.states.recv() => self.held = Some(kept(newer, &mut self.states).await?),
                    }
                }
            }
        }
    }

    async fn newest(&mut self) -> Result<Arc<Snapshot>, RecvError> {
        let first = self.states.recv().await;
        kept(first, &mut self.states).await
    }
}

/// Returns the message for a state.
pub(crate) fn message(state: &Snapshot) -> Utf8Bytes {
    Utf8Bytes::try_from(state.message()).expect("JSON is UTF-8")
}

/// A period longer than any station runs is that: no clock can add more.
fn spaced(seconds: f64) -> Rate {
    let period = Duration::try_from_secs_f64(seconds).unwrap_or(Duration::MAX);
    Rate::Spaced(period.min(LONGEST_PERIOD))
}

const LONGEST_PERIOD: Duration = Duration::from_secs(100 * 365 * 24 * 3600);

/// Returns the next state, or the one after a gap: a client with a limited rate does not miss any.
async fn kept(
    received: Result<Arc<Snapshot>, RecvError>,
    states: &mut broadcast::Receiver<Arc<Snapshot>>,
) -> Result<Arc<Snapshot>, RecvError> {
    match received {
        Err(RecvError::Lagged(_)) => states.recv().await,
        received => received,
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use crate::sample::state;

    fn snapshot(number: u32) -> Arc<Snapshot> {
        Arc::new(Snapshot::new(state(f64::from(number))))
    }

    fn number(message: &Utf8Bytes) -> f64 {
        let value: serde_json::Value = serde_json::from_str(message).unwrap();
        value["state"]["at_s"].as_f64().unwrap()
    }

    #[tokio::test(start_paused = true)]
    async fn a_client_of_every_state_gets_every_state() {
        let (sender, states) = broadcast::channel(16);
        let mut stream = StateStream::new(states, None);
        for n in 0..10 {
            sender.send(snapshot(n)).unwrap();
        }
        for n in 0..10 {
            assert_eq!(number(&stream.next().await.unwrap()), f64::from(n));
        }
    }

    #[tokio::test(start_paused = true)]
    async fn a_client_of_two_states_per_second_gets_the_newest_every_half_second() {
        let (sender, states) = broadcast::channel(1024);
        let mut stream = StateStream::new(states, Some(2.0));
        let sender = tokio::spawn(async move {
            for n in 0..500 {
                sender.send(snapshot(n)).unwrap();
                tokio::time::sleep(Duration::from_millis(10)).await;
            }
        });
        let began = Instant::now();
        let mut got = Vec::new();
        while let Ok(message) = stream.next().await {
            got.push((began.elapsed().as_millis(), number(&message)));
        }
        sender.await.unwrap();
        assert!((10..=11).contains(&got.len()), "{got:?}");
        for pair in got.windows(2) {
            assert!(pair[1].0 - pair[0].0 >= 499, "{got:?}");
            assert!(pair[1].1 - pair[0].1 >= 49.0, "{got:?}");
        }
    }

    #[tokio::test(start_paused = true)]
    async fn any_rate_above_zero_gives_the_first_state() {
        for per_s in [f64::MIN_POSITIVE, 9e-20, 1e-10, 1e300] {
            let (sender, states) = broadcast::channel(16);
            let mut stream = StateStream::new(states, Some(per_s));
            sender.send(snapshot(0)).unwrap();
            assert_eq!(number(&stream.next().await.unwrap()), 0.0, "{per_s}");
        }
    }

    #[tokio::test(start_paused = true)]
    async fn the_last_state_arrives_even_if_nothing_follows() {
        let (sender, states) = broadcast::channel(16);
        let mut stream = StateStream::new(states, Some(1.0));
        for n in 0..3 {
            sender.send(snapshot(n)).unwrap();
        }
        let mut last = number(&stream.next().await.unwrap());
        while last < 2.0 {
            last = number(&stream.next().await.unwrap());
        }
        assert_eq!(last, 2.0);
    }

    #[tokio::test(start_paused = true)]
    async fn a_client_of_all_states_that_lags_too_far_is_notified() {
        let (sender, states) = broadcast::channel(4);
        let mut stream = StateStream::new(states, None);
        for n in 0..9 {
            sender.send(snapshot(n)).unwrap();
        }
        assert!(matches!(stream.next().await, Err(RecvError::Lagged(_))));
    }
}
