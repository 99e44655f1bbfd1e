//! A background thread for slow disks and pipes.

use std::convert::Infallible;
use std::io;
use std::sync::mpsc::{Receiver, SyncSender, channel, sync_channel};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

/// A background thread with a bounded queue. Pushing never waits.
#[derive(Debug)]
pub struct Background<T> {
    queue: SyncSender<T>,
    /// Disconnected when the thread has ended.
    running: Mutex<Receiver<Infallible>>,
}

impl<T: Send + 'static> Background<T> {
    /// Starts a thread that processes pushed items until this is dropped.
    ///
    /// # Errors
    ///
    /// The operating system's error if no thread can be started.
    pub fn start(
        name: &str,
        capacity: usize,
        work: impl FnOnce(Receiver<T>) + Send + 'static,
    ) -> io::Result<Self> {
        let (queue, items) = sync_channel(capacity);
        let (alive, running) = channel();
        let thread = std::thread::Builder::new().name(name.into());
        thread.spawn(move || {
            work(items);
            drop(alive);
        })?;
        let running = Mutex::new(running);
        Ok(Self { queue, running })
    }

    /// Pushes an item; returns it if the queue is full.
    ///
    /// # Errors
    ///
    /// The item.
    pub fn push(&self, item: T) -> Result<(), T> {
        self.queue.try_send(item).map_err(|error| match error {
            std::sync::mpsc::TrySendError::Full(item)
            | std::sync::mpsc::TrySendError::Disconnected(item) => item,
        })
    }

    /// Waits until all items are processed, but no longer than this.
    pub fn finish(self, within: Duration) {
        drop(self.queue);
        let running = self.running.into_inner();
        let _ = running
            .unwrap_or_else(PoisonError::into_inner)
            .recv_timeout(within);
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn a_thread_that_hangs_costs_items_and_no_time() {
        let (unblock, blocked) = channel::<()>();
        let background = Background::start("test", 2, move |items: Receiver<u32>| {
            for _ in items {
                let _ = blocked.recv();
            }
        });
        let background = background.unwrap();
        let pushed = (0..100).filter(|n| background.push(*n).is_ok()).count();
        assert!((2..=3).contains(&pushed), "{pushed}");
        background.finish(Duration::from_millis(1));
        drop(unblock);
    }

    #[test]
    fn finish_waits_until_all_items_are_done() {
        let (done, results) = channel();
        let background = Background::start("test", 8, move |items: Receiver<u32>| {
            for n in items {
                done.send(n * n).unwrap();
            }
        });
        let background = background.unwrap();
        for n in 0..4 {
            background.push(n).unwrap();
        }
        background.finish(Duration::from_secs(60));
        assert_eq!(results.try_iter().collect::<Vec<_>>(), [0, 1, 4, 9]);
    }
}
