//! Panics of background work, with their source location.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Once;

/// Runs some work. If it panics, the error is the source location and the message in one line.
pub(super) fn caught<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    remember();
    // What the work has changed is given up with it.
    catch_unwind(AssertUnwindSafe(work)).map_err(|_| LAST.take())
}

/// Makes each thread keep its last panic; the previous hook still reports it. Only a hook gets the location.
fn remember() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let before = take_hook();
        set_hook(Box::new(move |panic| {
            let line = panic.to_string().replace('\n', " ");
            // A thread that ends has nobody left to ask for it.
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
    use dobot_api::problem_kinds::INTERNAL;

    use super::*;
    use crate::http::answer::beside;

    #[test]
    fn a_panic_is_told_with_its_place() {
        assert_eq!(caught(|| 7), Ok(7));
        let line = line!() + 1;
        let told = caught(|| panic!("no {}", "width")).map(|()| "no panic");
        let told = told.expect_err("it panicked");
        assert!(told.starts_with("panicked at "), "{told}");
        assert!(told.contains(&format!("panic.rs:{line}:")), "{told}");
        assert!(told.ends_with(": no width"), "{told}");
        assert_eq!(caught(|| 7), Ok(7));
    }

    #[tokio::test]
    async fn work_that_panics_is_answered_as_a_bug_of_the_station() {
        let problem = beside(|| panic!("no width"))
            .await
            .map(|()| "no panic")
            .expect_err("it panicked");
        assert_eq!(problem.status, 500);
        assert_eq!(problem.kind, INTERNAL.problem("").kind);
        assert!(problem.detail.contains("panic.rs:"), "{}", problem.detail);
        assert!(problem.detail.ends_with(": no width"), "{}", problem.detail);
    }
}
