//! A queue from the worker thread to a waiting call.

use std::collections::VecDeque;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// Messages that were sent and not received yet.
pub(crate) struct Mailbox<T> {
    inner: Mutex<Inner<T>>,
    changed: Condvar,
}

struct Inner<T> {
    messages: VecDeque<T>,
    /// The number of messages sent.
    count: u64,
    closed: bool,
    wake: Option<Box<dyn FnOnce() + Send>>,
}

/// The result of reading a mailbox.
pub(crate) enum Received<T> {
    Message(T),
    Nothing,
    /// There are no more messages.
    Closed,
}

/// The sending half; there are no more messages after it is dropped.
pub(crate) struct Sender<T>(Arc<Mailbox<T>>);

impl<T> Mailbox<T> {
    pub(crate) fn new() -> (Sender<T>, Arc<Self>) {
        let mailbox = Arc::new(Self {
            inner: Mutex::new(Inner {
                messages: VecDeque::new(),
                count: 0,
                closed: false,
                wake: None,
            }),
            changed: Condvar::new(),
        });
        (Sender(Arc::clone(&mailbox)), mailbox)
    }

    /// Returns the first message, within a timeout.
    pub(crate) fn receive(&self, time: Duration) -> Received<T> {
        let waiting = |queue: &mut Inner<T>| queue.messages.is_empty() && !queue.closed;
        let waited = self.changed.wait_timeout_while(self.lock(), time, waiting);
        let mut inner = waited.unwrap_or_else(PoisonError::into_inner).0;
        match inner.messages.pop_front() {
            Some(message) => Received::Message(message),
            None if inner.closed => Received::Closed,
            None => Received::Nothing,
        }
    }

    /// Calls this once when there is a message, or there are no more messages.
    pub(crate) fn when_ready(&self, wake: Box<dyn FnOnce() + Send>) {
        let mut inner = self.lock();
        if inner.messages.is_empty() && !inner.closed {
            inner.wake = Some(wake);
            return;
        }
        drop(inner);
        wake();
    }

    /// Returns the number of messages sent, including those received.
    pub(crate) fn count(&self) -> u64 {
        self.lock().count
    }

    pub(crate) fn len(&self) -> usize {
        self.lock().messages.len()
    }

    fn lock(&self) -> MutexGuard<'_, Inner<T>> {
        self.inner.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn change(&self, change: impl FnOnce(&mut Inner<T>)) {
        let mut inner = self.lock();
        change(&mut inner);
        let wake = inner.wake.take();
        drop(inner);
        self.changed.notify_all();
        if let Some(wake) = wake {
            wake();
        }
    }
}

impl<T> Sender<T> {
    pub(crate) fn send(&self, message: T) {
        self.0.change(|inner| {
            inner.messages.push_back(message);
            inner.count += 1;
        });
    }

    /// Returns the number of messages that were not received yet.
    pub(crate) fn unread(&self) -> usize {
        self.0.len()
    }

    /// Whether there is no receiver left.
    pub(crate) fn has_no_receiver(&self) -> bool {
        Arc::strong_count(&self.0) == 1
    }
}

impl<T> Drop for Sender<T> {
    fn drop(&mut self) {
        self.0.change(|inner| inner.closed = true);
    }
}
