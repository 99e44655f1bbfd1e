//! `dobot extras`: optional parts of the page.

use std::path::{Path, PathBuf};

use anyhow::anyhow;
use dobot_station::{EXTRAS, Extra, ExtraError};

use crate::failure::Failure;
use crate::output;
use crate::reach::folders;

/// Install optional parts of the page, or list them
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot extras                            list them
  npm pack @mediapipe/hands@0.4.1675469240
  dobot extras install hands mediapipe-hands-0.4.1675469240.tgz

`hands` lets the arm follow a hand in front of a camera. It is not part of the
program: 13 MB by Google (Apache-2.0). The archive is checked by its digest, kept
in the data folder, and served by the station of this user.")]
pub(crate) struct Args {
    #[command(subcommand)]
    action: Option<Action>,
    /// Data folder of the station
    #[arg(long, value_name = "FOLDER", global = true)]
    data: Option<PathBuf>,
}

#[derive(Debug, clap::Subcommand)]
enum Action {
    /// Install a part from an archive
    Install {
        /// Part: hands
        #[arg(value_name = "NAME")]
        name: String,
        /// Archive of its npm package
        #[arg(value_name = "FILE")]
        file: PathBuf,
    },
}

pub(crate) fn run(args: Args) -> Result<(), Failure> {
    let extras = folders(args.data)?.extras();
    match args.action {
        None => list(&extras),
        Some(Action::Install { name, file }) => {
            let extra = named(&name)?;
            extra.install(&extras, &file).map_err(|error| match error {
                ExtraError::Other { .. } => {
                    let hint = format!("get it with: npm pack {}", extra.package);
                    Failure::new(error, hint)
                }
                error => error.into(),
            })?;
            let folder = extras.join(extra.name);
            Ok(output::line(&format!("installed in {}", folder.display()))?)
        }
    }
}

fn list(extras: &Path) -> Result<(), Failure> {
    for extra in &EXTRAS {
        let state = if extra.is_installed(extras) {
            "installed".to_owned()
        } else {
            format!("not installed; its archive: npm pack {}", extra.package)
        };
        output::line(&format!("{}  {state}", extra.name))?;
    }
    Ok(())
}

fn named(name: &str) -> Result<&'static Extra, Failure> {
    let found = EXTRAS.iter().find(|extra| extra.name == name);
    found.ok_or_else(|| {
        let names = EXTRAS.map(|extra| extra.name).join(", ");
        Failure::usage(anyhow!("there is no part {name:?}; allowed: {names}"))
    })
}
