//! `cargo run -p dobot-examples --example crowd`: many clients, each connected to an arm.
//!
//! Measures the cost of serving many clients: serve arms in one process, and watch it while this
//! one receives:
//!
//! ```text
//! dobot arm --count 1000 --tcp 127.0.0.1:20000
//! cargo run --release -p dobot-examples --example crowd -- 1000 30 127.0.0.1:20000
//! ```
//!
//! Arguments: the number of clients, the seconds, and the address of the first arm; without an
//! address this process also serves the arms.

use std::error::Error;
use std::net::{Ipv4Addr, SocketAddr};
use std::time::Duration;

use dobot_controller::{Controller, PowerUp};
use dobot_sim::{SerialLine, Server, VirtualArm};
use tokio::io::AsyncReadExt;
use tokio::net::{TcpListener, TcpStream};
use tokio::task::JoinSet;
use tokio::time::{Instant, timeout_at};

#[tokio::main(flavor = "current_thread")]
async fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let count: u16 = arguments
        .next()
        .map_or(Ok(20), |argument| argument.parse())?;
    let seconds: u64 = arguments
        .next()
        .map_or(Ok(1), |argument| argument.parse())?;
    let addresses = match arguments.next() {
        None => serve(count).await?,
        Some(first) => from(first.parse()?, count),
    };

    let mut clients = JoinSet::new();
    for address in addresses {
        let stream = TcpStream::connect(address).await?;
        clients.spawn(listen(stream, Duration::from_secs(seconds)));
    }
    let bytes: usize = clients.join_all().await.into_iter().sum();

    let statuses = bytes / PACKET_LEN;
    let rate = statuses as u64 / (u64::from(count) * seconds);
    println!("{count} clients received {statuses} statuses in {seconds} s: {rate} a second each");
    Ok(())
}

/// Serves this many arms, and returns their addresses.
async fn serve(count: u16) -> std::io::Result<Vec<SocketAddr>> {
    let mut addresses = Vec::new();
    for _ in 0..count {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).await?;
        addresses.push(listener.local_addr()?);
        let arm = VirtualArm::new(Controller::power_up(PowerUp::default()), SerialLine::STOCK);
        let mut server = Server::new(arm).on_tcp(listener);
        tokio::spawn(async move { server.run(|_| {}).await });
    }
    Ok(addresses)
}

/// Returns this many addresses, with consecutive ports.
fn from(first: SocketAddr, count: u16) -> Vec<SocketAddr> {
    let at = |number| SocketAddr::new(first.ip(), first.port() + number);
    (0..count).map(at).collect()
}

/// Counts the bytes received within a time.
async fn listen(mut stream: TcpStream, time: Duration) -> usize {
    let end = Instant::now() + time;
    let mut bytes = 0;
    let mut buffer = [0; 256];
    while let Ok(Ok(count @ 1..)) = timeout_at(end, stream.read(&mut buffer)).await {
        bytes += count;
    }
    bytes
}

const PACKET_LEN: usize = 42;
