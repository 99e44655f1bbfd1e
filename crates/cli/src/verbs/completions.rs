//! `dobot completions`: what a shell has to know to complete the verbs.

use clap::CommandFactory;
use clap_complete::Shell;

use crate::Cli;
use crate::failure::Failure;
use crate::output;

/// Print what a shell needs to complete verbs and options with the Tab key
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot completions bash > ~/.local/share/bash-completion/completions/dobot
  dobot completions zsh > ~/.zfunc/_dobot
  dobot completions fish > ~/.config/fish/completions/dobot.fish")]
pub(crate) struct Args {
    /// Which shell
    shell: Shell,
}

pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let mut text = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::command(), "dobot", &mut text);
    Ok(output::bytes(&text)?)
}
