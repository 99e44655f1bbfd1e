//! Requests and answers as bytes: strict JSON, messages of the WebSocket, pages of lists, the OpenAPI document.

pub(crate) mod answer;
pub(crate) mod document;
pub(crate) mod internal_api;
pub(crate) mod messages;
pub(crate) mod paging;
pub(crate) mod requester;
pub(crate) mod strict_json;
