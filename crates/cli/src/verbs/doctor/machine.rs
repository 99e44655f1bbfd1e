//! Program, system and processor in one line.

use std::env::consts::{ARCH, OS};
use std::fs;

/// The program with its features, the system and the processor.
pub(super) fn description() -> String {
    let features = match (cfg!(feature = "full"), cfg!(feature = "fleet")) {
        (_, true) => "full, fleet",
        (true, false) => "full",
        (false, false) => "default features",
    };
    let system = distribution().unwrap_or_else(|| OS.to_owned());
    format!(
        "dobot {} ({features}) on {system}, {ARCH}{}",
        env!("CARGO_PKG_VERSION"),
        kernel()
    )
}

/// The name of a Linux distribution.
fn distribution() -> Option<String> {
    let text = fs::read_to_string("/etc/os-release").ok()?;
    pretty_name(&text)
}

fn pretty_name(os_release: &str) -> Option<String> {
    let mut values = os_release
        .lines()
        .filter_map(|line| line.strip_prefix("PRETTY_NAME="));
    values.next().map(|name| name.trim_matches('"').to_owned())
}

/// The version of Linux.
fn kernel() -> String {
    let release = fs::read_to_string("/proc/sys/kernel/osrelease");
    release.map_or_else(
        |_| String::new(),
        |release| format!(", kernel {}", release.trim()),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_name_of_a_distribution_is_read_without_quotes() {
        let text = "ID=debian\nPRETTY_NAME=\"Debian GNU/Linux 12 (bookworm)\"\n";
        assert_eq!(
            pretty_name(text).as_deref(),
            Some("Debian GNU/Linux 12 (bookworm)")
        );
        assert_eq!(pretty_name("ID=x\n"), None);
    }
}
