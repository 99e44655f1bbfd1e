//! Serving an agent over two byte streams.

use std::io;
use std::pin::Pin;
use std::task::{Context, Poll};

use rmcp::ServiceExt;
use tokio::io::{AsyncRead, AsyncWrite, ReadBuf};
use tokio::sync::watch;

use crate::Agents;

/// The error returned when an agent cannot be served.
#[derive(Debug, thiserror::Error)]
#[error("the agent does not speak the Model Context Protocol: {0}")]
pub struct ServeError(String);

/// Serves an agent until its input ends or `ending` becomes true. If it is moving the arm at that
/// time, the arm is stopped.
///
/// # Errors
///
/// [`ServeError`] if its first message is not a valid initialisation.
pub async fn serve(
    agents: Agents,
    input: impl AsyncRead + Send + Unpin + 'static,
    output: impl AsyncWrite + Send + Unpin + 'static,
    ending: watch::Receiver<bool>,
) -> Result<(), ServeError> {
    boxed(agents, Box::new(input), Box::new(output), ending).await
}

type Serving = Pin<Box<dyn Future<Output = Result<(), ServeError>> + Send>>;

/// Uses one type for all streams, so that the protocol is compiled only in this crate.
fn boxed(agents: Agents, input: Input, output: Output, ending: watch::Receiver<bool>) -> Serving {
    Box::pin(run(agents, input, output, ending))
}

type Input = Box<dyn AsyncRead + Send + Unpin>;
type Output = Box<dyn AsyncWrite + Send + Unpin>;

async fn run(
    agents: Agents,
    input: Input,
    output: Output,
    mut ending: watch::Receiver<bool>,
) -> Result<(), ServeError> {
    let gone = agents.gone();
    let input = UntilEnd {
        input,
        gone: gone.clone(),
    };
    let service = tokio::select! {
        service = agents.serve((input, output)) => service.map_err(|error| ServeError(error.to_string()))?,
        _ = ending.wait_for(|ending| *ending) => return Ok(()),
    };
    let end = service.cancellation_token();
    let waiting = service.waiting();
    tokio::pin!(waiting);
    tokio::select! {
        _ = &mut waiting => return Ok(()),
        _ = ending.wait_for(|ending| *ending) => {}
    }
    gone.send_replace(true);
    end.cancel();
    // Calls in progress stop the arm first.
    let _ = waiting.await;
    Ok(())
}

/// An input that reports its end.
struct UntilEnd {
    input: Input,
    gone: watch::Sender<bool>,
}

impl AsyncRead for UntilEnd {
    fn poll_read(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
        buffer: &mut ReadBuf<'_>,
    ) -> Poll<io::Result<()>> {
        let before = buffer.filled().len();
        let read = Pin::new(&mut self.input).poll_read(context, buffer);
        if let Poll::Ready(read) = &read
            && (read.is_err() || buffer.filled().len() == before)
        {
            self.gone.send_replace(true);
        }
        read
    }
}
