//! When a person or the system wants the program to end.

/// Waits for Ctrl-C, or for the request of a system that shuts down or of a terminal that closes:
/// an arm is left in order in either case.
pub(crate) async fn interrupt() {
    tokio::select! {
        () = ctrl_c() => {}
        () = ended() => {}
    }
}

async fn ctrl_c() {
    if tokio::signal::ctrl_c().await.is_err() {
        std::future::pending::<()>().await;
    }
}

#[cfg(unix)]
async fn ended() {
    use tokio::signal::unix::{SignalKind, signal};

    let signals = [SignalKind::terminate(), SignalKind::hangup()].map(signal);
    let [Ok(mut terminate), Ok(mut hangup)] = signals else {
        return std::future::pending().await;
    };
    tokio::select! {
        _ = terminate.recv() => {}
        _ = hangup.recv() => {}
    }
}

#[cfg(not(unix))]
async fn ended() {
    std::future::pending::<()>().await;
}
