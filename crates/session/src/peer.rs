//! An arm in this process with its own clock.

use std::fmt;
use std::time::Duration;

/// An arm in this process with its own clock: time passes only while the caller waits.
///
/// The virtual arm implements it (in a crate above this one), and so do the unresponsive, noisy and
/// broken arms of the tests.
pub trait Peer: fmt::Debug + Send {
    /// The time on its clock since the connection was opened.
    fn now(&self) -> Duration;

    /// The earliest time at which it may send bytes. Polling later gives the same bytes.
    fn next(&self) -> Duration {
        self.now()
    }

    /// Sends bytes to it.
    fn send(&mut self, bytes: &[u8]);

    /// Lets time pass until it sends bytes, which are appended to `bytes`, or until `until`. Returns
    /// whether it is still connected; a disconnected peer sends nothing more.
    fn receive(&mut self, until: Duration, bytes: &mut Vec<u8>) -> bool;
}
