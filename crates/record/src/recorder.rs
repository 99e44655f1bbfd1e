//! The recorder: a writing thread and a handle that never blocks.

use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, SyncSender, channel, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use jiff::Timestamp;

use crate::encoder::Encoder;
use crate::repairs::Repairs;
use crate::rotation::Rotation;
use crate::{About, Limits, Record, StartError};

/// A recorder with its own thread: its caller never waits and never fails.
///
/// Records are written to the file about once a second and synced to the disk every five seconds: a
/// killed program or a power failure loses that much, and up to ten seconds of a repeated status.
/// Unfinished files are repaired at the next start. If a file cannot be written, for example on a
/// full disk, [`Recorder::health`] gives the reason, and another one is tried ten seconds later.
/// Lost records are counted, and the next file contains their number.
///
/// Dropping it finishes its file.
#[derive(Debug)]
pub struct Recorder {
    queue: SyncSender<(Duration, Record)>,
    shared: Arc<Shared>,
    /// Dropped to end the thread.
    end: Option<Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

/// The health of a recorder.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Health {
    /// The current file; `None` before the first record and during an error.
    pub file: Option<PathBuf>,
    /// The reason why nothing can be recorded now; the recorder keeps trying.
    pub trouble: Option<String>,
    /// The number of records lost since the start, for any reason.
    pub lost: u64,
    /// The number of earlier truncated files repaired since the start: they are finished now and
    /// contain a note about the unreadable part.
    pub repaired: u64,
    /// The number of earlier truncated files left unchanged: they contain nothing readable, or
    /// cannot be rewritten.
    pub left: u64,
}

/// The state shared by handle and thread.
#[derive(Debug, Default)]
struct Shared {
    /// The approximate number of bytes in the queue.
    waiting: AtomicUsize,
    /// The number of records dropped because the queue was full.
    crowded_out: AtomicU64,
    health: Mutex<Health>,
}

impl Recorder {
    /// Starts a recorder of files in `folder`; the times of its records count from `start`.
    ///
    /// # Errors
    ///
    /// [`StartError`]; a folder that cannot be written is not an error but a matter of
    /// [`Recorder::health`].
    pub fn start(
        folder: impl Into<PathBuf>,
        limits: Limits,
        about: About,
        start: Timestamp,
    ) -> Result<Self, StartError> {
        limits.check()?;
        let encoder = Encoder::new(start).ok_or(StartError::Clock(start))?;
        let folder = folder.into();
        let repairs = Repairs::new(folder.clone(), limits);
        let rotation = Rotation::new(folder, limits, start, about, encoder);
        let shared = Arc::new(Shared::default());
        shared.set_health(rotation.health());
        let (queue, records) = sync_channel(QUEUE_LEN);
        let (end, ended) = channel();
        let worker = Worker {
            rotation,
            repairs,
            records,
            ended,
            shared: Arc::clone(&shared),
        };
        let thread = thread::Builder::new()
            .name("recorder".to_owned())
            .spawn(move || worker.run())
            .map_err(StartError::Thread)?;
        Ok(Self {
            queue,
            shared,
            end: Some(end),
            thread: Some(thread),
        })
    }

    /// Records an event at a time since the start; never waits. A record that does not fit into the
    /// queue, or is longer than 128 KiB, is counted as lost.
    pub fn record(&self, at: Duration, record: Record) {
        let size = record.size(MAX_LEN);
        let waiting = self.shared.waiting.fetch_add(size, Ordering::Relaxed);
        let fits = size <= MAX_LEN && waiting + size <= MAX_WAITING;
        if !fits || self.queue.try_send((at, record)).is_err() {
            self.shared.waiting.fetch_sub(size, Ordering::Relaxed);
            self.shared.crowded_out.fetch_add(1, Ordering::Relaxed);
        }
    }

    /// Returns the health.
    #[must_use]
    pub fn health(&self) -> Health {
        let health = self.shared.health.lock();
        health.unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Writes all records and finishes the file.
    #[must_use]
    pub fn finish(mut self) -> Health {
        self.end();
        self.health()
    }

    fn end(&mut self) {
        self.end = None;
        if let Some(thread) = self.thread.take() {
            // A thread that panicked has already reported it.
            let _ = thread.join();
        }
    }
}

impl Drop for Recorder {
    fn drop(&mut self) {
        self.end();
    }
}

impl Shared {
    fn set_health(&self, health: Health) {
        *self.health.lock().unwrap_or_else(PoisonError::into_inner) = health;
    }
}

/// The thread's side.
struct Worker {
    rotation: Rotation,
    repairs: Repairs,
    records: Receiver<(Duration, Record)>,
    ended: Receiver<()>,
    shared: Arc<Shared>,
}

impl Worker {
    /// Polls the queue instead of being woken for each record: a wake-up would cost the caller more
    /// than everything else.
    fn run(mut self) {
        let (mut idle, mut wait) = (Duration::ZERO, PERIOD);
        loop {
            let ended = self.ended.recv_timeout(wait) != Err(RecvTimeoutError::Timeout);
            let count = self.write_down();
            let repairs = !ended && self.repairs.step();
            // After a full round there may be more.
            let is_busy = count >= QUEUE_LEN || repairs;
            wait = if is_busy { Duration::ZERO } else { PERIOD };
            idle += wait;
            if count > 0 {
                idle = Duration::ZERO;
            }
            if idle >= IDLE {
                self.rotation.handle_idle();
            }
            let is_over = ended && count < QUEUE_LEN;
            if is_over {
                self.rotation.finish();
            }
            self.report_health();
            if is_over {
                return;
            }
        }
    }

    fn report_health(&self) {
        self.shared.set_health(Health {
            repaired: self.repairs.repaired(),
            left: self.repairs.left(),
            ..self.rotation.health()
        });
    }

    /// Writes one round of queued records; returns their number.
    fn write_down(&mut self) -> usize {
        let mut count = 0;
        while count < QUEUE_LEN
            && let Ok((at, record)) = self.records.try_recv()
        {
            let size = record.size(MAX_LEN);
            self.shared.waiting.fetch_sub(size, Ordering::Relaxed);
            self.note_crowded_out();
            self.rotation.handle_record(at, &record);
            count += 1;
        }
        self.note_crowded_out();
        count
    }

    fn note_crowded_out(&mut self) {
        let lost = self.shared.crowded_out.swap(0, Ordering::Relaxed);
        self.rotation.handle_lost(lost, CROWDED);
    }
}

/// The polling interval of the queue.
const PERIOD: Duration = Duration::from_millis(100);

/// Unflushed data is flushed after this much silence.
const IDLE: Duration = Duration::from_secs(1);

/// This allows some tens of thousands of records a second.
const QUEUE_LEN: usize = 4096;

/// The largest number of queued bytes ...
const MAX_WAITING: usize = 8 << 20;

/// ... and of bytes per record.
const MAX_LEN: usize = 128 << 10;

const CROWDED: &str =
    "records arrived faster than they could be written, or a record was longer than 128 KiB";
