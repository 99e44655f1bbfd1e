//! A status, and when it came.

use std::time::Duration;

use dobot_wire::Status;

/// A status and when it was there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TimedStatus {
    pub(crate) at: Duration,
    pub(crate) status: Status,
}
