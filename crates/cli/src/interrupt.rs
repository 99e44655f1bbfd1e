//! Ctrl-C and termination signals.

use std::future::Future;

/// Completes on Ctrl-C, and when the system shuts down or the terminal closes.
///
/// After the first call these signals no longer end the process. One that arrives while nothing waits
/// completes the next future; each signal completes one future only.
#[cfg(unix)]
pub(crate) fn interrupt() -> impl Future<Output = ()> {
    use std::sync::LazyLock;

    use tokio::signal::unix::{Signal, SignalKind, signal};
    use tokio::sync::Mutex;

    static SIGNALS: LazyLock<[std::io::Result<Mutex<Signal>>; 3]> = LazyLock::new(|| {
        [
            SignalKind::interrupt(),
            SignalKind::terminate(),
            SignalKind::hangup(),
        ]
        .map(|kind| signal(kind).map(Mutex::new))
    });
    let [interrupt, terminate, hangup] = &*SIGNALS;
    async move {
        tokio::select! {
            () = next_signal(interrupt) => {}
            () = next_signal(terminate) => {}
            () = next_signal(hangup) => {}
        }
    }
}

/// Waits for a signal; forever if it cannot be received.
#[cfg(unix)]
async fn next_signal(signal: &std::io::Result<tokio::sync::Mutex<tokio::signal::unix::Signal>>) {
    match signal {
        Ok(signal) if signal.lock().await.recv().await.is_some() => {}
        _ => std::future::pending().await,
    }
}

/// Completes on Ctrl-C.
#[cfg(not(unix))]
pub(crate) fn interrupt() -> impl Future<Output = ()> {
    async {
        if tokio::signal::ctrl_c().await.is_err() {
            std::future::pending::<()>().await;
        }
    }
}
