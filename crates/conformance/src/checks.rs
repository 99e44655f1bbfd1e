//! The checks by topic.

pub(crate) mod delay;
pub(crate) mod flow;
pub(crate) mod framing;
pub(crate) mod hand;
pub(crate) mod jog;
pub(crate) mod jump;
pub(crate) mod limits;
pub(crate) mod link;
pub(crate) mod moves;
pub(crate) mod release;
pub(crate) mod settings;
pub(crate) mod ticks;
pub(crate) mod traps;
pub(crate) mod write;
