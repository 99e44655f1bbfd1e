//! `dobot token`: who may do what over the network.

use std::path::PathBuf;

use clap::Subcommand;
use dobot_api::Role;
use dobot_station::Tokens;

use crate::failure::Failure;
use crate::output;
use crate::reach::folders;

/// Make, list and remove the tokens by which a station knows its clients
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot token add control plotter      a token for a client that moves the arm
  dobot token add queue agent          ... for one that queues drawings and programs, which a person starts
  dobot token add watch hall-screen    ... and for one that only watches (it may stop the arm, as anybody may)
  dobot token list
  dobot token remove plotter

A token is shown once, when it is made; the station keeps its digest only, and takes to changes at once. On the
other machine it goes into the environment variable DOBOT_TOKEN. Programs on the station's own machine need none.")]
pub(crate) struct Args {
    #[command(subcommand)]
    action: Action,
    /// Where the station keeps its data
    #[arg(long, value_name = "FOLDER", global = true)]
    data: Option<PathBuf>,
}

#[derive(Clone, Debug, Subcommand)]
enum Action {
    /// Make a token and show it, this once
    Add {
        /// What its holder may do: watch, queue, control or admin
        role: Role,
        /// Who it is for
        name: String,
    },
    /// List the tokens, without showing them
    List,
    /// Remove a token: its holder is not known any more
    Remove {
        /// Who it was for
        name: String,
    },
}

pub(crate) fn run(args: Args) -> Result<(), Failure> {
    let mut tokens = Tokens::open(&folders(args.data)?.tokens())?;
    match args.action {
        Action::Add { role, name } => {
            let token = tokens.add(role, &name)?;
            output::line(token.secret())?;
        }
        Action::List => {
            for (name, role) in tokens.list() {
                output::line(&format!("{role:8} {name}"))?;
            }
        }
        Action::Remove { name } => tokens.remove(&name)?,
    }
    Ok(())
}
