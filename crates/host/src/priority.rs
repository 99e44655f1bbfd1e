//! Thread priorities: the arm thread comes before everything that can wait.
//!
//! Linux has a nice value per thread; elsewhere nothing changes. What the system does not permit,
//! such as a negative nice value without `LimitNICE` or `CAP_SYS_NICE`, is left unchanged.

/// The arm thread: if it is 0.3 s late, it has to assume that the arm was unattended.
pub(crate) fn of_arm() {
    set(-10);
}

/// Threads that check jobs and access the journal. They yield to the arm, but only slightly: the
/// journal admits one of them at a time, and the arm waits for it between two windows of a job.
pub(crate) fn of_jobs() {
    set(5);
}

/// Threads that plan drawings and read files, sometimes for many seconds. The calling thread keeps
/// this priority.
pub(crate) fn of_planning() {
    set(10);
}

fn set(niceness: i32) {
    #[cfg(target_os = "linux")]
    let _ = rustix::process::setpriority_process(None, niceness);
    #[cfg(not(target_os = "linux"))]
    let _ = niceness;
}
