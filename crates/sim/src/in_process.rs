//! A virtual arm in this process, in virtual time.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use dobot_controller::{Controller, Personality, PowerUp};
use dobot_session::{Connection, Peer};

use crate::{SerialLine, VirtualArm};

/// Connects to a new virtual arm in this process, in virtual time.
#[must_use]
pub fn connect(personality: Personality) -> Connection {
    let controller = Controller::power_up(PowerUp::new(personality));
    let arm = InProcess::new(VirtualArm::new(controller, SerialLine::STOCK));
    Connection::over_peer(arm, Some(personality.dialect()))
}

/// A virtual arm in this process: its time passes only while the client waits.
///
/// Clones share the arm: pass one to a `Connection` and inspect the arm with another.
#[derive(Clone, Debug)]
pub struct InProcess {
    arm: Arc<Mutex<VirtualArm>>,
}

impl InProcess {
    /// Opens the port of a virtual arm.
    #[must_use]
    pub fn new(mut arm: VirtualArm) -> Self {
        arm.handle_open(arm.now());
        Self {
            arm: Arc::new(Mutex::new(arm)),
        }
    }

    /// Opens the port again after a client left or the port was closed.
    pub fn reopen(&self) {
        let mut arm = self.arm();
        let now = arm.now();
        arm.handle_open(now);
    }

    /// Locks the arm for inspection.
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
