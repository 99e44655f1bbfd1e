//! A virtual serial port that leads to the station, for programs that only speak serial.

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

/// A virtual serial port that leads to the station: the same as the [raw port](crate::RawPort), for
/// programs that only speak serial.
///
/// A serial port cannot turn anybody away: a second program that opens it shares the first one's
/// conversation, as with a real port that nobody has locked.
#[derive(Debug)]
pub struct VirtualPort {
    pty: Pty,
}

impl VirtualPort {
    /// Makes the port, and a symbolic link to it where one is asked for.
    ///
    /// # Errors
    ///
    /// As [`Pty::open`].
    pub fn open(link: Option<&Path>) -> io::Result<Self> {
        let pty = Pty::open(link)?;
        Ok(Self { pty })
    }

    /// The name by which a program opens it.
    #[must_use]
    pub fn path(&self) -> &Path {
        self.pty.path()
    }

    /// Serves programs, one after the other, until the station ends.
    ///
    /// # Errors
    ///
    /// What the operating system says about the port.
    pub async fn serve(
        mut self,
        handle: &StationHandle,
        mut tell: impl FnMut(ProgramNews),
    ) -> io::Result<()> {
        loop {
            let program = tokio::select! {
                program = self.program() => program?,
                () = handle.ended() => return Ok(()),
            };
            if self.serve_one(program, handle, &mut tell).await.is_err() {
                return Ok(());
            }
            if let Some(path) = self.pty.renew()? {
                tell(ProgramNews::PortMoved(path.to_owned()));
            }
        }
    }

    /// Waits for a program: somebody has to look whether it is there.
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
    /// When the station ends.
    async fn serve_one(
        &self,
        program: PtyClient,
        handle: &StationHandle,
        tell: &mut impl FnMut(ProgramNews),
    ) -> Result<(), Refusal> {
        let name = format!("serial program {}", self.path().display());
        let statuses = handle.packets();
        let client = handle.client(&name, Role::Control).await?;
        tell(ProgramNews::Came { name: name.clone() });
        let (reader, writer) = tokio::io::split(program);
        let traffic = bridge(reader, writer, &client, statuses).await;
        tell(ProgramNews::Left { name, traffic });
        Ok(())
    }
}

/// Whoever opens the port is noticed so soon.
const LOOK_AGAIN: Duration = Duration::from_millis(50);

#[cfg(test)]
mod tests;
