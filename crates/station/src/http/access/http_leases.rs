//! Clients that have control and come over plain HTTP, one request after another.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use dobot_api::problem_kinds::{ENDING, LEASE_GONE, ROLE, TOO_MANY_CLIENTS};
use dobot_api::{Problem, Role};
use dobot_host::Client;

use crate::http::access::tokens::{Token, digest};
use crate::http::app::Caller;

/// Clients that are kept between requests, known by their lease tokens.
#[derive(Debug, Default)]
pub(crate) struct HttpLeases(Mutex<HashMap<[u8; 32], HttpLease>>);

#[derive(Debug)]
struct HttpLease {
    client: Arc<Client>,
    /// Who took it.
    caller: Caller,
    used: Duration,
}

impl HttpLeases {
    /// Keeps a client; it is found by the token that comes back.
    ///
    /// # Errors
    ///
    /// [`TOO_MANY_CLIENTS`] where too many are kept already.
    pub(crate) fn keep(
        &self,
        client: Arc<Client>,
        caller: Caller,
        now: Duration,
    ) -> Result<Token, Problem> {
        let token = Token::random().map_err(|error| ENDING.problem(error.to_string()))?;
        self.with(|http_leases| {
            if http_leases.len() >= MOST {
                let detail = format!("{MOST} clients hold lease tokens already");
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

    /// The client of a token, which this renews.
    ///
    /// # Errors
    ///
    /// [`LEASE_GONE`] where there is none (any more), [`ROLE`] for one who may do less than the
    /// client.
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
                    "this lease belongs to the role {needed}; the token is for {role}"
                )));
            }
            http_lease.used = now;
            Ok(http_lease.client.clone())
        })
    }

    /// Ends a client: its lease ends too.
    pub(crate) fn end(&self, token: &str) {
        self.with(|http_leases| http_leases.remove(&digest(token)));
    }

    /// Ends those of callers who may not hold them any more.
    pub(crate) fn end_where(&self, may_not: impl Fn(&Caller) -> bool) {
        self.with(|http_leases| http_leases.retain(|_, it| !may_not(&it.caller)));
    }

    /// Ends those that have not been used for too long.
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

/// How long a lease token lasts without being used.
pub(crate) const LASTS: Duration = Duration::from_secs(10);

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
