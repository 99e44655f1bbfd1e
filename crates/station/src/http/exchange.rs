//! Requests and responses as bytes: strict JSON, WebSocket messages, paging, the OpenAPI document.

pub(crate) mod document;
pub(crate) mod internal_api;
pub(crate) mod messages;
pub(crate) mod paging;
pub(crate) mod requester;
pub(crate) mod responses;
pub(crate) mod strict_json;
