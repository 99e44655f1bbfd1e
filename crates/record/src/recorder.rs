//! The recorder: a thread that writes, and the handle that never waits for it.

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

/// Records what it is given, in a thread of its own: its caller never waits, and never fails.
///
/// Records are handed to the file about once a second, and to the disk every five seconds: so much is
/// lost when the program is killed or the power fails, and up to ten seconds of a status that repeats.
/// A file that was left unfinished is repaired at the next start. When a file cannot be written, as on
/// a full disk, [`Recorder::health`] says why, and another one is tried ten seconds later. Lost records
/// are counted, and the next file says how many they were.
///
/// Dropped, it ends its file in order.
#[derive(Debug)]
pub struct Recorder {
    queue: SyncSender<(Duration, Record)>,
    shared: Arc<Shared>,
    /// Gone when the thread is to end.
    end: Option<Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

/// How a recorder does.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Health {
    /// The file that is written; `None` before the first record and while there is trouble.
    pub file: Option<PathBuf>,
    /// Why nothing can be recorded now; it is tried again.
    pub trouble: Option<String>,
    /// Records that were lost since the start, for whatever reason.
    pub lost: u64,
    /// Files of before that broke off and were repaired since the start: they end in order now, and
    /// tell at their end what could not be read.
    pub repaired: u64,
    /// Files of before that broke off and were left as they are: they hold nothing readable, or cannot
    /// be written anew.
    pub left: u64,
}

/// What handle and thread both know.
#[derive(Debug, Default)]
struct Shared {
    /// About how many bytes wait to be written.
    waiting: AtomicUsize,
    /// Records that found no room.
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

    /// Records something that happened so long after the start; never waits. A record that finds no
    /// room in the queue, or is longer than 128 KiB, is counted as lost.
    pub fn record(&self, at: Duration, record: Record) {
        let size = record.size(LONGEST);
        let waiting = self.shared.waiting.fetch_add(size, Ordering::Relaxed);
        let fits = size <= LONGEST && waiting + size <= MOST_WAITING;
        if !fits || self.queue.try_send((at, record)).is_err() {
            self.shared.waiting.fetch_sub(size, Ordering::Relaxed);
            self.shared.crowded_out.fetch_add(1, Ordering::Relaxed);
        }
    }

    /// How it does.
    #[must_use]
    pub fn health(&self) -> Health {
        let health = self.shared.health.lock();
        health.unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Writes all that was recorded, and ends the file in order.
    #[must_use]
    pub fn finish(mut self) -> Health {
        self.end();
        self.health()
    }

    fn end(&mut self) {
        self.end = None;
        if let Some(thread) = self.thread.take() {
            // A thread that panicked has said so already.
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
    /// Looks after the queue now and then instead of being woken for each record: a wake-up would
    /// cost the caller more than all the rest.
    fn run(mut self) {
        let (mut idle, mut wait) = (Duration::ZERO, PERIOD);
        loop {
            let ended = self.ended.recv_timeout(wait) != Err(RecvTimeoutError::Timeout);
            let count = self.write_down();
            let repairs = !ended && self.repairs.step();
            // Behind a full round there may be more.
            wait = if count < QUEUE_LEN && !repairs {
                PERIOD
            } else {
                Duration::ZERO
            };
            idle = if count == 0 {
                idle + wait
            } else {
                Duration::ZERO
            };
            if idle >= IDLE {
                self.rotation.handle_idle();
            }
            let is_over = ended && count < QUEUE_LEN;
            if is_over {
                self.rotation.finish();
            }
            self.shared.set_health(Health {
                repaired: self.repairs.repaired(),
                left: self.repairs.left(),
                ..self.rotation.health()
            });
            if is_over {
                return;
            }
        }
    }

    /// Writes what waits, one round of it; says how many records that were.
    fn write_down(&mut self) -> usize {
        let mut count = 0;
        while count < QUEUE_LEN
            && let Ok((at, record)) = self.records.try_recv()
        {
            let size = record.size(LONGEST);
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

/// How often the queue is looked after.
const PERIOD: Duration = Duration::from_millis(100);

/// After that much silence what is not flushed is.
const IDLE: Duration = Duration::from_secs(1);

/// Some tens of thousands a second can be recorded.
const QUEUE_LEN: usize = 4096;

/// So many bytes may wait to be written ...
const MOST_WAITING: usize = 8 << 20;

/// ... and so many may belong to one record.
const LONGEST: usize = 128 << 10;

const CROWDED: &str = "more came than could be written, or a record was longer than 128 KiB";
