//! `dobot doctor`: checks this machine and prints a report.

mod checks;
mod machine;
mod report;

use std::path::PathBuf;

use anyhow::anyhow;

use self::report::Report;
use crate::failure::Failure;
use crate::output;
use crate::reach::folders;

/// Check this machine: ports, permissions, disk, station and more
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot doctor
  dobot doctor --json

No port is opened, so that no arm is reset. The report is meant for bug tickets:
it has no names, addresses, tokens or serial numbers; paths begin at ~ or DATA.
Exit code 1 if a check fails.")]
pub(crate) struct Args {
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Data folder of the station
    #[arg(long, value_name = "FOLDER")]
    data: Option<PathBuf>,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let folders = folders(args.data)?;
    let report = Report {
        machine: machine::description(),
        findings: checks::all(&folders).await,
    }
    .without_paths(&folders);
    if args.json {
        output::json(&report)?;
    } else {
        output::line(&report.to_string())?;
    }
    match report.failed() {
        0 => Ok(()),
        failed => Err(Failure::new(
            anyhow!("{} failed", output::count(failed, "check")),
            "do what stands below each `bad` line",
        )),
    }
}
