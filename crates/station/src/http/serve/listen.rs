//! Accepts and ends connections.

use std::collections::HashMap;
use std::net::{IpAddr, SocketAddr};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use axum::{Extension, Router};
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use tokio::io::{AsyncRead, AsyncWrite};
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::watch;
use tokio::task::{JoinHandle, JoinSet, spawn_blocking};
use tokio::time::{interval, sleep, timeout};

use crate::http::app::{App, MAX_SOCKETS, Peer, REFRESH_EVERY, ended};
use crate::http::routes;
use crate::http::tls::TlsAcceptor;

/// The timeout of the head of a request, and of a TLS handshake.
const HEAD_WITHIN: Duration = Duration::from_secs(10);
/// The time in which connections have to end.
const END_WITHIN: Duration = Duration::from_secs(3);
/// The delay before a retry when the system is out of connections.
const BREATH: Duration = Duration::from_millis(50);

/// Serves until the station ends, and then until all connections have ended.
pub(crate) async fn serve(listener: TcpListener, tls: Option<TlsAcceptor>, app: Arc<App>) {
    let router = routes::router(app.clone());
    let slots = Arc::new(ConnectionSlots::default());
    let mut connections = JoinSet::new();
    let mut ended = std::pin::pin!(ended(app.ending.clone()));
    let mut seconds = interval(Duration::from_secs(1));
    let mut refresh = interval(REFRESH_EVERY);
    let mut refreshing: Option<JoinHandle<()>> = None;
    loop {
        tokio::select! {
            accepted = listener.accept() => match accepted {
                Ok((stream, from)) => {
                    if let Some(connection) = Connection::new(&stream, from, tls.clone(), &slots) {
                        connections.spawn(connection.serve(stream, router.clone(), app.ending.clone()));
                    }
                }
                Err(_) => sleep(BREATH).await,
            },
            Some(_) = connections.join_next() => {}
            _ = seconds.tick() => app.http_leases.sweep(app.now()),
            _ = refresh.tick() => {
                // One at a time: the disk may hang.
                if refreshing.as_ref().is_none_or(JoinHandle::is_finished) {
                    let app = app.clone();
                    refreshing = Some(spawn_blocking(move || app.refresh_tokens()));
                }
            }
            () = &mut ended => break,
        }
    }
    drop(listener);
    app.agents.end();
    // Remaining connections are cut.
    let _ = timeout(END_WITHIN, async {
        while connections.join_next().await.is_some() {}
        let all = u32::try_from(MAX_SOCKETS).expect("a few thousand");
        let _ = app.sockets.acquire_many(all).await;
    })
    .await;
}

/// A connection with a slot.
struct Connection {
    peer: Peer,
    tls: Option<TlsAcceptor>,
}

impl Connection {
    fn new(
        stream: &TcpStream,
        from: SocketAddr,
        tls: Option<TlsAcceptor>,
        slots: &Arc<ConnectionSlots>,
    ) -> Option<Self> {
        let slot = slots.take(from.ip())?;
        // Slow is better than not at all.
        let _ = stream.set_nodelay(true);
        Some(Self {
            peer: Peer {
                from,
                to: stream.local_addr().ok()?,
                secure: tls.is_some(),
                by_fleet: false,
                _slot: Some(Arc::new(slot)),
            },
            tls,
        })
    }

    async fn serve(self, stream: TcpStream, router: Router, ending: watch::Receiver<bool>) {
        match self.tls {
            None => speak(stream, self.peer, router, ending).await,
            Some(tls) => {
                if let Ok(Ok(stream)) = timeout(HEAD_WITHIN, tls.accept(stream)).await {
                    speak(stream, self.peer, router, ending).await;
                }
            }
        }
    }
}

/// Serves HTTP to one client until it leaves or the station ends.
async fn speak<S>(stream: S, peer: Peer, router: Router, ending: watch::Receiver<bool>)
where
    S: AsyncRead + AsyncWrite + Unpin + Send + 'static,
{
    let service = TowerToHyperService::new(router.layer(Extension(peer)));
    let connection = http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(HEAD_WITHIN)
        .serve_connection(TokioIo::new(stream), service)
        .with_upgrades();
    let mut connection = std::pin::pin!(connection);
    // A broken connection is over, whatever the cause.
    tokio::select! {
        _ = connection.as_mut() => return,
        () = ended(ending) => connection.as_mut().graceful_shutdown(),
    }
    let _ = connection.await;
}

/// The slots for connections.
#[derive(Debug, Default)]
pub(crate) struct ConnectionSlots(Mutex<HashMap<IpAddr, usize>>);

/// The maximum number of connections.
const MAX_CONNECTIONS: usize = 4096;
/// The maximum number of connections per address of another machine.
const MAX_PER_ADDRESS: usize = 64;

impl ConnectionSlots {
    /// Reserves a slot for this address, if one is free.
    pub(crate) fn take(self: &Arc<Self>, from: IpAddr) -> Option<ConnectionSlot> {
        let mut taken = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let all: usize = taken.values().sum();
        let of_one = taken.entry(from).or_default();
        if all >= MAX_CONNECTIONS || (!from.is_loopback() && *of_one >= MAX_PER_ADDRESS) {
            return None;
        }
        *of_one += 1;
        Some(ConnectionSlot {
            from,
            slots: self.clone(),
        })
    }
}

/// A slot, freed when this is dropped.
#[derive(Debug)]
pub(crate) struct ConnectionSlot {
    from: IpAddr,
    slots: Arc<ConnectionSlots>,
}

impl Drop for ConnectionSlot {
    fn drop(&mut self) {
        let mut taken = self.slots.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(count) = taken.get_mut(&self.from) {
            *count -= 1;
            if *count == 0 {
                taken.remove(&self.from);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_machine_cannot_occupy_all_connections() {
        let slots = Arc::new(ConnectionSlots::default());
        let [one, other] = [[10, 0, 0, 1], [10, 0, 0, 2]].map(IpAddr::from);
        let mut taken: Vec<ConnectionSlot> = std::iter::from_fn(|| slots.take(one)).collect();
        assert_eq!(taken.len(), MAX_PER_ADDRESS);
        assert!(slots.take(other).is_some());
        taken.pop();
        assert!(slots.take(one).is_some());
    }
}
