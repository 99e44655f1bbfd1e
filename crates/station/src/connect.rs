//! Where the arm comes from: a port that is named or looked for, or a virtual arm of the station.

use dobot_client::{Address, Link};
use dobot_sim::Connector;
use tokio::sync::mpsc;

use crate::finder::{self, Reconnect};

/// Where the arm comes from.
#[derive(Clone, Debug)]
pub(crate) enum Source {
    /// A port that a person named.
    Named(Address),
    /// Whatever arm is found on the serial ports.
    Search,
    /// The station's own virtual arm.
    Virtual(Connector),
}

/// What is told while there is no link.
#[derive(Debug)]
pub(crate) enum Connecting {
    /// The port is open.
    Up {
        link: Link,
        address: Address,
        /// What came from the arm meanwhile.
        received: Vec<u8>,
    },
    /// Not yet, and why.
    Waiting(String),
}

impl Source {
    /// Looks for the arm until it is there, in a task of its own that ends with its receiver.
    pub(crate) fn connect(&self) -> mpsc::Receiver<Connecting> {
        let (tell, news) = mpsc::channel(4);
        tokio::spawn(connect(self.clone(), tell));
        news
    }

    /// Whether it is the station's own virtual arm.
    pub(crate) const fn is_virtual(&self) -> bool {
        matches!(self, Self::Virtual(_))
    }
}

async fn connect(source: Source, tell: mpsc::Sender<Connecting>) {
    let mut again = Reconnect::new();
    loop {
        let news = attempt(&source).await;
        let up = matches!(news, Connecting::Up { .. });
        if tell.send(news).await.is_err() || up {
            return;
        }
        tokio::select! {
            () = tokio::time::sleep(again.next_delay()) => {}
            () = tell.closed() => return,
        }
    }
}

/// Tries once.
async fn attempt(source: &Source) -> Connecting {
    let opened = match source {
        Source::Virtual(connector) => match connector.connect().await {
            Ok(stream) => Ok((Link::over_stream(stream), Address::Virtual, Vec::new())),
            Err(error) => Err(error.to_string()),
        },
        Source::Named(address) => match Link::open(address).await {
            Ok(link) => Ok((link, address.clone(), Vec::new())),
            Err(error) => Err(with_hint(&error)),
        },
        Source::Search => finder::find()
            .await
            .map(|found| (found.link, found.address, found.received))
            .map_err(|nothing| nothing.to_string()),
    };
    match opened {
        Ok((link, address, received)) => Connecting::Up {
            link,
            address,
            received,
        },
        Err(problem) => Connecting::Waiting(problem),
    }
}

fn with_hint(error: &dobot_client::OpenError) -> String {
    match error.hint() {
        Some(hint) => format!("{error}; {hint}"),
        None => error.to_string(),
    }
}
