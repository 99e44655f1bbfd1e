//! How a thread competes for the processor: the one that has the arm before all that can wait.
//!
//! Linux gives each thread a niceness of its own; elsewhere nothing changes. What the system does not allow, such as a
//! niceness below 0 without `LimitNICE` or `CAP_SYS_NICE`, is left as it is.

/// The thread that has the arm: late by 0.3 s, it has to assume that nobody watched the arm.
pub(crate) fn of_arm() {
    set(-10);
}

/// Threads that check jobs and read and write the journal. They give way to the arm, but not by far: the journal lets one
/// of them in at a time, and the arm waits for it between two windows of a job.
pub(crate) fn of_jobs() {
    set(5);
}

/// Threads that plan drawings and read files, for many seconds at times. The calling thread stays so.
pub(crate) fn of_planning() {
    set(10);
}

fn set(niceness: i32) {
    #[cfg(target_os = "linux")]
    let _ = rustix::process::setpriority_process(None, niceness);
    #[cfg(not(target_os = "linux"))]
    let _ = niceness;
}
