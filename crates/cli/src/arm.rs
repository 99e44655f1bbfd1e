//! `dobot arm`: serve a virtual arm.

use std::net::SocketAddr;
use std::path::PathBuf;

use anyhow::Context;
use dobot_controller::Personality;
use dobot_sim::{DEFAULT_TCP, Server, ServerEvent};
use tokio::net::TcpListener;

use crate::connect::virtual_arm;
use crate::failure::Failure;
use crate::interrupt::interrupt;
use crate::output;

/// Serve a virtual arm, in real time, on TCP and on a virtual serial port
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot arm                          on TCP 127.0.0.1:5555 and on a virtual serial port
  dobot arm --pty /tmp/dobot         a virtual serial port with a name of your own, only
  dobot arm --tcp 127.0.0.1:0        a free TCP port, only

It behaves like a real arm: one client at a time, 9600 baud, 12.5 statuses per second.
What it refuses is told here. Ctrl-C ends it.")]
pub(crate) struct Args {
    /// Serve on TCP; port 0 takes a free one
    #[arg(long, value_name = "HOST:PORT", num_args = 0..=1, default_missing_value = "127.0.0.1:5555")]
    tcp: Option<SocketAddr>,
    /// Serve on a virtual serial port, with a symbolic link to it at LINK
    #[cfg(unix)]
    #[arg(long, value_name = "LINK", num_args = 0..=1, default_missing_value = "")]
    pty: Option<PathBuf>,
    /// How the arm behaves: specification, or firmware-1.1 as the arms that were sold do
    #[arg(long, value_name = "PERSONALITY", default_value = "specification")]
    personality: Personality,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let interrupt = interrupt();
    let mut server = Server::new(virtual_arm(args.personality));
    let (tcp, pty) = args.places();
    if let Some(address) = tcp {
        let listener = listen(address).await?;
        let personality = args.personality;
        output::line(&format!(
            "tcp:{}   a virtual arm, personality {personality}",
            listener.local_addr()?
        ))?;
        server = server.on_tcp(listener);
    }
    #[cfg(unix)]
    if let Some(link) = pty {
        let link = Some(link).filter(|it| !it.as_os_str().is_empty());
        let pty =
            dobot_sim::Pty::open(link.as_deref()).map_err(|error| no_pty(error, link.as_ref()))?;
        output::line(&format!("serial:{}   the same arm", pty.path().display()))?;
        server = server.on_pty(pty);
    }
    tokio::select! {
        ended = server.run(|event| eprintln!("{}", text(&event))) => Ok(ended?),
        () = interrupt => Ok(()),
    }
}

impl Args {
    /// Where to serve: everywhere, unless told where. A virtual serial port without a link has an
    /// empty name.
    #[cfg(unix)]
    fn places(&self) -> (Option<SocketAddr>, Option<PathBuf>) {
        match (self.tcp, &self.pty) {
            (None, None) => (Some(DEFAULT_TCP), Some(PathBuf::new())),
            (tcp, pty) => (tcp, pty.clone()),
        }
    }

    #[cfg(not(unix))]
    fn places(&self) -> (Option<SocketAddr>, ()) {
        (self.tcp.or(Some(DEFAULT_TCP)), ())
    }
}

async fn listen(address: SocketAddr) -> Result<TcpListener, Failure> {
    TcpListener::bind(address).await.map_err(|error| {
        let taken = error.kind() == std::io::ErrorKind::AddrInUse;
        let error = anyhow::Error::from(error).context(format!("cannot serve on {address}"));
        if taken {
            Failure::new(
                error,
                "another arm may be served there; `--tcp 127.0.0.1:0` takes a free port",
            )
        } else {
            error.into()
        }
    })
}

#[cfg(unix)]
fn no_pty(error: std::io::Error, link: Option<&PathBuf>) -> Failure {
    let exists = error.kind() == std::io::ErrorKind::AlreadyExists;
    let Some(link) = link else {
        return anyhow::Error::from(error)
            .context("cannot make a virtual serial port")
            .into();
    };
    let result: Result<(), _> = Err(error);
    let error = result
        .with_context(|| format!("cannot make a virtual serial port at {}", link.display()))
        .expect_err("it is one");
    if exists {
        Failure::new(
            error,
            "something is there already: remove it or choose another name",
        )
    } else {
        error.into()
    }
}

fn text(event: &ServerEvent) -> String {
    match event {
        ServerEvent::TcpConnected(from) => format!("connected: {from}"),
        ServerEvent::TcpRefused(from) => {
            format!("turned away: {from}; another client has the arm")
        }
        ServerEvent::PtyOpened => "connected: virtual serial port".to_owned(),
        ServerEvent::PtyMoved(path) => format!(
            "the last client left the virtual serial port locked; now it is serial:{}",
            path.display()
        ),
        ServerEvent::Overrun => {
            "the client sends faster than 9600 baud: bytes are lost, as on a real line".to_owned()
        }
        ServerEvent::Disconnected => "disconnected".to_owned(),
        ServerEvent::Refused(refused) => refused.to_string(),
        other => format!("{other:?}"),
    }
}
