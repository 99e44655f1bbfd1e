//! The bridge between a program that speaks the arm's own protocol and the arm's driver.

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

/// Forwards packets of a program to the driver, and statuses to the program, until either leaves.
///
/// The queues are bounded. Packets are forwarded no faster than the driver takes them, and refused
/// packets or noise no faster than an arm's serial line would carry them. Packets are read ahead
/// far enough to detect the end of the program immediately; what is still waiting then is dropped.
/// Statuses that the program does not read in time are dropped, and it continues with the newest.
pub(crate) async fn bridge(
    reader: impl AsyncRead + Unpin,
    writer: impl AsyncWrite + Unpin,
    client: &Client,
    statuses: Receiver<[u8; PACKET_LEN]>,
) -> Traffic {
    let mut inward = Inward::new();
    let mut outward = Outward::new(statuses);
    // Both directions in one task: no packet waits for a wake-up of another task.
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

/// The direction from the program to the driver.
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

    /// Runs until the program or the driver leaves. Reads ahead, so that the end of the program is
    /// detected behind waiting packets, which are then dropped.
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

/// Reads packets ahead until the program leaves, or turns out to be a web browser.
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
        *web |= std::mem::take(&mut first) && is_web(&bytes[..len]);
        if *web {
            return;
        }
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

/// Forwards what was read, refused packets no faster than an arm's line carries them, until the
/// program has `left` and the rest would have to wait.
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
            // The driver reports it: the arm's protocol has no message for it.
            Err(_) => *refused += 1,
        }
        backoff.handle_bytes(opened.elapsed(), PACKET_LEN as u64);
        let wakeup = opened + backoff.poll_wakeup();
        if wakeup > Instant::now() {
            tokio::select! {
                biased;
                () = left.notified() => return,
                () = sleep_until(wakeup) => {}
            }
        }
    }
}

/// The direction from the driver to the program.
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

    /// Runs until the program or the driver leaves.
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
                // Each status is a permit, and an old one is out of date: continue with the newest.
                Err(RecvError::Lagged(missed)) => {
                    self.lost += missed + self.statuses.len() as u64;
                    self.statuses = self.statuses.resubscribe();
                }
            }
        }
    }
}

/// The number of packets that are read ahead: a megabyte, half an hour of an arm's line.
const AHEAD: usize = 25_000;
/// The size of the kernel's buffer for a serial port.
const READ_LEN: usize = 4096;

#[cfg(test)]
mod tests;
