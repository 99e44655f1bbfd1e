//! The program as a process, where a clock decides: in real time, one test at a time.

#[cfg(unix)]
mod blocked;
#[cfg(unix)]
mod guarding;
#[cfg(target_os = "linux")]
mod holding;
#[cfg(unix)]
mod interrupting;
#[cfg(unix)]
#[path = "../support/mod.rs"]
mod support;

#[cfg(unix)]
use std::sync::{Mutex, MutexGuard, PoisonError};

/// What each test here holds for as long as it runs: cargo runs one test program after the other.
#[cfg(unix)]
fn alone() -> MutexGuard<'static, ()> {
    static ALONE: Mutex<()> = Mutex::new(());
    ALONE.lock().unwrap_or_else(PoisonError::into_inner)
}
