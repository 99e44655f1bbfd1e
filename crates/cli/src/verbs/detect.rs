//! `dobot detect`: detects the dialect of the arm.

use dobot_api::{Reply, Request};
use dobot_host::StationClient;

use crate::connect::To;
use crate::control::{self, check_pose, stop, take_control};
use crate::failure::Failure;
use crate::interrupt::interrupt;
use crate::output;

/// Detect the arm's protocol dialect by small, slow motions
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot detect
  dobot detect --to serial:/dev/ttyUSB0
  dobot detect --json

The arm makes a few small motions: keep hands and objects away. The result is
printed and remembered for this arm. Ctrl-C stops the arm.")]
pub(crate) struct Args {
    #[command(flatten)]
    to: To,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let detect = async |station: &mut StationClient| detect(station, &args).await;
    args.to.with_lasting_arm("detect", detect).await
}

async fn detect(station: &mut StationClient, args: &Args) -> Result<(), Failure> {
    check_pose(station, args.to.pose_confirmed).await?;
    control::status(station).await?;
    take_control(station).await?;
    let reply = tokio::select! {
        reply = station.request_at_rest(Request::Detect) => Some(reply?),
        () = interrupt() => None,
    };
    match reply {
        None => stop(station).await,
        Some(Reply::Found { finding }) if !args.json => {
            for line in finding.lines() {
                output::line(&line)?;
            }
            Ok(output::line(&format!(
                "the dialect of the arm is {}",
                finding.dialect
            ))?)
        }
        Some(reply) => Ok(output::json(&reply)?),
    }
}
