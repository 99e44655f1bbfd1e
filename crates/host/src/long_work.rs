//! Long work in threads of lower priority than the arm thread.

use std::any::Any;
use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Once;

use crate::priority;

/// Why long work has no result.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum LongWorkError {
    /// It panicked: the source location and the message, in one line.
    #[error("{0}")]
    Panicked(String),
    /// The program is ending.
    #[error("the program is ending")]
    Ending,
}

/// Runs long work, such as planning a drawing or reading a file, in a thread of lower priority than
/// the arm thread.
///
/// # Errors
///
/// [`LongWorkError`].
#[expect(
    clippy::missing_panics_doc,
    reason = "the result has the type of the work"
)]
pub async fn run_long<T: Send + 'static>(
    work: impl FnOnce() -> T + Send + 'static,
) -> Result<T, LongWorkError> {
    let done = run(Box::new(move || Box::new(work()))).await?;
    Ok(*done.downcast().expect("it is what the work gave"))
}

/// One type for all work, because the runtime is compiled once for each type of task.
type Work = Box<dyn FnOnce() -> Box<dyn Any + Send> + Send>;

async fn run(work: Work) -> Result<Box<dyn Any + Send>, LongWorkError> {
    let done = tokio::task::spawn_blocking(|| {
        priority::of_planning();
        caught(work)
    })
    .await;
    done.map_err(|_| LongWorkError::Ending)?
        .map_err(LongWorkError::Panicked)
}

/// Runs work. If it panics, the error is the source location and the message, in one line.
fn caught<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    remember();
    // Anything the work has changed is dropped with it.
    catch_unwind(AssertUnwindSafe(work)).map_err(|_| LAST.take())
}

/// Records the last panic of each thread; the previous hook still reports it. Only a hook gets the
/// location.
fn remember() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let before = take_hook();
        set_hook(Box::new(move |panic| {
            let line = panic.to_string().replace('\n', " ");
            // A thread that is ending needs no record.
            let _ = LAST.try_with(|last| last.set(line));
            before(panic);
        }));
    });
}

thread_local! {
    static LAST: Cell<String> = const { Cell::new(String::new()) };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn a_panic_is_an_error_with_its_place() {
        assert_eq!(run_long(|| 7).await, Ok(7));
        let line = line!() + 1;
        let panicked = run_long(|| panic!("no {}", "width")).await;
        let panicked: Result<(), _> = panicked;
        let Err(LongWorkError::Panicked(text)) = panicked else {
            panic!("it is no panic: {panicked:?}");
        };
        assert!(text.starts_with("panicked at "), "{text}");
        assert!(text.contains(&format!("long_work.rs:{line}:")), "{text}");
        assert!(text.ends_with(": no width"), "{text}");
        assert_eq!(run_long(|| 7).await, Ok(7));
    }

    #[cfg(target_os = "linux")]
    #[tokio::test]
    async fn long_work_yields_to_the_arm() {
        let niceness = run_long(|| rustix::process::getpriority_process(None)).await;
        assert!(niceness.is_ok_and(|niceness| niceness.is_ok_and(|n| n >= 10)));
    }
}
