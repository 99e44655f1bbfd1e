//! What a fleet is set up with: certificates and a router.

use std::path::PathBuf;

use dobot_fleet::{Credentials, Holder, Router};

use crate::failure::Failure;
use crate::interrupt::interrupt;
use crate::{open_files, output};

/// Make certificates.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct Certificates {
    /// Where the authority is, or is made; the folder of each station is made in it
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,
    /// The stations, and the router with the names and addresses by which they connect to it
    #[arg(value_name = "NAME[=HOST,...]", required = true)]
    holders: Vec<Holder>,
}

impl Certificates {
    pub(super) fn run(&self) -> Result<(), Failure> {
        Credentials::make(&self.folder, &self.holders)?;
        for holder in &self.holders {
            output::line(&self.folder.join(holder.name()).display().to_string())?;
        }
        Ok(())
    }
}

/// Revoke certificates.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct RevokeArgs {
    /// Where the authority is
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,
    /// The stations whose certificates count no longer
    #[arg(value_name = "NAME", required = true)]
    names: Vec<String>,
}

impl RevokeArgs {
    pub(super) fn run(&self) -> Result<(), Failure> {
        for name in &self.names {
            Credentials::revoke(&self.folder, name)?;
        }
        let list = self.folder.join("revoked.txt");
        output::line(&format!(
            "copy {} to the folder of each station and of the router, and start them again",
            list.display()
        ))?;
        Ok(())
    }
}

/// Run a router.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct RouterArgs {
    /// Where stations reach it, as in quic/0.0.0.0:7447; may be given several times
    #[arg(long, value_name = "ADDRESS", default_value = "quic/127.0.0.1:7447")]
    listen: Vec<String>,
    /// The folder with its certificate; without one it is for this person's stations on this machine
    #[arg(long, value_name = "FOLDER")]
    fleet: Option<PathBuf>,
}

impl RouterArgs {
    pub(super) async fn run(&self) -> Result<(), Failure> {
        let credentials = match &self.fleet {
            Some(folder) => Credentials::read(folder)?,
            None => Credentials::of_person("router")?,
        };
        open_files::allow_many();
        let router = Router::start(&self.listen, &credentials).await?;
        if let Some(warning) = credentials.warning() {
            output::line(&warning)?;
        }
        output::line(&format!("the router is at {}", self.listen.join(", ")))?;
        interrupt().await;
        router.end().await;
        Ok(())
    }
}
