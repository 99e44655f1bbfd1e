//! `dobot confirm`: the arm stands where it says.

use std::io::IsTerminal;

use anyhow::anyhow;
use dobot_station::Request;

use crate::control;
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
    let mut station = args.station.connect("confirm").await?;
    let status = control::status(&mut station).await?;
    output::line(&output::status_text(&status))?;
    if !args.yes && !ask().await? {
        return Err(anyhow!("not confirmed").into());
    }
    station.request(Request::ConfirmPose).await?;
    Ok(output::line("the pose is trusted")?)
}

/// Asks the person.
async fn ask() -> Result<bool, Failure> {
    if !std::io::stdin().is_terminal() {
        return Err(Failure::new(
            anyhow!("nobody is there to be asked"),
            "`--yes`, when a person has looked at the arm",
        ));
    }
    eprintln!("does the arm stand there? y or n");
    let answer = tokio::task::spawn_blocking(|| {
        let mut line = String::new();
        std::io::stdin().read_line(&mut line).map(|_| line)
    });
    let answer = answer.await??;
    Ok(matches!(answer.trim(), "y" | "Y" | "yes"))
}
