//! The router, in a separate process: this program, started with another argument.

use std::error::Error;
use std::io::{BufRead, BufReader, Read};
use std::net::TcpListener;
use std::process::{Child, Command, Stdio};

use dobot_fleet::{Credentials, Router};

/// A router in a separate process; it ends when this is dropped.
#[derive(Debug)]
pub(crate) struct RouterProcess {
    child: Child,
    /// Its address.
    pub(crate) address: String,
}

const WORD: &str = "serve-a-router";

impl RouterProcess {
    /// Starts it, and waits until it listens.
    pub(crate) fn start() -> Result<Self, Box<dyn Error + Send + Sync>> {
        // Free at this moment; Zenoh does not report a port that it chose itself.
        let port = TcpListener::bind("127.0.0.1:0")?.local_addr()?.port();
        let address = format!("quic/127.0.0.1:{port}");
        let mut child = Command::new(std::env::current_exe()?)
            .args([WORD, &address])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()?;
        let out = child.stdout.take().ok_or("it was asked for")?;
        BufReader::new(out).read_line(&mut String::new())?;
        Ok(Self { child, address })
    }

    pub(crate) fn pid(&self) -> u32 {
        self.child.id()
    }
}

impl Drop for RouterProcess {
    fn drop(&mut self) {
        // It ends when its standard input is closed.
        drop(self.child.stdin.take());
        let _ = self.child.wait();
    }
}

/// Returns the address to listen on, if this is the router's process.
pub(crate) fn wanted() -> Option<String> {
    let mut words = std::env::args().skip(1);
    words.next().filter(|word| word == WORD)?;
    words.next()
}

/// Runs the router until the other process ends.
pub(crate) async fn serve(address: &str) -> Result<(), Box<dyn Error + Send + Sync>> {
    let credentials = Credentials::of_person("router")?;
    let router = Router::start(&[address.to_owned()], &credentials).await?;
    println!("{address}");
    let over = tokio::task::spawn_blocking(|| std::io::stdin().read_to_end(&mut Vec::new()));
    over.await??;
    router.end().await;
    Ok(())
}
