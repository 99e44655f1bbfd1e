//! An arm in this process, on a clock of its own.

use std::fmt;
use std::time::Duration;

/// An arm in this process, on a clock of its own: time passes when somebody waits.
///
/// The virtual arm is one (it lives above this crate, so it is met through this trait), and tests
/// bring others: deaf, noisy or broken ones.
pub trait Peer: fmt::Debug + Send {
    /// What its clock says now, since the connect.
    fn now(&self) -> Duration;

    /// When it may have something to say next, as far as can be told now; what is looked at later is no
    /// different.
    fn next(&self) -> Duration {
        self.now()
    }

    /// Starts sending bytes to it.
    fn send(&mut self, bytes: &[u8]);

    /// Lets time pass until bytes arrive from it, which are appended to `bytes`, or until `until`.
    /// Returns whether it is still there; one that left sends nothing any more.
    fn receive(&mut self, until: Duration, bytes: &mut Vec<u8>) -> bool;
}
