//! The bridge between a program that speaks the arm's own protocol and the driver of the arm.

mod backoff;
mod web;

use dobot_host::Client;
use dobot_supervisor::Refusal;
use dobot_wire::{Commands, Decoder, PACKET_LEN, Packet};
use tokio::io::{AsyncRead, AsyncReadExt, AsyncWrite, AsyncWriteExt};
use tokio::sync::broadcast::Receiver;
use tokio::sync::broadcast::error::RecvError;
use tokio::sync::{Notify, mpsc};
use tokio::time::{Instant, sleep_until};

use self::backoff::Backoff;
use self::web::is_web;
use crate::Traffic;

/// Carries packets of a program to the driver of the arm, and statuses to the program, until either
/// of them leaves.
///
/// Little piles up here. What the program sends is passed on no faster than the driver takes it, and no
/// faster than an arm's line carries it once it is refused or noise; so much of it is read ahead that
/// the end of a program is seen at once, and what still had to wait is forgotten. Statuses that the
/// program does not read in time are lost to it, and it goes on with the newest.
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

/// The way from the program to the driver.
struct Inward {
    decoder: Decoder<Commands>,
    opened: Instant,
    refused: u64,
    web: bool,
}

impl Inward {
    fn new() -> Self {
        Self {
            decoder: Decoder::commands(),
            opened: Instant::now(),
            refused: 0,
            web: false,
        }
    }

    /// Runs until the program leaves, or the driver does. What it sent is read ahead, so that its end is
    /// seen behind what waits: then what would have to wait is forgotten.
    async fn run(&mut self, reader: impl AsyncRead + Unpin, client: &Client) {
        let (ahead, packets) = mpsc::channel(AHEAD);
        let left = Notify::new();
        let (opened, refused) = (self.opened, &mut self.refused);
        let reading = async {
            read(reader, &mut self.decoder, &mut self.web, opened, ahead).await;
            left.notify_one();
            std::future::pending::<()>().await;
        };
        tokio::select! {
            () = serve(packets, client, opened, refused, &left) => {}
            () = reading => {}
        }
    }
}

/// Reads packets ahead until the program leaves, or shows to be a web browser.
async fn read(
    mut reader: impl AsyncRead + Unpin,
    decoder: &mut Decoder<Commands>,
    web: &mut bool,
    opened: Instant,
    ahead: mpsc::Sender<Packet>,
) {
    let mut bytes = [0; READ_LEN];
    let mut backoff = Backoff::default();
    let mut first = true;
    while let Ok(len @ 1..) = reader.read(&mut bytes).await {
        *web |= first && is_web(&bytes[..len]);
        if *web {
            return;
        }
        first = false;
        let before = decoder.counts().skipped_bytes;
        for packet in decoder.feed(&bytes[..len]) {
            if ahead.send(packet).await.is_err() {
                return;
            }
        }
        let noise = decoder.counts().skipped_bytes - before;
        backoff.handle_bytes(opened.elapsed(), noise);
        sleep_until(opened + backoff.poll_wakeup()).await;
    }
}

/// Passes on what was read, refused packets no faster than an arm's line carries them, until the program
/// has `left` and the rest would have to wait.
async fn serve(
    mut packets: mpsc::Receiver<Packet>,
    client: &Client,
    opened: Instant,
    refused: &mut u64,
    left: &Notify,
) {
    let mut backoff = Backoff::default();
    while let Some(packet) = packets.recv().await {
        match client.raw(packet).await {
            Ok(()) => continue,
            Err(Refusal::Ending) => return,
            // The driver tells of it: the arm's protocol has no words for it.
            Err(_) => *refused += 1,
        }
        backoff.handle_bytes(opened.elapsed(), PACKET_LEN as u64);
        let wakeup = opened + backoff.poll_wakeup();
        if wakeup <= Instant::now() {
            continue;
        }
        tokio::select! {
            biased;
            () = left.notified() => return,
            () = sleep_until(wakeup) => {}
        }
    }
}

/// The way from the driver to the program.
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

    /// Runs until the program leaves, or the driver does.
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

/// So many packets are read ahead: a megabyte, half an hour of an arm's line.
const AHEAD: usize = 25_000;
/// What the kernel of a computer keeps for a serial port.
const READ_LEN: usize = 4096;

#[cfg(test)]
mod tests;
