//! Statistics of measured times.

use std::time::Duration;

/// Measured times, in ascending order.
#[derive(Clone, Debug)]
pub(crate) struct Times(Vec<Duration>);

impl Times {
    pub(crate) fn new(mut times: Vec<Duration>) -> Self {
        assert!(!times.is_empty(), "something was measured");
        times.sort_unstable();
        Self(times)
    }

    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    /// Returns the percentile of the times.
    pub(crate) fn percentile(&self, percent: usize) -> Duration {
        self.0[((self.0.len() * percent).div_ceil(100)).max(1) - 1]
    }

    pub(crate) fn median(&self) -> Duration {
        self.percentile(50)
    }

    pub(crate) fn p99(&self) -> Duration {
        self.percentile(99)
    }

    /// Prints a line of statistics.
    pub(crate) fn print(&self, what: &str) {
        println!(
            "{what:42} median {:>9.1?}  p90 {:>9.1?}  p99 {:>9.1?}  longest {:>9.1?}  of {}",
            self.median(),
            self.percentile(90),
            self.p99(),
            self.percentile(100),
            self.len()
        );
    }
}

/// Returns the CPU time of all threads of a process.
pub(crate) fn cpu_time(pid: u32) -> Duration {
    let threads = std::fs::read_dir(format!("/proc/{pid}/task"));
    let threads = threads.expect("the system lists its threads");
    let ns = threads.flatten().filter_map(|thread| {
        let text = std::fs::read_to_string(thread.path().join("schedstat")).ok()?;
        text.split_whitespace().next()?.parse::<u64>().ok()
    });
    Duration::from_nanos(ns.sum())
}

/// Returns the load of the machine in the last minute.
pub(crate) fn load() -> String {
    let load = std::fs::read_to_string("/proc/loadavg").unwrap_or_default();
    let minute = load.split_whitespace().next().unwrap_or("unknown");
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    format!("load of the last minute {minute}, {cores} cores")
}
