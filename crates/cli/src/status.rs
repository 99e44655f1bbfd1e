//! `dobot status`: what the arm tells, live.

use std::io::{IsTerminal, Write};

use dobot_wire::Status;

use crate::connect::{Reached, To};
use crate::control;
use crate::failure::Failure;
use crate::interrupt::interrupt;
use crate::output;

/// Show what the arm tells, live
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot status                                             through the running station
  dobot status --to serial:/dev/ttyUSB0
  dobot status --to tcp:localhost:5555 --json --count 10

Nothing is sent to the arm. A virtual arm in this process stands still, so one status of it is shown.")]
pub(crate) struct Args {
    #[command(flatten)]
    to: To,
    /// Print JSON, one object a line
    #[arg(long)]
    json: bool,
    /// Stop after so many statuses (a real arm sends 12.5 per second)
    #[arg(long, value_parser = clap::value_parser!(u64).range(1..))]
    count: Option<u64>,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let mut reached = args.to.reach("status").await?;
    let count = match (&reached, args.count) {
        (Reached::Arm(_), None) if args.to.is_virtual() => 1,
        (_, None) => u64::MAX,
        (_, Some(count)) => count,
    };
    let in_place = !args.json && args.count.is_none() && std::io::stdout().is_terminal();
    for _ in 0..count {
        let status = tokio::select! {
            status = next(&mut reached) => status?,
            () = interrupt() => break,
        };
        if in_place {
            print!("\r{}\x1b[K", output::status_text(&status));
            std::io::stdout().flush()?;
        } else {
            output::status(&status, args.json)?;
        }
    }
    if in_place {
        println!();
    }
    Ok(())
}

async fn next(reached: &mut Reached) -> Result<Status, Failure> {
    match reached {
        Reached::Station(station) => control::status(station).await,
        Reached::Arm(connected) => Ok(connected.arm.next_status().await?),
    }
}
