//! What is on its way.

use std::time::Duration;

/// What a session has given and the arm has not done yet.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Queue {
    /// Commands that have not been sent.
    pub waiting: usize,
    /// Commands sent and not seen to be over.
    pub in_flight: usize,
    /// How long it should take until all that was sent is over.
    pub ahead: Duration,
    /// Whether the arm has no room for another one: four or more commands are under way, and a
    /// status that was due has not come (note N20). An idle link is told from it by statuses that
    /// come.
    pub is_full: bool,
}
