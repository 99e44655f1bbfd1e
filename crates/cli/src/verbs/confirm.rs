//! `dobot confirm`: confirms the reported pose of the arm.

use crate::control::{self, check_pose};
use crate::failure::Failure;
use crate::output;
use crate::reach::Station;

/// Confirm the reported pose of the arm after a reset
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot confirm            show the reported pose, and ask
  dobot confirm --yes      a person has looked already

After a reset, the arm assumes that its base points straight ahead. If it does
not, turn it by hand, or send the angles with `dobot set angles`. The station
moves nothing until the pose is confirmed.")]
pub(crate) struct Args {
    /// Confirm without being asked; a person must have looked
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
    Ok(output::line("the pose is confirmed")?)
}
