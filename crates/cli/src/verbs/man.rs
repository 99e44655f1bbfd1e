//! `dobot man`: prints or writes manual pages.

use std::path::PathBuf;

#[cfg(feature = "full")]
use anyhow::Context;

#[cfg(feature = "full")]
use crate::command_line;
use crate::failure::Failure;
#[cfg(feature = "full")]
use crate::output;

/// Print or write manual pages
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot man | man -l -                        read the page of the program
  dobot man --out ~/.local/share/man/man1     write a page for each command")]
pub(crate) struct Args {
    /// Folder for the pages of the program and of each command (default: print the page of the program)
    #[arg(long, value_name = "FOLDER")]
    out: Option<PathBuf>,
}

#[cfg(feature = "full")]
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let Some(folder) = &args.out else {
        let mut page = Vec::new();
        clap_mangen::Man::new(command_line::command()).render(&mut page)?;
        return Ok(output::bytes(&page)?);
    };
    let written = std::fs::create_dir_all(folder)
        .and_then(|()| clap_mangen::generate_to(command_line::command(), folder));
    Ok(written.with_context(|| format!("cannot write manual pages to {}", folder.display()))?)
}

#[cfg(not(feature = "full"))]
pub(crate) fn run(_: &Args) -> Result<(), Failure> {
    Err(dobot_api::NotBuilt("manual pages").into())
}
