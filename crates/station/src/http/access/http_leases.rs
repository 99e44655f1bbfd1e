//! Leases of clients that use plain HTTP, one request after another.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use dobot_api::problem_kinds::{ENDING, LEASE_GONE, ROLE, TOO_MANY_CLIENTS};
use dobot_api::{Problem, Role};
use dobot_host::Client;

use crate::http::access::tokens::{Token, digest};
use crate::http::app::Caller;

/// Clients that exist between requests, by lease token.
#[derive(Debug, Default)]
pub(crate) struct HttpLeases(Mutex<HashMap<[u8; 32], HttpLease>>);

#[derive(Debug)]
struct HttpLease {
    client: Arc<Client>,
    /// The caller that took the lease.
    caller: Caller,
    used: Duration,
}

impl HttpLeases {
    /// Stores a client under its lease token.
    ///
    /// # Errors
    ///
    /// [`TOO_MANY_CLIENTS`] if there are too many clients.
    pub(crate) fn keep(
        &self,
        client: Arc<Client>,
        caller: Caller,
        now: Duration,
    ) -> Result<Token, Problem> {
        let token = Token::random().map_err(|error| ENDING.problem(error.to_string()))?;
        self.with(|http_leases| {
            if http_leases.len() >= MAX_CLIENTS {
                let detail = format!("{MAX_CLIENTS} clients already hold lease tokens");
                return Err(TOO_MANY_CLIENTS.problem(detail));
            }
            http_leases.insert(
                digest(token.secret()),
                HttpLease {
                    client,
                    caller,
                    used: now,
                },
            );
            Ok(token.clone())
        })
    }

    /// Returns the client of a lease token, and renews it.
    ///
    /// # Errors
    ///
    /// [`LEASE_GONE`] if there is none (any more), [`ROLE`] if the caller's role is below that of
    /// the client.
    pub(crate) fn find(
        &self,
        token: &str,
        role: Role,
        now: Duration,
    ) -> Result<Arc<Client>, Problem> {
        self.sweep(now);
        self.with(|http_leases| {
            let http_lease = http_leases.get_mut(&digest(token)).ok_or_else(gone)?;
            if role < http_lease.client.role() {
                let needed = http_lease.client.role();
                return Err(ROLE.problem(format!(
                    "this lease requires the role {needed}; the token has the role {role}"
                )));
            }
            http_lease.used = now;
            Ok(http_lease.client.clone())
        })
    }

    /// Removes a client: its lease ends too.
    pub(crate) fn end(&self, token: &str) {
        self.with(|http_leases| http_leases.remove(&digest(token)));
    }

    /// Removes the clients of callers that have lost their rights.
    pub(crate) fn end_where(&self, may_not: impl Fn(&Caller) -> bool) {
        self.with(|http_leases| http_leases.retain(|_, lease| !may_not(&lease.caller)));
    }

    /// Removes the clients that have not been used for too long.
    pub(crate) fn sweep(&self, now: Duration) {
        self.with(|http_leases| {
            http_leases.retain(|_, http_lease| {
                if Arc::strong_count(&http_lease.client) > 1 {
                    http_lease.used = now;
                }
                now.saturating_sub(http_lease.used) <= LASTS
            });
        });
    }

    fn with<T>(&self, act: impl FnOnce(&mut HashMap<[u8; 32], HttpLease>) -> T) -> T {
        act(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

/// The time after which an unused lease token expires.
pub(crate) const LASTS: Duration = Duration::from_secs(10);

/// The maximum number of clients.
const MAX_CLIENTS: usize = 64;

fn gone() -> Problem {
    LEASE_GONE.hinted(
        format!(
            "no lease has this token; a lease expires when it is unused for {} s",
            LASTS.as_secs()
        ),
        "take control again with `POST /api/v1/lease`",
    )
}
