//! Cancellation of long calculations.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use thiserror::Error;

/// Cancels a calculation from another thread.
///
/// Readers and planners check the token after every few thousand steps of work at most.
#[derive(Clone, Debug)]
pub struct CancelToken(Arc<AtomicUsize>);

impl CancelToken {
    /// Returns a token that cancels itself after this number of checks, for tests of where a
    /// calculation checks it.
    #[must_use]
    pub fn after_checks(count: usize) -> Self {
        Self(Arc::new(AtomicUsize::new(count)))
    }

    /// Cancels the calculation permanently.
    pub fn cancel(&self) {
        self.0.store(0, Ordering::Relaxed);
    }

    /// Returns whether the calculation was cancelled.
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        let left = self.0.load(Ordering::Relaxed);
        if left != 0 && left != NEVER {
            // A concurrent `cancel` must win.
            let fewer = left - 1;
            let order = Ordering::Relaxed;
            return self.0.compare_exchange(left, fewer, order, order) == Err(0);
        }
        left == 0
    }

    /// Checks that the calculation was not cancelled.
    ///
    /// # Errors
    ///
    /// [`Cancelled`] if it was.
    pub fn check(&self) -> Result<(), Cancelled> {
        if self.is_cancelled() {
            return Err(Cancelled);
        }
        Ok(())
    }
}

impl Default for CancelToken {
    /// Returns a token that is not cancelled.
    fn default() -> Self {
        Self::after_checks(NEVER)
    }
}

/// The error returned when a calculation was cancelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("the calculation was cancelled")]
pub struct Cancelled;

const NEVER: usize = usize::MAX;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_copies_of_a_token_are_cancelled_together_and_for_good() {
        let token = CancelToken::default();
        let copy = token.clone();
        assert_eq!(copy.check(), Ok(()));
        token.cancel();
        assert_eq!([copy.check(), copy.check()], [Err(Cancelled); 2]);
    }

    #[test]
    fn a_token_for_tests_cancels_itself_after_some_checks() {
        let token = CancelToken::after_checks(2);
        let checks = [(); 4].map(|()| token.is_cancelled());
        assert_eq!(checks, [false, false, true, true]);
    }
}
