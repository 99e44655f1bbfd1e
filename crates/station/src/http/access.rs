//! Who may do what: tokens, the check of each request, rate limits, and control without a connection.

pub(crate) mod auth;
pub(crate) mod http_leases;
pub(crate) mod rate;
pub(crate) mod tokens;
