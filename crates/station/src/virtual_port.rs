//! A virtual serial port to the station, for programs that only support serial ports.

use std::io;
use std::path::Path;
use std::time::Duration;

use dobot_api::Role;
use dobot_host::StationHandle;
use dobot_sim::{Pty, PtyClient};
use dobot_supervisor::Refusal;
use tokio::time::{MissedTickBehavior, interval};

use crate::ProgramNews;
use crate::bridge::bridge;

/// A virtual serial port to the station, for programs that only support serial ports; otherwise
/// like the [raw port](crate::RawPort).
///
/// A serial port cannot turn programs away: a second program that opens it shares the connection of
/// the first one, as with an unlocked real port.
#[derive(Debug)]
pub struct VirtualPort {
    pty: Pty,
}

impl VirtualPort {
    /// Creates the port, and a symbolic link to it if requested.
    ///
    /// # Errors
    ///
    /// As [`Pty::open`].
    pub fn open(link: Option<&Path>) -> io::Result<Self> {
        let pty = Pty::open(link)?;
        Ok(Self { pty })
    }

    /// Returns the path of the port.
    #[must_use]
    pub fn path(&self) -> &Path {
        self.pty.path()
    }

    /// Serves programs, one after the other, until the station ends.
    ///
    /// # Errors
    ///
    /// The error of the operating system.
    pub async fn serve(
        mut self,
        handle: &StationHandle,
        mut report: impl FnMut(ProgramNews),
    ) -> io::Result<()> {
        loop {
            let program = tokio::select! {
                program = self.program() => program?,
                () = handle.ended() => return Ok(()),
            };
            if self.serve_one(program, handle, &mut report).await.is_err() {
                return Ok(());
            }
            if let Some(path) = self.pty.renew()? {
                report(ProgramNews::PortMoved(path.to_owned()));
            }
        }
    }

    /// Waits for a program by polling.
    async fn program(&self) -> io::Result<PtyClient> {
        let mut looks = interval(LOOK_AGAIN);
        looks.set_missed_tick_behavior(MissedTickBehavior::Delay);
        loop {
            looks.tick().await;
            if let Some(program) = self.pty.client()? {
                return Ok(program);
            }
        }
    }

    /// Serves a program until it leaves.
    ///
    /// # Errors
    ///
    /// If the station ends.
    async fn serve_one(
        &self,
        program: PtyClient,
        handle: &StationHandle,
        report: &mut impl FnMut(ProgramNews),
    ) -> Result<(), Refusal> {
        let name = format!("serial program {}", self.path().display());
        let statuses = handle.packets();
        let client = handle.client(&name, Role::Control).await?;
        report(ProgramNews::Came { name: name.clone() });
        let (reader, writer) = tokio::io::split(program);
        let traffic = bridge(reader, writer, &client, statuses).await;
        report(ProgramNews::Left { name, traffic });
        Ok(())
    }
}

/// The interval at which a new program is noticed.
const LOOK_AGAIN: Duration = Duration::from_millis(50);

#[cfg(test)]
mod tests;
