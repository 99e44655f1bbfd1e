//! `dobot token`: access tokens of the station.

use std::path::{Path, PathBuf};

use anyhow::anyhow;
use clap::Subcommand;
use dobot_api::Role;
use dobot_station::{Token, Tokens};

use crate::failure::Failure;
use crate::output;
use crate::reach::folders;

/// Create, list and remove access tokens of the station
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot token add control plotter      for a client that moves the arm
  dobot token add queue agent          for one that queues jobs for a person to start
  dobot token add watch hall-screen    for one that only watches (and may stop)
  dobot token add control teacher --same-as teacher.txt
                                       a token that another station created
  dobot token add control class --shared
                                       for a class: time slots use stated names
  dobot token list
  dobot token remove plotter

A token is shown only when it is created; the station keeps only its digest.
Changes take effect immediately. On the other machine, put it in the environment
variable DOBOT_TOKEN. Programs on the station's machine need no token.")]
pub(crate) struct Args {
    #[command(subcommand)]
    action: Action,
    /// Data folder of the station
    #[arg(long, value_name = "FOLDER", global = true, hide_short_help = true)]
    data: Option<PathBuf>,
}

#[derive(Clone, Debug, Subcommand)]
enum Action {
    /// Create a token and show it once
    Add {
        /// Role: watch, queue, control or admin
        role: Role,
        /// Name of the client or person
        name: String,
        /// Shared by several people: time slots use the name that each client states
        #[arg(long)]
        shared: bool,
        /// File with a token that another station created, or - for standard input
        #[arg(long, value_name = "FILE")]
        same_as: Option<PathBuf>,
    },
    /// List names and roles, without the tokens
    List,
    /// Remove a token; its clients lose access immediately
    Remove {
        /// Name of the client or person
        name: String,
    },
}

/// Reads the token in a file.
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
        } => add(&mut tokens, role, &name, shared, same_as.as_deref())?,
        Action::List => list(&tokens)?,
        Action::Remove { name } => tokens.remove(&name)?,
    }
    Ok(())
}

fn add(
    tokens: &mut Tokens,
    role: Role,
    name: &str,
    shared: bool,
    same_as: Option<&Path>,
) -> Result<(), Failure> {
    let made = match same_as {
        None => Some(tokens.add(role, name)?),
        Some(file) => {
            tokens.accept(role, name, &known(file)?)?;
            None
        }
    };
    if shared {
        tokens.share(name)?;
    }
    if let Some(token) = made {
        output::line(token.secret())?;
    }
    Ok(())
}

fn list(tokens: &Tokens) -> Result<(), Failure> {
    for (name, role) in tokens.list() {
        let shared = if tokens.is_shared(name) {
            "  (shared)"
        } else {
            ""
        };
        output::line(&format!("{role:8} {name}{shared}"))?;
    }
    Ok(())
}
