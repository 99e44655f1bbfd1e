//! The commands that are waiting or in flight.

use std::time::Duration;

/// The commands of a session that have not ended.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Queue {
    /// Commands that have not been sent.
    pub waiting: usize,
    /// Commands that were sent and have not ended.
    pub in_flight: usize,
    /// Expected time until all in-flight commands have ended.
    pub ahead: Duration,
    /// Whether the arm's queue is full: four or more commands are in flight and a status that was due
    /// has not arrived (note N20). On an idle link the statuses continue.
    pub is_full: bool,
}
