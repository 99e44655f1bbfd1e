//! `dobot stop`: stop the arm, or let it move again.

use anyhow::anyhow;
use dobot_api::{Reply, Request};

use crate::failure::Failure;
use crate::output;
use crate::reach::Station;

/// Stop the arm, from anywhere, whoever has control; or let it move again
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot stop
  dobot stop --reason \"the pen is broken\"
  dobot stop --reset                      a person has looked: it may move again

The laser goes off first, and nothing more is sent. What the arm is at it may have to finish: the
protocol has no stop of its own. It stays stopped until somebody resets that.")]
pub(crate) struct Args {
    /// Why, for those who find the arm stopped
    #[arg(long, value_name = "TEXT")]
    reason: Option<String>,
    /// Let the arm move again after a stop: a person has looked at it
    #[arg(long, conflicts_with = "reason")]
    reset: bool,
    #[command(flatten)]
    station: Station,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let mut station = args.station.client("stop").await?;
    if args.reset {
        station.request_at_rest(Request::ResetStop).await?;
        return Ok(output::line("the arm may move again")?);
    }
    let reason = args.reason;
    let reply = station.request(Request::Stop { reason }).await?;
    let text = match reply {
        Reply::Stopping {
            delivered: false, ..
        } => {
            return Err(Failure::new(
                anyhow!("no link to the arm: the stop was NOT DELIVERED"),
                "switch the arm off by hand; the stop is sent as soon as the link is back",
            ));
        }
        Reply::Stopping { rests_within_s, .. } => {
            format!("the arm is stopped; it rests within {rests_within_s:.2} s")
        }
        _ => "the arm is stopped".to_owned(),
    };
    Ok(output::line(&text)?)
}
