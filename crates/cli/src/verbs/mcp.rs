//! `dobot mcp`: the arm as tools for an agent.

use std::path::PathBuf;

#[cfg(feature = "full")]
use dobot_mcp::{Agents, FilesFolder, NoStation, Settings, serve};
#[cfg(feature = "full")]
use tokio::sync::watch;

use crate::failure::Failure;
#[cfg(feature = "full")]
use crate::interrupt::interrupt;
use crate::reach::Station;

/// Give the arm of a station to an agent, as tools of the Model Context Protocol
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot mcp                            for the agent that starts it; its standard output belongs to the protocol
  dobot mcp --may-move                 the agent starts drawings and programs itself, and moves the arm
  dobot mcp --files ~/drawings         the agent may draw and run what is in this folder
  DOBOT_TOKEN=... dobot mcp --station https://lab.example:8642

A station runs beside it: `dobot up`. Over HTTP agents come to the station itself, at http://127.0.0.1:8642/mcp: nothing
has to be started for that. All of its rules hold, and the laser is never armed. What the agent gives up, or
leaves under way when it ends, stops the arm.")]
pub(crate) struct Args {
    /// Let the agent move the arm and start drawings and programs (default: it queues them, and a person starts each)
    #[arg(long)]
    may_move: bool,
    /// The default
    #[arg(long, hide = true, conflicts_with = "may_move")]
    ask: bool,
    /// The folder whose files the agent may draw and run
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
