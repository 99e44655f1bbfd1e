//! `dobot man`: manual pages.

use std::fs;
use std::path::PathBuf;

use anyhow::Context;
use clap::CommandFactory;

use crate::Cli;
use crate::failure::Failure;
use crate::output;

/// Write the manual pages
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot man | man -l -                           read the page of the program
  dobot man --out ~/.local/share/man/man1        a page for each verb, for `man dobot-draw`")]
pub(crate) struct Args {
    /// Write a page for the program and for each verb into this folder
    #[arg(long, value_name = "FOLDER")]
    out: Option<PathBuf>,
}

pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let Some(folder) = &args.out else {
        let mut page = Vec::new();
        clap_mangen::Man::new(Cli::command()).render(&mut page)?;
        return Ok(output::bytes(&page)?);
    };
    let written =
        fs::create_dir_all(folder).and_then(|()| clap_mangen::generate_to(Cli::command(), folder));
    Ok(written.with_context(|| format!("cannot write manual pages to {}", folder.display()))?)
}
