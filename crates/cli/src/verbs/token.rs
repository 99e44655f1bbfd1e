//! `dobot token`: who may do what over the network.

use std::path::{Path, PathBuf};

use anyhow::anyhow;
use clap::Subcommand;
use dobot_api::Role;
use dobot_station::{Token, Tokens};

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
  dobot token add control teacher --same-as teacher.txt      the one that another station has made
  dobot token add control class --shared     for a whole class: time slots go by the name that each one says
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
        /// It is for several people: time slots know each by what he calls himself, and not by the token's name
        #[arg(long)]
        shared: bool,
        /// The token that another station has made, in a file, or on standard input with -
        #[arg(long, value_name = "FILE")]
        same_as: Option<PathBuf>,
    },
    /// List the tokens, without showing them
    List,
    /// Remove a token: its holder is not known any more
    Remove {
        /// Who it was for
        name: String,
    },
}

/// The token in a file.
fn known(file: &Path) -> Result<Token, Failure> {
    let text = if file == Path::new("-") {
        std::io::read_to_string(std::io::stdin())
    } else {
        std::fs::read_to_string(file)
    };
    let text = text.map_err(|error| anyhow!("{}: {error}", file.display()))?;
    Ok(Token::of_secret(text.trim())?)
}

pub(crate) fn run(args: Args) -> Result<(), Failure> {
    let mut tokens = Tokens::open(&folders(args.data)?.tokens())?;
    match args.action {
        Action::Add {
            role,
            name,
            shared,
            same_as,
        } => {
            let made = match same_as {
                None => Some(tokens.add(role, &name)?),
                Some(file) => {
                    tokens.accept(role, &name, &known(&file)?)?;
                    None
                }
            };
            if shared {
                tokens.share(&name)?;
            }
            if let Some(token) = made {
                output::line(token.secret())?;
            }
        }
        Action::List => {
            for (name, role) in tokens.list() {
                let shared = if tokens.is_shared(name) {
                    "  (shared)"
                } else {
                    ""
                };
                output::line(&format!("{role:8} {name}{shared}"))?;
            }
        }
        Action::Remove { name } => tokens.remove(&name)?,
    }
    Ok(())
}
