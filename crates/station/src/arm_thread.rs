//! The thread that has the arm.

use std::io;

use tokio::runtime::{Builder, Handle};
use tokio::sync::oneshot;

use crate::Found;
use crate::owner::Owner;

/// The thread that has the arm: the owner of its port runs there, and those who speak the arm's own
/// protocol, so that no packet waits until a thousand others have been told where the arm is.
#[derive(Debug)]
pub(crate) struct ArmThread {
    runtime: Handle,
    ended: oneshot::Receiver<()>,
}

impl ArmThread {
    /// Lets the owner run there; the thread ends with it, and with the thread all else that runs
    /// there.
    ///
    /// # Errors
    ///
    /// What the operating system says.
    pub(crate) fn start(owner: Owner, found: Option<Found>) -> io::Result<Self> {
        let runtime = Builder::new_current_thread().enable_all().build()?;
        let handle = runtime.handle().clone();
        let (over, ended) = oneshot::channel();
        let thread = std::thread::Builder::new().name("arm".into());
        thread.spawn(move || {
            runtime.block_on(owner.run(found));
            // Nobody may be waiting for that.
            let _ = over.send(());
        })?;
        Ok(Self {
            runtime: handle,
            ended,
        })
    }

    /// Lets something else run there.
    pub(crate) fn spawn(&self, task: impl Future<Output = ()> + Send + 'static) {
        self.runtime.spawn(task);
    }

    /// Waits until the owner has ended.
    pub(crate) async fn ended(self) {
        // A thread that was torn down has nothing to say.
        let _ = self.ended.await;
    }
}
