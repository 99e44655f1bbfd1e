//! The bridge between a program that speaks the arm's own protocol and the owner of the arm.

mod patience;
mod web;

use dobot_wire::{Commands, Decoder, PACKET_LEN};
use tokio::io::{AsyncRead, AsyncReadExt, AsyncWrite, AsyncWriteExt};
use tokio::sync::broadcast::Receiver;
use tokio::sync::broadcast::error::RecvError;
use tokio::time::{Instant, sleep_until};

use self::patience::Patience;
use self::web::is_web;
use crate::words::Refusal;
use crate::{Client, Traffic};

/// Carries packets of a program to the owner of the arm, and statuses to the program, until either
/// of them leaves.
///
/// Nothing piles up here. What the program sends is read no faster than the owner takes it, and no
/// faster than an arm's line carries it once it is refused or noise; statuses that the program does
/// not read in time are lost to it, and it goes on with the newest.
pub(crate) async fn bridge(
    reader: impl AsyncRead + Unpin,
    writer: impl AsyncWrite + Unpin,
    client: &Client,
    statuses: Receiver<[u8; PACKET_LEN]>,
) -> Traffic {
    let mut inward = Inward::new();
    let mut outward = Outward::new(statuses);
    // Both in one task: no packet waits for another one to be woken.
    tokio::select! {
        () = inward.run(reader, client) => {}
        () = outward.run(writer) => {}
    }
    Traffic {
        packets: inward.decoder.counts().frames,
        refused: inward.refused,
        damaged_bytes: inward.decoder.counts().skipped_bytes + inward.decoder.waiting() as u64,
        statuses: outward.sent,
        lost_statuses: outward.lost,
        web: inward.web,
    }
}

/// The way from the program to the owner.
struct Inward {
    decoder: Decoder<Commands>,
    patience: Patience,
    opened: Instant,
    refused: u64,
    web: bool,
}

impl Inward {
    fn new() -> Self {
        Self {
            decoder: Decoder::commands(),
            patience: Patience::default(),
            opened: Instant::now(),
            refused: 0,
            web: false,
        }
    }

    /// Runs until the program leaves, or the owner does.
    async fn run(&mut self, mut reader: impl AsyncRead + Unpin, client: &Client) {
        let mut bytes = [0; READ_LEN];
        let mut first = true;
        while let Ok(len @ 1..) = reader.read(&mut bytes).await {
            self.web |= first && is_web(&bytes[..len]);
            if self.web || self.take(&bytes[..len], client).await.is_err() {
                break;
            }
            first = false;
        }
    }

    /// Passes on the packets that these bytes complete.
    async fn take(&mut self, bytes: &[u8], client: &Client) -> Result<(), Refusal> {
        let before = self.decoder.counts().skipped_bytes;
        for packet in self.decoder.feed(bytes) {
            match client.raw(packet).await {
                Ok(()) => {}
                Err(Refusal::Ending) => return Err(Refusal::Ending),
                // The owner tells of it: the arm's protocol has no words for it.
                Err(_) => {
                    self.refused += 1;
                    self.patience
                        .handle_bytes(self.opened.elapsed(), PACKET_LEN as u64);
                    sleep_until(self.opened + self.patience.poll_wakeup()).await;
                }
            }
        }
        let noise = self.decoder.counts().skipped_bytes - before;
        self.patience.handle_bytes(self.opened.elapsed(), noise);
        sleep_until(self.opened + self.patience.poll_wakeup()).await;
        Ok(())
    }
}

/// The way from the owner to the program.
struct Outward {
    statuses: Receiver<[u8; PACKET_LEN]>,
    sent: u64,
    lost: u64,
}

impl Outward {
    const fn new(statuses: Receiver<[u8; PACKET_LEN]>) -> Self {
        Self {
            statuses,
            sent: 0,
            lost: 0,
        }
    }

    /// Runs until the program leaves, or the owner does.
    async fn run(&mut self, mut writer: impl AsyncWrite + Unpin) {
        while let Some(status) = self.next().await {
            if writer.write_all(&status).await.is_err() {
                break;
            }
            self.sent += 1;
        }
    }

    async fn next(&mut self) -> Option<[u8; PACKET_LEN]> {
        loop {
            match self.statuses.recv().await {
                Ok(status) => return Some(status),
                Err(RecvError::Closed) => return None,
                // Each status is a permit, and an old one tells where the arm was: on with the
                // newest.
                Err(RecvError::Lagged(missed)) => {
                    self.lost += missed + self.statuses.len() as u64;
                    self.statuses = self.statuses.resubscribe();
                }
            }
        }
    }
}

/// What the kernel of a computer keeps for a serial port.
const READ_LEN: usize = 4096;

#[cfg(test)]
mod tests;
