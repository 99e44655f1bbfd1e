//! A status with its time.

use std::time::Duration;

use dobot_wire::Status;

/// A status with its arrival time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TimedStatus {
    pub(crate) at: Duration,
    pub(crate) status: Status,
}
