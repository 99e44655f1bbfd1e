//! The program as a process, where a clock decides: in real time, few tests at a time.

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
use std::sync::{Condvar, Mutex, PoisonError};

/// What each test here holds for as long as it runs, so that few use the computer at once: cargo runs one test program after the
/// other.
#[cfg(unix)]
struct Turn;

/// They wait most of the time: together these use half a core.
#[cfg(unix)]
const AT_ONCE: usize = 3;
#[cfg(unix)]
static RUNNING: Mutex<usize> = Mutex::new(0);
#[cfg(unix)]
static ENDED: Condvar = Condvar::new();

#[cfg(unix)]
impl Turn {
    fn wait() -> Self {
        let running = RUNNING.lock().unwrap_or_else(PoisonError::into_inner);
        let running = ENDED.wait_while(running, |running| *running == AT_ONCE);
        *running.unwrap_or_else(PoisonError::into_inner) += 1;
        Self
    }
}

#[cfg(unix)]
impl Drop for Turn {
    fn drop(&mut self) {
        *RUNNING.lock().unwrap_or_else(PoisonError::into_inner) -= 1;
        ENDED.notify_one();
    }
}
