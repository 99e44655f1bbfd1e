//! Standard error, written by a thread of its own: a pipe that nobody reads, or a stopped terminal, holds up nothing else.

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
/// Lines that found no room.
static DROPPED: AtomicU64 = AtomicU64::new(0);

/// A writer for a log: each write is a line.
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

/// Writes a line, without waiting. A line that finds no room is dropped and counted.
pub(crate) fn line(text: &str) {
    push(format!("{text}\n").into_bytes());
}

/// Waits until all lines are written, but not for a reader that does not read.
pub(crate) fn flush() {
    let (done, written) = sync_channel(1);
    if let Some(thread) = &*THREAD
        && thread.push(Item::Flush(done)).is_ok()
    {
        let _ = written.recv_timeout(PATIENCE);
    }
}

/// Writes the message of a panic, without holding up the thread that panicked for long.
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
        .is_some_and(|it| it.push(Item::Bytes(bytes)).is_ok());
    if !pushed {
        DROPPED.fetch_add(1, Ordering::Relaxed);
    }
}

fn write_item(item: Item) {
    match item {
        Item::Bytes(bytes) => {
            // Nobody may read any more.
            let _ = io::stderr().write_all(&bytes);
        }
        Item::Flush(done) => drop(done.send(())),
    }
    let dropped = DROPPED.swap(0, Ordering::Relaxed);
    if dropped > 0 {
        let _ = writeln!(
            io::stderr(),
            "{dropped} lines were dropped: nobody read standard error"
        );
    }
}

/// Lines that wait to be written, at most.
const CAPACITY: usize = 1024;
const PATIENCE: Duration = Duration::from_millis(500);
