//! `dobot stop`: stops the arm, or clears a stop.

use anyhow::anyhow;
use dobot_api::{Reply, Request};

use crate::failure::Failure;
use crate::output;
use crate::reach::Station;

/// Stop the arm, with or without control, or clear a stop
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot stop
  dobot stop --reason \"the pen is broken\"
  dobot stop --reset                        clear the stop after looking at the arm

The laser goes off first, and nothing more is sent. The arm may have to finish
its current motion: the protocol has no stop command. The stop stays set until
it is cleared.")]
pub(crate) struct Args {
    /// Reason, shown to others who find the arm stopped
    #[arg(long, value_name = "TEXT")]
    reason: Option<String>,
    /// Clear the stop; a person must have looked at the arm
    #[arg(long, conflicts_with = "reason")]
    reset: bool,
    #[command(flatten)]
    station: Station,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let station = args.station.client("stop").await;
    let mut station = if args.reset {
        station?
    } else {
        station.map_err(with_emergency_hint)?
    };
    if args.reset {
        station.request_at_rest(Request::ResetStop).await?;
        return Ok(output::line("the arm may move again")?);
    }
    let reason = args.reason;
    let reply = station.request(Request::Stop { reason }).await?;
    Ok(output::line(&stopped(&reply)?)?)
}

/// Describes how the arm stops.
fn stopped(reply: &Reply) -> Result<String, Failure> {
    Ok(match reply {
        Reply::Stopping {
            delivered: false, ..
        } => {
            return Err(Failure::new(
                anyhow!("no link to the arm: the stop was NOT DELIVERED"),
                "switch the arm off by hand; the stop is sent when the link is back",
            ));
        }
        Reply::Stopping { rests_within_s, .. } => {
            format!("the arm is stopped; it comes to rest within {rests_within_s:.2} s")
        }
        _ => "the arm is stopped".to_owned(),
    })
}

/// Points to the arm's own switch: a station that is not reached stops nothing.
fn with_emergency_hint(failure: Failure) -> Failure {
    let hint = "if the arm moves, switch it off by hand";
    let hint = match failure.hint() {
        Some(other) => format!("{hint}; {other}"),
        None => hint.to_owned(),
    };
    failure.with_hint(hint)
}
