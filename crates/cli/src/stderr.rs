//! Standard error, written by its own thread, so that a blocked pipe or terminal blocks nothing else.

use std::backtrace::{Backtrace, BacktraceStatus};
use std::io::{self, Write};
use std::panic::PanicHookInfo;
use std::sync::LazyLock;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{SyncSender, sync_channel};
use std::time::Duration;

use dobot_host::Background;

enum Item {
    Bytes(Vec<u8>),
    Flush(SyncSender<()>),
}

static THREAD: LazyLock<Option<Background<Item>>> = LazyLock::new(|| {
    Background::start("stderr", CAPACITY, |items| {
        items.iter().for_each(write_item);
    })
    .ok()
});
/// The number of dropped lines.
static DROPPED: AtomicU64 = AtomicU64::new(0);

/// A writer for the log; each write is a line.
pub(crate) struct Lines;

impl Write for Lines {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        push(bytes.to_vec());
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Writes a line without blocking. If the queue is full, the line is dropped and counted.
pub(crate) fn line(text: &str) {
    push(format!("{text}\n").into_bytes());
}

/// Waits until all lines are written, for a limited time.
pub(crate) fn flush() {
    let (done, written) = sync_channel(1);
    if let Some(thread) = &*THREAD
        && thread.push(Item::Flush(done)).is_ok()
    {
        let _ = written.recv_timeout(PATIENCE);
    }
}

/// Writes the message of a panic without blocking its thread for long.
pub(crate) fn report_panic(panic: &PanicHookInfo<'_>) {
    let thread = std::thread::current();
    line(&format!(
        "thread '{}' {panic}",
        thread.name().unwrap_or("unnamed")
    ));
    let backtrace = Backtrace::capture();
    if backtrace.status() == BacktraceStatus::Captured {
        line(&backtrace.to_string());
    }
    flush();
}

fn push(bytes: Vec<u8>) {
    let pushed = THREAD
        .as_ref()
        .is_some_and(|thread| thread.push(Item::Bytes(bytes)).is_ok());
    if !pushed {
        DROPPED.fetch_add(1, Ordering::Relaxed);
    }
}

fn write_item(item: Item) {
    match item {
        Item::Bytes(bytes) => {
            // The reader may be gone.
            let _ = io::stderr().write_all(&bytes);
        }
        Item::Flush(done) => drop(done.send(())),
    }
    let dropped = DROPPED.swap(0, Ordering::Relaxed);
    if dropped > 0 {
        let _ = writeln!(
            io::stderr(),
            "{} dropped, because standard error was not read",
            crate::output::many(dropped, "line was", "lines were")
        );
    }
}

/// The maximum number of waiting lines.
const CAPACITY: usize = 1024;
const PATIENCE: Duration = Duration::from_millis(500);
