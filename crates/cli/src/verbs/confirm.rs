//! `dobot confirm`: the arm stands where it says.

use crate::control::{self, check_pose};
use crate::failure::Failure;
use crate::output;
use crate::reach::Station;

/// Confirm that the arm stands where its statuses say, after a reset
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot confirm            shows where the arm says that it stands, and asks
  dobot confirm --yes      a person has looked already

An arm that was reset takes its base for pointing straight ahead, wherever it points. If it does not, turn it by
hand, or tell it its angles with `dobot set angles`. Until its pose is trusted, the station moves nothing.")]
pub(crate) struct Args {
    /// Do not ask: a person has looked
    #[arg(long)]
    yes: bool,
    #[command(flatten)]
    station: Station,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let mut station = args.station.client("confirm").await?;
    let status = control::status(&mut station).await?;
    check_pose(&mut station, args.yes).await?;
    output::line(&output::status_text(&status))?;
    Ok(output::line("the pose is trusted")?)
}
