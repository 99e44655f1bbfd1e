//! `dobot status`: shows the arm's pose and state, live.

use std::io::{IsTerminal, Write};

use dobot_host::StationClient;

use crate::connect::To;
use crate::control;
use crate::failure::Failure;
use crate::interrupt::interrupt;
use crate::{output, values};

/// Show the arm's pose and state, live
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot status                            the arm of the running station
  dobot status --to serial:/dev/ttyUSB0
  dobot status --json --count 10          ten statuses as JSON

Nothing is sent to the arm except a command that switches its laser off. Of a
virtual arm in this process, one status is shown: it does not move.")]
pub(crate) struct Args {
    #[command(flatten)]
    to: To,
    /// Print JSON, one object per line
    #[arg(long)]
    json: bool,
    /// Number of statuses to show (default: until Ctrl-C); a real arm sends 12.5 per second
    #[arg(long, value_name = "N", value_parser = values::whole_from(1))]
    count: Option<u64>,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let Args { to, json, count } = args;
    to.with_arm("status", async |station| show(station, json, count).await)
        .await
}

async fn show(station: &mut StationClient, json: bool, count: Option<u64>) -> Result<(), Failure> {
    let still = station.virtual_arm().is_some();
    let in_place = !json && count.is_none() && std::io::stdout().is_terminal();
    for _ in 0..count.unwrap_or(if still { 1 } else { u64::MAX }) {
        let status = tokio::select! {
            status = control::status(station) => status?,
            () = interrupt() => break,
        };
        if in_place {
            print!("\r{}\x1b[K", output::status_text(&status));
            std::io::stdout().flush()?;
        } else {
            output::status(&status, json)?;
        }
    }
    if in_place {
        println!();
    }
    Ok(())
}
