//! The cost of a process on Linux.

use std::error::Error;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use super::times::cpu_time;

/// The resources of a process.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Usage {
    /// Its memory, in KiB.
    memory: u32,
    threads: u32,
    /// Its open files and sockets.
    files: u32,
    processor: Duration,
}

/// The cost of an idle process.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Costs {
    usage: Usage,
    /// Its share of one core.
    share: f64,
}

impl Usage {
    /// Returns the current resources of a process.
    pub(crate) fn now(pid: u32) -> Result<Self, Box<dyn Error + Send + Sync>> {
        let folder = PathBuf::from(format!("/proc/{pid}"));
        let status = std::fs::read_to_string(folder.join("status"))
            .map_err(|error| format!("cannot read {} (Linux only): {error}", folder.display()))?;
        let field = |name: &str| {
            let line = status.lines().find_map(|line| line.strip_prefix(name));
            let number = line.and_then(|line| line.split_whitespace().next());
            number
                .and_then(|digits| digits.parse::<u32>().ok())
                .ok_or(format!("no {name} in {status}"))
        };
        Ok(Self {
            memory: field("VmRSS:")?,
            threads: field("Threads:")?,
            files: std::fs::read_dir(folder.join("fd"))?.count().try_into()?,
            processor: cpu_time(pid),
        })
    }
}

impl Costs {
    /// Observes a process for a while.
    pub(crate) async fn at_rest(
        pid: u32,
        rest: Duration,
    ) -> Result<Self, Box<dyn Error + Send + Sync>> {
        let (before, began) = (Usage::now(pid)?, Instant::now());
        tokio::time::sleep(rest).await;
        let (usage, took) = (Usage::now(pid)?, began.elapsed());
        let used = usage.processor.saturating_sub(before.processor);
        Ok(Self {
            usage,
            share: used.as_secs_f64() / took.as_secs_f64(),
        })
    }

    /// Prints the cost of each station, above that of the process before.
    pub(crate) fn print_each(&self, what: &str, before: &Usage, stations: u16) {
        let each = f64::from(stations);
        println!(
            "{what}: {:.2} % of a core, {:.2} MB, {:.1} threads, {:.1} files",
            100.0 * self.share / each,
            megabytes(self.usage.memory.saturating_sub(before.memory)) / each,
            f64::from(self.usage.threads - before.threads) / each,
            f64::from(self.usage.files - before.files) / each,
        );
    }

    /// Prints how much more each station costs than before.
    pub(crate) fn print_more(&self, what: &str, before: &Self, stations: u16) {
        let each = f64::from(stations);
        println!(
            "{what}: {:+.2} % of a core, {:+.2} MB",
            100.0 * (self.share - before.share) / each,
            (megabytes(self.usage.memory) - megabytes(before.usage.memory)) / each,
        );
    }

    /// Prints the cost of a process.
    pub(crate) fn print(&self, what: &str) {
        println!(
            "{what}: {:.1} % of a core, {:.1} MB, {} threads, {} files",
            100.0 * self.share,
            megabytes(self.usage.memory),
            self.usage.threads,
            self.usage.files
        );
    }
}

fn megabytes(kibibytes: u32) -> f64 {
    f64::from(kibibytes) * 1024.0 / 1e6
}
