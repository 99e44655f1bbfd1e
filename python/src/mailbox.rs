//! What the worker tells a waiting call, from one thread to the other.

use std::collections::VecDeque;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// What was told and not taken yet.
pub(crate) struct Mailbox<T> {
    inner: Mutex<Inner<T>>,
    came: Condvar,
}

struct Inner<T> {
    told: VecDeque<T>,
    /// How much was told in all.
    count: u64,
    closed: bool,
    wake: Option<Box<dyn FnOnce() + Send>>,
}

/// What is found in a mailbox.
pub(crate) enum Taken<T> {
    It(T),
    Nothing,
    /// Nothing more will come.
    Closed,
}

/// The end that tells; nothing more comes when it is dropped.
pub(crate) struct Teller<T>(Arc<Mailbox<T>>);

impl<T> Mailbox<T> {
    pub(crate) fn new() -> (Teller<T>, Arc<Self>) {
        let mailbox = Arc::new(Self {
            inner: Mutex::new(Inner {
                told: VecDeque::new(),
                count: 0,
                closed: false,
                wake: None,
            }),
            came: Condvar::new(),
        });
        (Teller(Arc::clone(&mailbox)), mailbox)
    }

    /// What came first, waited for at most so long.
    pub(crate) fn take(&self, time: Duration) -> Taken<T> {
        let waiting = |queue: &mut Inner<T>| queue.told.is_empty() && !queue.closed;
        let waited = self.came.wait_timeout_while(self.lock(), time, waiting);
        let mut inner = waited.unwrap_or_else(PoisonError::into_inner).0;
        match inner.told.pop_front() {
            Some(it) => Taken::It(it),
            None if inner.closed => Taken::Closed,
            None => Taken::Nothing,
        }
    }

    /// Calls this once when there is something to take, or nothing more comes.
    pub(crate) fn when_told(&self, wake: Box<dyn FnOnce() + Send>) {
        let mut inner = self.lock();
        if inner.told.is_empty() && !inner.closed {
            inner.wake = Some(wake);
            return;
        }
        drop(inner);
        wake();
    }

    /// How much was told in all, also what was taken already.
    pub(crate) fn count(&self) -> u64 {
        self.lock().count
    }

    pub(crate) fn len(&self) -> usize {
        self.lock().told.len()
    }

    fn lock(&self) -> MutexGuard<'_, Inner<T>> {
        self.inner.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn change(&self, change: impl FnOnce(&mut Inner<T>)) {
        let mut inner = self.lock();
        change(&mut inner);
        let wake = inner.wake.take();
        drop(inner);
        self.came.notify_all();
        if let Some(wake) = wake {
            wake();
        }
    }
}

impl<T> Teller<T> {
    pub(crate) fn tell(&self, it: T) {
        self.0.change(|inner| {
            inner.told.push_back(it);
            inner.count += 1;
        });
    }

    /// How much was told and not taken yet.
    pub(crate) fn untaken(&self) -> usize {
        self.0.len()
    }

    /// Whether nobody is left who could take anything.
    pub(crate) fn is_alone(&self) -> bool {
        Arc::strong_count(&self.0) == 1
    }
}

impl<T> Drop for Teller<T> {
    fn drop(&mut self) {
        self.0.change(|inner| inner.closed = true);
    }
}
