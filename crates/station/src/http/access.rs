//! Access control: tokens, the check of each request, rate limits, and leases over plain HTTP.

pub(crate) mod auth;
pub(crate) mod http_leases;
pub(crate) mod rate;
pub(crate) mod tokens;
