//! `dobot watchdog`: started only by a station.

use std::io::{IsTerminal, stdin};
use std::path::PathBuf;

use anyhow::anyhow;

use crate::failure::Failure;
use crate::interrupt::interrupt;

/// Guard the arm in case its station is killed or hangs
///
/// Started by a station. Standard input is the heartbeat, standard output the port.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// File for its report
    #[arg(long, value_name = "FILE")]
    note: PathBuf,
}

/// Guards the arm until the station ends properly. Ignores Ctrl-C and the termination signal that the
/// system sends to all processes of a service: the station handles them and then ends the watchdog.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    if stdin().is_terminal() {
        return Err(Failure::new(
            anyhow!("standard input is a terminal; expected the heartbeat of a station"),
            "run `dobot up`, which starts a watchdog for its arm",
        ));
    }
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build()?;
    let _context = runtime.enter();
    let _stays = interrupt();
    dobot_host::guard(&args.note)?;
    Ok(())
}
