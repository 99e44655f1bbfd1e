//! Clients that have control and come over plain HTTP, one request after another.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use dobot_api::kinds::{ENDING, LEASE_GONE, ROLE, TOO_MANY_CLIENTS};
use dobot_api::{Problem, Role};
use dobot_rules::Client;

use super::tokens::{Token, digest};

/// Clients that are kept between requests, known by their lease tokens.
#[derive(Debug, Default)]
pub(super) struct Visits(Mutex<HashMap<[u8; 32], Visit>>);

#[derive(Debug)]
struct Visit {
    client: Arc<Client>,
    used: Duration,
}

impl Visits {
    /// Keeps a client; it is found by the token that comes back.
    ///
    /// # Errors
    ///
    /// [`TOO_MANY_CLIENTS`] where too many are kept already.
    pub(super) fn keep(&self, client: Arc<Client>, now: Duration) -> Result<Token, Problem> {
        let token = Token::random().map_err(|error| ENDING.problem(error.to_string()))?;
        self.with(|visits| {
            if visits.len() >= MOST {
                let detail = format!("{MOST} clients hold lease tokens already");
                return Err(TOO_MANY_CLIENTS.problem(detail));
            }
            visits.insert(digest(token.secret()), Visit { client, used: now });
            Ok(token.clone())
        })
    }

    /// The client of a token, which this renews.
    ///
    /// # Errors
    ///
    /// [`LEASE_GONE`] where there is none (any more), [`ROLE`] for one who may do less than the
    /// client.
    pub(super) fn find(
        &self,
        token: &str,
        role: Role,
        now: Duration,
    ) -> Result<Arc<Client>, Problem> {
        self.sweep(now);
        self.with(|visits| {
            let visit = visits.get_mut(&digest(token)).ok_or_else(gone)?;
            if role < visit.client.role() {
                let needed = visit.client.role();
                return Err(ROLE.problem(format!(
                    "this lease belongs to the role {needed}; the token is for {role}"
                )));
            }
            visit.used = now;
            Ok(visit.client.clone())
        })
    }

    /// Ends a client: its lease ends too.
    pub(super) fn end(&self, token: &str) {
        self.with(|visits| visits.remove(&digest(token)));
    }

    /// Ends those that have not been used for too long.
    pub(super) fn sweep(&self, now: Duration) {
        self.with(|visits| {
            visits.retain(|_, visit| {
                if Arc::strong_count(&visit.client) > 1 {
                    visit.used = now;
                }
                now.saturating_sub(visit.used) <= LASTS
            });
        });
    }

    fn with<T>(&self, act: impl FnOnce(&mut HashMap<[u8; 32], Visit>) -> T) -> T {
        act(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

/// How long a lease token lasts without being used.
pub(super) const LASTS: Duration = Duration::from_secs(10);

/// How many clients are kept at most.
const MOST: usize = 64;

fn gone() -> Problem {
    LEASE_GONE.hinted(
        format!(
            "no lease has this token; one ends when it is not used for {} s",
            LASTS.as_secs()
        ),
        "take it again with `POST /api/v1/lease`",
    )
}
