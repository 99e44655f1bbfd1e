//! `dobot completions`: prints shell completions.

use clap_complete::Shell;

use crate::command_line;
use crate::failure::Failure;
use crate::output;

/// Print shell completions
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot completions bash > ~/.local/share/bash-completion/completions/dobot
  dobot completions zsh > ~/.zfunc/_dobot
  dobot completions fish > ~/.config/fish/completions/dobot.fish")]
pub(crate) struct Args {
    /// Shell
    shell: Shell,
}

pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let mut text = Vec::new();
    clap_complete::generate(args.shell, &mut command_line::command(), "dobot", &mut text);
    Ok(output::bytes(&text)?)
}
