//! Live data: WebSockets, server-sent events, packets.

pub(crate) mod events;
pub(crate) mod packets;
pub(crate) mod socket;
