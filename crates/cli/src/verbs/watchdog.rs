//! `dobot watchdog`: a station starts it, nobody else.

use std::io::{IsTerminal, stdin};
use std::path::PathBuf;

use anyhow::anyhow;

use crate::failure::Failure;
use crate::interrupt::interrupt;

/// Guard an arm in case its station is killed or stands still: standard input is the heartbeat, standard output the port
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Where it leaves what it did
    #[arg(long, value_name = "FILE")]
    note: PathBuf,
}

/// Watches over the arm until the station says goodbye. Ctrl-C, and the request to end that a system
/// sends to all of a service's processes, are for the station: it says goodbye then.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    if stdin().is_terminal() {
        return Err(Failure::new(
            anyhow!(
                "standard input is a terminal; a watchdog is told by its station that it lives"
            ),
            "`dobot up` starts one for its arm",
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
