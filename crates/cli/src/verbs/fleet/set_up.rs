//! Setup of a fleet: certificates and a router.

use std::path::PathBuf;

use dobot_fleet::{Credentials, Holder, Router};

use crate::failure::Failure;
use crate::interrupt::interrupt;
use crate::{open_files, output};

/// Arguments of `dobot fleet certificates`.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct Certificates {
    /// Folder of the authority; a folder for each station is created in it
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,
    /// Stations, and the router with the names and addresses by which they connect to it
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

/// Arguments of `dobot fleet revoke`.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct RevokeArgs {
    /// Folder of the authority
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,
    /// Stations whose certificates are revoked
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
            "copy {} to the folders of all stations and of the router, and restart them",
            list.display()
        ))?;
        Ok(())
    }
}

/// Arguments of `dobot fleet router`.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct RouterArgs {
    /// Address to listen on, for example quic/0.0.0.0:7447; may be repeated
    #[arg(long, value_name = "ADDRESS", default_value = "quic/127.0.0.1:7447")]
    listen: Vec<String>,
    /// Folder with the router's certificate (default: only for this person's stations on this machine)
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
        output::line(&format!("router listening at {}", self.listen.join(", ")))?;
        interrupt().await;
        router.end().await;
        Ok(())
    }
}
