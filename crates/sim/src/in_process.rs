//! A virtual arm in this process, in virtual time.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use dobot_session::Peer;

use crate::VirtualArm;

/// A virtual arm in this process: time passes as fast as it is waited for.
///
/// Clones share the arm: one is given to a `Connection`, another looks at the arm afterwards.
#[derive(Clone, Debug)]
pub struct InProcess {
    arm: Arc<Mutex<VirtualArm>>,
}

impl InProcess {
    /// Shares a virtual arm, and opens its port.
    #[must_use]
    pub fn new(mut arm: VirtualArm) -> Self {
        arm.handle_open(arm.now());
        Self {
            arm: Arc::new(Mutex::new(arm)),
        }
    }

    /// Opens the port again, which is there: after a client left, or after it was closed.
    pub fn reopen(&self) {
        let mut arm = self.arm();
        let now = arm.now();
        arm.handle_open(now);
    }

    /// The arm, to look at it; it is locked meanwhile.
    pub fn arm(&self) -> MutexGuard<'_, VirtualArm> {
        self.arm.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Peer for InProcess {
    fn now(&self) -> Duration {
        self.arm().now()
    }

    fn next(&self) -> Duration {
        let arm = self.arm();
        arm.poll_delivery().max(arm.now())
    }

    fn send(&mut self, bytes: &[u8]) {
        let mut arm = self.arm();
        let now = arm.now();
        arm.handle_bytes(now, bytes);
    }

    fn receive(&mut self, until: Duration, bytes: &mut Vec<u8>) -> bool {
        let mut arm = self.arm();
        let had = bytes.len();
        arm.poll_bytes(bytes);
        while bytes.len() == had && arm.now() < until && arm.has_port() {
            let next = arm.poll_wakeup().min(until);
            arm.handle_time(next);
            arm.poll_bytes(bytes);
        }
        arm.has_port()
    }
}
