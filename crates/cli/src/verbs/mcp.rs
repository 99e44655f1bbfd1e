//! `dobot mcp`: offers the arm to an agent.

use std::path::PathBuf;

#[cfg(feature = "full")]
use dobot_mcp::{Agents, FilesFolder, NoStation, Settings, serve};
#[cfg(feature = "full")]
use tokio::sync::watch;

use crate::failure::Failure;
#[cfg(feature = "full")]
use crate::interrupt::interrupt;
use crate::reach::Station;

/// Offer the station's arm to an agent (Model Context Protocol)
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot mcp                        started by an agent; standard output is reserved
  dobot mcp --may-move             the agent may start jobs and move the arm
  dobot mcp --files ~/drawings     the agent may draw and run the files in a folder
  DOBOT_TOKEN=... dobot mcp --station https://lab.example:8642

It needs a running station (`dobot up`). Agents can also connect to the station
over HTTP, at http://127.0.0.1:8642/mcp, without this command. All rules of the
station apply, and the laser is never armed. If the agent cancels a request or
ends during a motion, the arm is stopped.")]
pub(crate) struct Args {
    /// Let the agent move the arm and start jobs (default: it queues jobs, and a person starts each)
    #[arg(long)]
    may_move: bool,
    /// The default
    #[arg(long, hide = true, conflicts_with = "may_move")]
    ask: bool,
    /// Folder with files that the agent may draw and run
    #[arg(long, value_name = "FOLDER")]
    files: Option<PathBuf>,
    #[command(flatten)]
    station: Station,
}

#[cfg(feature = "full")]
pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let station = args.station;
    let mut settings = Settings::finding(move || {
        let station = station.clone();
        async move {
            let found = station.address_of_running().await;
            found.map_err(|failure| NoStation {
                detail: failure.detail(),
                hint: failure.hint(),
            })
        }
    });
    settings.asks = args.ask || !args.may_move;
    settings.files = args.files.as_deref().map(FilesFolder::new).transpose()?;
    let (end, ending) = watch::channel(false);
    let interrupted = interrupt();
    tokio::spawn(async move {
        interrupted.await;
        end.send_replace(true);
    });
    let agents = Agents::new(settings);
    Ok(serve(agents, tokio::io::stdin(), tokio::io::stdout(), ending).await?)
}

#[cfg(not(feature = "full"))]
#[expect(clippy::unused_async, reason = "with the feature `full` it serves")]
pub(crate) async fn run(_: Args) -> Result<(), Failure> {
    Err(dobot_api::NotBuilt("tools for agents (MCP)").into())
}
