//! `dobot detect`: find out which dialect the arm speaks.

use dobot_station::{Reply, Request};

use crate::control::{self, request_at_rest, stop, take_control};
use crate::failure::Failure;
use crate::interrupt::interrupt;
use crate::output;
use crate::reach::Station;

/// Find out which dialect the arm of the station speaks, by small slow motions
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot detect
  dobot detect --json

The arm makes a few small motions: keep your hands off, and let nothing stand next to it. What it does where the
dialects disagree is shown, and the station remembers it for this arm. Ctrl-C stops the arm.")]
pub(crate) struct Args {
    #[command(flatten)]
    station: Station,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let mut station = args.station.connect("detect").await?;
    control::status(&mut station).await?;
    take_control(&mut station).await?;
    let reply = tokio::select! {
        reply = request_at_rest(&mut station, Request::Detect) => Some(reply?),
        () = interrupt() => None,
    };
    match reply {
        None => stop(&mut station).await,
        Some(Reply::Found { finding }) if !args.json => {
            for line in finding.lines() {
                output::line(&line)?;
            }
            Ok(output::line(&format!(
                "the arm speaks {}",
                finding.dialect
            ))?)
        }
        Some(reply) => Ok(output::json(&reply)?),
    }
}
